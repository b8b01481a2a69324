// fields.js - a slider and a number field that show the same number.
import { element } from "./dom.js";
import { freshId } from "./widgets.js";

/** label: of both; range: { min, max, step } of the slider's own steps; number: attributes of the field;
 * toValue, toStep: from the slider's steps to the number and back; unit: said after it; onInput(value). */
export function numberField(
    label,
    { range, number = {}, toValue = Number, toStep = Number, unit = "", onInput },
) {
    const slider = element("input", { type: "range", ...range, "aria-label": label });
    const field = element("input", { type: "number", step: "any", ...number, id: freshId("number") });
    const tell = (value) => Number.isFinite(value) && onInput(value);
    slider.addEventListener("input", () => tell(toValue(Number(slider.value))));
    field.addEventListener("input", () => field.value !== "" && tell(Number(field.value)));
    field.addEventListener("change", () => (field.value = field.dataset.shown));
    const node = element(
        "div",
        { class: "number-field" },
        element("label", { for: field.id }, label),
        slider,
        element("span", { class: "number-value" }, field, unit),
    );
    const show = (value) => {
        const shown = String(Number(value.toPrecision(6)));
        field.dataset.shown = shown;
        if (document.activeElement !== field) field.value = shown;
        if (document.activeElement !== slider || toValue(Number(slider.value)) !== value)
            slider.value = toStep(value);
        slider.setAttribute("aria-valuetext", `${shown}${unit}`);
    };
    return { node, show };
}
