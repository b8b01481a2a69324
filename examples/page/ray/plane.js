// plane.js - all complex roots of a ray's polynomial in the plane: proved boxes with their multiplicities,
// the sector of complex space laid over them, the root that is seen marked.
import { anchorOf, linear } from "./axis.js";
import { element, svg } from "../base/dom.js";
import { short } from "../base/number.js";
import { planeView } from "./planeview.js";
import { WedgeHandles, wedgeAreas } from "./wedge.js";
import { button, labelled } from "../base/widgets.js";

const HEIGHT = 300; // pixels
const SMALLEST = 5; // pixels: a box smaller than that is a mark only
const ZOOM_LEAST = -6; // of the slider, powers of 2
const ZOOM_MOST = 60;
const BEYOND = 2.5; // times the farthest end of the chord: roots farther out are not in the first view

const widest = ({ box }) => Math.max(box[1] - box[0], box[3] - box[2]);

/** A root as text. */
function nameOf({ re, im, real }) {
    if (real) return short(re, 8);
    return `${short(re, 8)} ${im < 0 ? "−" : "+"} ${short(Math.abs(im), 8)} i`;
}

function axes(view) {
    const range = (of, a, b) => {
        const [lo, hi] = [of(a), of(b)];
        const shift = anchorOf(lo, hi);
        return {
            shift,
            ticks: linear(lo - shift, hi - shift).ticks(Math.max(2, Math.floor(Math.abs(b - a) / 75))),
        };
    };
    const below = range(view.re, 30, view.width - 20);
    const beside = range(view.im, view.height - 30, 28);
    const nodes = [];
    for (const { at, name } of below.ticks) {
        const x = view.x(at + below.shift);
        nodes.push(svg("path", { class: "plot-grid", d: `M${x} 0V${view.height}` }));
        nodes.push(svg("text", { x, y: view.height - 5, "text-anchor": "middle" }, name));
    }
    for (const { at, name } of beside.ticks) {
        const y = view.y(at + beside.shift);
        nodes.push(svg("path", { class: "plot-grid", d: `M0 ${y}H${view.width}` }));
        nodes.push(svg("text", { x: 4, y: y - 3 }, name));
    }
    const y = view.y(0);
    if (y > -1 && y < view.height + 1)
        nodes.push(svg("path", { class: "plot-zero", d: `M0 ${y}H${view.width}` }));
    const x = view.x(0);
    if (x > -1 && x < view.width + 1)
        nodes.push(svg("path", { class: "plot-zero", d: `M${x} 0V${view.height}` }));
    const title = (what, shift) => (shift ? `${what} − ${short(shift, 15)}`.replace("− −", "+ ") : what);
    const ends = { class: "plot-label", "text-anchor": "end", x: view.width - 6 };
    nodes.push(svg("text", { ...ends, y: view.height - 20 }, title("Re t", below.shift)));
    nodes.push(svg("text", { class: "plot-label", x: 4, y: 14 }, title("Im t", beside.shift)));
    return nodes;
}

/** A box as far as it is in view; a line where it has no height. */
function rectangle(view, [reLo, reHi, imLo, imHi]) {
    const within = (pixels, size) => Math.max(-2, Math.min(size + 2, pixels));
    const [left, right] = [reLo, reHi].map((re) => within(view.x(re), view.width));
    const [top, bottom] = [imHi, imLo].map((im) => within(view.y(im), view.height));
    const size = { width: Math.max(1, right - left), height: Math.max(1, bottom - top) };
    return svg("rect", { class: "root-box", x: left, y: top, ...size });
}

function boxOf(view, root, selected) {
    const [reLo, reHi, imLo, imHi] = root.box;
    const [x, y] = [view.x(root.re), view.y(root.im)];
    const far = 3 * (view.width + view.height);
    if (Math.abs(x) > far || Math.abs(y) > far) return [];
    const state = `${root.real ? " root-real" : ""}${root.chosen ? " root-chosen" : ""}`;
    const nodes = [];
    if (Math.max(reHi - reLo, imHi - imLo) * view.scale > SMALLEST) nodes.push(rectangle(view, root.box));
    if (root.chosen) nodes.push(svg("circle", { class: "root-ring", cx: x, cy: y, r: 9 }));
    nodes.push(svg("circle", { class: `root${state}`, cx: x, cy: y, r: selected ? 5 : 4 }));
    const notes = [];
    if (root.multiplicity > 1) notes.push(`×${root.multiplicity}`);
    if (selected) notes.push(`↔ ${widest(root) === 0 ? "0" : short(widest(root), 2)}`);
    const atRight = x > view.width - 90;
    const place = { x: x + (atRight ? -12 : 12), y: y + 14, "text-anchor": atRight ? "end" : "start" };
    if (notes.length) nodes.push(svg("text", { class: "root-note", ...place }, notes.join("  ")));
    return nodes;
}

