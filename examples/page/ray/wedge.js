// wedge.js - the sector of complex space over the plane of roots: sigma .. sigma + delta and its mirror
// image, with a handle on each edge that can be dragged, or moved by the arrow keys.

import { svg } from "../base/dom.js";
import { short } from "../base/number.js";
import { rayIn, wedgeIn } from "./planeview.js";
import { toDegrees, toRadians, withFirstEdge, withLastEdge } from "../complex/sector.js";

const KEY_STEP = 1; // degrees; with shift a tenth
const KEYS = { ArrowUp: 1, ArrowRight: -1, ArrowDown: -1, ArrowLeft: 1, PageUp: 10, PageDown: -10 };

const EDGES = [
    { name: "sigma", share: 0.32, angle: (sector) => sector.sigma, move: withFirstEdge },
    { name: "delta", share: 0.5, angle: (sector) => sector.sigma + sector.delta, move: withLastEdge },
];

const pathOf = (view, points) =>
    points.map(([re, im], i) => `${i ? "L" : "M"}${view.x(re).toFixed(1)} ${view.y(im).toFixed(1)}`).join("");

/** The areas and edges of the sector. */
export function wedgeAreas(view, { sigma, delta }) {
    const nodes = [];
    for (const side of [1, -1]) {
        const corners = wedgeIn(view, sigma, sigma + delta, side);
        const kind = side > 0 ? "wedge" : "wedge wedge-mirror";
        if (corners.length > 2) nodes.push(svg("path", { class: kind, d: `${pathOf(view, corners)}Z` }));
        for (const angle of [sigma, sigma + delta]) {
            const span = rayIn(view, side * angle);
            if (!span) continue;
            const ends = span.map((r) => [r * Math.cos(angle), side * r * Math.sin(angle)]);
            nodes.push(svg("path", { class: `${kind} wedge-edge`, d: pathOf(view, ends) }));
        }
    }
    return nodes;
}

/** Both handles; they live as long as the plane, so that a drag survives each new picture of it. */
export class WedgeHandles {
    #view = null;
    #sector = null;
    #dragged = null;

    /** onChange(sector): somebody moves an edge; toPoint(event): where the pointer is, in pixels of the
     * view. */
    constructor({ text, onChange, toPoint }) {
        this.onChange = onChange;
        this.toPoint = toPoint;
        this.node = svg("g", {});
        this.handles = EDGES.map((edge) => this.#make(edge, text(`ray.handle.${edge.name}`)));
        this.node.append(...this.handles);
    }

    #make(edge, label) {
        const handle = svg(
            "g",
            { class: "wedge-handle", tabindex: 0, role: "slider", "aria-label": label },
            svg("circle", { class: "wedge-reach", r: 20 }),
            svg("circle", { class: "wedge-grip", r: 7 }),
            svg("text", { x: 11, y: -9 }, edge.name === "sigma" ? "σ" : "σ+δ"),
        );
        handle.setAttribute("aria-valuemin", 0);
        handle.setAttribute("aria-valuemax", 180);
        handle.addEventListener("pointerdown", (event) => {
            this.#dragged = edge;
            handle.setPointerCapture(event.pointerId);
            event.preventDefault();
            handle.focus();
        });
        handle.addEventListener("pointermove", (event) => this.#dragged === edge && this.#drag(edge, event));
        for (const end of ["pointerup", "pointercancel"])
            handle.addEventListener(end, () => (this.#dragged = null));
        handle.addEventListener("keydown", (event) => this.#press(edge, event));
        return handle;
    }

    #drag(edge, event) {
        const { x, y } = this.toPoint(event);
        const angle = Math.atan2(this.#view.im(y), this.#view.re(x));
        const below = angle > -Math.PI / 2 ? 0 : Math.PI; // under the real axis: its nearer end
        this.onChange(edge.move(this.#sector, angle < 0 ? below : angle));
    }

    #press(edge, event) {
        const now = toDegrees(edge.angle(this.#sector));
        const ends = { Home: 0, End: 180 };
        const step = event.shiftKey ? KEY_STEP / 10 : KEY_STEP;
        const to = event.key in ends ? ends[event.key] : now + step * KEYS[event.key];
        if (Number.isNaN(to)) return;
        event.preventDefault();
        event.stopPropagation();
        this.onChange(edge.move(this.#sector, toRadians(to)));
    }

    place(view, sector) {
        this.#view = view;
        this.#sector = sector;
        EDGES.forEach((edge, i) => {
            const angle = edge.angle(sector);
            const span = rayIn(view, angle);
            const handle = this.handles[i];
            handle.classList.toggle("wedge-away", !span);
            const degrees = toDegrees(angle);
            handle.setAttribute("aria-valuenow", degrees.toFixed(2));
            handle.setAttribute("aria-valuetext", `${short(degrees, 4)}°`);
            if (!span) return;
            const r = span[0] + edge.share * (span[1] - span[0]);
            const [x, y] = [view.x(r * Math.cos(angle)), view.y(r * Math.sin(angle))];
            handle.setAttribute("transform", `translate(${x.toFixed(1)} ${y.toFixed(1)})`);
        });
    }
}
