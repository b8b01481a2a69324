// link.js - a state as the fragment of an address, and back.
//
//     #v1&equation=x^2+y^2=z^2&let:a=1.5:0:3&extent=sphere:2@0,0,1&eye=1,2,3&...
//
// Fields have the names of render's options.  What a reader does not know is ignored, and named; so is what
// is out of range.  A camera that was not moved is left out: the picture then suits the reader's window.
import { areUsual, checkedState, isPrintable, LIMITS, VERSION } from "./state.js";

const LONGEST = 40_000; // characters of a link; an equation of 10,000 may be escaped
const list = (numbers) => numbers.map((x) => String(x)).join(",");
const vector = (text) => text.split(",").map(number);

function number(text) {
    return text.trim() === "" ? NaN : Number(text);
}

/** Percent escapes for what address bars, mail and chat programs do not leave alone. */
function escaped(text) {
    const plain = encodeURIComponent(text).replace(/%(5E|2B|3D|2F|2C|3A|40|3B)/g, (code) =>
        decodeURIComponent(code),
    );
    return plain.replace(/['!~]/g, (c) => `%${c.charCodeAt(0).toString(16)}`);
}

function unescaped(text) {
    try {
        return decodeURIComponent(text);
    } catch {
        return undefined;
    }
}

/** home: the camera as it was before it was moved, or null. */
export function linkOf(state, home = null) {
    const fields = [];
    const add = (key, value) => fields.push(`${escaped(key)}=${escaped(value)}`);
    if (state.name) add("name", state.name);
    add("equation", state.equation);
    for (const [name, p] of Object.entries(state.parameters))
        add(`let:${name}`, `${p.value}:${p.from}:${p.to}`);
    const { kind, size, centre } = state.extent;
    add("extent", `${kind}:${list(size)}${centre.some((x) => x !== 0) ? `@${list(centre)}` : ""}`);
    for (const plane of state.clip) add("clip", list(plane));
    const { eye, lookAt, up, fov } = state.camera;
    if (JSON.stringify(state.camera) !== JSON.stringify(home)) {
        add("eye", list(eye));
        add("look-at", list(lookAt));
        add("up", list(up));
        add("fov", String(fov));
    }
    const { outside, inside, background } = state.colours;
    if (!areUsual(state.colours)) {
        add("colour", outside.slice(1));
        add("inside", inside.slice(1));
    }
    if (background !== "none") add("background", background === null ? "white" : background.slice(1));
    if (state.light) add("light", `${state.light.azimuth}:${state.light.elevation}`);
    if (state.thin !== null) add("thin", state.thin ? "yes" : "no");
    if (state.axes) add("axes", "yes");
    if (state.box) add("box", "yes");
    if (state.complex) {
        add("sigma", String(state.complex.sigma));
        add("delta", String(state.complex.delta));
        for (const [k, v] of Object.entries(state.complex.imaginary)) add("imag", `${k}:${v}`);
    }
    const link = `#v${VERSION}&${fields.join("&")}`;
    return link.replace(/[).,:*]$/, (c) => `%${c.charCodeAt(0).toString(16)}`); // taken for a sentence's end
}

// ---- reading: each takes the value and what is read so far ----

const yesOrNo = (value) => (value === "yes" ? true : value === "no" ? false : value);

const READERS = {
    name: (value, raw) => (raw.name = value),
    equation: (value, raw) => (raw.equation = value),
    extent(value, raw) {
        const [, kind, size, centre] = /^(\w+):([^@]*)(?:@(.*))?$/.exec(value) ?? [];
        raw.extent = { kind, size: vector(size ?? ""), centre: centre ? vector(centre) : [0, 0, 0] };
    },
    clip: (value, raw) => (raw.clip = [...(raw.clip ?? []), vector(value)]),
    eye: (value, raw) => (raw.camera = { ...raw.camera, eye: vector(value) }),
    "look-at": (value, raw) => (raw.camera = { ...raw.camera, lookAt: vector(value) }),
    up: (value, raw) => (raw.camera = { ...raw.camera, up: vector(value) }),
    fov: (value, raw) => (raw.camera = { ...raw.camera, fov: number(value) }),
    colour: (value, raw) => (raw.colours = { background: "none", ...raw.colours, outside: `#${value}` }),
    inside: (value, raw) => (raw.colours = { background: "none", ...raw.colours, inside: `#${value}` }),
    background: (value, raw) =>
        (raw.colours = {
            ...raw.colours,
            background: value === "none" ? value : value === "white" ? null : `#${value}`,
        }),
    light(value, raw) {
        const [azimuth, elevation] = value.split(":").map(number);
        raw.light = { azimuth, elevation };
    },
    thin: (value, raw) => (raw.thin = yesOrNo(value)),
    axes: (value, raw) => (raw.axes = yesOrNo(value)),
    box: (value, raw) => (raw.box = yesOrNo(value)),
    sigma: (value, raw) =>
        (raw.complex = { delta: 1e-10, imaginary: {}, ...raw.complex, sigma: number(value) }),
    delta: (value, raw) => (raw.complex = { sigma: 0, imaginary: {}, ...raw.complex, delta: number(value) }),
    imag(value, raw) {
        const [k, v] = value.split(":");
        const before = raw.complex ?? { sigma: 0, delta: 1e-10 };
        raw.complex = { ...before, imaginary: { ...before.imaginary, [k]: number(v ?? "") } };
    },
};

function readParameter(name, value, raw) {
    const [at, from, to] = value.split(":").map(number);
    raw.parameters = { ...raw.parameters, [name]: { value: at, from, to } };
}

/** { state, hasCamera, bad, unknown, newer, refused } of a fragment, or null when it is none of ours; refused:
 * it holds what is not printed, and nothing of it is taken. */
export function stateOfLink(fragment, defaults) {
    const version = /^#v(\d{1,6})(?=&|$)/.exec(fragment);
    if (!version) return null;
    const raw = {}, unknown = [], bad = [];
    const fields = fragment.length <= LONGEST ? fragment.slice(version[0].length + 1).split("&") : [];
    if (fields.length === 0) bad.push("link");
    for (const field of fields.slice(0, 3 * LIMITS.parameters)) {
        const cut = field.indexOf("=");
        const key = unescaped(field.slice(0, Math.max(cut, 0))), value = unescaped(field.slice(cut + 1));
        if (!isPrintable((key ?? "") + (value ?? ""))) return { state: defaults, refused: true };
        if (cut < 0 || key === undefined || value === undefined) {
            if (field !== "") bad.push(unescaped(field.slice(0, 20)) ?? "%");
        } else if (key.startsWith("let:")) readParameter(key.slice(4), value, raw);
        else if (Object.hasOwn(READERS, key)) READERS[key](value, raw);
        else unknown.push(key.slice(0, 40));
    }
    if (raw.camera) raw.camera = { up: [0, 0, 1], lookAt: [0, 0, 0], fov: 25, ...raw.camera };
    const checked = checkedState(raw, defaults);
    return {
        state: checked.state,
        hasCamera: raw.camera !== undefined && !checked.bad.includes("camera"),
        bad: [...bad, ...checked.bad],
        unknown,
        newer: Number(version[1]) > VERSION,
    };
}
