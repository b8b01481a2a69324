// keys.js - keys for everything, where no text is being typed.

const TYPED =
    "input:not([type='range'], [type='checkbox'], [type='radio'], [type='color']), textarea, select";
const ARROWS = /^(Arrow|Home|End|Page)/;

/** acts: motion, gallery, sliders, and functions by name. */
export function keepKeys(acts) {
    const keys = {
        e: acts.equation,
        "/": acts.equation,
        p: () => acts.sliders.toggle(),
        "[": () => acts.gallery.step(-1),
        "]": () => acts.gallery.step(1),
        r: acts.ray,
        c: acts.complex,
        l: acts.link,
        s: acts.save,
        t: acts.theme,
        w: acts.wide,
        "?": acts.help,
        Escape: acts.escape,
    };
    document.addEventListener("keydown", (event) => {
        if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
        const { target } = event;
        if (document.querySelector("dialog[open]") || target.closest?.(TYPED)) return;
        const usesArrows = target.closest?.("input, .panel, .strip") && ARROWS.test(event.key);
        if (usesArrows) return;
        const name = event.key.length === 1 ? event.key.toLowerCase() : event.key;
        const act = Object.hasOwn(keys, name) ? keys[name] : null;
        if (act) act();
        else if (!acts.motion.key(event)) return;
        event.preventDefault();
    });
}
