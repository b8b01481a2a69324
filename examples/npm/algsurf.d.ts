// algsurf.d.ts - what algsurf.mjs gives.
//
// Every answer is decided as the C library's headers promise: they have the exact words.  What cannot be answered
// throws an AlgsurfError.  Arrays of numbers are copied in and out.

declare global {
    interface SymbolConstructor {
        readonly dispose: unique symbol;
    }
}

/** An array of numbers of whatever kind. */
export type Numbers = ArrayLike<number> & Iterable<number>;

/** Three numbers: a point, a direction or a colour (red, green, blue, 0 to 1). */
export type Triple = readonly [number, number, number];

/** One array each for x, y and z. */
export type Columns = readonly [Float64Array, Float64Array, Float64Array];

/** What a call that cannot be answered throws. */
export class AlgsurfError extends Error {
    /** The library's number for what is wrong, negative. */
    readonly status: number;
    /** Its name: "E_SYNTAX", "E_NAME", "E_ARGUMENT", "E_NOT_FINITE", "E_NO_MEMORY", ... */
    readonly code: string;
    /** Where in the text of an equation, as an index of the string. */
    readonly offset?: number;
    /** How long what is wrong there is: E_NAME tells the name of a parameter in want of a value. */
    readonly length?: number;
    constructor(status: number, code: string, text: string, offset?: number, length?: number);
}

/** A real root, between two neighbouring doubles, or equal to lo = hi. */
export interface RealRoot {
    root: number;
    lo: number;
    hi: number;
    multiplicity: number;
    /** Of the polynomial just before the root: -1 or 1. */
    sign: number;
}

/** A box that holds exactly so many roots. */
export interface ComplexRoot {
    root: { re: number; im: number };
    box: { re: [number, number]; im: [number, number] };
    multiplicity: number;
    /** Whether it is real: proved. */
    real: boolean;
}

/** A ball or a box, its centre the origin unless given.  Box: half the lengths of its edges. */
export type Extent = { sphere: number; centre?: Triple } | { box: Triple; centre?: Triple };

/** Rays origin + t direction, tMin <= t <= tMax; as a rule 0 and infinity. */
export interface Rays {
    origin: readonly [Numbers, Numbers, Numbers];
    direction: readonly [Numbers, Numbers, Numbers];
    tMin?: Numbers;
    tMax?: Numbers;
}

/** States of a hit. */
export const MISS: 0;
export const HIT: 1;
export const UNDECIDED: 2;

/** For each ray what it meets first; of a miss t, tLo and tHi are infinite. */
export interface Hits {
    /** MISS or HIT; UNDECIDED if the coefficients are known to an error only. */
    state: Uint8Array;
    /** 1 where the ray crosses the surface, 2 where it touches, 0 where it lies in it. */
    multiplicity: Int32Array;
    /** The sign of P on the ray before the hit. */
    side: Int8Array;
    t: Float64Array;
    /** The hit is in [tLo, tHi], and none before. */
    tLo: Float64Array;
    tHi: Float64Array;
    position: Columns;
    /** Unit length. */
    normal: Columns;
}

/** Where a picture is seen from: with fov, the degrees from its top to its bottom (25), or in parallel. */
export interface Camera {
    eye: Triple;
    /** The origin, unless given. */
    lookAt?: Triple;
    /** The z axis, unless given. */
    up?: Triple;
    fov?: number;
    /** The height of the picture in space, of a parallel projection. */
    orthographic?: number;
}

/**
 * Colours of the two sides in linear light, and weights from 0 to 1 of lights, of light from all around and from
 * the eye, of the highlight, its width, and of haze. What is left out is as usual.
 */
export interface Material {
    outside?: Triple;
    inside?: Triple;
    diffuse?: number;
    ambient?: number;
    fill?: number;
    specular?: number;
    roughness?: number;
    haze?: number;
}

/** The roots t with sigma <= arg t <= sigma + delta; imaginary[k] i is added to the coefficient of t^k. */
export interface ComplexSpace {
    sigma?: number;
    delta: number;
    imaginary?: Numbers;
}

/** What is drawn and how; what is not given is as the library has it. */
export interface PictureOptions {
    width: number;
    height: number;
    /** The slice begin <= row < end of the picture; the same bytes as in the whole. */
    rows?: readonly [number, number];
    camera?: Camera;
    /** All of space, which takes longer, unless given. */
    extent?: Extent;
    /** No illumination, lights, or lights and shadows. */
    quality?: "preview" | "standard" | "full";
    /** n x n samples a pixel. */
    antialias?: number;
    /** Only for pixels that differ from a neighbour by more than this, 0 to 1. */
    antialiasThreshold?: number;
    background?: Triple;
    material?: Material;
    complexSpace?: ComplexSpace;
    /** Whether to give t, too. */
    distances?: boolean;
}

/** A picture; data, width and height are as ImageData takes them. */
export interface Picture {
    /** Red, green, blue, 255 for each pixel, from the top. */
    data: Uint8ClampedArray;
    width: number;
    /** The number of rows drawn. */
    height: number;
    rays: number;
    hits: number;
    undecided: number;
    /** If asked for: the distance from the eye for each pixel, Infinity where nothing is hit. */
    t?: Float64Array;
}

/** A surface P(x,y,z) = 0.  Its memory is given back by free(), `using`, or the garbage collector. */
export interface Surface {
    readonly degree: number;
    free(): void;
    [Symbol.dispose](): void;
}

/** The library. */
export interface Algsurf {
    readonly version: string;
    /** How much memory it holds. */
    readonly memoryBytes: number;
    /** The real roots in [lo, hi], the whole line unless given, in increasing order. */
    realRoots(coefficients: Iterable<number>, interval?: { lo?: number; hi?: number }): RealRoot[];
    /** All roots; a coefficient is a number or a pair of real and imaginary part.  Lowest power first. */
    complexRoots(coefficients: Iterable<number | readonly [number, number]>): ComplexRoot[];
    /** A surface from an equation, "x^2 + y^2 = a - z^2", and the values of what else it names. */
    surface(equation: string, constants?: Readonly<Record<string, number>>): Surface;
    /** A surface from terms [i, j, k, a]: the sum of a x^i y^j z^k. */
    surfaceFromTerms(terms: readonly (readonly [number, number, number, number])[]): Surface;
    /** The first hit of each ray inside the extent, all of space unless given. */
    firstHits(surface: Surface, rays: Rays, extent?: Extent): Hits;
    render(surface: Surface, options: PictureOptions): Picture;
}

/** Where algsurf.wasm is, unless beside algsurf.mjs: an address, its bytes, or the compiled module. */
export type Source = string | URL | BufferSource | WebAssembly.Module;

/** The compiled module: it can be sent to workers, and loaded there. */
export function compile(source?: Source): Promise<WebAssembly.Module>;

/** An instance of the library, with memory of its own. */
export function load(source?: Source): Promise<Algsurf>;
