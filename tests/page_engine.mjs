// The page's engine in node: its pictures have the bytes of `render`, its views are those that `render` chooses, its
// rays have the bits of `intersect`, what is wrong with an equation is told at its place, and no state, however
// broken, harms it.  Run by cli_page.
//
//     node page_engine.mjs PAGE_FOLDER PROGRAM_FOLDER
import { spawnSync } from "node:child_process";
import { pathToFileURL } from "node:url";

const [folder, programs] = process.argv.slice(2);
const { Engine } = await import(pathToFileURL(`${folder}/picture/engine.js`));
const engine = await Engine.load();
let checks = 0, failures = 0;

function check(holds, what) {
    checks++;
    if (holds) return;
    failures++;
    console.error(`FAILED: ${what}`);
}

/** Are the doubles the same, or numbers that near to each other? */
function near(a, b, error) {
    return a === b || Math.abs(a - b) <= error * Math.max(1, Math.abs(b));
}

// ---- states, and the options that say the same ----

const usual = {
    equation: "x^2 + y^2 + z^2 = 1",
    parameters: {},
    extent: { kind: "sphere", size: [2], centre: [0, 0, 0] },
    clip: [],
    camera: { eye: [4, -5, 3], lookAt: [0, 0, 0], up: [0, 0, 1], fov: 25 },
    colours: { outside: null, inside: null, background: null },
    light: null,
    thin: null,
    complex: null,
};
const BARTH =
    "4((3+sqrt(5))/2*x^2 - y^2)((3+sqrt(5))/2*y^2 - z^2)((3+sqrt(5))/2*z^2 - x^2)" +
    " - (2+sqrt(5))(x^2+y^2+z^2-1)^2";
const TANGLE = "x^4 - 5x^2 + y^4 - 5y^2 + z^4 - 5z^2 + 11.8";
const tangle = { ...usual, equation: TANGLE, extent: { kind: "sphere", size: [3.7], centre: [0, 0, 0] } };
tangle.camera = { eye: [6.12, -12.51, 7.19], lookAt: [-0.05, -0.16, -0.22], up: [0, 0, 1], fov: 25 };
const states = {
    sphere: usual,
    barth: { ...usual, equation: BARTH, camera: { ...usual.camera, eye: [8.33, -5.15, 0.52] } },
    "barth without thin": { ...usual, equation: BARTH, thin: false },
    "Whitney's umbrella, thin": { ...usual, equation: "x^2 z + y^2" },
    "a box": { ...tangle, extent: { kind: "box", size: [1.9, 2.5, 1], centre: [0.25, 0, -0.5] } },
    parameters: {
        ...usual,
        equation: "a x^2 + b*y^2 = c_1 z + 0.1",
        parameters: {
            a: { value: -1.0625 },
            b: { value: 0.1 },
            c_1: { value: 1 / 3, from: 0, to: 1 },
            unused: { value: 7 }, // the page keeps what was a slider; render refuses it
        },
    },
    colours: {
        ...tangle,
        colours: { outside: "#c02040", inside: "#20E0a0", background: "#123456" },
        light: { azimuth: -40, elevation: 35 },
    },
    "one colour": { ...usual, equation: "z = x y", colours: { outside: "#ffb000", inside: null, background: null } },
    "degree 9": { ...usual, equation: "x^9 + y^9 + z^9 = x^2 + y^2 + z^2" },
    "degree 16": { ...usual, equation: "x^16 + y^16 + z^16 = 1", camera: { ...usual.camera, up: [0.1, 0.2, 1] } },
    axes: { ...tangle, axes: true },
    "a box of one's own, in another colour": {
        ...tangle,
        extent: { kind: "box", size: [1.9, 2.5, 1], centre: [0.25, 0, -0.5] },
        clip: [[0, -1, 0, 0.7]],
        colours: { outside: null, inside: null, background: "#102030" },
        axes: true,
        box: true,
    },
    "axes in complex space": { ...tangle, axes: true, complex: { sigma: 0.1, delta: 0.25, imaginary: {} } },
    "one plane": { ...tangle, clip: [[0, 0, 1, 0.5]] },
    "three planes": { ...tangle, clip: [[1, 0.3, 0, 1.1], [-2, 5, 1, 4], [0, 0, -1e-3, 1.5e-3]] },
    "complex space, cut": { ...tangle, clip: [[0, -1, 0, 0.7]], complex: { sigma: 0.1, delta: 0.25, imaginary: {} } },
    complex: { ...tangle, complex: { sigma: 0.1, delta: 0.25, imaginary: {} } },
    imaginary: { ...usual, complex: { sigma: 0, delta: 0.4, imaginary: { 0: 0.5, 2: -0.125 } } },
};

