// sector.js - the range of arguments sigma .. sigma + delta of complex space, in radians, and how it may
// change. The library wants 0 <= sigma, 0 <= delta, sigma + delta <= pi.

/** Real space: positive real roots only, whose arguments are exactly 0. */
export const REAL = { sigma: 0, delta: 1e-10 };

const clamp = (value, lo, hi) => Math.min(hi, Math.max(lo, Number.isFinite(value) ? value : lo));

export const toDegrees = (radians) => (radians * 180) / Math.PI;
export const toRadians = (degrees) => (degrees * Math.PI) / 180;

/** Another sigma, the same delta as far as there is room. */
export function withSigma({ delta }, sigma) {
    const from = clamp(sigma, 0, Math.PI);
    return { sigma: from, delta: Math.min(delta, Math.PI - from) };
}

/** Another delta. */
export const withDelta = ({ sigma }, delta) => ({ sigma, delta: clamp(delta, 0, Math.PI - sigma) });

/** The first edge goes to an angle, the last one stays. */
export function withFirstEdge({ sigma, delta }, angle) {
    const last = sigma + delta;
    const from = clamp(angle, 0, last);
    return { sigma: from, delta: clamp(last - from, 0, Math.PI - from) };
}

/** The last edge goes to an angle, the first one stays. */
export const withLastEdge = ({ sigma, delta }, angle) => withDelta({ sigma, delta }, angle - sigma);

/** What a state shows: its sector, or that of real space. */
export const sectorOf = (state) => state.complex ?? REAL;

/** The same complex space with another sector; switches it on where it was off. */
export const complexWith = (state, { sigma, delta }) => ({
    imaginary: {},
    ...state.complex,
    sigma,
    delta,
});
