// complex.js - complex space: on or off, the sector of arguments, imaginary parts, and the sweeps of the
// paper.
import { element } from "../base/dom.js";
import { numberField } from "../base/fields.js";
import { ImaginaryParts } from "./imaginary.js";
import { lowered } from "../base/number.js";
import { PAPER_SWEEPS } from "./papersweeps.js";
import { sectorOf, toDegrees, toRadians, withDelta, withSigma } from "./sector.js";
import { surfaceOf } from "../state/surfaces.js";
import { SweepFields } from "./sweepfields.js";
import { button, mover } from "../base/widgets.js";

const FIRST = { sigma: 0, delta: toRadians(10), imaginary: {} };

function presetName({ surface, sweep }, text) {
    const symbol = sweep.what === "imaginary" ? `p${lowered(sweep.k)}` : "δ";
    return `${text(`name.${surface}`)}, ${symbol}`;
}

/** The camera with a field of view that shows the same on a canvas that is higher than wide: the eye has to
 * stay where it is, since what complex space shows depends on it. */
function seenWhole(camera, { clientWidth, clientHeight }) {
    const half = Math.tan(toRadians(camera.fov / 2)) * Math.max(1, clientHeight / clientWidth);
    return { ...camera, fov: Number(toDegrees(2 * Math.atan(half)).toPrecision(6)) };
}

class Panel {
    degree = 0; // of the last picture
    #kept = FIRST; // what is shown when complex space is switched on again

    constructor(room, { painter, store, text, canvas, open }) {
        Object.assign(this, { store, text, canvas, open });
        this.move = mover(store);
        this.on = element("input", { type: "checkbox", change: () => this.#switch() });
        this.angles = {
            sigma: this.#angle("sigma", withSigma),
            delta: this.#angle("delta", withDelta),
        };
        this.parts = new ImaginaryParts(text, (k, value) => this.#setPart(k, value));
        this.sweep = new SweepFields({ painter, store, text });
        this.inside = element(
            "div",
            {},
            this.angles.sigma.node,
            this.angles.delta.node,
            this.parts.node,
            this.sweep.node,
        );
        room.append(
            element("label", { class: "complex-switch" }, this.on, ` ${text("complex.on")}`),
            element("p", { class: "ray-said" }, text("complex.what")),
            this.inside,
            element("h3", {}, text("complex.presets")),
            element(
                "div",
                { class: "complex-presets" },
                ...PAPER_SWEEPS.map((preset) => this.#preset(preset)),
            ),
        );
        this.#show(store.get());
        store.subscribe((state, { changed }) => {
            if (changed.has("complex") || changed.has("picture")) this.#show(state);
        });
    }

    #angle(name, change) {
        return numberField(this.text(`complex.${name}`), {
            range: { min: 0, max: 180, step: 0.1 },
            number: { min: 0, max: 180 },
            unit: "°",
            onInput: (degrees) => {
                const { complex } = this.store.get();
                this.move({ complex: { ...complex, ...change(complex, toRadians(degrees)) } });
            },
        });
    }

    #setPart(k, value) {
        const { complex } = this.store.get();
        const imaginary = { ...complex.imaginary, [k]: value };
        if (value === 0) delete imaginary[k];
        this.move({ complex: { ...complex, imaginary } });
    }

    #switch() {
        const { complex } = this.store.get();
        if (complex) this.#kept = complex;
        this.store.set({ complex: this.on.checked ? this.#kept : null });
    }

    #preset(preset) {
        return button(presetName(preset, this.text), () => {
            const { name, equation, parameters, colours } = surfaceOf(preset.surface);
            this.sweep.set(preset.sweep);
            const { extent, camera } = preset.view;
            const complex = { sigma: 0, delta: toRadians(preset.delta), imaginary: preset.imaginary };
            const state = { name, equation, parameters, colours, extent, complex };
            this.open(state, { camera: seenWhole(camera, this.canvas) });
        });
    }

    #show(state) {
        const { complex, picture } = state;
        this.degree = picture?.degree ?? this.degree;
        this.on.checked = complex !== null;
        this.inside.hidden = complex === null;
        const sector = sectorOf(state);
        this.angles.sigma.show(toDegrees(sector.sigma));
        this.angles.delta.show(toDegrees(sector.delta));
        this.parts.show(complex?.imaginary ?? {}, this.degree);
        this.sweep.setDegree(this.degree);
    }
}

/** Puts the panel into an element; open(state, { camera }) shows another surface. */
export const mount = (room, services) => new Panel(room, services);
