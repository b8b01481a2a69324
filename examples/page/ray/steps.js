// steps.js - how a method goes to the root inside its bracket, step by step, and what each method costs.
import { anchorOf, linear, log, ofValues } from "./axis.js";
import { samples } from "./bernstein.js";
import { element } from "../base/dom.js";
import { short, whole } from "../base/number.js";
import { Plot, band, line, marks, numbered, zero } from "./plot.js";
import { freshId, stepper } from "../base/widgets.js";

export const METHODS = ["default", "brent", "regula-falsi", "bisection"];

const SAMPLES = 120;
const MOST_SHOWN = 64; // evaluations on the abscissa: bisection's, about; regula falsi may need many more

/** The curve from lo to hi. */
function curveIn(hull, points, lo, hi) {
    const values = hull.map((point) => point[1]);
    const drawn = samples(values, hull[0][0], hull[hull.length - 1][0], lo, hi, SAMPLES);
    return [...drawn, ...points.map(({ t, value }) => [t, value])].sort((a, b) => a[0] - b[0]);
}

/** What to show: the bracket, or where there is none, all that was evaluated. */
function windowOf(bracket, runs) {
    const places = [];
    for (const { points, root } of Object.values(runs)) places.push(root, ...points.map((point) => point.t));
    if (bracket) places.push(bracket.lo, bracket.hi);
    const lo = Math.min(...places);
    const hi = Math.max(...places);
    const margin = Math.max(0.04 * (hi - lo), 2 ** -50 * Math.max(Math.abs(lo), Math.abs(hi)));
    return [lo - margin, hi + margin];
}

/** The figure of the methods. */
export class Steps {
    #step = 0;
    #method = METHODS[0];
    #report = null;

    constructor(text) {
        this.text = text;
        this.plot = new Plot({ height: 240 });
        this.course = new Plot({ height: 220 });
        this.rows = element("tbody");
        const words = { back: text("ray.back"), on: text("ray.on") };
        this.steps = stepper(text("ray.iterates"), words, (step) => this.#go(step));
        this.said = element("p", { class: "ray-said", "aria-live": "polite" });
        const heads = ["ray.method", "ray.evaluations", "ray.root"].map((key) =>
            element("th", { scope: "col" }, text(key)),
        );
        const table = element(
            "table",
            { class: "ray-methods" },
            element("thead", {}, element("tr", {}, ...heads)),
            this.rows,
        );
        this.node = element(
            "figure",
            {},
            table,
            this.plot.node,
            this.steps.node,
            this.said,
            this.course.node,
        );
    }

    /** runs: by method, what the engine's refine() returns; isolated: what isolate() returned; root: t. */
    show(runs, isolated, root) {
        const bracket = isolated.brackets.find(({ lo, hi }) => lo <= root && root <= hi);
        this.#report = { runs, bracket, hull: isolated.hull, root };
        this.#fillTable();
        this.#choose(this.#method);
        this.#drawCourse();
    }

    #fillTable() {
        const group = freshId("method");
        const rows = METHODS.map((method) => {
            const { evaluations, root } = this.#report.runs[method];
            const pick = element("input", { type: "radio", name: group, value: method });
            pick.checked = method === this.#method;
            pick.addEventListener("change", () => this.#choose(method));
            const name = element(
                "label",
                { class: `method-${method}` },
                pick,
                ` ${this.text(`ray.method.${method}`)}`,
            );
            const count = element("td", { class: "ray-number" }, String(evaluations));
            return element(
                "tr",
                {},
                element("td", {}, name),
                count,
                element("td", { class: "ray-number" }, short(root, 12)),
            );
        });
        this.rows.replaceChildren(...rows);
    }

    #choose(method) {
        this.#method = method;
        const { points } = this.#report.runs[method];
        this.steps.range.max = points.length;
        this.steps.node.hidden = points.length === 0;
        this.#go(points.length);
    }

    #go(step) {
        this.#step = step;
        this.steps.range.value = step;
        this.said.textContent = this.#sentence();
        this.steps.range.setAttribute("aria-valuetext", this.said.textContent);
        this.#drawBracket();
    }

    #sentence() {
        const { runs, root } = this.#report;
        const { points } = runs[this.#method];
        if (points.length === 0) return this.text("ray.iterates.none");
        if (this.#step === 0) return this.text("ray.iterates.begin");
        const { t, value, engine } = points[this.#step - 1];
        return this.text("ray.iterate", {
            number: this.#step,
            count: points.length,
            t: whole(t),
            value: short(value, 3),
            distance: short(Math.abs(t - root), 2),
            who: this.text(`ray.engine.${engine}`),
        });
    }

    #drawBracket() {
        const { runs, bracket, hull, root } = this.#report;
        const { points } = runs[this.#method];
        const [lo, hi] = windowOf(bracket, { one: runs[this.#method] });
        const shift = anchorOf(lo, hi);
        const part = curveIn(hull, points, lo, hi).map(([t, value]) => [t - shift, value]);
        const { scale, even } = ofValues(part.map((point) => point[1]));
        const seen = points.slice(0, this.#step).map(({ t, value }) => [t - shift, value]);
        const kind = `method-${this.#method}`;
        this.plot.draw({
            about: this.text("ray.steps.about", {
                method: this.text(`ray.method.${this.#method}`),
                count: points.length,
            }),
            x: {
                scale: linear(lo - shift, hi - shift),
                label: this.text("ray.axis.t") + (shift ? ` − ${short(shift, 15)}` : ""),
            },
            y: { scale, label: this.text(even ? "ray.axis.p" : "ray.axis.plog") },
            layers: [
                ...(bracket ? [band(bracket.lo - shift, bracket.hi - shift, "plot-bracket")] : []),
                zero,
                line(part, "plot-curve"),
            ],
            outside: [
                marks([[root - shift, 0]], "plot-first", 5),
                numbered(seen, kind),
                marks(seen.slice(-1), `plot-now ${kind}`, 6),
            ],
        });
    }

    #drawCourse() {
        const { runs, root } = this.#report;
        const distances = {};
        for (const method of METHODS)
            distances[method] = runs[method].points
                .map(({ t }, i) => [i + 1, Math.abs(t - root)])
                .filter(([i, distance]) => distance > 0 && i <= MOST_SHOWN);
        const all = Object.values(distances).flat();
        this.course.node.hidden = all.length === 0;
        if (all.length === 0) return;
        const sizes = all.map((point) => point[1]);
        this.course.draw({
            about: this.text("ray.course.about"),
            x: {
                scale: linear(0, Math.max(10, ...all.map((point) => point[0])) + 1),
                label: this.text("ray.axis.number"),
            },
            y: { scale: log(Math.min(...sizes), Math.max(...sizes)), label: this.text("ray.axis.distance") },
            layers: METHODS.map((method) => line(distances[method], `method-${method}`)),
            outside: METHODS.map((method) => marks(distances[method], `method-${method}`, 2.5)),
        });
    }
}
