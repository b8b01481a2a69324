// nothing.js - an empty picture says why it is empty, and has a button that shows the surface.
import { button } from "../base/controls.js";
import { element, fill } from "../base/dom.js";
import { isBox } from "../state/state.js";

/** room: over the picture; fit(what) chooses extent and camera. */
export function mount(room, { store, painter, text, fit }) {
    async function whyOf({ state }) {
        if (state.complex) return "sector";
        return painter.ask("nothing", state, { latest: true }).catch(() => "view");
    }

    function said(why, { extent }) {
        const radius = Number(extent.size[0].toPrecision(3));
        return text(why === "extent" && isBox(extent) ? "nothing.box" : `nothing.${why}`, { radius });
    }

    async function show(picture) {
        const why = await whyOf(picture);
        if (store.get().picture !== picture) return;
        const act = why === "nowhere" ? [] : [button(text("view.fit"), () => fit("view"), { class: "main" })];
        fill(room, element("p", {}, said(why, picture.state)), ...act);
        room.hidden = false;
    }

    function follow({ picture }) {
        if (!picture) return;
        const isEmpty = picture.hits + picture.undecided + picture.thin === 0;
        if (!isEmpty) room.hidden = true;
        else if (picture.stage !== "moving") void show(picture);
    }
    follow(store.get());
    store.subscribe((state, { changed }) => changed.has("picture") && follow(state));
}
