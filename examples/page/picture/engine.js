// engine.js - the library as the page uses it: one wasm instance, one thread, every call ends with an answer.
//
//     const engine = await Engine.load(moduleOrAddress);
//     engine.compile("x^2 + y^2 = a", { a: 1 }).degree
//     engine.render(state, { width, height, rowBegin, rowEnd, quality: "standard", antialias: 1 }).data
//
// A state is what state.js makes; nothing of it is believed: what is out of range throws an EngineError with
// a code.  An instance that traps is replaced by a new one, and the call throws E_TRAP.  The calls are those
// of glue_*.c; what a state's members are there, `numbersOf` says.  Surface and scene are kept from one call to
// the next, for bands of a picture.  algsurf.js is ../npm/algsurf.mjs, of which the build exports the parts,
// too.
import { Algsurf, AlgsurfError, Module, compile, systemOf } from "../algsurf.js";
import { isBox, isInOwnColours, isName, LIMITS } from "../state/state.js";

const { degree: MAX_DEGREE, planes: MOST_PLANES, side: MAX_SIDE } = LIMITS;
const LONGEST_EQUATION = 1 << 20; // characters; the page itself stops at LIMITS.equation
const MOST_LETTERS = 64; // without a value that are looked for: some beyond LIMITS, so that too many are told
const LONGEST_SEARCH = 300; // milliseconds for them
const CURVE_POINTS = 256;
const MOST_NUMBERS = 1 << 16; // of cells or points
const ENOSYS = 52; // of WASI: there are no files here
const LIBRARY = -1;
const TRANSPARENT = -2;
const STATES = ["miss", "hit", "undecided", "thin"];
const QUALITIES = { preview: 0, standard: 1, full: 2 };
const METHODS = { default: 0, brent: 1, bisection: 2, "regula-falsi": 3 };
const AXES = 1, BOX = 2; // of axes.h
const MESHES = { stl: 0, glb: 3 }; // of mesh_write.h
const ENGINES = ["none", "doubles", "integers"];

/** What a call that cannot be answered throws; plain enough to be sent by postMessage. */
export class EngineError extends Error {
    constructor(code, message, more = {}) {
        super(message);
        this.name = "EngineError";
        this.code = code;
        Object.assign(this, more);
    }
}

function refused(message) {
    return new EngineError("E_ARGUMENT", message);
}

// ---- from a state to numbers ----

function number(value, what, low = -1e300, high = 1e300) {
    if (typeof value !== "number" || !(value >= low && value <= high))
        throw refused(`${what}: not a number in range`);
    return value;
}

function vector(value, what, low, high) {
    if (!Array.isArray(value) || value.length !== 3) throw refused(`${what}: not three numbers`);
    return value.map((x) => number(x, what, low, high));
}