/** The figure of the roots. */
export class Plane {
    #roots = [];
    #chord = [0, 1];
    #sector = { sigma: 0, delta: 0 };
    #selected = 0;
    #followed = true; // the root that is seen is the selected one, until somebody selects another

    /** onSector(sector): an edge of the wedge is moved. */
    constructor(text, onSector) {
        this.text = text;
        this.back = svg("g", {});
        this.picture = svg("svg", { class: "plot plane", role: "group", height: HEIGHT }, this.back);
        const toPoint = (event) => {
            const box = this.picture.getBoundingClientRect();
            return { x: event.clientX - box.left, y: event.clientY - box.top };
        };
        this.handles = new WedgeHandles({ text, onChange: onSector, toPoint });
        this.picture.append(this.handles.node);
        this.room = element("div", { class: "plot-room" }, this.picture);
        const zoom = { type: "range", min: ZOOM_LEAST, max: ZOOM_MOST, step: 0.25, value: 0 };
        this.zoom = element("input", zoom);
        this.zoom.addEventListener("input", () => this.#paint());
        this.said = element("p", { class: "ray-said" });
        this.list = element("ul", { class: "roots" });
        const note = element("p", { class: "ray-said" }, text("ray.plane.note"));
        this.node = element(
            "figure",
            {},
            this.room,
            labelled(text("ray.zoom"), this.zoom, "ray-zoom"),
            this.said,
            this.list,
            note,
        );
        new ResizeObserver(() => this.#paint()).observe(this.room);
    }

    /** roots: what the engine's complexRoots() returns; chord: from which t to which one the ray is seen. */
    show(roots, chord, sector) {
        const chosen = roots.findIndex((root) => root.chosen);
        if (roots.length !== this.#roots.length) this.#followed = true;
        if (this.#followed || this.#selected >= roots.length) this.#selected = Math.max(0, chosen);
        this.#roots = roots;
        this.#chord = chord;
        this.setSector(sector);
        this.#say();
    }

    setSector(sector) {
        this.#sector = sector;
        this.#paint();
    }

    #select(i) {
        this.#followed = false;
        this.#selected = i;
        this.#say();
        this.#paint();
    }

    #say() {
        const roots = this.#roots;
        const count = roots.reduce((sum, root) => sum + root.multiplicity, 0);
        const real = roots.reduce((sum, root) => sum + (root.real ? root.multiplicity : 0), 0);
        const chosen = roots.find((root) => root.chosen);
        const seen = chosen
            ? this.text("ray.plane.seen", { root: nameOf(chosen) })
            : this.text("ray.plane.unseen");
        const far = roots.length - this.#inReach().length;
        const away = far > 0 ? ` ${this.text("ray.plane.far", { count: far })}` : "";
        this.said.textContent = `${this.text("ray.plane.count", { count, real })} ${seen}${away}`;
        this.picture.setAttribute("aria-label", this.said.textContent);
        const focused = this.list.contains(document.activeElement);
        const rows = roots.map((root, i) => {
            const multiple = root.multiplicity > 1 ? ` ×${root.multiplicity}` : "";
            const row = button(`${nameOf(root)}${multiple}`, () => this.#select(i), {
                "aria-pressed": String(i === this.#selected),
                class: root.chosen ? "root-row root-row-chosen" : "root-row",
            });
            row.append(element("small", {}, ` ↔ ${short(widest(root), 2)}`));
            return element("li", {}, row);
        });
        this.list.replaceChildren(...rows);
        if (focused) this.list.querySelectorAll("button")[this.#selected]?.focus();
    }

    #inReach() {
        const reach = BEYOND * this.#chord[1];
        return this.#roots.filter(({ re, im }) => Math.hypot(re, im) <= reach);
    }

    #paint() {
        const width = this.room.clientWidth;
        if (width === 0 || this.#roots.length === 0) return;
        const points = [{ re: 0, im: 0 }, { re: this.#chord[1], im: 0 }, ...this.#inReach()];
        const fixed = this.#roots[this.#selected];
        const view = planeView(width, HEIGHT, points, fixed, 2 ** Number(this.zoom.value));
        this.picture.setAttribute("width", width);
        this.picture.setAttribute("viewBox", `0 0 ${width} ${HEIGHT}`);
        const range = this.#chord
            .filter((t) => t > 0)
            .map((t) => {
                const ring = { class: "plane-chord", cx: view.x(0), cy: view.y(0), r: t * view.scale };
                return ring.r < 1e5 ? svg("circle", ring) : null;
            });
        this.back.replaceChildren(
            ...wedgeAreas(view, this.#sector),
            ...axes(view),
            ...range.filter(Boolean),
            ...this.#roots.flatMap((root, i) => boxOf(view, root, i === this.#selected)),
        );
        this.handles.place(view, this.#sector);
    }
}
