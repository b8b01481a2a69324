// The npm package: its answers have the bits of the native programs, its errors say what is wrong, its memory does
// not grow.  Run by cli_npm.
//
//     node --expose-gc npm_test.mjs PACKAGE_FOLDER ANSWERS_FOLDER
import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { pathToFileURL } from "node:url";

const [folder, answers] = process.argv.slice(2);
const { load, compile, AlgsurfError, MISS, HIT, UNDECIDED } = await import(pathToFileURL(`${folder}/algsurf.mjs`));
let checks = 0, failures = 0;

function check(holds, what) {
    checks++;
    if (!holds) {
        failures++;
        console.error(`FAILED: ${what}`);
    }
}

function equal(what, expected, got) {
    checks++;
    if (expected.length === got.length && expected.every((e, i) => Object.is(e, got[i]))) return;
    failures++;
    const at = expected.findIndex((e, i) => !Object.is(e, got[i]));
    console.error(`FAILED: ${what}: at ${at}: ${got[at]}, not ${expected[at]}; ${got.length} of ${expected.length}`);
}

const lines = (name) => readFileSync(`${answers}/${name}`, "utf8").split("\n").filter((line) => line !== "");

/** Decimal or hexadecimal, infinite or NaN, to the double it stands for. */
function number(text) {
    const word = /^(-?)(inf|nan)$/.exec(text);
    if (word) return word[2] === "nan" ? NaN : word[1] ? -Infinity : Infinity;
    const hex = /^(-?)0x([0-9a-f]+)\.?([0-9a-f]*)p([-+]?\d+)$/.exec(text);
    if (!hex) return Number(text);
    const exponent = Number(hex[4]) - 4 * hex[3].length, half = Math.trunc(exponent / 2);
    return Number(`0x${hex[2]}${hex[3]}`) * 2 ** half * 2 ** (exponent - half) * (hex[1] ? -1 : 1);
}
const hexadecimal = ["-0x1.ap+2", "0x0.0000000000001p-1022", "0x1p+1023"];
equal("hexadecimal numbers", [-6.5, 5e-324, 2 ** 1023], hexadecimal.map(number));

const algsurf = await load();

/** Rows of a table of the program roots, for each line of its input. */
function tableOf(name) {
    const [head, ...rows] = lines(name).map((line) => line.replace("#", "").split("\t"));
    const byLine = new Map();
    for (const row of rows) {
        const entry = Object.fromEntries(head.map((column, i) => [column, row[i]]));
        if (!byLine.has(entry.line)) byLine.set(entry.line, []);
        if (entry.index !== "error") byLine.get(entry.line).push(entry);
    }
    return (line) => byLine.get(String(line)) ?? [];
}

const cells = (row, ...names) => names.map((name) => number(row[name]));
let compared = 0;

const realTable = tableOf("real_roots.tsv");
lines("real_polynomials").forEach((line, i) => {
    const roots = algsurf.realRoots(line.split(" ").map(number), { lo: 0 });
    const expected = realTable(i + 1).flatMap((row) => cells(row, "re", "re_lo", "re_hi", "multiplicity"));
    equal(`real roots of line ${i + 1}`, expected, roots.flatMap((r) => [r.root, r.lo, r.hi, r.multiplicity]));
    compared += roots.length;
});
check(compared > 500, `only ${compared} real roots`);

compared = 0;
const complexTable = tableOf("roots.tsv");
lines("polynomials").forEach((line, i) => {
    const c = line.split(" ").map((pair) => pair.split(",").map(number));
    const real = c.every(([, im]) => im === 0);
    const roots = algsurf.complexRoots(real ? c.map(([re]) => re) : c);
    const names = ["re", "im", "re_lo", "re_hi", "im_lo", "im_hi", "multiplicity"];
    const expected = complexTable(i + 1).flatMap((row) => cells(row, ...names));
    const flat = ({ root, box, multiplicity }) => [root.re, root.im, ...box.re, ...box.im, multiplicity];
    equal(`complex roots of line ${i + 1}`, expected, roots.flatMap(flat));
    check(roots.every((r) => !r.real || r.box.im.every((y) => y === 0)), `real roots of line ${i + 1}`);
    compared += roots.length;
});
check(compared > 1000, `only ${compared} complex roots`);

