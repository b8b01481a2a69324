// algsurf.mjs - libalgsurf in JavaScript: roots of polynomials, first hits of rays, pictures, all decided.
//
//     const algsurf = await load();
//     algsurf.realRoots([-2, 0, 1]);
//
// algsurf.d.ts beside this file says what each function takes and gives.  algsurf.wasm is the library and
// glue.c, one thread: each worker of a page loads its own.  Numbers go in and out as arrays in the module's
// memory.  That memory may grow in any call, and old views of it are then empty: a view is made where it is used.

const NO_MEMORY = -3;
const ARGUMENT = -1;
const RAYS_AT_ONCE = 4096; // so that memory does not grow with the number of rays
const LARGEST_BLOCK = 0x7fff0000; // bytes
const MAX_SIDE = 65535;
const MAX_DEGREE = 64;
const EXTENTS = { all: 0, sphere: 1, box: 2 };
const QUALITIES = { preview: 0, standard: 1, full: 2 };

export const MISS = 0;
export const HIT = 1;
export const UNDECIDED = 2;

/** What a call that cannot be answered throws. */
export class AlgsurfError extends Error {
    constructor(status, code, text, offset, length) {
        super(text);
        this.name = "AlgsurfError";
        this.status = status;
        this.code = code;
        if (offset === undefined) return;
        this.offset = offset;
        this.length = length;
    }
}

/** A surface; its memory is the module's until free() is called or the garbage collector finds it. */
class Surface {
    #module;
    #address;

    constructor(module, address) {
        this.#module = module;
        this.#address = address;
        module.surfaces.register(this, address, this);
    }

