// search.js - the polynomial along the ray and how its roots were isolated, cell by cell (after ZEROFIND).
import { convexHull, restrict } from "./bernstein.js";
import { anchorOf, linear, ofValues } from "./axis.js";
import { element, svg } from "../base/dom.js";
import { between, short } from "../base/number.js";
import { Plot, area, band, line, marks, zero } from "./plot.js";
import { stepper } from "../base/widgets.js";

const DEEPEST = 12; // row of cells below the plot, from 0; smaller cells share it
const ROW = 9; // pixels
const SIGNS = { "-1": "−", 0: "0", 1: "+", 2: "?" };

const signsOf = (cell) => Array.from(cell.signs ?? [], (sign) => SIGNS[sign]).join("");

/** What became of a cell: its class and the last part of its text's key. */
function fateOf(cell) {
    if (cell.variations === 0) return "empty";
    if (signsOf(cell).includes("?")) return "open";
    return cell.variations === 1 ? "isolates" : "cut";
}

/** In which row below the plot a cell stands: one for each halving. */
function levelOf(cell, chord) {
    const halvings = Math.round(Math.log2((chord[1] - chord[0]) / (cell.hi - cell.lo)));
    return Math.max(0, Math.min(DEEPEST, halvings || 0));
}

/** The cells that were looked at so far; step 0: all of them. */
function rowsOfCells(cells, step, chord, shift) {
    return (frame) =>
        cells.slice(0, step || cells.length).map((cell, i) => {
            const from = Math.max(frame.left, frame.x(Math.max(cell.lo, chord[0]) - shift));
            const to = Math.min(frame.right, frame.x(Math.min(cell.hi, chord[1]) - shift));
            return svg("rect", {
                class: `cell cell-${fateOf(cell)}${i + 1 === step ? " cell-now" : ""}`,
                x: Math.min(from, frame.right - 2),
                y: frame.strip.top + ROW * levelOf(cell, chord),
                width: Math.max(2, to - from),
                height: ROW - 2,
            });
        });
}

/** The figure of the search. */
export class Search {
    #step = 0;
    #report = null;

    constructor(text) {
        this.text = text;
        this.plot = new Plot({ height: 250 });
        const words = { back: text("ray.back"), on: text("ray.on") };
        this.steps = stepper(text("ray.cells"), words, (step) => this.#go(step));
        this.said = element("p", { class: "ray-said", "aria-live": "polite" });
        this.node = element("figure", {}, this.plot.node, this.steps.node, this.said);
    }

    /** report: what the engine's isolate() returns; root: the first one's t, or null. */
    show(report, root) {
        this.#report = { ...report, root };
        this.steps.range.max = report.cells.length;
        this.steps.node.hidden = report.cells.length === 0;
        this.#go(0);
    }

    #go(step) {
        this.#step = Math.min(step, this.#report.cells.length);
        this.steps.range.value = this.#step;
        this.said.textContent = this.#sentence();
        this.steps.range.setAttribute("aria-valuetext", this.said.textContent);
        this.#draw();
    }

    #sentence() {
        const { cells, hits } = this.#report;
        if (cells.length === 0) return this.text("ray.cells.none", { roots: hits.length });
        if (this.#step === 0) return this.text("ray.cells.all", { cells: cells.length, roots: hits.length });
        const cell = cells[this.#step - 1];
        const what = this.text(`ray.cell.${fateOf(cell)}`);
        const who = this.text(`ray.engine.${cell.engine}`);
        return this.text("ray.cell", {
            number: this.#step,
            cells: cells.length,
            lo: short(cell.lo, 8),
            hi: short(cell.hi, 8),
            signs: signsOf(cell) || "–",
            variations: cell.variations,
            what,
            who,
        });
    }

    /** Control points of the cell that is looked at, or of the whole chord. */
    #polygon() {
        const { cells, hull } = this.#report;
        if (this.#step === 0 || hull.length < 2) return hull;
        const cell = cells[this.#step - 1];
        const [lo, hi] = [hull[0][0], hull[hull.length - 1][0]];
        const values = hull.map((point) => point[1]);
        return restrict(values, lo, hi, Math.max(lo, cell.lo), Math.min(hi, cell.hi));
    }

    #draw() {
        const { cells, brackets, hits, hull, curve, root } = this.#report;
        const chord = [curve[0][0], curve[curve.length - 1][0]];
        const shift = anchorOf(...chord);
        const moved = (points) => points.map(([t, value]) => [t - shift, value]);
        const margin = 0.03 * (chord[1] - chord[0]);
        const { scale, even } = ofValues([...curve, ...hull].map((point) => point[1]));
        const roots = hits.filter((hit) => hit.state === "hit").map((hit) => [hit.t - shift, 0]);
        const polygon = moved(this.#polygon());
        const rows = Math.max(0, ...cells.map((cell) => 1 + levelOf(cell, chord)));
        this.plot.strip = ROW * rows + 4;
        this.plot.draw({
            about: this.text("ray.plot.about", { chord: between(...chord), roots: roots.length }),
            x: {
                scale: linear(chord[0] - margin - shift, chord[1] + margin - shift),
                label: this.text("ray.axis.t") + (shift ? ` − ${short(shift, 15)}` : ""),
            },
            y: { scale, label: this.text(even ? "ray.axis.p" : "ray.axis.plog") },
            layers: [
                ...brackets.map(({ lo, hi }) => band(lo - shift, hi - shift, "plot-bracket")),
                area(convexHull(polygon), "plot-hull"),
                zero,
                line(polygon, "plot-control"),
                marks(polygon, "plot-control", 2.5),
                line(moved(curve), "plot-curve"),
            ],
            outside: [
                marks(roots, "plot-root"),
                marks(Number.isFinite(root) ? [[root - shift, 0]] : [], "plot-first", 5),
                rowsOfCells(cells, this.#step, chord, shift),
            ],
        });
    }
}
