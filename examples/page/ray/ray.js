// ray.js - one ray, looked into: where it meets the surface, its polynomial, how the first root was found,
// and all complex roots.  Where the panel is a sheet that is closed, one line over the picture tells the hit.
import { element, narrow } from "../base/dom.js";
import { between, lowered, short, whole } from "../base/number.js";
import { Place } from "./place.js";
import { Plane } from "./plane.js";
import { Search } from "./search.js";
import { complexWith, sectorOf } from "../complex/sector.js";
import { METHODS, Steps } from "./steps.js";
import { button, labelled, latest, mover } from "../base/widgets.js";

// What of a state the ray depends on.
const MATTERS = ["equation", "parameters", "extent", "clip", "camera", "complex"];

const vector = (v) => `(${v.map((x) => short(x, 6)).join(", ")})`;

/** Numbers as they are counted, without marks for thousands. */
const plain = (place) =>
    Object.fromEntries(Object.entries(place).map(([key, value]) => [key, String(value)]));

/** The rows "name, value" of what is known of a hit. */
function factsOf(pick, place, complex, text) {
    const facts = [["ray.pixel", text("ray.pixel.of", plain(place))]];
    const width = short(pick.tHi - pick.tLo, 2);
    if (pick.state === "hit")
        facts.push(
            ["ray.position", vector(pick.position)],
            ["ray.normal", vector(pick.normal)],
            ["ray.multiplicity", String(pick.multiplicity)],
            [complex ? "ray.t.complex" : "ray.t", whole(pick.t)],
            [
                "ray.enclosure",
                `${between(pick.tLo, pick.tHi)}, ${text("ray.wide", { width })}`,
            ],
        );
    return facts;
}

function coefficientsOf(pick, imaginary) {
    return pick.polynomial.map((value, k) => {
        const i = imaginary[k]
            ? ` ${imaginary[k] < 0 ? "−" : "+"} ${short(Math.abs(imaginary[k]), 6)} i`
            : "";
        return element("li", {}, `p${lowered(k)} = ${whole(value)}${i}`);
    });
}

const verdictOf = (pick, { complex }) => `ray.verdict.${complex ? "complex." : ""}${pick.state}`;

class Panel {
    #moving = false;

    constructor(room, { painter, store, text, canvas, line }) {
        Object.assign(this, { painter, store, text, line });
        this.ask = latest(() => this.#ask());
        this.place = new Place(canvas, () => this.#changed());
        this.search = new Search(text);
        this.steps = new Steps(text);
        const move = mover(store);
        this.plane = new Plane(text, (sector) => move({ complex: complexWith(store.get(), sector) }));
        this.#build(room);
        this.section = room.closest("details");
        this.section.addEventListener("toggle", () => this.#changed());
        store.subscribe((state, { changed, moving }) => {
            const resized =
                changed.has("picture") &&
                state.picture.stage !== "moving" &&
                this.place.resize(state.picture);
            if (resized) this.#changed();
            const rests = changed.size === 0 && !moving;
            if (!rests && !MATTERS.some((key) => changed.has(key))) return;
            if (changed.has("complex")) this.plane.setSector(sectorOf(state));
            this.#changed(moving);
        });
    }

    #build(room) {
        const { text } = this;
        const field = (axis) =>
            element("input", {
                type: "number",
                min: 0,
                step: 1,
                change: () => this.#typed(),
                "data-axis": axis,
            });
        this.x = field("x");
        this.y = field("y");
        this.hint = element("p", {}, text("ray.hint"));
        this.verdict = element("p", { class: "ray-verdict", role: "status" });
        this.facts = element("dl", { class: "ray-facts" });
        this.coefficients = element("ol", { class: "ray-coefficients" });
        this.realPart = element("p", { class: "ray-said" }, text("ray.realpart"));
        const part = (key, ...nodes) =>
            element("section", { class: "ray-part" }, element("h3", {}, text(key)), ...nodes);
        const list = element(
            "details",
            {},
            element("summary", {}, text("ray.coefficients")),
            this.coefficients,
        );
        this.stepsPart = part("ray.methods", this.steps.node);
        this.planePart = part("ray.plane", this.plane.node);
        this.parts = element(
            "div",
            {},
            part("ray.polynomial", this.realPart, this.search.node, list),
            this.stepsPart,
        );
        room.append(
            this.hint,
            element(
                "div",
                { class: "ray-place" },
                button(text("ray.middle"), () => this.place.move()),
                labelled("x", this.x),
                labelled("y", this.y),
                button("✕", () => this.place.clear(), {
                    class: "sign",
                    "aria-label": text("ray.clear"),
                    title: text("ray.clear"),
                }),
            ),
            this.verdict,
            this.facts,
            this.planePart,
            this.parts,
        );
        this.#hide("");
    }

    #typed() {
        if (this.x.value !== "" && this.y.value !== "")
            this.place.move(Number(this.x.value), Number(this.y.value));
    }

    #changed(moving = false) {
        this.#moving = moving; // while it does, slower questions wait
        if (moving && narrow.matches && !this.isOpen && this.place.get()) this.place.clear();
        else this.ask();
    }