function optionsOf({ equation, parameters, extent, clip, camera, colours, light, thin, complex, axes, box }) {
    const list = (numbers) => numbers.join(",");
    const options = ["--equation", equation, "--centre", list(extent.centre)];
    for (const [name, { value }] of Object.entries(parameters))
        if (equation.includes(name)) options.push("--let", `${name}=${value}`);
    options.push("--extent", `${extent.kind}:${list(extent.size)}`);
    for (const plane of clip) options.push("--clip", list(plane));
    options.push("--eye", list(camera.eye), "--look-at", list(camera.lookAt), "--up", list(camera.up));
    options.push("--fov", String(camera.fov));
    if (colours.outside) options.push("--colour", colours.outside);
    if (colours.inside) options.push("--inside", colours.inside);
    if (colours.background) options.push("--background", colours.background);
    if (light) options.push("--light", `${light.azimuth}:${light.elevation}`);
    if (thin === false) options.push("--thin", "none");
    if (axes) options.push("--axes");
    if (box) options.push("--box");
    if (complex) {
        options.push("--sigma", String(complex.sigma), "--delta", String(complex.delta));
        for (const [k, value] of Object.entries(complex.imaginary)) options.push("--imag", `${k}=${value}`);
    }
    return options;
}

function run(program, options, input) {
    const { status, stdout, stderr } = spawnSync(`${programs}/${program}`, options, { input, maxBuffer: 1 << 28 });
    if (status !== 0) throw new Error(`${program} ${options.join(" ")}: ${stderr}`);
    return { stdout, stderr: String(stderr) };
}

// ---- pictures ----

const size = { width: 97, height: 73 };
const native = (state, { width, height, quality = "standard", antialias = 1 }) => {
    const options = [...optionsOf(state), "--size", `${width}x${height}`, "--quality", quality];
    options.push("--antialias", String(antialias), "--progress", "never", "--output", "-");
    const { stdout } = run("render", options);
    return stdout.subarray(stdout.length - 3 * width * height);
};

/** A picture of the engine in bands of so many rows, without alpha, which is 255. */
function drawn(state, options, rows = options.height) {
    const rgb = Buffer.alloc(3 * options.width * options.height);
    for (let rowBegin = 0; rowBegin < options.height; rowBegin += rows) {
        const rowEnd = Math.min(options.height, rowBegin + rows);
        const { data } = engine.render(state, { ...options, rowBegin, rowEnd });
        const first = 3 * options.width * rowBegin;
        for (let i = 0; i < data.length / 4; i++) {
            for (let k = 0; k < 3; k++) rgb[first + 3 * i + k] = data[4 * i + k];
            if (data[4 * i + 3] !== 255) check(false, "a pixel that is not opaque");
        }
    }
    return rgb;
}

for (const [name, state] of Object.entries(states)) {
    const expected = native(state, size);
    check(drawn(state, size).equals(expected), `the picture of ${name}`);
    check(drawn(state, size, 10).equals(expected), `the picture of ${name}, in bands`);
    check(new Set(expected).size > 20, `${name} is seen`);
}
for (const look of [{ quality: "full" }, { quality: "preview" }, { quality: "full", antialias: 4 }]) {
    const [got, expected] = [drawn(tangle, { ...size, ...look }), native(tangle, { ...size, ...look })];
    const others = got.reduce((sum, byte, i) => sum + (byte !== expected[i]), 0);
    check(others <= (look.antialias ? 2 : 0), `${JSON.stringify(look)}: ${others} other bytes`); // see render.h
}
const clear = engine.render({ ...tangle, colours: { background: "none" } }, size).data;
const share = clear.filter((byte, i) => i % 4 === 3 && byte === 0).length / (size.width * size.height);
check(share > 0.2 && share < 0.8, `without a background ${share} of the picture is transparent`);

