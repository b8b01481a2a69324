// waiting.js - while a picture is on its way: the old one is marked as old, what takes long tells how far it
// is, and can be stopped.
import { button } from "../base/controls.js";
import { element } from "../base/dom.js";

const OLD = 250, HEAVY = 1000; // milliseconds
const FINE = 5000; // milliseconds that antialiasing or shadows may take before they are told
const TICK = 100; // milliseconds between two looks

/** room: over the picture; stage: around both; notify(words) */
export function mount(room, { stage, store, painter, text, notify }) {
    let timer = null;
    const words = element("span");
    const stop = button(text("stop"), () => {
        painter.stop();
        notify(text("stopped"));
        show();
    });
    room.append(words, stop);

    function show() {
        const { isShown, waitMs, isDrawn, isFirst, ms, share } = painter.progress;
        const isOld = !isShown && waitMs > OLD;
        stage.classList.toggle("old", isOld);
        stage.setAttribute("aria-busy", String(isOld));
        room.hidden = !isDrawn || !(isOld || ms > (isFirst ? HEAVY : FINE));
        const percent = share > 0 ? `${text.number(Math.floor(1000 * share) / 10)} %` : "";
        words.textContent = room.hidden ? "" : text("drawing", { percent });
        if (isDrawn || (!isShown && !isOld)) return;
        clearInterval(timer);
        timer = null;
    }
    function watch() {
        show();
        timer ??= setInterval(show, TICK); // also after a picture: a better one may be next
    }
    watch();
    store.subscribe(watch);
}
