// controls.js - rows of the panel: a label, a field, and how it follows the state.
import { element } from "./dom.js";

let made = 0;

/** A row with a label before its field. */
export function row(label, field, ...more) {
    field.id ||= `control-${++made}`;
    return element("div", { class: "row" }, element("label", { for: field.id }, label), field, ...more);
}

/** A slider: onInput(value, moving) while it moves, and at its end. */
export function slider({ min, max, step, show, onInput, ...attributes }) {
    const range = element("input", {
        type: "range", min, max, step, ...attributes,
        input: () => onInput(Number(range.value), true),
        change: () => onInput(Number(range.value), false),
    });
    const output = element("output", { "aria-hidden": "true" });
    const follow = (value) => {
        range.value = value;
        output.textContent = show(value);
        range.setAttribute("aria-valuetext", show(value));
    };
    return { range, output, follow };
}

/** A choice among [value, text] pairs. */
export function choice(pairs, onChange) {
    const options = pairs.map(([value, text]) => element("option", { value }, text));
    const select = element("select", { change: () => onChange(select.value) }, ...options);
    return select;
}

/** A field for a number; onNumber is called with what is finite and in range. */
export function numberField({ label, min = -1e9, max = 1e9, onNumber }) {
    const field = element("input", {
        type: "number", step: "any", min, max, "aria-label": label,
        change: () => {
            const x = field.value === "" ? NaN : Number(field.value);
            if (x >= min && x <= max) {
                field.dataset.good = x;
                onNumber(x);
            } else {
                field.value = field.dataset.good;
            }
        },
    });
    field.follow = (x) => {
        field.dataset.good = x;
        if (document.activeElement !== field || Number(field.value) !== x) field.value = x;
    };
    return field;
}

/** A button with a text. */
export function button(text, onClick, attributes = {}) {
    return element("button", { type: "button", ...attributes, click: onClick }, text);
}