// ---- what is shown ----

for (const equation of [BARTH, TANGLE, "x^2 + y^2 = z^2", "(x-3)^2 + 4y^2 + z^2 = 0.01", "z^3 + x z + y", "x^2 z + y^2"]) {
    const fitted = { ...usual, equation, extent: { kind: "fitted" }, camera: null };
    const { stderr } = run("render", ["--equation", equation, "--size", "64x48", "--output", "/dev/null"]);
    const chosen = { "--centre": "0,0,0", "--fov": "25" };
    const words = /chosen: (.*)/.exec(stderr)[1].split(" ");
    for (let i = 0; i < words.length; i += 2) chosen[words[i]] = words[i + 1];
    const { extent, camera } = engine.fit(fitted, { width: 64, height: 48 });
    const got = { "--extent": `sphere:${extent.size[0]}`, "--centre": String(extent.centre), "--eye": String(camera.eye) };
    got["--look-at"] = String(camera.lookAt);
    got["--fov"] = String(camera.fov);
    for (const option in got) check(got[option] === chosen[option], `${equation}: ${option} ${got[option]}, not ${chosen[option]}`);
    check(extent.kind === "fitted" && String(camera.up) === "0,0,1", `${equation}: kind and up`);
}
const boxed = engine.fit({ ...states["a box"], camera: null });
check(String(boxed.extent.size) === "1.9,2.5,1" && boxed.extent.kind === "box", "an extent that is given stays");

// ---- equations ----

/** What a call throws. */
function thrown(call) {
    try {
        call();
    } catch (error) {
        return error;
    }
    return { code: "nothing" };
}

const wrong = [
    ["x^2 +* y", "E_SYNTAX", 5, 1],
    ["x^2 + é² = 1", "E_SYNTAX", 6, 1], // in characters, not in bytes
    ["ππ x = é", "E_SYNTAX", 7, 1],
    ["x^65", "E_DEGREE", 1, 1],
    ["(x", "E_SYNTAX", 2, 0],
    ["x^1000", "E_DEGREE", 1, 1],
    ["tan(x)", "E_SYNTAX", 0, 3],
    ["x = 1e999", "E_RANGE", 4, 5],
    ["x\0y", "E_SYNTAX", 1, 1],
    ["x - x", "E_ZERO", null, 0],
    ["", "E_SYNTAX", 0, 0],
];
for (const [equation, code, offset, length] of wrong) {
    const error = thrown(() => engine.compile(equation));
    const got = [error.code, error.offset, error.length].join();
    check(got === [code, offset, length].join(), `${equation}: ${got}, not ${code},${offset},${length}`);
    check(typeof error.message === "string" && !/, at \d+$/.test(error.message), `${equation}: ${error.message}`);
}
const compiled = (equation, values) => JSON.stringify(engine.compile(equation, values));
const expectCompiled = (equation, values, degree, letters, missing) =>
    check(
        compiled(equation, values) === JSON.stringify({ degree, letters, missing }),
        `${equation}: ${compiled(equation, values)}`,
    );
expectCompiled("x^2 + y^2 = z", {}, 2, [], []);
expectCompiled("(x+y+z+1)^64", {}, 64, [], []);
expectCompiled("x^2 + a y^2 = b*z^3 + a", {}, 3, ["a", "b"], ["a", "b"]);
expectCompiled("x^2 + a y^2 = b z", { b: 2, c: 3 }, 2, ["b", "a"], ["a"]);
expectCompiled("x^2 + \u03c6 y^2 = \u03c0 z", {}, 2, ["\u03c6"], ["\u03c6"]); // a Greek letter; pi is no name
expectCompiled("x^2 + \\mu y^2 = \\pi z", { "\\mu": 2 }, 2, ["\\mu"], []);
const unset = thrown(() => engine.render({ ...usual, equation: "x^2 = radius" }, size));
check(unset.code === "E_NAME" && unset.name === "radius" && unset.offset === 6, `no value: ${unset.code}, ${unset.name}`);

