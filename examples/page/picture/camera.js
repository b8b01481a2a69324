// camera.js - a camera moved: every function gives a new one, {eye, lookAt, up, fov}.
//
// Turning is by rotations about axes of the picture, and takes `up` along: there is no pole and no gimbal.
// Zooming in narrows the field of view, so that the eye never gets into the surface.

const USUAL_FOV = 25, LEAST_FOV = 1e-5, RADIANS = Math.PI / 180;
const MOST_DISTANCE = 1e9;

const minus = (a, b) => a.map((x, i) => x - b[i]);
const plus = (a, b, times = 1) => a.map((x, i) => x + times * b[i]);
const unit = (a) => a.map((x) => x / Math.hypot(...a));
const cross = (a, b) =>
    [0, 1, 2].map((i) => a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3]);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** Right, up and forward, unit vectors; half the picture's height where it looks at, and how far that is. */
export function axesOf(camera) {
    const way = minus(camera.lookAt, camera.eye), distance = Math.hypot(...way), forward = unit(way);
    const right = unit(cross(forward, camera.up));
    const half = Math.tan((camera.fov / 2) * RADIANS) * distance;
    return { right, up: cross(right, forward), forward, distance, half };
}

/** Rodrigues' formula: v turned about a unit vector. */
function turned(v, axis, angle) {
    const c = Math.cos(angle), s = Math.sin(angle), w = cross(axis, v), along = dot(axis, v);
    return v.map((x, i) => c * x + s * w[i] + (1 - c) * along * axis[i]);
}

/** Numbers that are read as easily as they are exact enough; up a unit vector again, across the view. */
function tidy(camera) {
    const { up, distance } = axesOf(camera);
    const step = 10 ** Math.floor(Math.log10((distance * camera.fov) / USUAL_FOV) - 5);
    const digits = Math.min(Math.max(0, -Math.floor(Math.log10(step))), 15);
    const round = (x) => Number(x.toFixed(digits));
    return {
        eye: camera.eye.map(round),
        lookAt: camera.lookAt.map(round),
        up: up.map((x) => Number(x.toFixed(6))),
        fov: Number(camera.fov.toPrecision(6)),
    };
}

/** The surface follows the pointer: angles to the right and downwards, in radians, about what is looked
 * at. */
export function turn(camera, toRight, down) {
    const angle = Math.hypot(toRight, down);
    if (angle === 0) return camera;
    const { right, up } = axesOf(camera);
    const axis = unit(plus(up.map((x) => x * toRight), right, down));
    const back = turned(minus(camera.eye, camera.lookAt), axis, -angle);
    return tidy({ ...camera, eye: plus(camera.lookAt, back), up: turned(up, axis, -angle) });
}

/** About the direction of view, in radians. */
export function roll(camera, angle) {
    const { up, forward } = axesOf(camera);
    return tidy({ ...camera, up: turned(up, forward, angle) });
}

/** About the axis `up` through what is looked at, as the sweep "turn" of the program render. */
export function circle(camera, angle) {
    const axis = unit(camera.up), back = turned(minus(camera.eye, camera.lookAt), axis, angle);
    return { ...camera, eye: plus(camera.lookAt, back), up: turned(camera.up, axis, angle) };
}

/** A place of the picture, x to the right, y up from the middle, in halves of its height, moves by so
 * much. */
export function pan(camera, x, y) {
    const { right, up, half } = axesOf(camera);
    const by = plus(right.map((r) => -x * half * r), up, -y * half);
    return tidy({ ...camera, eye: plus(camera.eye, by), lookAt: plus(camera.lookAt, by) });
}

/** Narrows or widens the field of view; the eye stays, and the ray through x, y (as for pan) keeps its
 * place. */
function magnify(camera, slope, x, y) {
    const { right, up, forward, distance, half } = axesOf(camera);
    const through = (steepness) => unit(plus(plus(forward, right, x * steepness), up, y * steepness));
    const from = through(slope),
        to = through(half / distance),
        axis = cross(from, to),
        sine = Math.hypot(...axis);
    const turn = (v) => (sine > 1e-15 ? turned(v, unit(axis), Math.atan2(sine, dot(from, to))) : v);
    return {
        ...camera,
        lookAt: plus(camera.eye, turn(forward), distance),
        up: turn(up),
        fov: (2 / RADIANS) * Math.atan(slope),
    };
}

/** `times` as large.  The field of view narrows and widens back to the usual one; beyond that the eye moves,
 * and
 *  comes as near as `nearest` again.  What is at x, y (as for pan) stays there: all of the ray in the former
 *  case, in the latter the point of the plane that is looked at. */
export function zoom(camera, times, x = 0, y = 0, nearest = 0) {
    const { distance, half } = axesOf(camera);
    const usual = Math.tan((USUAL_FOV / 2) * RADIANS), least = Math.tan((LEAST_FOV / 2) * RADIANS);
    const now = half / distance, widest = Math.max(usual, now), wanted = half / times;
    let far = distance;
    if (times > 1 && now >= usual && distance > nearest) far = Math.max(wanted / now, nearest);
    if (times < 1 && wanted / distance > widest) far = Math.min(wanted / widest, MOST_DISTANCE);
    const slope = Math.min(Math.max(wanted / far, least), widest);
    const magnified = slope === now ? camera : magnify(camera, slope, x, y);
    if (far === distance) return tidy(magnified);
    const grown = distance / far, moved = plus(magnified.lookAt, axesOf(magnified).forward, -far);
    return pan({ ...magnified, eye: moved }, x * (1 - grown), y * (1 - grown));
}

/** The same picture, but what is looked at is so far from the eye: what it turns about then. */
export function lookAtDistance(camera, distance) {
    const { forward } = axesOf(camera);
    return tidy({ ...camera, lookAt: plus(camera.eye, forward, distance) });
}

/** A camera made for pictures that are wider than high, for one of this shape: what was seen still is. */
export function suited(camera, width, height) {
    if (width >= height) return camera;
    const back = minus(camera.eye, camera.lookAt);
    return tidy({ ...camera, eye: plus(camera.lookAt, back, height / width) });
}
