// past.js - surfaces that were looked at: own ones are kept in the gallery, the browser's Back goes to the
// one before.  What was typed on the way to something else is not kept.
import { debounced } from "../base/dom.js";
import { stateOfLink } from "../state/link.js";
import { checkedState } from "../state/state.js";
import { SURFACES } from "../state/surfaces.js";

const ON_THE_WAY = 4000; // milliseconds: what is typed over something younger replaces it
const FIRST = checkedState(SURFACES[0]).state;

/** Tells whether a surface only replaces the last one that it was asked about. */
function typing(box) {
    let session = -1, at = 0;
    return ({ name }) => {
        const goesOn = name === "" && session === box.session && performance.now() - at < ON_THE_WAY;
        [session, at] = [box.session, performance.now()];
        return goesOn;
    };
}

/** Own surfaces, once they were drawn. */
function keepOwn({ store, box, gallery }) {
    const goesOn = typing(box);
    let last = "";
    const keep = debounced(200, (state) => {
        if (state.equation === last) return;
        gallery.remember(state, goesOn(state) ? last : "");
        last = state.equation;
    });
    const follow = ({ picture }) => {
        if (picture && picture.stage !== "moving" && picture.state.name === "") keep(picture.state);
    };
    follow(store.get());
    store.subscribe((state, { changed }) => changed.has("picture") && follow(state));
}

/** The address: that of what is shown; each surface has an entry in the browser's history. */
function keepAddress({ store, box, shown }) {
    const goesOn = typing(box);
    let hasCome = location.hash !== ""; // what is shown, from the address, which may be a bad one
    let opening = 0; // addresses that are on their way to be shown
    function keep() {
        if (opening > 0) return;
        const state = store.get(), before = stateOfLink(location.hash, FIRST)?.state ?? FIRST;
        const isSame = before.equation === state.equation || hasCome;
        const way = isSame || goesOn(state) ? "replaceState" : "pushState"; // the same is not typed again
        hasCome = false;
        history[way](null, "", shown.link);
    }
    const keepLater = debounced(600, keep);
    store.subscribe((state, { changed }) => {
        if (changed.has("picture")) return;
        if (changed.has("equation")) keep();
        keepLater();
    });
    // The event's address: that of the page may by now be the one that keep wrote.
    window.addEventListener("hashchange", async ({ newURL }) => {
        const { hash } = new URL(newURL);
        const link = stateOfLink(hash, FIRST) ?? (hash === "" ? { state: FIRST } : null);
        if (!link) return;
        opening++;
        await shown.openLink(link);
        opening--;
        hasCome = true;
        keepLater();
    });
    keepLater();
}

/** services: { store, box, gallery, shown } */
export function keepPast(services) {
    keepOwn(services);
    keepAddress(services);
}
