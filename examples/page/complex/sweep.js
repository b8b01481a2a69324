// sweep.js - one number of complex space that goes from here to there and back: delta, sigma, or an imaginary
// part.
import { toRadians, withDelta, withSigma } from "./sector.js";

/** The complex space of a sweep { what, k, from, to } where it has gone so far, share 0..1; angles in
 * degrees. */
export function complexAt(complex, { what, k, from, to }, share) {
    const value = from + (to - from) * share;
    if (what === "delta") return { ...complex, ...withDelta(complex, toRadians(value)) };
    if (what === "sigma") return { ...complex, ...withSigma(complex, toRadians(value)) };
    return { ...complex, imaginary: { ...complex.imaginary, [k]: value } };
}

/** There and back: 0 at 0, 1 at half a period, 0 at a whole one, slower at both ends. */
export const thereAndBack = (time, period) => (1 - Math.cos((2 * Math.PI * time) / period)) / 2;

/** Plays: calls set(share) in every frame of the screen until stop() is called; the painter draws what it
 * can. */
export class Player {
    #began = 0;
    #frame = 0;

    constructor(period) {
        this.period = period;
    }

    get playing() {
        return this.#frame !== 0;
    }

    start(set) {
        this.#began = performance.now();
        const next = () => {
            this.#frame = requestAnimationFrame(next);
            if (!document.hidden) set(thereAndBack(performance.now() - this.#began, this.period));
        };
        next();
    }

    stop() {
        cancelAnimationFrame(this.#frame);
        this.#frame = 0;
    }
}