    /** Where it is in the module's memory. */
    addressIn(module) {
        if (module !== this.#module) throw new TypeError("a surface of another module");
        if (this.#address === 0) throw new TypeError("the surface was freed");
        return this.#address;
    }

    get degree() {
        return this.#module.wasm.algsurf_surface_degree(this.addressIn(this.#module));
    }

    free() {
        if (this.#address === 0) return;
        this.#module.surfaces.unregister(this);
        this.#module.wasm.algsurf_surface_free(this.#address);
        this.#address = 0;
    }
}
if (Symbol.dispose) Surface.prototype[Symbol.dispose] = Surface.prototype.free;

/** The exported functions of one instance, its memory, and how its answers become exceptions. */
class Module {
    constructor(wasm) {
        this.wasm = wasm;
        this.surfaces = new FinalizationRegistry((address) => wasm.algsurf_surface_free(address));
    }

    doubles(address, count) {
        return new Float64Array(this.wasm.memory.buffer, address, count);
    }

    integers(address, count) {
        return new Int32Array(this.wasm.memory.buffer, address, count);
    }

    bytes(address, count) {
        return new Uint8Array(this.wasm.memory.buffer, address, count);
    }

    text(address) {
        const from = new Uint8Array(this.wasm.memory.buffer, address);
        return new TextDecoder().decode(from.slice(0, from.indexOf(0)));
    }

    error(status, detail, offset, length) {
        const code = this.text(this.wasm.algsurf_status_name(status)).replace("ALGSURF_", "");
        const text = this.text(this.wasm.algsurf_status_text(status));
        return new AlgsurfError(status, code, `${code}: ${text}${detail ? `: ${detail}` : ""}`, offset, length);
    }

    /** The status or count of a call, unless it is an error. */
    checked(status) {
        if (status < 0) throw this.error(status);
        return status;
    }

    /** Calls use(address) with so many bytes of the module's memory, which are free again afterwards. */
    borrow(bytes, use) {
        const address = bytes <= LARGEST_BLOCK ? this.wasm.malloc(bytes) : 0;
        if (address === 0) throw this.error(NO_MEMORY);
        try {
            return use(address);
        } finally {
            this.wasm.free(address);
        }
    }
}

/** Bytes of the text and a zero byte. */
function terminated(text) {
    const bytes = new TextEncoder().encode(text);
    if (bytes.includes(0)) throw new TypeError("a text with a zero character");
    return Uint8Array.from([...bytes, 0]);
}

/** An extent's kind, and the six doubles that glue.c wants. */
function extentOf(extent) {
    if (extent === undefined || extent === null) return { kind: EXTENTS.all, places: [0, 0, 0, 1, 1, 1] };
    const centre = extent.centre ?? [0, 0, 0];
    if (extent.sphere !== undefined) return { kind: EXTENTS.sphere, places: [...centre, extent.sphere, 0, 0] };
    if (extent.box !== undefined) return { kind: EXTENTS.box, places: [...centre, ...extent.box] };
    throw new TypeError("an extent has a sphere or a box");
}

function isSide(number) {
    return Number.isInteger(number) && number >= 1 && number <= MAX_SIDE;
}

class Algsurf {
    #module;

    constructor(module) {
        this.#module = module;
        this.version = module.text(module.wasm.algsurf_version());
    }

    /** How much memory the module holds. */
    get memoryBytes() {
        return this.#module.wasm.memory.buffer.byteLength;
    }

    realRoots(coefficients, { lo = -Infinity, hi = Infinity } = {}) {
        const module = this.#module;
        const c = Float64Array.from(coefficients);
        return module.borrow(8 * (c.length + 5 * c.length), (address) => {
            const rows = address + 8 * c.length;
            module.doubles(address, c.length).set(c);
            const count = module.checked(module.wasm.real_roots(address, c.length - 1, lo, hi, rows));
            return Array.from({ length: count }, (_, i) => {
                const [root, lo, hi, multiplicity, sign] = module.doubles(rows + 40 * i, 5);
                return { root, lo, hi, multiplicity, sign };
            });
        });
    }

    complexRoots(coefficients) {
        const module = this.#module;
        const given = Array.from(coefficients);
        const real = given.every((c) => typeof c === "number");
        const pairs = given.flatMap((c) => (typeof c === "number" ? [c, 0] : [c[0], c[1]]));
        const c = Float64Array.from(real ? given : pairs);
        return module.borrow(8 * (c.length + 8 * given.length), (address) => {
            const rows = address + 8 * c.length;
            module.doubles(address, c.length).set(c);
            const count = module.checked(module.wasm.complex_roots(address, real ? 1 : 0, given.length - 1, rows));
            return Array.from({ length: count }, (_, i) => {
                const [re, im, reLo, reHi, imLo, imHi, multiplicity, isReal] = module.doubles(rows + 64 * i, 8);
                return {
                    root: { re, im },
                    box: { re: [reLo, reHi], im: [imLo, imHi] },
                    multiplicity,
                    real: isReal === 1,
                };
            });
        });
    }

    surface(equation, constants = {}) {
        const module = this.#module;
        const text = terminated(equation);
        const names = Object.keys(constants).map(terminated);
        const values = Float64Array.from(Object.values(constants));
        const allNames = Uint8Array.from(names.flatMap((name) => [...name]));
        const blocks = 8 * values.length + 16;
        return module.borrow(blocks + text.length + allNames.length, (address) => {
            const result = address + 8 * values.length, letters = address + blocks;
            module.doubles(address, values.length).set(values);
            module.bytes(letters, text.length).set(text);
            module.bytes(letters + text.length, allNames.length).set(allNames);
            const { surface_from_equation: make } = module.wasm;
            const surface = make(letters, letters + text.length, address, values.length, result);
            return this.#made(surface, result, text);
        });
    }

    surfaceFromTerms(terms) {
        const module = this.#module;
        const exponents = terms.flatMap(([i, j, k]) => [i, j, k]);
        if (!exponents.every((e) => Number.isInteger(e) && Math.abs(e) < 2 ** 31))
            throw module.error(ARGUMENT, "exponents");
        return module.borrow(20 * terms.length + 16, (address) => {
            const integers = address + 8 * terms.length, result = integers + 12 * terms.length;
            module.doubles(address, terms.length).set(terms.map((term) => term[3]));
            module.integers(integers, exponents.length).set(exponents);
            const surface = module.wasm.surface_from_terms(address, integers, terms.length, result);
            return this.#made(surface, result);
        });
    }

    /** The surface at an address, or why there is none. */
    #made(surface, result, text) {
        const module = this.#module;
        if (surface !== 0) return new Surface(module, surface);
        const [status, offset, message, bytes] = module.integers(result, 4);
        if (message === 0) throw module.error(status);
        const index = new TextDecoder().decode(text.subarray(0, offset)).length;
        const { length } = new TextDecoder().decode(text.subarray(offset, offset + bytes));
        throw module.error(status, `${module.text(message)}, at ${index}`, index, length);
    }

    firstHits(surface, rays, extent) {
        const module = this.#module;
        const address = surface.addressIn(module);
        const { kind, places } = extentOf(extent);
        const count = rays.origin[0].length;
        const inputs = [...rays.origin, ...rays.direction, rays.tMin, rays.tMax];
        if (inputs.length !== 8 || inputs.some((array) => array && array.length !== count))
            throw module.error(ARGUMENT, "arrays of different lengths");
        const hits = {
            state: new Uint8Array(count),
            multiplicity: new Int32Array(count),
            side: new Int8Array(count),
            t: new Float64Array(count),
            tLo: new Float64Array(count),
            tHi: new Float64Array(count),
            position: [0, 1, 2].map(() => new Float64Array(count)),
            normal: [0, 1, 2].map(() => new Float64Array(count)),
        };
        const room = Math.min(count, RAYS_AT_ONCE);
        return module.borrow(8 * 6 + room * (8 * 17 + 4 + 2), (block) => {
            for (let begin = 0; begin < count; begin += room)
                this.#hitsOf(address, kind, places, inputs, hits, begin, Math.min(begin + room, count), block);
            return hits;
        });
    }

    /** The hits of rays begin .. end-1, by way of a block of memory. */
    #hitsOf(surface, kind, places, inputs, hits, begin, end, block) {
        const module = this.#module;
        const count = end - begin;
        const from = block + 8 * 6, to = from + 8 * 8 * count;
        const multiplicity = to + 8 * 9 * count, state = multiplicity + 4 * count, side = state + count;
        const slice = (array) => (array.subarray ? array.subarray(begin, end) : array.slice(begin, end));
        module.doubles(block, 6).set(places);
        inputs.forEach((array, i) => {
            const place = module.doubles(from + 8 * i * count, count);
            if (array) place.set(slice(array));
            else place.fill(i === 6 ? 0 : Infinity);
        });
        module.checked(module.wasm.first_hits(surface, kind, block, count, from, to, state, side, multiplicity));
        [hits.t, hits.tLo, hits.tHi, ...hits.position, ...hits.normal].forEach((array, i) =>
            array.set(module.doubles(to + 8 * i * count, count), begin),
        );
        hits.multiplicity.set(module.integers(multiplicity, count), begin);
        hits.state.set(module.bytes(state, count), begin);
        hits.side.set(module.bytes(side, count), begin);
    }

    render(surface, options) {
        const module = this.#module;
        const { width, height, rows = [0, height], distances = false } = options;
        const [begin, end] = rows;
        if (!isSide(width) || !isSide(height)) throw module.error(ARGUMENT, "width and height");
        if (!Number.isInteger(begin) || !Number.isInteger(end) || begin < 0 || begin >= end || end > height)
            throw module.error(ARGUMENT, "rows");
        const scene = this.#scene(surface, options);
        try {
            return this.#draw(scene, width, height, begin, end, distances);
        } finally {
            module.wasm.algsurf_scene_free(scene);
        }
    }

    #draw(scene, width, height, begin, end, distances) {
        const module = this.#module;
        const pixels = width * (end - begin);
        return module.borrow(8 * 3 + (distances ? 8 * pixels : 0) + 4 * pixels, (counts) => {
            const t = counts + 8 * 3, rgba = t + (distances ? 8 * pixels : 0);
            module.checked(module.wasm.render(scene, width, height, begin, end, rgba, distances ? t : 0, counts));
            const [rays, hits, undecided] = module.doubles(counts, 3);
            const data = new Uint8ClampedArray(module.bytes(rgba, 4 * pixels));
            const picture = { data, width, height: end - begin, rays, hits, undecided };
            if (distances) picture.t = module.doubles(t, pixels).slice();
            return picture;
        });
    }