const transposed = (rows) => rows[0].map((_, k) => Float64Array.from(rows, (row) => row[k]));
const numbersOf = (line) => line.split(" ").map(number);
const termsOf = (name) => lines(name).filter((line) => !line.startsWith("#")).map(numbersOf);

for (const name of ["sphere", "torus", "boy", "decic"]) {
    const surface = algsurf.surfaceFromTerms(termsOf(`${name}.terms`));
    const rays = lines(`${name}.rays`).map(numbersOf);
    const [ox, oy, oz, dx, dy, dz, tMin, tMax] = transposed(rays);
    const hits = algsurf.firstHits(surface, { origin: [ox, oy, oz], direction: [dx, dy, dz], tMin, tMax });
    const states = { miss: MISS, hit: HIT, undecided: UNDECIDED };
    const columns = [hits.t, hits.tLo, hits.tHi, ...hits.position, ...hits.normal];
    lines(`${name}.tsv`).slice(1).forEach((line, i) => {
        const [, state, ...numbers] = line.split("\t");
        equal(`${name}: state of ray ${i + 1}`, [states[state]], [hits.state[i]]);
        const found = columns.map((column) => column[i]);
        if (state === "hit") equal(`${name}: ray ${i + 1}`, numbers.slice(0, 9).map(number), found);
    });
    check(hits.state.filter((s) => s === HIT).length > 20, `${name}: too few hits`);

    // More rays than are handed over at once, without ends, as plain arrays: the same hits.
    const many = Array.from({ length: 10000 }, (_, i) => rays[i % rays.length]);
    const [x, y, z, u, v, w] = transposed(many).map((column) => Array.from(column));
    const ball = { sphere: 3, centre: [0, 0, 0] };
    const once = algsurf.firstHits(surface, { origin: [ox, oy, oz], direction: [dx, dy, dz] }, ball);
    const often = algsurf.firstHits(surface, { origin: [x, y, z], direction: [u, v, w] }, ball);
    for (const key of ["t", "tLo", "state", "side", "multiplicity"])
        equal(`${name}: ${key} of many rays`, many.map((_, i) => once[key][i % rays.length]), Array.from(often[key]));
    surface.free();
}

// Pictures, in the colours of a scene.
const eye = [4, 3, 2.5];
const view = { width: 160, height: 120, camera: { eye }, extent: { sphere: 2.5 }, distances: true };
const ways = {
    plain: {},
    fine: { antialias: 3, antialiasThreshold: 0.1, background: [1, 1, 1] },
    shadows: { quality: "full" },
    preview: {
        quality: "preview",
        camera: { eye, orthographic: 5 },
        extent: { box: [1.5, 1, 1], centre: [0.25, 0, 0] },
    },
    complex: { complexSpace: { delta: Math.PI / 18, imaginary: [0.5] } },
};
const barth = algsurf.surface(lines("equation")[0], { p: (1 + Math.sqrt(5)) / 2 });
equal("degree", [6], [barth.degree]);
for (const [way, options] of Object.entries(ways)) {
    const picture = algsurf.render(barth, { ...view, ...options });
    const file = readFileSync(`${answers}/${way}.ppm`);
    const pixels = 160 * 120, rgb = file.subarray(file.length - 3 * pixels);
    const rgba = Array.from({ length: 4 * pixels }, (_, i) => (i % 4 < 3 ? rgb[3 * (i >> 2) + (i % 4)] : 255));
    equal(`${way}: bytes`, rgba, Array.from(picture.data));
    const hits = readFileSync(`${answers}/${way}.hits`);
    const t = Array.from({ length: pixels }, (_, i) => hits.readDoubleLE(8 * i)).map((x) => (isNaN(x) ? Infinity : x));
    equal(`${way}: distances`, t, Array.from(picture.t));
    check(picture.hits > 1000 && picture.undecided === 0 && picture.rays >= pixels, `${way}: counts`);
    const slice = algsurf.render(barth, { ...view, ...options, rows: [40, 77], distances: false });
    equal(`${way}: a slice`, Array.from(picture.data.subarray(160 * 4 * 40, 160 * 4 * 77)), Array.from(slice.data));
    equal(`${way}: its size`, [160, 37, undefined], [slice.width, slice.height, slice.t]);
}

