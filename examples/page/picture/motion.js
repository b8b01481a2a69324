// motion.js - the picture moved: pointers, wheel, keys.
//
//     one pointer    turns the surface (a trackball: no pole); with Shift it moves, with Alt it moves the
//                    light,
//                    with Ctrl, or while `cuts` is true, the cutting plane
//     two pointers   pinch: zoom at the place between them, move
//     wheel          zooms at the pointer; with Ctrl it changes the radius of what is shown
//     double click   as at first
//     click          looked into: listeners of "place" get { x, y } in 0..1 of the picture
import { axesOf, lookAtDistance, pan, roll, turn, zoom } from "./camera.js";
import { dragged } from "../panels/clip.js";
import { debounced } from "../base/dom.js";
import { isBox, radiusOf } from "../state/state.js";

const TURN = 2.6; // radians for a drag over the picture's height
const CLICK = 5; // pixels that a pointer may move in a click
const KEY_ANGLE = (7.5 * Math.PI) / 180, KEY_TIMES = 1.25;
const SECOND = 260; // milliseconds in which a second click makes a double one
const REST = 180; // milliseconds without input: the picture rests

export class Motion {
    cuts = false;
    #canvas;
    #store;
    #painter;
    #home;
    #pointers = new Map();
    #moved = 0;
    #click = 0; // a timer: no second one followed
    #rest = debounced(REST, () => this.rest());
    #anchor = debounced(400, () => this.#takeAnchor());

    /** home(): the camera that double click goes back to. */
    constructor(canvas, { store, painter, home }) {
        this.#canvas = canvas;
        this.#store = store;
        this.#painter = painter;
        this.#home = home;
        canvas.addEventListener("pointerdown", (event) => this.#down(event));
        canvas.addEventListener("pointermove", (event) => this.#move(event));
        for (const end of ["pointerup", "pointercancel"])
            canvas.addEventListener(end, (event) => this.#up(event));
        canvas.addEventListener("wheel", (event) => this.#wheel(event), { passive: false });
        canvas.addEventListener("dblclick", () => {
            clearTimeout(this.#click);
            this.reset();
        });
    }

    /** The full picture is drawn. */
    rest() {
        this.#store.set({}, { moving: false });
    }

    reset() {
        this.#store.set({ camera: this.#home() });
    }

    #setCamera(camera) {
        this.#store.set({ camera }, { moving: true });
        this.#rest();
    }

    /** In halves of the picture's height from its middle, y upwards. */
    #placeOf(clientX, clientY) {
        const { left, top, width, height } = this.#canvas.getBoundingClientRect();
        return [(2 * (clientX - left) - width) / height, (height - 2 * (clientY - top)) / height];
    }

    // ---- pointers ----

    #down(event) {
        if (event.button > 1) return;
        this.#canvas.focus({ preventScroll: true });
        this.#canvas.setPointerCapture(event.pointerId);
        if (this.#pointers.size === 0) this.#moved = 0;
        else this.#moved = CLICK + 1;
        this.#pointers.set(event.pointerId, [event.clientX, event.clientY]);
    }

    #move(event) {
        const before = this.#pointers.get(event.pointerId);
        if (!before) return;
        const now = [event.clientX, event.clientY];
        this.#moved += Math.hypot(now[0] - before[0], now[1] - before[1]);
        if (this.#moved <= CLICK) return;
        const others = [...this.#pointers].filter(([id]) => id !== event.pointerId).map(([, place]) => place);
        this.#pointers.set(event.pointerId, now);
        if (others.length > 0) this.#pinch(others[0], before, now);
        else this.#drag(event, before, now);
    }

    #drag(event, before, now) {
        const { camera } = this.#store.get();
        const { height } = this.#canvas.getBoundingClientRect();
        const dx = (now[0] - before[0]) / height, dy = (now[1] - before[1]) / height;
        if (event.altKey) this.#dragLight(dx, dy);
        else if (event.ctrlKey || event.metaKey) this.#dragPlane(dx, dy);
        else if (event.shiftKey || event.buttons === 4) this.#setCamera(pan(camera, 2 * dx, -2 * dy));
        else if (this.cuts) this.#dragPlane(dx, dy);
        else this.#setCamera(turn(camera, TURN * this.#calm() * dx, TURN * this.#calm() * dy));
    }

    /** What is magnified turns slower, as much as it is larger. */
    #calm() {
        const { camera, extent } = this.#store.get();
        return Math.min(1, (1.6 * axesOf(camera).half) / radiusOf(extent));
    }

    #pinch(fixed, before, now) {
        const far = (place) => Math.max(Math.hypot(place[0] - fixed[0], place[1] - fixed[1]), 10);
        const between = (place) => this.#placeOf((place[0] + fixed[0]) / 2, (place[1] + fixed[1]) / 2);
        const from = between(before), to = between(now);
        const { camera } = this.#store.get();
        const moved = pan(camera, to[0] - from[0], to[1] - from[1]);
        const angle = (place) => Math.atan2(place[1] - fixed[1], place[0] - fixed[0]);
        const twist = Math.atan2(Math.sin(angle(now) - angle(before)), Math.cos(angle(now) - angle(before)));
        const turned = Math.abs(twist) < 0.5 ? roll(moved, -twist) : moved;
        this.#setCamera(zoom(turned, far(now) / far(before), ...to, this.#nearest()));
        this.#anchor();
    }

    #up(event) {
        if (!this.#pointers.delete(event.pointerId) || this.#pointers.size > 0) return;
        if (this.#moved > CLICK) {
            this.rest();
        } else if (event.type === "pointerup") {
            const { left, top, width, height } = this.#canvas.getBoundingClientRect();
            const detail = { x: (event.clientX - left) / width, y: (event.clientY - top) / height };
            clearTimeout(this.#click);
            this.#click = setTimeout(
                () => this.#canvas.dispatchEvent(new CustomEvent("place", { detail })),
                SECOND,
            );
        }
    }

    // ---- cutting plane, light ----

    #dragPlane(dx, dy) {
        this.#store.set({ clip: dragged(this.#store.get(), dx, dy) }, { moving: true });
        this.#rest();
    }

