// clip.js - the cutting plane: how it is made and moved, and its rows in the panel "view".
//
// A plane [a, b, c, d] keeps a x + b y + c z <= d.  The first one of the state is the one that moves; a link
// can bring more of them, which stay.
import { axesOf } from "../picture/camera.js";
import { button, row, slider } from "../base/controls.js";
import { element } from "../base/dom.js";
import { radiusOf } from "../state/state.js";

const STEEP = 0.3; // a normal that is shorter in the picture points at the viewer, or away

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** The plane so far from the middle of the extent along its normal, rounded to what is seen at a scale. */
function placed(normal, far, extent, scale = radiusOf(extent)) {
    const digits = Math.max(0, Math.min(15, 4 - Math.floor(Math.log10(scale))));
    return [...normal, Number((dot(normal, extent.centre) + far * Math.hypot(...normal)).toFixed(digits))];
}

/** How far the plane is from the middle of the extent. */
function farOf([a, b, c, d], extent) {
    return (d - dot([a, b, c], extent.centre)) / Math.hypot(a, b, c);
}

/** A plane through the middle of what is shown, across the view: what is behind it is kept. */
function facing({ camera, extent }) {
    const normal = axesOf(camera).forward.map((x) => Number((-x).toFixed(4)) + 0);
    return placed(normal, 0, extent);
}

/** The planes after a drag in the picture, in its heights, y downwards: the first follows the pointer along
 * its
 *  normal; seen from the front, down is towards the viewer.  Where there is none, one is made. */
export function dragged(state, dx, dy) {
    const plane = state.clip[0] ?? facing(state), [a, b, c] = plane;
    const { right, up, forward, half } = axesOf(state.camera), length = Math.hypot(a, b, c);
    const x = dot([a, b, c], right) / length, y = dot([a, b, c], up) / length, seen = Math.hypot(x, y);
    const front = dot([a, b, c], forward) < 0 ? 1 : -1;
    const by = seen > STEEP ? (dx * x - dy * y) / seen ** 2 : front * dy;
    const most = radiusOf(state.extent), far = farOf(plane, state.extent) + 2 * half * by;
    const held = Math.max(-most, Math.min(most, far));
    return [placed([a, b, c], held, state.extent, Math.min(half, most)), ...state.clip.slice(1)];
}

/** services: { store, text, motion } */
export function clipRows({ store, text, motion }) {
    const set = (clip, moving = false) => store.set({ clip }, { moving });
    const others = () => store.get().clip.slice(1);

    const cuts = element("input", {
        type: "checkbox",
        change: () => set(cuts.checked ? [facing(store.get())] : []),
    });
    const place = slider({
        min: -1, max: 1, step: 0.01,
        show: (share) => text.number(Number((share * radiusOf(store.get().extent)).toPrecision(3))),
        onInput(share, moving) {
            const { clip, extent } = store.get();
            set([placed(clip[0].slice(0, 3), share * radiusOf(extent), extent), ...others()], moving);
        },
    });
    const face = button(text("clip.face"), () => set([facing(store.get()), ...others()]));
    const drags = button(text("clip.drag"), () => press(!motion.cuts), { "aria-pressed": "false" });
    function press(isPressed) {
        motion.cuts = isPressed;
        drags.setAttribute("aria-pressed", String(isPressed));
    }
    const rows = [
        row(text("clip.at"), place.range, place.output),
        element("div", { class: "row" }, face, drags),
    ];

    function follow({ clip, extent }) {
        cuts.checked = clip.length > 0;
        for (const node of rows) node.hidden = !cuts.checked;
        if (cuts.checked) place.follow(farOf(clip[0], extent) / radiusOf(extent));
        else press(false);
    }
    follow(store.get());
    store.subscribe((state, { changed }) => (changed.has("clip") || changed.has("extent")) && follow(state));
    return [row(text("clip"), cuts), ...rows];
}
