// sweep.js - one number of complex space that goes from here to there and back: delta, sigma, or an imaginary part.
import { toRadians, withDelta, withSigma } from "./sector.js";

/** The complex space of a sweep { what, k, from, to } where it has gone so far, share 0..1; angles in degrees. */
export function complexAt(complex, { what, k, from, to }, share) {
    const value = from + (to - from) * share;
    if (what === "delta") return { ...complex, ...withDelta(complex, toRadians(value)) };
    if (what === "sigma") return { ...complex, ...withSigma(complex, toRadians(value)) };
    return { ...complex, imaginary: { ...complex.imaginary, [k]: value } };
}

/** There and back: 0 at 0, 1 at half a period, 0 at a whole one, slower at both ends. */
export const thereAndBack = (time, period) => (1 - Math.cos((2 * Math.PI * time) / period)) / 2;

const LONGEST_WAIT = 400; // milliseconds for a picture, before the next value is set all the same

/** Plays: calls set(share) again and again, after each picture that it hears of, until stop() is called. */
export class Player {
    #began = 0;
    #waiting = 0;
    #set = null;

    constructor(period) {
        this.period = period;
    }

    get playing() {
        return this.#set !== null;
    }

    start(set) {
        this.#set = set;
        this.#began = performance.now();
        this.#next();
    }

    stop() {
        clearTimeout(this.#waiting);
        this.#set = null;
    }

    /** A picture is complete. */
    pictureCame() {
        if (!this.playing) return;
        clearTimeout(this.#waiting);
        requestAnimationFrame(() => this.#next());
    }

    #next() {
        if (!this.playing) return;
        clearTimeout(this.#waiting);
        this.#waiting = setTimeout(() => this.#next(), LONGEST_WAIT);
        this.#set(thereAndBack(performance.now() - this.#began, this.period));
    }
}