    /** A scene of the library's, made as the options say. */
    #scene(surface, options) {
        const module = this.#module;
        return module.borrow(8 * (MAX_DEGREE + 1), (address) => {
            module.checked(module.wasm.algsurf_scene_create(surface.addressIn(module), address));
            const scene = module.integers(address, 1)[0];
            try {
                this.#setUp(scene, options, (numbers) => {
                    if (numbers.length > MAX_DEGREE + 1) throw module.error(ARGUMENT, "too many numbers");
                    module.doubles(address, MAX_DEGREE + 1).fill(0).set(numbers);
                    return address;
                });
            } catch (error) {
                module.wasm.algsurf_scene_free(scene);
                throw error;
            }
            return scene;
        });
    }

    /** Hands the options to the scene; put(numbers) gives the address of a copy of them. */
    #setUp(scene, options, put) {
        const module = this.#module;
        const wasm = module.wasm;
        const { camera, quality, antialias, antialiasThreshold, background, material, complexSpace } = options;
        const { kind, places } = extentOf(options.extent);
        module.checked(wasm.scene_extent(scene, kind, put(places)));
        if (camera !== undefined) {
            const { eye, lookAt = [0, 0, 0], up = [0, 0, 1], fov = 25, orthographic } = camera;
            const parallel = orthographic !== undefined;
            const view = put([...eye, ...lookAt, ...up]);
            module.checked(wasm.scene_camera(scene, view, parallel ? 1 : 0, parallel ? orthographic : fov));
        }
        if (quality !== undefined) module.checked(wasm.algsurf_scene_set_quality(scene, QUALITIES[quality] ?? -1));
        if (antialias !== undefined) module.checked(wasm.algsurf_scene_set_antialias(scene, antialias));
        if (antialiasThreshold !== undefined)
            module.checked(wasm.algsurf_scene_set_antialias_threshold(scene, antialiasThreshold));
        if (background !== undefined) module.checked(wasm.algsurf_scene_set_background(scene, put(background)));
        if (material !== undefined) {
            const same = [NaN, NaN, NaN];
            const { outside = same, inside = same } = material;
            const weights = ["diffuse", "ambient", "fill", "specular", "roughness", "haze"];
            const numbers = [...outside, ...inside, ...weights.map((name) => material[name] ?? NaN)];
            module.checked(wasm.scene_material(scene, put(numbers)));
        }
        if (complexSpace !== undefined) {
            const { sigma = 0, delta, imaginary = [] } = complexSpace;
            module.checked(wasm.scene_complex_space(scene, sigma, delta, put(imaginary)));
        }
    }
}

