// state.js - what a picture depends on: makes it, and checks what comes from links and files.
//
// page state, plain JSON: see initialState().  checkedState() takes anything and gives a state: what is
// missing, out of range or of the wrong kind becomes the default, and its name is told.

export const VERSION = 1;
// Planes, degree and side of a picture are the library's (ALGSURF_MAX_CLIP_PLANES, ALGSURF_MAX_DEGREE, render.h);
// the others are what fits a page and a link.
export const LIMITS = { equation: 10_000, parameters: 50, planes: 8, degree: 64, side: 65535, number: 1e12 };
export const BLUE = { outside: "#69b5ff", inside: "#f6a245" };
const TAKEN = new Set(["x", "y", "z", "sqrt", "sin", "cos", "pi", "\\pi", "π"]);

/** A sphere: every state has all of these members. */
export function initialState() {
    return {
        version: VERSION,
        name: "",
        equation: "x^2 + y^2 + z^2 = 1",
        parameters: {},
        extent: { kind: "sphere", size: [1.2], centre: [0, 0, 0] },
        clip: [],
        camera: { eye: [2.93, -3.6, 2.14], lookAt: [0, 0, 0], up: [0, 0, 1], fov: 25 },
        colours: { ...BLUE, background: "none" },
        light: null,
        thin: null,
        axes: false,
        box: false,
        complex: null,
    };
}

// ---- checks: each gives the value, or undefined ----

/** May a constant of an equation be called that?  \phi is a Greek letter, too. */
export function isName(name) {
    return (
        typeof name === "string" &&
        /^\\?[a-zͰ-Ͽ][\wͰ-Ͽ]{0,39}$/i.test(name) &&
        !TAKEN.has(name)
    );
}

function inRange(x, from = -LIMITS.number, to = LIMITS.number) {
    return typeof x === "number" && x >= from && x <= to ? x : undefined;
}

function numbers(list, count, from, to) {
    const is =
        Array.isArray(list) && list.length === count && list.every((x) => inRange(x, from, to) !== undefined);
    return is ? [...list] : undefined;
}

function isObject(value) {
    return typeof value === "object" && value !== null && !Array.isArray(value);
}

/** A text without what is not printed: control characters, ends of lines, what turns or hides others. */
export function printable(value) {
    return value.replaceAll("\u2062", "*").replace(/[\p{C}\p{Zl}\p{Zp}]/gu, " "); // \u2062: invisible times
}

export const isPrintable = (value) => printable(value) === value;

function text(value, longest) {
    const is = typeof value === "string" && value.length <= longest && isPrintable(value);
    return is ? value : undefined;
}

export function parameter(value) {
    if (!isObject(value)) return undefined;
    const at = inRange(value.value);
    if (at === undefined) return undefined;
    let from = inRange(value.from), to = inRange(value.to);
    if (from === undefined || to === undefined || !(from < to)) [from, to] = usualRange(at);
    return { value: at, from: Math.min(from, at), to: Math.max(to, at) };
}

/** A range that is worth looking through. */
export function usualRange(value) {
    const reach = Math.max(2, 2 * Math.abs(value));
    return [-reach, reach];
}

function parametersOf(value) {
    if (!isObject(value)) return undefined;
    const entries = Object.entries(value);
    const made = entries.map(([name, p]) => [name, isName(name) ? parameter(p) : undefined]);
    if (entries.length > LIMITS.parameters || made.some(([, p]) => p === undefined)) return undefined;
    return Object.fromEntries(made);
}

function extentOf(value) {
    if (!isObject(value) || !["fitted", "sphere", "box"].includes(value.kind)) return undefined;
    const first = (edges) => numbers(value.size?.slice?.(0, edges), edges, 1e-9, 1e9);
    const size = (value.kind === "sphere" ? undefined : first(3)) ?? (value.kind === "box" ? undefined : first(1));
    const centre = numbers(value.centre, 3);
    return size && centre ? { kind: value.kind, size, centre } : undefined;
}

function clipOf(value) {
    if (!Array.isArray(value) || value.length > LIMITS.planes) return undefined;
    const planes = value.map((plane) => numbers(plane, 4));
    return planes.every((p) => p && Math.hypot(p[0], p[1], p[2]) > 1e-9) ? planes : undefined;
}