    #dragLight(dx, dy) {
        const light = this.#store.get().light ?? { azimuth: -31, elevation: 30 };
        const within = (x, most) => Math.round(Math.min(Math.max(x, -most), most));
        this.#store.set(
            {
                light: {
                    azimuth: within(light.azimuth + 180 * dx, 180),
                    elevation: within(light.elevation - 180 * dy, 90),
                },
            },
            { moving: true },
        );
        this.#rest();
    }

    // ---- zoom ----

    #nearest() {
        const home = this.#home();
        return Math.hypot(...home.eye.map((x, i) => x - home.lookAt[i]));
    }

    #wheel(event) {
        event.preventDefault();
        const lines = event.deltaMode === 1 ? 16 : event.deltaMode === 2 ? 400 : 1;
        const delta = Math.max(-240, Math.min(240, event.deltaY * lines));
        const isPinch = event.ctrlKey && Math.abs(event.deltaY) < 30 && !Number.isInteger(event.deltaY);
        if (event.ctrlKey && !isPinch) this.#resize(Math.exp(-delta * 0.0012));
        else
            this.#zoomBy(
                Math.exp(-delta * (isPinch ? 0.01 : 0.0016)),
                ...this.#placeOf(event.clientX, event.clientY),
            );
    }

    #resize(times) {
        const { extent } = this.#store.get();
        const size = extent.size.map((x) => Number((x * times).toPrecision(3)));
        this.#store.set(
            { extent: { ...extent, kind: isBox(extent) ? "box" : "sphere", size } },
            { moving: true },
        );
        this.#rest();
    }

    #zoomBy(times, x, y) {
        this.#setCamera(zoom(this.#store.get().camera, times, x, y, this.#nearest()));
        this.#anchor();
    }

    /** After zooming, turns go about the point of the surface in the middle, if there is one. */
    async #takeAnchor() {
        const state = this.#store.get();
        const { width, height } = this.#canvas;
        if (state.complex || this.#calm() > 0.7 || this.#pointers.size > 0) return;
        try {
            const hit = await this.#painter.ask("pick", state, {
                width,
                height,
                x: width / 2,
                y: height / 2,
            });
            const same = this.#store.get().camera === state.camera;
            if (!same || hit?.state !== "hit") return;
            const way = hit.position.map((p, i) => p - state.camera.eye[i]);
            this.#store.set({ camera: lookAtDistance(state.camera, Math.hypot(...way)) }, { moving: true });
            this.rest();
        } catch {
            // A newer question took its place, or the surface changed: turns go on about the old point.
        }
    }

    // ---- keys ----

    /** Acts on a key; false: it is not one of these. */
    key(event) {
        const { camera } = this.#store.get();
        const angle = (event.shiftKey ? 0.2 : 1) * KEY_ANGLE * this.#calm();
        const step = event.shiftKey ? 1.06 : KEY_TIMES;
        const acts = {
            ArrowLeft: () => this.#setCamera(turn(camera, -angle, 0)),
            ArrowRight: () => this.#setCamera(turn(camera, angle, 0)),
            ArrowUp: () => this.#setCamera(turn(camera, 0, -angle)),
            ArrowDown: () => this.#setCamera(turn(camera, 0, angle)),
            "<": () => this.#setCamera(roll(camera, -angle)),
            ">": () => this.#setCamera(roll(camera, angle)),
            "+": () => this.#zoomBy(step, 0, 0),
            "=": () => this.#zoomBy(step, 0, 0),
            "-": () => this.#zoomBy(1 / step, 0, 0),
            _: () => this.#zoomBy(1 / step, 0, 0),
            0: () => this.reset(),
            Home: () => this.reset(),
        };
        if (!Object.hasOwn(acts, event.key)) return false;
        acts[event.key]();
        return true;
    }
}
