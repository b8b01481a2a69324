// imaginary.js - the imaginary parts of the coefficients p_0 ... p_n of a ray's polynomial, a slider for
// each.
import { element } from "../base/dom.js";
import { numberField } from "../base/fields.js";
import { lowered } from "../base/number.js";
import { button } from "../base/widgets.js";

const FEW = 5; // are shown; the others when somebody asks for them
const MOST = 20; // at the slider's ends
const STEPS = 100; // on each side

// Fine near 0, coarse at the ends: three digits of a cube.
const toValue = (step) => Number((MOST * (step / STEPS) ** 3).toPrecision(3));
const toStep = (value) => STEPS * Math.cbrt(Math.max(-1, Math.min(1, value / MOST)));

/** The fields; onInput(k, value). */
export class ImaginaryParts {
    #fields = [];
    #all = false;
    #degree = -1;

    constructor(text, onInput) {
        this.text = text;
        this.onInput = onInput;
        this.rows = element("div", {});
        this.more = button(text("complex.more"), () => {
            this.#all = true;
            this.#build();
        });
        this.node = element(
            "fieldset",
            {},
            element("legend", {}, text("complex.imaginary")),
            this.rows,
            this.more,
        );
    }

    #build() {
        const count = this.#all ? this.#degree + 1 : Math.min(FEW, this.#degree + 1);
        this.#fields = Array.from({ length: count }, (_, k) =>
            numberField(`Im p${lowered(k)}`, {
                range: { min: -STEPS, max: STEPS, step: 1 },
                toValue,
                toStep,
                onInput: (value) => this.onInput(k, value),
            }),
        );
        this.rows.replaceChildren(...this.#fields.map((field) => field.node));
        this.more.hidden = count > this.#degree;
        this.#show();
    }

    #show() {
        this.#fields.forEach((field, k) => field.show(this.parts[k] ?? 0));
    }

    /** parts: value by k. */
    show(parts, degree) {
        this.parts = parts;
        const needed = Object.keys(parts).some(
            (k) => parts[k] !== 0 && Number(k) >= FEW && Number(k) <= degree,
        );
        const grows = needed && !this.#all;
        if (grows) this.#all = true;
        if (grows || degree !== this.#degree) {
            this.#degree = degree;
            this.#build();
        } else this.#show();
    }
}