/** "#rrggbb" as a number; null and undefined: the library's. */
function colour(value, what) {
    if (value === null || value === undefined) return LIBRARY;
    if (typeof value !== "string" || !/^#[0-9a-f]{6}$/i.test(value))
        throw refused(`${what}: not a colour #rrggbb`);
    return parseInt(value.slice(1), 16);
}

function thinness(value) {
    return value === null || value === undefined ? -1 : value ? 1 : 0;
}

/** The extent: whether it is given, kind, centre, size.  A fitted one that holds no numbers yet is not
 * given. */
function extentNumbers(extent) {
    const { kind, size, centre = [0, 0, 0] } = extent ?? {};
    const fitted = kind === "fitted" || kind === undefined;
    if (fitted && !Array.isArray(size)) return [0, 1, 0, 0, 0, 1, 0, 0];
    if (!fitted && kind !== "sphere" && kind !== "box") throw refused("extent: neither sphere nor box");
    const sizes = isBox(extent) ? vector(size, "extent", 1e-300) : [number(size?.[0], "extent", 1e-300), 0, 0];
    return [fitted ? 0 : 1, isBox(extent) ? 2 : 1, ...vector(centre, "centre"), ...sizes];
}

function cameraNumbers(camera) {
    const { eye, lookAt, up, fov } = camera ?? {};
    return [
        ...vector(eye, "eye"),
        ...vector(lookAt, "look at"),
        ...vector(up, "up"),
        number(fov, "field of view"),
    ];
}

function complexNumbers(complex) {
    const imaginary = new Array(MAX_DEGREE + 1).fill(0);
    if (!complex) return [0, 0, 0, ...imaginary];
    for (const [k, value] of Object.entries(complex.imaginary ?? {})) {
        if (!/^\d{1,2}$/.test(k) || Number(k) > MAX_DEGREE) throw refused("imaginary: no such coefficient");
        imaginary[Number(k)] = number(value, "imaginary");
    }
    return [1, number(complex.sigma ?? 0, "sigma", 0, 4), number(complex.delta, "delta", 0, 4), ...imaginary];
}

/** The cutting planes: how many, and four numbers each. */
function planeNumbers(clip) {
    const planes = clip ?? [];
    if (!Array.isArray(planes) || planes.length > MOST_PLANES)
        throw refused(`clip: at most ${MOST_PLANES} planes`);
    const room = new Array(4 * MOST_PLANES).fill(0);
    planes.forEach((plane, i) => {
        if (!Array.isArray(plane) || plane.length !== 4) throw refused("clip: not four numbers");
        plane.forEach((x, k) => (room[4 * i + k] = number(x, "clip")));
    });
    return [planes.length, ...room];
}

/** glue.h's page_state. */
function numbersOf(state, { camera = true } = {}) {
    const { light } = state, isOwn = isInOwnColours(state);
    const { outside, inside, background } = state.colours ?? {};
    const angles = light
        ? [1, number(light.azimuth, "light", -180, 180), number(light.elevation, "light", -90, 90)]
        : [0, 0, 0];
    return [
        ...extentNumbers(state.extent),
        ...(camera ? cameraNumbers(state.camera) : new Array(10).fill(0)),
        isOwn ? LIBRARY : colour(outside, "outside"),
        isOwn ? LIBRARY : colour(inside, "inside"),
        background === "none" ? TRANSPARENT : colour(background, "background"),
        ...angles,
        thinness(state.thin),
        ...planeNumbers(state.clip),
        ...complexNumbers(state.complex),
    ];
}

/** Names and values of a state's parameters. */
function valuesOf(parameters) {
    return Object.fromEntries(Object.entries(parameters ?? {}).map(([name, p]) => [name, p?.value]));
}

function side(value, what) {
    if (!Number.isInteger(value) || value < 1 || value > MAX_SIDE)
        throw refused(`${what}: from 1 to ${MAX_SIDE}`);
    return value;
}

// ---- the engine ----

export class Engine {
    #compiled;
    #module;
    #algsurf;
    #surface = null; // { key, surface, degree }
    #scene = null; // { key, address }
    #onProgress = null; // of mesh()

    static async load(source) {
        return new Engine(await compile(source ?? new URL("../algsurf.wasm", import.meta.url)));
    }

    /** compiled: a WebAssembly.Module */
    constructor(compiled) {
        this.#compiled = compiled;
        this.#start();
    }

    /** How much memory the instance holds. */
    get memoryBytes() {
        return this.#module.wasm.memory.buffer.byteLength;
    }

    #start() {
        this.#surface = this.#scene = null;
        const nothing = Object.fromEntries(
            WebAssembly.Module.imports(this.#compiled).map(({ name }) => [name, () => ENOSYS]),
        );
        const system = { ...nothing, ...systemOf(() => instance.exports.memory) };
        const progress = (done, total) => {
            this.#onProgress(done / total);
            return 0;
        };
        const imports = { wasi_snapshot_preview1: system, page: { progress } };
        const instance = new WebAssembly.Instance(this.#compiled, imports);
        instance.exports._initialize();
        this.#module = new Module(instance.exports);
        this.#algsurf = new Algsurf(this.#module);
    }

    /** Calls use(); what is thrown is an EngineError.  After a trap there is a new instance. */
    #answer(use) {
        try {
            return use();
        } catch (error) {
            if (error instanceof EngineError) throw error;
            if (error instanceof AlgsurfError) throw new EngineError(error.code, error.message);
            this.#start();
            throw new EngineError("E_TRAP", `the calculation was abandoned: ${error.message}`);
        }
    }

    /** The status or count of a call, unless it is an error. */
    #checked(status) {
        return this.#module.checked(status);
    }

    // ---- surfaces ----

    /** A surface from an equation; throws an EngineError that says where it is wrong. */
    #make(equation, values) {
        if (typeof equation !== "string") throw refused("equation: not a text");
        if (equation.length > LONGEST_EQUATION) throw refused("equation: too long");
        for (const [name, value] of Object.entries(values)) {
            if (!isName(name)) throw refused("parameter: not a name");
            number(value, name);
        }
        const zero = equation.indexOf("\0");
        if (zero >= 0)
            throw new EngineError("E_SYNTAX", "a zero character", { offset: zero, length: 1, name: null });
        try {
            return this.#algsurf.surface(equation, values);
        } catch (error) {
            if (!(error instanceof AlgsurfError)) throw error;
            const { code, offset = null, length = 0 } = error;
            const name = code === "E_NAME" ? equation.slice(offset, offset + length) : null;
            // "E_SYNTAX: text is ...: what is wrong, at 3": the rest is the code's and the offset's
            const message =
                offset === null
                    ? error.message
                    : error.message.replace(/^.*?: .*?: /, "").replace(/, at \d+$/, "");
            throw new EngineError(code, message, { offset, length, name });
        }
    }

    /** The letters without a value, in the order of the text; the others have the values given. */
    #missing(equation, values) {
        const missing = [];
        const begin = performance.now();
        for (const all = { ...values }; ; ) {
            try {
                this.#make(equation, all).free();
                return missing;
            } catch (error) {
                const known = error.code !== "E_NAME" || error.name === "" || error.name in all;
                if (known || !isName(error.name)) throw error;
                if (missing.length >= MOST_LETTERS || performance.now() - begin > LONGEST_SEARCH) throw error;
                missing.push(error.name);
                all[error.name] = 1.5;
            }
        }
    }

    /** Is this one of the equation's letters? */
    #isUsed(equation, values, name) {
        if (!mentions(equation, name)) return false;
        const others = { ...values };
        delete others[name];
        try {
            this.#make(equation, others).free();
            return false;
        } catch (error) {
            return error.code === "E_NAME";
        }
    }

    /** Degree, and all letters of the equation that are neither variables nor constants: `missing` of them
     * are without a value, and stand for 1.5 in the degree. */
    compile(equation, values = {}) {
        return this.#answer(() => {
            const missing = this.#missing(equation, values);
            const all = { ...values, ...Object.fromEntries(missing.map((name) => [name, 1.5])) };
            const begin = performance.now();
            const surface = this.#make(equation, all);
            const degree = surface.degree;
            surface.free();
            const quick = (performance.now() - begin) * Object.keys(values).length < LONGEST_SEARCH;
            const used = Object.keys(values).filter((name) =>
                quick ? this.#isUsed(equation, all, name) : mentions(equation, name),
            );
            return { degree, letters: [...used, ...missing], missing };
        });
    }

    #surfaceOf(state) {
        const values = valuesOf(state.parameters);
        const key = JSON.stringify([state.equation, values]);
        if (this.#surface?.key === key) return this.#surface;
        this.#forget();
        this.#surface?.surface.free();
        this.#surface = null;
        const surface = this.#make(state.equation, values);
        this.#surface = { key, surface, degree: surface.degree, address: surface.addressIn(this.#module) };
        return this.#surface;
    }

    /** Frees the scene, which refers to the surface. */
    #forget() {
        if (this.#scene) this.#module.wasm.algsurf_scene_free(this.#scene.address);
        this.#scene = null;
    }

    /** Calls use(address of glue.h's page_state, address of so many doubles more). */
    #withState(state, room, use, options) {
        const numbers = numbersOf(state, options);
        const module = this.#module;
        if (numbers.length !== module.wasm.page_state_length()) throw refused("state: another version");
        return module.borrow(8 * (numbers.length + room), (address) => {
            module.doubles(address, numbers.length).set(numbers);
            return use(address, address + 8 * numbers.length);
        });
    }

    // ---- what is shown ----

    /** Extent and camera as `render` chooses them; an extent that is not "fitted" stays. */
    fit(state, { width = 1024, height = 768 } = {}) {
        return this.#answer(() => {
            const { address: surface, degree } = this.#surfaceOf(state);
            const given = state.extent ?? { kind: "fitted" };
            const asked = { ...state, extent: given.kind === "fitted" ? { kind: "fitted" } : given };
            const use = (numbers, fitted) => {
                side(width, "width");
                side(height, "height");
                this.#checked(this.#module.wasm.page_fit(surface, numbers, width, height, fitted));
                return Array.from(this.#module.doubles(fitted, 17));
            };
            const f = this.#withState(asked, 17, use, { camera: false });
            const bounded = f[16] === 1;
            const edges = f[4] > 0 ? f.slice(3, 6) : [f[3]]; // a box or a ball
            const size = given.kind === "fitted" ? edges : given.size;
            const notes = bounded ? [] : ["unbounded"];
            return {
                extent: { kind: given.kind, size, centre: f.slice(0, 3) },
                camera: { eye: f.slice(6, 9), lookAt: f.slice(9, 12), up: f.slice(12, 15), fov: f[15] },
                bounded,
                degree,
                notes,
            };
        });
    }

    /** Why nothing is seen: "nowhere", no point is real; "extent", none is in there; "view". */
    nothing(state) {
        return this.#answer(() => {
            const { address } = this.#surfaceOf(state);
            const use = (numbers) => this.#checked(this.#module.wasm.page_nothing(address, numbers));
            return ["view", "extent", "nowhere"][this.#withState(state, 0, use, { camera: false })];
        });
    }

    // ---- pictures ----

    #sceneOf(state) {
        const { key: surfaceKey, address: surface, degree } = this.#surfaceOf(state);
        const { extent, camera, colours, light, thin, complex, clip } = state;
        const key = JSON.stringify([surfaceKey, extent, camera, colours, light, thin, complex, clip]);
        if (this.#scene?.key === key) return this.#scene;
        this.#forget();
        const address = this.#withState(state, 1, (numbers, status) => {
            const scene = this.#module.wasm.page_scene(surface, numbers, status);
            this.#checked(this.#module.integers(status, 1)[0]);
            return scene;
        });
        this.#scene = { key, address, degree };
        return this.#scene;
    }

    /** How much a picture must be magnified, at most 1, so that the box is in it. */
    room(state, { width, height }) {
        return this.#answer(() =>
            this.#withState(state, 1, (numbers, zoom) => {
                const sides = [side(width, "width"), side(height, "height")];
                this.#checked(this.#module.wasm.page_room(numbers, ...sides, zoom));
                return this.#module.doubles(zoom, 1)[0];
            }),
        );
    }

    /** Rows rowBegin .. rowEnd-1 of a picture; bounded: doubles alone decide; factor: it is shown so much
     * larger. */
    render(state, options) {
        return this.#answer(() => {
            const {
                width,
                height,
                rowBegin = 0,
                rowEnd = height,
                quality = "standard",
                antialias = 1,
            } = options;
            const { t = false, bounded = false, factor = 1 } = options;
            const what = (state.axes ? AXES : 0) | (state.box ? BOX : 0), hasFar = t || what > 0;
            const pixels = side(width, "width") * (rowEnd - rowBegin);
            side(height, "height");
            if (!(rowBegin >= 0 && rowBegin < rowEnd && rowEnd <= height)) throw refused("rows");
            const begin = performance.now();
            const module = this.#module;
            const { wasm } = module;
            const { address: scene, degree } = this.#sceneOf(state);
            this.#checked(wasm.algsurf_scene_set_quality(scene, QUALITIES[quality] ?? -1));
            this.#checked(wasm.algsurf_scene_set_antialias(scene, antialias));
            this.#checked(wasm.page_set_bounded(scene, bounded ? 1 : 0));
            return module.borrow(8 * 5 + (hasFar ? 8 * pixels : 0) + 4 * pixels, (counts) => {
                const far = counts + 8 * 5, rgba = far + (hasFar ? 8 * pixels : 0);
                this.#checked(
                    wasm.page_render(scene, width, height, rowBegin, rowEnd, rgba, hasFar ? far : 0, counts),
                );
                const { address: surface } = this.#surfaceOf(state);
                const size = [width, height, rowBegin, rowEnd, number(factor, "factor", 1, MAX_SIDE)];
                const draw = (numbers) => wasm.page_axes(surface, numbers, what, ...size, rgba, far);
                if (what > 0) this.#checked(this.#withState(state, 0, draw));
                const [rays, hits, undecided, exact, thin] = module.doubles(counts, 5);
                const data = new Uint8ClampedArray(module.bytes(rgba, 4 * pixels));
                const picture = {
                    data,
                    rays,
                    hits,
                    undecided,
                    exact,
                    thin,
                    degree,
                    ms: performance.now() - begin,
                };
                if (t) picture.t = module.doubles(far, pixels).slice();
                return picture;
            });
        });
    }

    // ---- triangles ----

    /** The surface as the program mesh makes it, as bytes of a file of `format`, null where there are no
     * triangles; so many of them, edges where it is open, places that may show less than there is. */
    mesh(state, { format, cells }, onProgress = () => {}) {
        return this.#answer(() => {
            if (state.complex) throw refused("complex space has no triangles");
            if (!Object.hasOwn(MESHES, format)) throw refused(`no such format: ${format}`);
            const { wasm } = this.#module;
            const { address: scene } = this.#sceneOf(state);
            const { address: surface } = this.#surfaceOf(state);
            this.#onProgress = onProgress;
            return this.#withState(state, 5, (numbers, told) => {
                const file = wasm.page_mesh(surface, scene, numbers, MESHES[format], cells, told);
                const [status, length, open, triangles, doubts] = this.#doubles(told, 5);
                this.#checked(status);
                const bytes = triangles > 0 ? this.#module.bytes(file, length).slice() : null;
                wasm.free(file);
                return { bytes, triangles, open, doubts };
            });
        });
    }

    // ---- one ray ----

    /** Calls use(numbers, surface, ray, room) with the ray through the middle of the pixel that holds the
     * place, cut to the extent and by the planes, and so many doubles more. */
    #alongRay(state, place, room, use) {
        return this.#answer(() => {
            const { address: surface, degree } = this.#surfaceOf(state);
            const { width, height, x, y } = place;
            side(width, "width");
            side(height, "height");
            number(x, "x");
            number(y, "y");
            return this.#withState(state, 8 + room, (numbers, ray) => {
                const { wasm } = this.#module;
                const middle = [Math.floor(x) + 0.5, Math.floor(y) + 0.5];
                const meets = this.#checked(wasm.page_ray(numbers, width, height, ...middle, ray));
                return use({ numbers, surface, degree, ray, meets, room: ray + 64 });
            });
        });
    }

    #doubles(address, count) {
        return Array.from(this.#module.doubles(address, count));
    }

    #rayAt(address) {
        const [a, b, c, d, e, f, tMin, tMax] = this.#doubles(address, 8);
        return { origin: [a, b, c], direction: [d, e, f], tMin, tMax };
    }

    #hitAt(address) {
        const [state, multiplicity, hitSide, t, tLo, tHi, ...vectors] = this.#doubles(address, 12);
        const [position, normal] = [vectors.slice(0, 3), vectors.slice(3)];
        return { state: STATES[state], t, tLo, tHi, position, normal, multiplicity, side: hitSide };
    }

    /** What is seen at a place of a picture, and the polynomial along the ray; null: the ray misses the
     * extent. */
    pick(state, place) {
        return this.#alongRay(
            state,
            place,
            12 + 2 * (MAX_DEGREE + 1),
            ({ numbers, surface, degree, ray, meets, room }) => {
                if (!meets) return null;
                const { wasm } = this.#module;
                const c = room + 8 * 12,
                    radii = c + 8 * (MAX_DEGREE + 1);
                this.#checked(wasm.page_hit(surface, numbers, ray, room));
                this.#checked(wasm.page_polynomial(surface, ray, c, radii));
                const polynomial = this.#doubles(c, degree + 1);
                return {
                    ...this.#hitAt(room),
                    ray: this.#rayAt(ray),
                    polynomial,
                    radii: this.#doubles(radii, degree + 1),
                    degree,
                };
            },
        );
    }

    /** Where all roots on the chord were isolated: cells in the order of the search; null: the extent is
     * missed. */
    isolate(state, place) {
        const hits = 12 * MAX_DEGREE;
        return this.#alongRay(
            state,
            place,
            hits + 2 + 65 + MOST_NUMBERS,
            ({ numbers, surface, degree, ray, meets, room }) => {
                if (!meets) return null;
                const { wasm } = this.#module;
                const counts = room + 8 * hits,
                    bernstein = counts + 16,
                    cellNumbers = bernstein + 8 * 65;
                this.#checked(
                    wasm.page_isolate(surface, numbers, ray, room, cellNumbers, MOST_NUMBERS, counts),
                );
                this.#checked(wasm.page_hull(surface, ray, bernstein));
                const [hitCount, used] = this.#doubles(counts, 2);
                const cells = cellsFrom(this.#doubles(cellNumbers, used));
                const found = Array.from({ length: hitCount }, (_, i) => this.#hitAt(room + 96 * i));
                const { tMin, tMax } = this.#rayAt(ray);
                const b = this.#doubles(bernstein, degree + 1);
                const at = (i, n) => tMin + ((tMax - tMin) * i) / n;
                return {
                    cells,
                    brackets: found.map((hit) => bracketOf(hit, cells)),
                    hits: found,
                    hull: b.map((value, i) => [degree ? at(i, degree) : tMin, value]),
                    curve: Array.from({ length: CURVE_POINTS + 1 }, (_, i) => [
                        at(i, CURVE_POINTS),
                        casteljau(b, i / CURVE_POINTS),
                    ]),
                };
            },
        );
    }

    /** The first hit by a method of refinement, point by point; null: the extent is missed. */
    refine(state, place, method = "default") {
        return this.#alongRay(
            state,
            place,
            12 + 2 + MOST_NUMBERS,
            ({ numbers, surface, ray, meets, room }) => {
                if (!meets) return null;
                if (!(method in METHODS)) throw refused("method: unknown");
                const counts = room + 8 * 12,
                    list = counts + 16;
                this.#checked(
                    this.#module.wasm.page_refine(
                        surface,
                        numbers,
                        ray,
                        METHODS[method],
                        room,
                        list,
                        MOST_NUMBERS,
                        counts,
                    ),
                );
                const [used, evaluations] = this.#doubles(counts, 2);
                const from = this.#doubles(list, used);
                const points = Array.from({ length: used / 3 }, (_, i) => ({
                    t: from[3 * i],
                    value: from[3 * i + 1],
                    engine: ENGINES[from[3 * i + 2]],
                }));
                const hit = this.#hitAt(room);
                return { points, root: hit.state === "miss" ? null : hit.t, evaluations, hit };
            },
        );
    }

    /** All complex roots t of the polynomial along the ray, with the imaginary parts of the state; chosen:
     * the one that is shown. */
    complexRoots(state, place) {
        return this.#alongRay(state, place, 8 * MAX_DEGREE + 2, ({ numbers, surface, ray, meets, room }) => {
            const { wasm } = this.#module;
            const count = this.#checked(wasm.page_complex_roots(surface, numbers, ray, room));
            const roots = Array.from({ length: count }, (_, i) => {
                const [re, im, reLo, reHi, imLo, imHi, multiplicity, real] = this.#doubles(room + 64 * i, 8);
                return {
                    re,
                    im,
                    box: [reLo, reHi, imLo, imHi],
                    multiplicity,
                    real: real === 1,
                    chosen: false,
                };
            });
            const shown = room + 8 * 8 * MAX_DEGREE;
            const seen = meets ? this.#checked(wasm.page_chosen(surface, numbers, ray, shown)) : 0;
            const [re, im] = this.#doubles(shown, 2);
            const away = (root) => Math.hypot(root.re - re, root.im - im);
            const nearest = roots.reduce(
                (best, root) => (!best || away(root) < away(best) ? root : best),
                null,
            );
            if (seen && nearest) nearest.chosen = true;
            return roots;
        });
    }
}