// ---- one ray ----

for (const [name, state] of Object.entries(states).filter(([, { complex }]) => !complex)) {
    const place = { ...size, x: 44, y: 40 };
    const pick = engine.pick(state, place);
    if (!pick) {
        check(false, `${name}: the middle ray misses the extent`);
        continue;
    }
    const { origin, direction } = pick.ray;
    const ray = [...origin, ...direction, 0, "inf"].join(" ");
    const options = optionsOf({ ...state, colours: {}, light: null, thin: null });
    const own = options.filter((_, i) => ["--equation", "--let", "--extent", "--centre", "--clip"].includes(options[i - (i % 2)]));
    const [row] = String(run("intersect", [...own, "--format", "json"], ray).stdout).trim().split("\n").map((line) => JSON.parse(line));
    const same = ["t", "t_lo", "t_hi"].every((key, i) => pick.state === "miss" || pick[["t", "tLo", "tHi"][i]] === row[key]);
    check(pick.state === row.state && same, `${name}: pick ${pick.state} ${pick.t}, intersect ${row.state} ${row.t}`);
    const picture = engine.render(state, { ...size, rowBegin: 40, rowEnd: 41, t: true });
    if (pick.state === "hit" && state.thin === false) check(near(picture.t[44], pick.t, 1e-9), `${name}: t of the picture`);

    const { tMin, tMax } = pick.ray;
    const roots = engine.complexRoots(state, place);
    const sum = roots.reduce((total, root) => total + root.multiplicity, 0);
    const value = pick.polynomial.findLastIndex((c) => c !== 0);
    check(sum === value, `${name}: ${sum} roots of degree ${value}`);
    check(roots.every(({ re, im, box }) => box[0] <= re && re <= box[1] && box[2] <= im && im <= box[3]), `${name}: boxes`);
    const onChord = roots.filter(({ real, re }) => real && re >= tMin && re <= tMax);
    const isolated = engine.isolate(state, place);
    check(isolated.brackets.length === onChord.length, `${name}: ${isolated.brackets.length} of ${onChord.length} roots isolated`);
    isolated.hits.forEach(({ t }, i) => {
        check(near(t, onChord[i]?.re, 1e-6), `${name}: root ${i} at ${t}, not ${onChord[i]?.re}`);
        const { lo, hi } = isolated.brackets[i];
        check(lo <= t && t <= hi, `${name}: bracket ${lo} to ${hi} without ${t}`);
    });
    const { hull, curve } = isolated;
    check(hull.length === pick.degree + 1 && curve.at(-1)[1] === hull.at(-1)[1] && curve[0][1] === hull[0][1], `${name}: hull`);
    const chosen = roots.filter((root) => root.chosen);
    check(chosen.length === (pick.state === "hit" ? 1 : 0), `${name}: ${chosen.length} roots are shown`);
    if (pick.state !== "hit") continue;
    check(near(chosen[0].re, pick.t, 1e-6) && chosen[0].real, `${name}: the root shown`);
    for (const method of ["default", "brent", "bisection", "regula-falsi"]) {
        const refined = engine.refine(state, place, method);
        check(near(refined.root, pick.t, 1e-9), `${name}: ${method} finds ${refined.root}, not ${pick.t}`);
        check(refined.points.length === refined.evaluations, `${name}: ${method}: points and evaluations`);
    }
}
const halving = ["bisection", "default"].map((method) => engine.refine(tangle, { ...size, x: 45, y: 36 }, method).evaluations);
check(halving[0] > 30 && halving[1] < 20 && halving[1] > 0, `evaluations: ${halving}`);
check(engine.pick(usual, { ...size, x: 0, y: 0 }) === null, "a ray that misses the extent");
check(engine.pick({ ...usual, clip: [[0, 0, 1, -2]] }, { ...size, x: 48, y: 36 }) === null, "a plane that keeps nothing");
const place = { ...size, x: 44, y: 40 };
const there = { ...size, x: 30, y: 36 };
const inComplex = engine.pick(states.complex, there);
const behind = engine.pick({ ...usual, clip: [[0.2, -0.7, 0.5, 0.1]] }, { ...size, x: 48, y: 36 });
check(behind.state === "hit" && behind.t > engine.pick(usual, { ...size, x: 48, y: 36 }).t, "a plane cuts the first hit off");
check(behind.ray.tMin <= behind.t && behind.t <= behind.ray.tMax, "the chord begins at the plane");
const seen = engine.complexRoots(states.complex, there).filter((root) => root.chosen);
check(seen.length === 1 && near(Math.hypot(seen[0].re, seen[0].im), inComplex.t, 1e-9), "the root that complex space shows");

