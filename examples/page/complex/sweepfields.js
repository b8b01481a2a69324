// sweepfields.js - which number of complex space is swept, from where to where, and the button that plays it.
import { stemOf } from "../files/command.js";
import { download, element } from "../base/dom.js";
import { lowered } from "../base/number.js";
import { filmOf } from "../files/record.js";
import { Player, complexAt } from "./sweep.js";
import { button, labelled } from "../base/widgets.js";

const PERIOD = 6000; // milliseconds there and back
const STILLS = 8; // pictures there, for those who want no motion

const reduced = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

const nameOf = ({ what, k }) => (what === "imaginary" ? `imaginary-${k}` : what);

function sweepNamed(name) {
    const [what, k] = name.split("-");
    return k === undefined ? { what } : { what, k: Number(k) };
}

export class SweepFields {
    #player = new Player(PERIOD);
    #still = 0;
    #recording = null; // AbortController

    constructor({ painter, store, text }) {
        Object.assign(this, { painter, store, text });
        this.what = element("select", { change: () => this.#stop() });
        const end = () => element("input", { type: "number", step: "any", change: () => this.#stop() });
        [this.from, this.to] = [end(), end()];
        this.play = button("", () => this.#toggle());
        this.record = button("", () => this.#record());
        this.said = element("span", { role: "status" });
        this.node = element(
            "fieldset",
            { class: "sweep" },
            element("legend", {}, text("complex.sweep")),
            labelled(text("complex.sweep.what"), this.what),
            labelled(text("complex.sweep.from"), this.from),
            labelled(text("complex.sweep.to"), this.to),
            this.play,
            this.record,
            this.said,
        );
        store.subscribe(({ complex }) => complex === null && this.#stop());
        this.set({ what: "delta", from: 0, to: 70 });
        this.#label();
    }

    /** The sweep of the fields. */
    get() {
        return { ...sweepNamed(this.what.value), from: Number(this.from.value), to: Number(this.to.value) };
    }

    set(sweep) {
        this.#stop();
        const name = nameOf(sweep);
        if (![...this.what.options].some((option) => option.value === name)) this.#list(sweep.k ?? 0, name);
        this.what.value = name;
        this.from.value = sweep.from;
        this.to.value = sweep.to;
    }

    /** As many coefficients as the surface has. */
    setDegree(degree) {
        if (this.what.options.length !== degree + 3) this.#list(degree, this.what.value);
    }

    #list(degree, chosen) {
        const choice = (name, label) => element("option", { value: name }, label);
        const parts = Array.from({ length: degree + 1 }, (_, k) =>
            choice(`imaginary-${k}`, `Im p${lowered(k)}`),
        );
        this.what.replaceChildren(choice("delta", "δ (°)"), choice("sigma", "σ (°)"), ...parts);
        this.what.value = chosen;
        if (this.what.selectedIndex < 0) this.what.value = "delta";
    }

    #show(share, moving) {
        const { complex } = this.store.get();
        if (complex) this.store.set({ complex: complexAt(complex, this.get(), share) }, { moving });
    }

    #toggle() {
        if (reduced()) {
            this.#still = (this.#still + 1) % (STILLS + 1);
            this.#show(this.#still / STILLS, false);
        } else if (this.#player.playing) {
            this.#stop();
        } else {
            this.#player.start((share) => this.#show(share, true));
            this.#label();
        }
    }

    /** Draws the sweep as a film, and hands it to the user; once more: gives up. */
    async #record() {
        if (this.#recording) return this.#recording.abort();
        const state = this.store.get();
        if (!state.complex) return undefined;
        this.#stop();
        this.#recording = new AbortController();
        this.#label();
        const { signal } = this.#recording;
        const onProgress = (share) => (this.said.textContent = `${Math.round(100 * share)} %`);
        try {
            const film = await filmOf(this.painter, state, this.get(), { onProgress, signal });
            download(film, `${stemOf(state)}-${this.what.value}.png`);
            this.said.textContent = "";
        } catch (error) {
            this.said.textContent = signal.aborted
                ? ""
                : this.text("complex.record.failed", { reason: error.message });
        }
        this.#recording = null;
        return this.#label();
    }

    #stop() {
        if (!this.#player.playing) return;
        this.#player.stop();
        this.#label();
        this.store.set({}, { moving: false });
    }

    #label() {
        this.record.textContent = this.text(this.#recording ? "complex.record.cancel" : "complex.record");
        this.play.textContent = this.text(reduced() ? "complex.still" : "complex.play");
        if (reduced()) this.play.removeAttribute("aria-pressed");
        else this.play.setAttribute("aria-pressed", String(this.#player.playing));
    }
}
