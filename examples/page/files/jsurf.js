// jsurf.js - files of IMAGINARY's SURFER: equation, parameters, view and colours, read and written.
//
// Sources: java.util.Properties for the lines; jsurf_file.c and view.c of the programs for the keys and for
// the view: the same file gives the same picture there and here, but for parallel projection, which is not
// drawn here: a camera that is far away stands for it.
import { isColour, isPrintable, LIMITS, radiusOf } from "../state/state.js";

export const LARGEST = 1 << 20; // bytes of a file
const RADIANS = Math.PI / 180;
const FAR_FOV = 1; // degrees, for a parallel projection
const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** Why a file cannot be read: a key of the texts, with values. */
export class FileError extends Error {
    constructor(key, values = {}) {
        super(key);
        Object.assign(this, { key, values });
    }
}

// ---- lines ----

function logicalLines(text) {
    const lines = [];
    let open = null;
    for (const raw of text.split(/\r\n|\r|\n/)) {
        const line = raw.replace(/^[ \t\f]+/, "");
        if (open === null && (line === "" || line[0] === "#" || line[0] === "!")) continue;
        let end = line.length;
        while (line[end - 1] === "\\") end--;
        const goesOn = (line.length - end) % 2 === 1;
        const joined = (open ?? "") + (goesOn ? line.slice(0, -1) : line);
        if (!goesOn) lines.push(joined);
        open = goesOn ? joined : null;
    }
    return open === null ? lines : [...lines, open];
}

function unescaped(text) {
    return text.replace(/\\(u[0-9a-fA-F]{4}|[^])/g, (whole, code) => {
        if (code.length === 5) return String.fromCharCode(parseInt(code.slice(1), 16));
        return { t: "\t", n: "\n", r: "\r", f: "\f" }[code] ?? code;
    });
}

/** Key and value of a line, read once from left to right: files come from anywhere. */
function property(line) {
    let at = 0;
    const skip = () => {
        while (line[at] === " " || line[at] === "\t") at++;
    };
    while (at < line.length && !"=: \t".includes(line[at])) at += line[at] === "\\" ? 2 : 1;
    const key = line.slice(0, at);
    skip();
    if (line[at] === "=" || line[at] === ":") at++;
    skip();
    return [unescaped(key), unescaped(line.slice(at)).trim()];
}

// ---- values ----

function numbersOf(all, key, count, fallback) {
    if (!all.has(key)) return fallback;
    const numbers = all.get(key).split(/\s+/).map(Number);
    if (numbers.length !== count || !numbers.every(Number.isFinite))
        throw new FileError("file.value", { key });
    return numbers;
}

function colourOf(all, key, fallback) {
    const rgb = numbersOf(all, key, 3, null);
    if (!rgb) return fallback;
    const byte = (x) => Math.round(255 * Math.min(Math.max(x, 0), 1)).toString(16).padStart(2, "0");
    return `#${rgb.map(byte).join("")}`;
}

const times = (a, b) =>
    IDENTITY.map((_, at) => [0, 1, 2, 3].reduce((sum, k) => sum + a[(at & ~3) + k] * b[4 * k + (at & 3)], 0));

/** Which way is up, which way back to the viewer, and how large the ball is that is shown. */
function viewOf(all) {
    const matrix = (key) => numbersOf(all, key, 16, IDENTITY);
    const turned = times(matrix("transform_matrix"), matrix("rotation_matrix"));
    const m = times(matrix("surface_transform_matrix"), turned);
    const scale = Math.hypot(m[0], m[4], m[8]);
    const radius = scale * 10 ** numbersOf(all, "scale_factor", 1, [0])[0];
    if (!(radius > 1e-6 && radius < 1e6)) throw new FileError("file.value", { key: "scale_factor" });
    const column = (j) => [m[j] / scale, m[4 + j] / scale, m[8 + j] / scale];
    return { up: column(1), back: column(2), radius };
}

/** Without the last digits, which are rounding errors. */
const told = (x) => Number(x.toPrecision(12));

/** A state's members from the text of a file. */
export function stateOfFile(text) {
    if (text.length > LARGEST) throw new FileError("file.large");
    const all = new Map(logicalLines(text).map(property));
    const equation = all.get("surface_equation");
    if (!equation) throw new FileError("file.none");
    if (!isPrintable(equation) || ![...all.keys()].every(isPrintable)) throw new FileError("unprintable");
    const { up, back, radius } = viewOf(all);
    const perspective = all.get("camera_type") !== "ORTHOGRAPHIC_CAMERA";
    const height = numbersOf(all, "camera_height", 1, [2])[0];
    const fov = perspective ? numbersOf(all, "camera_fov_y", 1, [60])[0] : FAR_FOV;
    const distance = perspective
        ? 1 / Math.sin((fov / 2) * RADIANS)
        : height / 2 / Math.tan((FAR_FOV / 2) * RADIANS);
    const parameters = {};
    for (const [key, value] of all) {
        const name = /^surface_parameter_(.+)$/.exec(key)?.[1];
        if (name && Object.keys(parameters).length < LIMITS.parameters)
            parameters[name] = { value: Number(value) };
    }
    const outside = colourOf(all, "front_material_color", null);
    return {
        name: "",
        equation,
        parameters,
        extent: { kind: "sphere", size: [radius], centre: [0, 0, 0] },
        camera: {
            eye: back.map((x) => told(x * distance * radius)),
            lookAt: [0, 0, 0],
            up: up.map(told),
            fov,
        },
        colours: {
            outside,
            inside: colourOf(all, "back_material_color", outside),
            background: colourOf(all, "background_color", "none"),
        },
    };
}

// ---- writing ----

function escaped(text) {
    const one = (c) => (c > "~" ? `\\u${c.charCodeAt(0).toString(16).padStart(4, "0")}` : c);
    return text.replace(/\\/g, "\\\\").replace(/[^ -~]/g, one);
}

function rgbOf(colour) {
    return [1, 3, 5].map((i) => parseInt(colour.slice(i, i + 2), 16) / 255).join(" ");
}

/** The text of a file of a state: SURFER shows balls about the origin, from outside. */
export function fileOf(state, axes) {
    const { right, up, forward } = axes, radius = radiusOf(state.extent);
    const rotation = [0, 1, 2].flatMap((i) => [right[i], up[i], -forward[i], 0]);
    const lines = [
        "#libalgsurf",
        `surface_equation=${escaped(state.equation)}`,
        ...Object.entries(state.parameters).map(([name, p]) => `surface_parameter_${escaped(name)}=${p.value}`),
        "transform_matrix=" + IDENTITY.join(" "),
        "rotation_matrix=" + [...rotation, 0, 0, 0, 1].join(" "),
        `scale_factor=${Math.log10(radius)}`,
        "surface_transform_matrix=" + IDENTITY.join(" "),
        "camera_type=PERSPECTIVE_CAMERA",
        `camera_fov_y=${(2 / RADIANS) * Math.asin(Math.min(0.99, radius / axes.distance))}`,
        `front_material_color=${rgbOf(state.colours.outside)}`,
        `back_material_color=${rgbOf(state.colours.inside)}`,
        `background_color=${isColour(state.colours.background) ? rgbOf(state.colours.background) : "1 1 1"}`,
    ];
    return `${lines.join("\n")}\n`;
}