    /** Are the answers seen? */
    get isOpen() {
        return this.section.open && (!narrow.matches || document.body.classList.contains("open"));
    }

    /** Asks now, since they are seen. */
    look() {
        this.#changed();
    }

    #hide(verdict) {
        this.verdict.textContent = verdict;
        this.facts.replaceChildren();
        this.parts.hidden = true;
        this.planePart.hidden = true;
    }

    /** All questions about the place as it is now; none while nobody sees the answers. */
    async #ask() {
        const place = this.place.get();
        this.place.visible = this.isOpen || narrow.matches;
        if (!this.isOpen && place && narrow.matches) return this.#tellInLine(place);
        this.line.hidden = true;
        if (!this.isOpen) return undefined;
        this.hint.hidden = place !== null;
        if (!place) return this.#hide("");
        const state = this.store.get();
        try {
            await this.#fill(state, place, this.#moving);
        } catch (error) {
            this.#hide(this.text("ray.failed", { reason: error.message }));
        }
    }

    /** The hit, in one line. */
    async #tellInLine(place) {
        const { text } = this, state = this.store.get();
        const pick = await this.painter.ask("pick", state, place).catch(() => null);
        const position = pick?.state === "hit" ? pick.position.map((x) => Number(x.toPrecision(4))) : null;
        if (position) this.line.textContent = text("ray.line", { position: vector(position) });
        else this.line.textContent = text(pick ? verdictOf(pick, state) : "ray.outside");
        this.line.hidden = false;
    }

    async #fill(state, place, moving) {
        const pick = await this.painter.ask("pick", state, place);
        for (const axis of ["x", "y"])
            if (document.activeElement !== this[axis]) this[axis].value = place[axis];
        if (!pick) return this.#hide(this.text("ray.outside"));
        this.#tell(pick, place, state);
        const roots = await this.painter.ask("complexRoots", state, place);
        this.planePart.hidden = roots.length === 0;
        this.plane.show(roots, [pick.ray.tMin, pick.ray.tMax], sectorOf(this.store.get()));
        if (moving) return undefined;
        const isolated = await this.painter.ask("isolate", state, place);
        const runs = {};
        for (const method of METHODS) runs[method] = await this.painter.ask("refine", state, place, method);
        this.parts.hidden = false;
        this.realPart.hidden = !state.complex;
        const root = runs.default?.root ?? null;
        this.stepsPart.hidden = root === null;
        this.search.show(isolated, root);
        if (root !== null) this.steps.show(runs, isolated, root);
        return undefined;
    }

    #tell(pick, place, state) {
        const { text } = this;
        this.verdict.textContent = text(verdictOf(pick, state));
        const rows = factsOf(pick, place, state.complex, text);
        this.facts.replaceChildren(
            ...rows.flatMap(([name, value]) => [element("dt", {}, text(name)), element("dd", {}, value)]),
        );
        this.coefficients.replaceChildren(...coefficientsOf(pick, state.complex?.imaginary ?? {}));
    }
}

/** Puts the panel into an element, which is part of one that unfolds; canvas: the picture; line: over it. */
export function mount(room, services) {
    return new Panel(room, services);
}
