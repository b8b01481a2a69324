// command.js - the command line of the program render that draws a state, pixel for pixel.
import { isBox, isInOwnColours, printable } from "../state/state.js";

const list = (numbers) => numbers.map(String).join(",");

/** A word of a POSIX shell, of printable characters: a terminal acts on others before the shell does. */
export function quoted(text) {
    if (/^[A-Za-z0-9_./:,=-]+$/.test(text)) return text;
    return `'${printable(text).replaceAll("'", "'\\''")}'`;
}

/** A name for files: of the surface, else "surface". */
export function stemOf(state) {
    return /^[a-z0-9-]+$/.test(state.name) ? state.name : "surface";
}

function extentWords(extent) {
    const { size, centre } = extent;
    const words = ["--extent", isBox(extent) ? `box:${list(size)}` : `sphere:${size[0]}`];
    return centre.some((x) => x !== 0) ? [...words, "--centre", list(centre)] : words;
}

function colourWords(state) {
    const { outside, inside, background } = state.colours;
    const words = isInOwnColours(state) ? [] : ["--colour", outside, "--inside", inside];
    return background === null ? words : [...words, "--background", background];
}

function complexWords({ sigma, delta, imaginary }) {
    const parts = Object.entries(imaginary).filter(([, v]) => v !== 0);
    return [
        "--sigma",
        String(sigma),
        "--delta",
        String(delta),
        ...parts.flatMap(([k, v]) => ["--imag", `${k}=${v}`]),
    ];
}

/** A plane as --clip has it. */
function clipWords(plane) {
    return ["--clip", list(plane)];
}

/** options: { width, height, quality, antialias, sweep: { kind: "turn"|"let", name, from, to, pictures, rate
 * } } */
export function commandWords(state, { width, height, quality = "standard", antialias = 4, sweep = null }) {
    const { eye, lookAt, up, fov } = state.camera;
    const letters = Object.entries(state.parameters).filter(
        ([name]) => sweep?.kind !== "let" || name !== sweep.name,
    );
    const words = ["render", "--equation", state.equation];
    for (const [name, p] of letters) words.push("--let", `${name}=${p.value}`);
    words.push(...extentWords(state.extent), ...state.clip.flatMap(clipWords));
    words.push("--eye", list(eye), "--look-at", list(lookAt), "--up", list(up), "--fov", String(fov));
    words.push(...colourWords(state));
    if (state.light) words.push("--light", `${state.light.azimuth}:${state.light.elevation}`);
    if (state.thin !== null && !(state.thin && state.complex))
        words.push("--thin", state.thin ? state.colours.outside : "none");
    for (const name of ["axes", "box"]) if (state[name]) words.push(`--${name}`);
    if (state.complex) words.push(...complexWords(state.complex));
    words.push("--size", `${width}x${height}`, "--antialias", String(antialias));
    if (quality !== "standard" && !state.complex) words.push("--quality", quality);
    if (sweep) {
        const what = sweep.kind === "turn" ? "turn" : `let:${sweep.name}:${sweep.from}:${sweep.to}`;
        words.push("--sweep", `${what}:${sweep.pictures}`, "--animate", String(sweep.rate));
    }
    return [...words, "--output", `${stemOf(state)}.png`];
}

/** The same as one line for a shell. */
export function commandOf(state, options) {
    return commandWords(state, options).map(quoted).join(" ");
}