function cameraOf(value) {
    if (!isObject(value)) return undefined;
    const [eye, lookAt, up] = [value.eye, value.lookAt, value.up].map((v) => numbers(v, 3));
    const fov = inRange(value.fov, 1e-6, 170);
    if (!eye || !lookAt || !up || fov === undefined) return undefined;
    const back = eye.map((x, i) => x - lookAt[i]), distance = Math.hypot(...back);
    const across = [0, 1, 2].map((i) => {
        const j = (i + 1) % 3, k = (i + 2) % 3;
        return back[j] * up[k] - back[k] * up[j];
    });
    return Math.hypot(...across) > 1e-6 * distance * Math.hypot(...up) ? { eye, lookAt, up, fov } : undefined;
}

export function isColour(value) {
    return typeof value === "string" && /^#[0-9a-f]{6}$/i.test(value);
}

function coloursOf(value) {
    if (!isObject(value)) return undefined;
    const { outside = null, inside = null, background = null } = value;
    if (![outside, inside].every((c) => c === null || isColour(c))) return undefined;
    if (background !== null && background !== "none" && !isColour(background)) return undefined;
    return { outside: outside ?? BLUE.outside, inside: inside ?? BLUE.inside, background };
}

function lightOf(value) {
    if (value === null) return null;
    const azimuth = inRange(value?.azimuth, -180, 180), elevation = inRange(value?.elevation, -90, 90);
    return azimuth === undefined || elevation === undefined ? undefined : { azimuth, elevation };
}

function complexOf(value) {
    if (value === null) return null;
    if (!isObject(value)) return undefined;
    const sigma = inRange(value.sigma, 0, Math.PI), delta = inRange(value.delta, 0, Math.PI);
    const parts = Object.entries(value.imaginary ?? {});
    const are = parts.every(
        ([k, v]) => /^\d{1,2}$/.test(k) && Number(k) <= LIMITS.degree && inRange(v) !== undefined,
    );
    if (sigma === undefined || delta === undefined || !are) return undefined;
    return { sigma, delta, imaginary: Object.fromEntries(parts) };
}

const flag = (value) => (typeof value === "boolean" ? value : undefined);

const CHECKS = {
    name: (value) => text(value, 40),
    equation: (value) => text(value, LIMITS.equation),
    parameters: parametersOf,
    extent: extentOf,
    clip: clipOf,
    camera: cameraOf,
    colours: coloursOf,
    light: lightOf,
    thin: (value) => (value === null ? null : flag(value)),
    axes: flag,
    box: flag,
    complex: complexOf,
};

/** A state of what is good in `raw`, the rest as in `defaults`; bad and unknown members are named. */
export function checkedState(raw, defaults = initialState()) {
    const state = { ...defaults, version: VERSION };
    const bad = [], unknown = [];
    for (const [key, value] of Object.entries(isObject(raw) ? raw : {})) {
        if (key === "version") continue;
        const check = Object.hasOwn(CHECKS, key) ? CHECKS[key] : null;
        if (!check) {
            unknown.push(key);
            continue;
        }
        const checked = check(value);
        if (checked === undefined) bad.push(key);
        else state[key] = checked;
    }
    return { state, bad, unknown };
}

/** Are both sides coloured as everywhere where nothing is said?  Links leave them out then. */
export function areUsual({ outside, inside }) {
    return outside === BLUE.outside && inside === BLUE.inside;
}

/** Is the picture in the library's own colours, of which BLUE is what eight bits hold?  Then nothing is told
 * of them. render has no word for thin features that are asked for in that colour. */
export function isInOwnColours({ colours, thin }) {
    return areUsual(colours ?? {}) && thin !== true;
}

/** Values of the parameters, by name. */
export function constantsOf(state) {
    return Object.fromEntries(Object.entries(state.parameters).map(([name, p]) => [name, p.value]));
}

/** A fitted extent is a box if it has three sizes, else a ball. */
export function isBox({ kind, size }) {
    return kind === "box" || (kind === "fitted" && size.length === 3);
}

/** Radius of a ball about what is shown. */
export function radiusOf(extent) {
    return isBox(extent) ? Math.hypot(...extent.size) : extent.size[0];
}