/** May the equation have that letter, alone or in a product such as ax? */
function mentions(equation, name) {
    return equation.replace(/sqrt|sin|cos|pi/g, " ").includes(name);
}

/** Cells from the numbers that glue_ray.c's on_cell records. */
function cellsFrom(numbers) {
    const cells = [];
    for (let at = 0; at + 5 <= numbers.length; ) {
        const [lo, hi, variations, engine, count] = numbers.slice(at, at + 5);
        const signs = numbers.slice(at + 5, at + 5 + count);
        cells.push({ lo, hi, variations, engine: ENGINES[engine], signs });
        at += 5 + count;
    }
    return cells;
}

/** The narrowest cell with this root alone, or else what encloses the root. */
function bracketOf(hit, cells) {
    const holding = cells.filter((cell) => cell.variations === 1 && cell.lo <= hit.tLo && hit.tHi <= cell.hi);
    const narrowest = holding.reduce(
        (best, cell) => (!best || cell.hi - cell.lo < best.hi - best.lo ? cell : best),
        null,
    );
    return narrowest ? { lo: narrowest.lo, hi: narrowest.hi } : { lo: hit.tLo, hi: hit.tHi };
}

/** The value of a polynomial at s of its interval, from its Bernstein coefficients. */
function casteljau(coefficients, s) {
    const b = coefficients.slice();
    for (let n = b.length - 1; n > 0; n--) for (let i = 0; i < n; i++) b[i] = (1 - s) * b[i] + s * b[i + 1];
    return b[0];
}