const usual = algsurf.render(barth, view), other = algsurf.render(barth, { ...view, material: { haze: 1 } });
check(usual.data.some((byte, i) => byte !== other.data[i]), "the material changes nothing");

/** The call throws an AlgsurfError with this code, and offset, whose text names the code. */
function refused(code, call, offset, length) {
    try {
        call();
        check(false, `not refused: ${call}`);
    } catch (error) {
        const { status, message } = error;
        check(error instanceof AlgsurfError && error.code === code && status < 0, `${call}: ${error}`);
        check(message.startsWith(`${code}: `) && error.offset === offset, `${call}: ${message}, ${error.offset}`);
        if (length !== undefined) check(error.length === length, `${call}: length ${error.length}`);
    }
}
refused("E_SYNTAX", () => algsurf.surface("x^2 + $"), 6);
refused("E_SYNTAX", () => algsurf.surface("\u00e9 + x"), 0);
refused("E_SYNTAX", () => algsurf.surface(""), 0);
refused("E_NAME", () => algsurf.surface("x + b y", { a: 2 }), 4, 1);
refused("E_NAME", () => algsurf.surface("x\u00b2 + radius x", { a: 2 }), 5, 6);
refused("E_SYNTAX", () => algsurf.surface("x \u0436"), 2, 1);
refused("E_DEGREE", () => algsurf.surface("x + y^65"), 5);
refused("E_ZERO", () => algsurf.surface("x - x"));
refused("E_ARGUMENT", () => algsurf.surface("x", { x: 1 }));
refused("E_NOT_FINITE", () => algsurf.surface("x + a", { a: NaN }));
refused("E_ARGUMENT", () => algsurf.surfaceFromTerms([[1.5, 0, 0, 1]]));
refused("E_ARGUMENT", () => algsurf.surfaceFromTerms([[-1, 0, 0, 1]]));
refused("E_ARGUMENT", () => algsurf.surfaceFromTerms([]));
refused("E_ZERO", () => algsurf.surfaceFromTerms([[1, 0, 0, 0]]));
refused("E_ARGUMENT", () => algsurf.realRoots([]));
refused("E_ZERO", () => algsurf.realRoots([0, 0]));
refused("E_NOT_FINITE", () => algsurf.realRoots([1, Infinity]));
refused("E_ARGUMENT", () => algsurf.realRoots([1, 1], { lo: 1, hi: 0 }));
refused("E_DEGREE", () => algsurf.realRoots(new Float64Array(600).fill(1)));
refused("E_ARGUMENT", () => algsurf.complexRoots([]));
refused("E_NOT_FINITE", () => algsurf.complexRoots([[0, NaN], 1]));
const origin = [[0], [0], [0]];
refused("E_ARGUMENT", () => algsurf.firstHits(barth, { origin, direction: [[0], [0], [0]] }));
refused("E_ARGUMENT", () => algsurf.firstHits(barth, { origin, direction: [[1], [0], [0, 0]] }));
refused("E_ARGUMENT", () => algsurf.firstHits(barth, { origin, direction: [[1], [0], [0]] }, { sphere: -1 }));
const badOptions = [
    { width: 0 }, { height: 1.5 }, { width: 65536 }, { rows: [5, 5] }, { rows: [-1, 5] }, { rows: [0, 121] },
    { rows: [0.5, 1] }, { quality: "best" }, { antialias: 0 }, { antialiasThreshold: 2 }, { background: [-1, 0, 0] },
    { camera: { eye: [0, 0, 0] } }, { camera: { eye: [0, 0, 9] } }, { extent: { box: [1, 1, 0] } },
    { complexSpace: { delta: 9 } }, { complexSpace: { delta: 1, imaginary: new Float64Array(66) } },
    { material: { roughness: 0 } },
];
for (const bad of badOptions) refused("E_ARGUMENT", () => algsurf.render(barth, { ...view, ...bad }));
refused("E_NO_MEMORY", () => algsurf.render(barth, { ...view, width: 65535, height: 65535 }));

