// planeview.js - the part of the complex plane that a picture of the roots shows: equal units on both axes,
// zoomed about one root, whose difference to any other point is what becomes pixels (so that a box 1e-15 wide
// can be looked at).

const MARGIN = 0.14; // of the range on each side, free

/** width, height in pixels; points {re, im}: all of them are seen; fixed: stays where it is at any zoom. */
export function planeView(width, height, points, fixed, zoom) {
    const range = (pick, least) => {
        let lo = Math.min(...points.map(pick));
        let hi = Math.max(...points.map(pick));
        const room = Math.max(MARGIN * (hi - lo), least);
        return [lo - room, hi + room];
    };
    const size = Math.max(...points.map(({ re, im }) => Math.hypot(re, im)), 1e-300);
    const [left, right] = range((point) => point.re, 0.05 * size);
    const [low, high] = range((point) => point.im, 0.05 * size);
    const unit = Math.min(width / (right - left), height / (high - low));
    const home = {
        x: width / 2 + (fixed.re - (left + right) / 2) * unit,
        y: height / 2 - (fixed.im - (low + high) / 2) * unit,
    };
    const scale = unit * zoom;
    return {
        width,
        height,
        scale,
        x: (re) => home.x + (re - fixed.re) * scale,
        y: (im) => home.y - (im - fixed.im) * scale,
        re: (x) => fixed.re + (x - home.x) / scale,
        im: (y) => fixed.im + (home.y - y) / scale,
    };
}

/** The part of a polygon (points [x, y]) where a x + b y >= 0. */
function halfPlane(polygon, a, b) {
    const side = ([x, y]) => a * x + b * y;
    return polygon.flatMap((point, i) => {
        const before = polygon[(i + polygon.length - 1) % polygon.length];
        const [s, r] = [side(point), side(before)];
        const cut = r / (r - s);
        const crossing = [before[0] + cut * (point[0] - before[0]), before[1] + cut * (point[1] - before[1])];
        return [...(s >= 0 !== r >= 0 ? [crossing] : []), ...(s >= 0 ? [point] : [])];
    });
}

/** The corners of what a view shows, as points [re, im]. */
const cornersOf = (view) => [
    [view.re(0), view.im(view.height)],
    [view.re(view.width), view.im(view.height)],
    [view.re(view.width), view.im(0)],
    [view.re(0), view.im(0)],
];

/** The wedge from one argument to another, as far as it is in view; side: -1 for its mirror image. */
export function wedgeIn(view, from, to, side) {
    const upper = halfPlane(cornersOf(view), -Math.sin(from), side * Math.cos(from));
    return halfPlane(upper, Math.sin(to), -side * Math.cos(to));
}

/** Where the ray from 0 with an argument enters and leaves the view, as magnitudes; null where it doesn't. */
export function rayIn(view, angle) {
    let [near, far] = [0, Infinity];
    const [[left, low], , [right, high]] = cornersOf(view);
    for (const [step, lo, hi] of [
        [Math.cos(angle), left, right],
        [Math.sin(angle), low, high],
    ]) {
        if (Math.abs(step) < 1e-15 && (lo > 0 || hi < 0)) return null;
        if (Math.abs(step) < 1e-15) continue;
        const [a, b] = [lo / step, hi / step];
        near = Math.max(near, Math.min(a, b));
        far = Math.min(far, Math.max(a, b));
    }
    return near < far ? [near, far] : null;
}
