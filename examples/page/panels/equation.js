// equation.js - the box that equations are typed into: compiled while typing; the last good picture stays.
//
// What is wrong is marked in place, by a layer of the same text behind the transparent box.  A name of the
// catalogue opens its surface: at once by Enter, else after a while, since it may be the beginning of another.
import { compiledWith } from "../picture/asking.js";
import { surfaceNamed, surfacesLike } from "./names.js";
import { element, fill } from "../base/dom.js";
import { printable } from "../state/state.js";

const WAIT = 30; // milliseconds after a key,
const NAME_WAIT = 700; // and after a name

export class EquationBox {
    #box;
    #mirror;
    #mistake;
    #services;
    #timer = 0;
    #latest = 0;

    session = 0; // of typing: another one begins where the box is entered, or what it holds is meant

    /** services: { store, painter, text, onSurface(partial state, compiled), open(state) } */
    constructor({ box, mirror, mistake }, services) {
        this.#box = box;
        this.#mirror = mirror;
        this.#mistake = mistake;
        this.#services = services;
        box.addEventListener("input", () => this.#later());
        box.addEventListener("scroll", () => (mirror.scrollTop = box.scrollTop));
        box.addEventListener("keydown", (event) => this.#key(event));
        box.addEventListener("focus", () => this.session++);
        new ResizeObserver(() => this.#fit()).observe(box.parentElement);
        if (!this.isSettled) this.#later(); // typed before there was this
    }

    /** Is what stands in the box what is shown? */
    get isSettled() {
        return printable(this.#box.value) === this.#services.store.get().equation;
    }

    focus() {
        this.#box.focus();
        this.#box.select();
    }

    /** Shows an equation that is known to be good. */
    show(equation) {
        clearTimeout(this.#timer);
        this.#latest++;
        this.session++;
        this.#box.value = equation;
        this.#fit();
        this.#mark(null);
    }

    #key(event) {
        if (event.key === "Enter" && !event.shiftKey) {
            event.preventDefault();
            void this.#compile(true).then(() => this.session++);
        }
        if (event.key === "Escape") {
            event.stopPropagation();
            this.show(this.#services.store.get().equation);
            this.#box.blur();
        }
    }

    #later() {
        this.#fit();
        this.#mark(null);
        clearTimeout(this.#timer);
        this.#timer = setTimeout(() => this.#compile(), WAIT);
    }

    /** As high as the text is. */
    #fit() {
        this.#box.style.height = "auto";
        this.#box.style.height = `${this.#box.scrollHeight + 2}px`;
    }

    /** Compiles what stands in the box, and hands it on if it is good; isMeant: no more will be typed. */
    async #compile(isMeant = false) {
        clearTimeout(this.#timer);
        const turn = ++this.#latest, equation = printable(this.#box.value);
        const { store, painter, text, onSurface, open } = this.#services;
        if (equation.trim() === "" || equation === store.get().equation) return this.#mark(null);
        const named = surfaceNamed(equation, text);
        if (named && isMeant) return open(named);
        if (named) {
            this.#timer = setTimeout(() => this.#compile(true), NAME_WAIT);
            return;
        }
        try {
            const { parameters, compiled } = await compiledWith(painter, equation, store.get().parameters);
            if (turn !== this.#latest) return;
            if (compiled.degree === 0) return this.#mark({ code: "CONSTANT" });
            this.#mark(null);
            await onSurface({ name: "", equation, parameters }, compiled);
        } catch (error) {
            if (turn === this.#latest && error.code !== "E_CANCELLED") this.#mark(error);
        }
    }

    #mark(error) {
        const { value } = this.#box;
        this.#box.setAttribute("aria-invalid", String(error !== null));
        if (!error) {
            fill(this.#mirror);
            this.#mistake.textContent = "";
            return;
        }
        const offset = Math.min(error.offset ?? 0, value.length),
            end = offset + Math.max(error.length ?? 1, 1);
        const piece = value.slice(offset, end) || " ";
        const parts = [value.slice(0, offset), element("mark", {}, piece), value.slice(end)];
        fill(this.#mirror, ...(typeof error.offset === "number" ? parts : []));
        this.#mirror.scrollTop = this.#box.scrollTop;
        const like = surfacesLike(value, this.#services.text).map((surface) => this.#offer(surface));
        fill(this.#mistake, this.#saying(error, offset), ...like);
    }

    /** A button that opens the surface. */
    #offer(surface) {
        const { text, open } = this.#services;
        const name = text(`name.${surface.name}`);
        return element("button", { type: "button", click: () => open(surface) }, name);
    }

    #saying(error, offset) {
        const { text } = this.#services;
        const what = text.mistake(error);
        if (error.offset === undefined || error.offset === null) return what;
        return text("mistake.at", { column: offset + 1, what });
    }
}