/** The bytes of a file or of what a server sends. */
async function bytesOf(url) {
    if (url.protocol === "file:") {
        const { readFile } = await import("node:fs/promises");
        return readFile(url);
    }
    const response = await fetch(url);
    if (!response.ok) throw new Error(`${url}: ${response.status} ${response.statusText}`);
    return response.arrayBuffer();
}

/** The compiled module: it can be sent to workers, and loaded there. */
export async function compile(source = new URL("algsurf.wasm", import.meta.url)) {
    if (source instanceof WebAssembly.Module) return source;
    const isAddress = typeof source === "string" || source instanceof URL;
    return WebAssembly.compile(isAddress ? await bytesOf(new URL(source, import.meta.url)) : source);
}

/** All that the library asks of a system: the time, in nanoseconds, for a picture measures what it takes. */
function systemOf(memory) {
    return {
        clock_time_get(clock, precision, address) {
            const now = BigInt(Math.round(performance.now() * 1e6));
            new DataView(memory().buffer).setBigUint64(address, now, true);
            return 0;
        },
    };
}

/** An instance of the library, with memory of its own. */
export async function load(source) {
    const system = systemOf(() => instance.exports.memory);
    const instance = await WebAssembly.instantiate(await compile(source), { wasi_snapshot_preview1: system });
    instance.exports._initialize();
    return new Algsurf(new Module(instance.exports));
}
