// plot.js - a plot as SVG: a frame with labelled axes, and layers that draw in it.
//
// A layer is a function of the frame that returns SVG nodes; frame.x and frame.y bring values to pixels of
// the element, so that letters have the same size on a telephone and on a wide screen.  Colours and strokes
// are those of ray.css.
import { element, svg } from "../base/dom.js";

const LETTER = 6.3; // pixels, of 12 pixels high
const ROW = 28; // pixels from one tick of the ordinate to the next, at least
const BELOW = 40; // pixels for the abscissa's ticks and its label

const FAR = 4000; // pixels: what is farther out is drawn there, behind the clip

const near = (pixels) => Math.max(-FAR, Math.min(FAR, pixels));

function frameOf(width, height, strip, x, y) {
    const rows = y.scale.ticks(Math.max(2, Math.floor((height - BELOW) / ROW)));
    const left = 22 + LETTER * Math.max(2, ...rows.map((tick) => tick.name.length));
    const frame = {
        left,
        top: 10,
        width: Math.max(60, width - left - 12),
        height: height - BELOW - 10,
        rows,
    };
    frame.columns = x.scale.ticks(Math.max(2, Math.floor(frame.width / 55)));
    frame.bottom = frame.top + frame.height;
    frame.right = frame.left + frame.width;
    frame.strip = { top: height + 2, height: strip };
    frame.x = (value) => near(frame.left + frame.width * x.scale.at(value));
    frame.y = (value) => near(frame.bottom - frame.height * y.scale.at(value));
    return frame;
}

const word = (x, y, text, attributes) => svg("text", { x, y, ...attributes }, text);

function ordinate(frame, label) {
    const middle = frame.top + frame.height / 2;
    const nodes = [
        word(0, 0, label, {
            class: "plot-label",
            "text-anchor": "middle",
            transform: `translate(12 ${middle}) rotate(-90)`,
        }),
    ];
    for (const tick of frame.rows) {
        const y = frame.y(tick.at);
        nodes.push(svg("path", { class: "plot-grid", d: `M${frame.left} ${y}H${frame.right}` }));
        nodes.push(word(frame.left - 5, y + 4, tick.name, { "text-anchor": "end" }));
    }
    return nodes;
}

function abscissa(frame, label) {
    const nodes = [
        word(frame.left + frame.width / 2, frame.bottom + 34, label, {
            class: "plot-label",
            "text-anchor": "middle",
        }),
    ];
    for (const tick of frame.columns) {
        const x = frame.x(tick.at);
        nodes.push(svg("path", { class: "plot-grid", d: `M${x} ${frame.top}V${frame.bottom}` }));
        nodes.push(word(x, frame.bottom + 16, tick.name, { "text-anchor": "middle" }));
    }
    return nodes;
}

/** An element that holds a plot, draws it when told, and again when its width changes. */
export class Plot {
    #content = null;

    /** height of the plot with its axes; strip: further pixels below, for layers that want them. */
    constructor({ height = 260, strip = 0 } = {}) {
        this.height = height;
        this.strip = strip;
        this.picture = svg("svg", { class: "plot", role: "img" });
        this.node = element("div", { class: "plot-room" }, this.picture);
        let width = 0;
        new ResizeObserver(() => {
            if (this.node.clientWidth === width) return;
            width = this.node.clientWidth;
            this.#paint();
        }).observe(this.node);
    }

    /** content: { about, x: { scale, label }, y: { scale, label }, layers, outside }; about is what a screen
     * reader says; layers are clipped to the frame, outside are not. */
    draw(content) {
        this.#content = content;
        this.#paint();
    }

    #paint() {
        const width = this.node.clientWidth;
        if (!this.#content || width === 0) return;
        const { about, x, y, layers, outside = [] } = this.#content;
        const frame = frameOf(width, this.height, this.strip, x, y);
        const inside = svg("svg", {
            x: frame.left,
            y: frame.top,
            width: frame.width,
            height: frame.height,
            viewBox: `${frame.left} ${frame.top} ${frame.width} ${frame.height}`,
        });
        inside.append(...layers.flatMap((layer) => layer(frame)));
        const all = this.height + this.strip;
        for (const [name, value] of Object.entries({ width, height: all, viewBox: `0 0 ${width} ${all}` }))
            this.picture.setAttribute(name, value);
        this.picture.setAttribute("aria-label", about);
        const border = { class: "plot-frame", x: frame.left, y: frame.top, width: frame.width };
        this.picture.replaceChildren(
            ...ordinate(frame, y.label),
            ...abscissa(frame, x.label),
            inside,
            svg("rect", { ...border, height: frame.height }),
            ...outside.flatMap((layer) => layer(frame)),
        );
    }
}

// ---- layers ----

const path = (frame, points) =>
    points.map(([x, y], i) => `${i ? "L" : "M"}${frame.x(x).toFixed(2)} ${frame.y(y).toFixed(2)}`).join("");

/** A line through points [x, y]. */
export const line = (points, kind) => (frame) =>
    points.length ? [svg("path", { class: `plot-line ${kind}`, d: path(frame, points) })] : [];

/** An area with straight edges; they are drawn in parts, since a scale may bend them. */
export function area(corners, kind) {
    const PARTS = 24;
    const points = corners.flatMap(([x, y], i) => {
        const [u, v] = corners[(i + 1) % corners.length];
        return Array.from({ length: PARTS }, (_, k) => [
            x + ((u - x) * k) / PARTS,
            y + ((v - y) * k) / PARTS,
        ]);
    });
    return (frame) =>
        points.length ? [svg("path", { class: `plot-area ${kind}`, d: `${path(frame, points)}Z` })] : [];
}

/** From one abscissa to another, over the whole height; however narrow, it can be seen. */
export const band = (lo, hi, kind) => (frame) => {
    const from = frame.x(lo);
    const wide = Math.max(2, frame.x(hi) - from);
    return [
        svg("rect", { class: `plot-band ${kind}`, x: from, y: frame.top, width: wide, height: frame.height }),
    ];
};

/** The line y = 0. */
export const zero = (frame) => [
    svg("path", { class: "plot-zero", d: `M${frame.left} ${frame.y(0)}H${frame.right}` }),
];

/** Marks at points [x, y]. */
export const marks =
    (points, kind, radius = 3.5) =>
    (frame) =>
        points.map(([x, y]) =>
            svg("circle", { class: `plot-mark ${kind}`, cx: frame.x(x), cy: frame.y(y), r: radius }),
        );

/** Marks with their numbers above or below, as far as there is room. */
export const numbered = (points, kind) => (frame) => {
    const taken = [];
    const numbers = points.flatMap(([x, y], i) => {
        const u = frame.x(x);
        const base = frame.y(y);
        for (const v of [base - 7, base + 17]) {
            const free = taken.every(([p, q]) => Math.abs(p - u) > 14 || Math.abs(q - v) > 11);
            if (!free || v < frame.top + 9 || v > frame.bottom - 2) continue;
            taken.push([u, v]);
            return [
                svg(
                    "text",
                    { class: `plot-number ${kind}`, x: u, y: v, "text-anchor": "middle" },
                    String(i + 1),
                ),
            ];
        }
        return [];
    });
    return [...marks(points, kind)(frame), ...numbers];
};
