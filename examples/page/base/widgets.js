// widgets.js - small parts of the panels of the ray and of complex space.
import { debounced, element } from "./dom.js";

let made = 0;

/** An id that no other element has. */
export const freshId = (stem) => `${stem}-${++made}`;

export const button = (label, click, attributes = {}) =>
    element("button", { type: "button", click, ...attributes }, label);

/** A field after its label. */
export function labelled(label, field, kind = "ray-field") {
    field.id ||= freshId("field");
    return element("span", { class: kind }, element("label", { for: field.id }, label), field);
}

/** A slider from 0 to a largest step, with buttons before and after it. */
export function stepper(label, words, onStep) {
    const go = (by) => {
        range.value = Number(range.value) + by;
        onStep(Number(range.value));
    };
    const range = element("input", {
        type: "range",
        min: 0,
        max: 0,
        value: 0,
        "aria-label": label,
        input: () => go(0),
    });
    const node = element(
        "div",
        { class: "ray-stepper" },
        button("◂", () => go(-1), { "aria-label": words.back }),
        range,
        button("▸", () => go(1), { "aria-label": words.on }),
    );
    return { node, range };
}

/** Work that is asked for more often than it can be done: while it runs, one further run is kept in mind. */
export function latest(work) {
    let busy = false;
    let again = false;
    return async () => {
        again = true;
        if (busy) return;
        busy = true;
        try {
            while (again) {
                again = false;
                await work();
            }
        } finally {
            busy = false;
        }
    };
}

const REST = 180; // milliseconds without change: the picture rests

/** A function that sets a part of the store's state while something moves, and lets the picture rest
 * after. */
export function mover(store) {
    const rest = debounced(REST, () => store.set({}, { moving: false }));
    return (partial) => {
        store.set(partial, { moving: true });
        rest();
    };
}
