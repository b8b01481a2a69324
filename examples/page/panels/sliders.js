// sliders.js - a slider for each free letter of the equation: value, range to edit, a button that plays it.
import { element, fill } from "../base/dom.js";
import { LIMITS } from "../state/state.js";

const STEPS = 1000; // of a slider
const PERIOD = 8000; // milliseconds from one end to the other and back

const inLimits = (x) => Number.isFinite(x) && Math.abs(x) <= LIMITS.number;
const rounded = (x, range) => Number(x.toFixed(Math.max(0, Math.min(12, 4 - Math.floor(Math.log10(range))))));

export class Sliders {
    #room;
    #services;
    #rows = new Map();
    #playing = null; // { name, phase, last }

    constructor(room, services) {
        this.#room = room;
        this.#services = services;
        services.store.subscribe((state, { changed }) => changed.has("parameters") && this.#show(state));
        this.#show(services.store.get());
    }

    get playing() {
        return this.#playing !== null;
    }

    /** Plays the first one, or stops. */
    toggle(name = [...this.#rows.keys()][0]) {
        if (this.#playing) return this.#stop();
        const p = this.#services.store.get().parameters[name];
        if (!p) return;
        const share = (p.value - p.from) / (p.to - p.from);
        this.#playing = { name, phase: Math.acos(1 - 2 * share) / (2 * Math.PI), last: performance.now() };
        this.#mark();
        requestAnimationFrame((now) => this.#tick(now));
    }

    #stop() {
        this.#playing = null;
        this.#mark();
        this.#services.store.set({}, { moving: false });
    }

    #tick(now) {
        const play = this.#playing;
        if (!play) return;
        const p = this.#services.store.get().parameters[play.name];
        if (!p) return this.#stop();
        const passed = document.hidden ? 0 : now - play.last, range = p.to - p.from;
        play.phase = (play.phase + passed / PERIOD) % 1;
        play.last = now;
        const share = (1 - Math.cos(2 * Math.PI * play.phase)) / 2;
        if (passed > 0) this.#change(play.name, { value: rounded(p.from + share * range, range) }, true);
        requestAnimationFrame((next) => this.#tick(next));
    }

    #change(name, partial, moving) {
        const { store } = this.#services;
        const { parameters } = store.get();
        store.set({ parameters: { ...parameters, [name]: { ...parameters[name], ...partial } } }, { moving });
    }

    // ---- what is seen ----

    #show({ parameters }) {
        const names = Object.keys(parameters);
        const same = names.length === this.#rows.size && names.every((name) => this.#rows.has(name));
        if (!same) this.#build(names);
        for (const name of names) this.#rows.get(name).follow(parameters[name]);
        this.#room.hidden = names.length === 0;
        if (this.#playing && !this.#rows.has(this.#playing.name)) this.#playing = null;
    }

    #build(names) {
        this.#rows = new Map(names.map((name) => [name, this.#row(name)]));
        fill(this.#room, ...[...this.#rows.values()].map(({ node }) => node));
    }

    #mark() {
        for (const [name, { button }] of this.#rows) {
            const plays = this.#playing?.name === name;
            button.textContent = plays ? "❚❚" : "▶";
            button.setAttribute("aria-pressed", String(plays));
        }
    }

    #row(name) {
        const { text } = this.#services;
        const at = () => this.#services.store.get().parameters[name];
        const id = `parameter-${name}`;
        const slide = element("input", {
            type: "range", id, min: 0, max: STEPS, step: 1,
            input: () => {
                const p = at(), range = p.to - p.from;
                this.#change(name, { value: rounded(p.from + (slide.value / STEPS) * range, range) }, true);
            },
            change: () => this.#services.store.set({}, { moving: false }),
        });
        const number = (label, take) => {
            const field = element("input", {
                type: "number", step: "any", "aria-label": label,
                change: () => {
                    const x = field.value === "" ? NaN : Number(field.value);
                    if (inLimits(x)) take(x);
                    this.#rows.get(name)?.follow(at());
                },
            });
            return field;
        };
        const value = number(text("parameters.value", { name }), (x) =>
            this.#change(name, { value: x, from: Math.min(x, at().from), to: Math.max(x, at().to) }, false));
        const from = number(text("parameters.from", { name }), (x) =>
            x < at().to && this.#change(name, { from: x, value: Math.max(x, at().value) }, false));
        const to = number(text("parameters.to", { name }), (x) =>
            x > at().from && this.#change(name, { to: x, value: Math.min(x, at().value) }, false));
        const button = element(
            "button",
            {
                type: "button",
                "aria-label": text("parameters.play", { name }),
                "aria-pressed": "false",
                click: () => this.toggle(name),
            },
            "▶",
        );
        const range = element("div", { class: "range" }, from, to);
        const node = element(
            "div",
            { class: "parameter" },
            element("label", { for: id }, name),
            slide,
            value,
            button,
            range,
        );
        const follow = (p) => {
            slide.value = Math.round((STEPS * (p.value - p.from)) / (p.to - p.from));
            slide.setAttribute("aria-valuetext", String(p.value));
            for (const [field, x] of [[value, p.value], [from, p.from], [to, p.to]])
                if (document.activeElement !== field || Number(field.value) !== x) field.value = x;
        };
        return { node, button, follow };
    }
}