/** The call throws a TypeError: misuse of JavaScript, not of mathematics. */
function misused(call) {
    try {
        call();
        check(false, `not refused: ${call}`);
    } catch (error) {
        check(error instanceof TypeError, `${call}: ${error}`);
    }
}
const freed = algsurf.surface("x");
freed.free();
freed.free();
misused(() => freed.degree);
misused(() => algsurf.render(freed, view));
misused(() => algsurf.surface("x\0y"));
misused(() => algsurf.render(barth, { ...view, extent: {} }));
if (Symbol.dispose) {
    const disposed = algsurf.surface("x");
    disposed[Symbol.dispose]();
    misused(() => disposed.degree);
}

// Other instances: from bytes, from a compiled module, from a server, as in a browser.
const bytes = readFileSync(`${folder}/algsurf.wasm`);
const server = createServer((request, response) => {
    if (request.url === "/algsurf.wasm") response.end(bytes);
    else response.writeHead(404).end();
});
await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
const address = `http://127.0.0.1:${server.address().port}`;
for (const source of [bytes, await compile(), `${address}/algsurf.wasm`]) {
    const other = await load(source);
    equal("another instance", [Math.SQRT2], other.realRoots([-2, 0, 1], { lo: 0 }).map((r) => r.root));
    misused(() => other.render(barth, view));
}
const missing = await load(`${address}/nothing`).catch((error) => error.message);
check(/: 404 /.test(missing), `a file that is not there: ${missing}`);
server.close();

// 10,000 calls, those that fail among them, and surfaces that nobody frees: no more memory than after the first.
async function thousandCalls() {
    for (let i = 0; i < 125; i++) {
        const surface = algsurf.surface("x^4 + y^4 + z^4 - (x^2 + y^2 + z^2) + a", { a: i / 1000 });
        algsurf.surfaceFromTerms([[2, 0, 0, 1], [0, 0, 0, -1]]);
        algsurf.realRoots([i, -50, 35, -10, 1]);
        algsurf.complexRoots([1, [2, 3], 4, 5]);
        algsurf.firstHits(surface, { origin: [[-4], [0.1], [0]], direction: [[1], [0], [0]] }, { sphere: 2 });
        algsurf.render(surface, { width: 16, height: 12, extent: { sphere: 2 } });
        refused("E_SYNTAX", () => algsurf.surface("x +"), 3);
        refused("E_ARGUMENT", () => algsurf.render(surface, { width: 9, height: 9, antialias: 99 }));
        surface.free();
    }
    globalThis.gc();
    await new Promise((resolve) => setTimeout(resolve, 10)); // finalizers run between tasks
}
await thousandCalls();
const before = algsurf.memoryBytes;
for (let i = 0; i < 10; i++) await thousandCalls();
equal("memory after 10,000 calls", [before], [algsurf.memoryBytes]);

// The types name what the module has.
const textOf = (file) => readFileSync(`${folder}/${file}`, "utf8");
const words = (text, pattern) => [...text.matchAll(pattern)].map((match) => match[1]).sort();
const exported = (file) => words(textOf(file), /^export (?:async )?(?:class|const|function) (\w+)/gm);
equal("exported names", exported("algsurf.mjs"), exported("algsurf.d.ts"));
equal("their number", [6], [exported("algsurf.mjs").length]);
const [, body] = /^export interface Algsurf \{(.*?)^\}/ms.exec(textOf("algsurf.d.ts"));
const declared = words(body, /^ {4}(?:readonly )?(\w+)[(:]/gm);
const prototype = Object.getOwnPropertyNames(Object.getPrototypeOf(algsurf));
const own = [...prototype, ...Object.keys(algsurf)].filter((name) => name !== "constructor").sort();
equal("members", declared, own);
equal("version", [algsurf.version], [JSON.parse(textOf("package.json")).version]);

if (failures > 0) {
    console.error(`${failures} of ${checks} checks failed`);
    process.exit(1);
}
console.log(`${checks} checks passed`);