// ---- boxes of roots hold the roots of the exact ray: the exact signs at their ends differ ----

/** A double as [n, e]: n 2^e. */
function exactly(x) {
    let e = 0;
    while (!Number.isInteger(x)) [x, e] = [2 * x, e - 1];
    return [BigInt(x), e];
}
const times = ([n, e], [m, f]) => [n * m, e + f];
const plus = ([n, e], [m, f]) => (e < f ? [n + (m << BigInt(f - e)), e] : [(n << BigInt(e - f)) + m, f]);
const ONE = exactly(1);

/** The sign of TANGLE's polynomial where the ray is at t. */
function exactSign({ origin, direction }, t) {
    const at = origin.map((o, i) => plus(exactly(o), times(exactly(t), exactly(direction[i]))));
    const parts = at.map((x) => times(x, times(x, plus(times(x, x), times(exactly(-5), ONE)))));
    const [n] = parts.reduce(plus, exactly(11.8));
    return n > 0n ? 1 : n < 0n ? -1 : 0;
}
let boxes = 0;
for (const away of [1, 10, 1e4]) {
    const eye = tangle.camera.eye.map((x) => away * x);
    const state = { ...tangle, camera: { ...tangle.camera, eye, fov: 25 / away } };
    for (let i = 0; i < 100; i++) {
        const at = { ...size, x: (37 * i) % size.width, y: (53 * i) % size.height };
        const pick = engine.pick(state, at);
        if (!pick) continue;
        for (const { box, real, multiplicity } of engine.complexRoots(state, at)) {
            if (!real || multiplicity > 1) continue;
            const signs = box.slice(0, 2).map((t) => exactSign(pick.ray, t));
            boxes++;
            check(signs[0] * signs[1] <= 0, `a root outside its box ${box.slice(0, 2)}, eye ${away} times as far`);
            check(box[1] - box[0] < 1e-9 * away, `a box as wide as ${box[1] - box[0]}`);
        }
    }
}
check(boxes > 200, `${boxes} boxes`);

// ---- states of all kinds ----

const far = (value) => ({ ...usual.camera, eye: value });
const bad = {
    "nothing": {},
    "null members": { ...usual, extent: null, camera: null, colours: null, parameters: null },
    "an eye at the point looked at": { ...usual, camera: far([0, 0, 0]) },
    "up along the view": { ...usual, camera: { ...far([0, 0, 5]), up: [0, 0, 1] } },
    "a field of view of 180": { ...usual, camera: { ...usual.camera, fov: 180 } },
    "a radius of 0": { ...usual, extent: { ...usual.extent, size: [0] } },
    "a kind that is none": { ...usual, extent: { ...usual.extent, kind: "cone" } },
    "a colour that is none": { ...usual, colours: { outside: "red; x" } },
    "too much light": { ...usual, light: { azimuth: 1e9, elevation: 0 } },
    "a sector above pi": { ...usual, complex: { sigma: 3, delta: 3 } },
    "coefficient 65": { ...usual, complex: { sigma: 0, delta: 1, imaginary: { 65: 1 } } },
    "a name that is none": { ...usual, parameters: { "a b": { value: 1 } } },
    "a plane at infinity": { ...usual, clip: [[0, 0, Infinity, 0]] },
    "a plane without a normal": { ...usual, clip: [[0, 0, 0, 1]] },
    "three numbers as a plane": { ...usual, clip: [[0, 0, 1]] },
    "nine planes": { ...usual, clip: new Array(9).fill([0, 0, 1, 0]) },
    "degree 1000": { ...usual, equation: "x^1000" },
    "a long equation": { ...usual, equation: "(".repeat(1 << 20) },
    "too long an equation": { ...usual, equation: "x+".repeat(1 << 20) },
    "no text": { ...usual, equation: 7 },
};
for (const value of [NaN, Infinity, -Infinity, "1", null, [], {}, 1e308]) {
    bad[`an eye at ${value}`] = { ...usual, camera: far([value, 1, 1]) };
    bad[`a radius of ${value}`] = { ...usual, extent: { ...usual.extent, size: [value] } };
    bad[`a parameter of ${value}`] = { ...usual, equation: "x = a", parameters: { a: { value } } };
}
delete bad["a parameter of 1e+308"]; // that one is none
const calls = [
    (state) => engine.render(state, size),
    (state) => engine.fit({ ...state, camera: null }),
    (state) => engine.pick(state, place),
    (state) => engine.isolate(state, place),
    (state) => engine.refine(state, place, "brent"),
    (state) => engine.complexRoots(state, place),
    (state) => engine.mesh(state, { format: "glb", cells: 8 }),
];
for (const [name, state] of Object.entries(bad)) {
    const { code } = thrown(() => calls[0](state));
    check(/^E_/.test(code) && code !== "E_TRAP", `${name}: ${code}`);
    for (const call of calls) check(!["E_TRAP", "E_INTERNAL"].includes(thrown(() => call(state)).code), `${name}: a trap`);
}
for (const strange of [
    { ...usual, equation: "1e300 x^2 + 1e-300 y = 1" },
    { ...usual, camera: far([1e200, 1, 1]) },
    { ...usual, extent: { kind: "sphere", size: [1e150], centre: [1e100, 0, 0] } },
    { ...usual, extent: { kind: "sphere", size: [1e-150], centre: [0, 0, 0] } },
    { ...usual, equation: "1" },
    { ...usual, equation: `x = ${Array.from({ length: 200 }, (_, i) => `p${i}`).join("+")}`, parameters: Object.fromEntries(Array.from({ length: 200 }, (_, i) => [`p${i}`, { value: i }])) },
    { ...usual, equation: `x=${"1+".repeat(100000)}1` },
])
    for (const call of calls) {
        const { code = "" } = thrown(() => call(strange));
        check(code === "nothing" || (/^E_/.test(code) && code !== "E_TRAP"), `${strange.equation.slice(0, 30)}: ${code}`);
    }
for (const options of [{}, { format: "ply", cells: 8 }, ...[NaN, 3, 1e9, "many"].map((cells) => ({ format: "stl", cells }))])
    check(thrown(() => engine.mesh(usual, options)).code === "E_ARGUMENT", `triangles of ${JSON.stringify(options)}`);
check(thrown(() => engine.mesh(states.complex, { format: "stl", cells: 8 })).code === "E_ARGUMENT", "triangles of complex space");
for (const options of [{ width: 0 }, { width: NaN }, { height: 1e9 }, { rowBegin: 5, rowEnd: 5 }, { rowEnd: 1000 }, { quality: "best" }, { antialias: 99 }]) {
    const { code } = thrown(() => engine.render(usual, { ...size, ...options }));
    check(code === "E_ARGUMENT", `${JSON.stringify(options)}: ${code}`);
}
check(drawn(states.barth, size).equals(native(states.barth, size)), "after all that, the picture is the same");
const held = engine.memoryBytes;
for (let i = 0; i < 300; i++) engine.render({ ...usual, equation: `x^2 + y^2 + z^2 = ${1 + i / 1000}` }, { width: 16, height: 12 });
check(engine.memoryBytes === held, `memory grew from ${held} to ${engine.memoryBytes}`);

console.log(`page_engine: ${checks} checks, ${failures} failures`);
process.exitCode = failures ? 1 : 0;
