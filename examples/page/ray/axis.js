// axis.js - scales of an axis: where in 0..1 a value stands, and which values get a tick.
import { raised, short } from "../base/number.js";

const STEPS = [1, 2, 5, 10];

function evenTicks(lo, hi, most) {
    const rough = (hi - lo) / Math.max(1, most);
    const power = 10 ** Math.floor(Math.log10(rough));
    const step = power * STEPS.find((one) => one * power >= rough * (1 - 1e-9));
    if (!(step > 0) || !Number.isFinite(step)) return [];
    const ticks = [];
    for (let k = Math.ceil(lo / step - 1e-9); k * step <= hi + 1e-9 * step && ticks.length < 50; k++)
        ticks.push({ at: k * step, name: short(k * step, 6) });
    return ticks;
}

/** Equal steps. */
export function linear(lo, hi) {
    if (!(hi > lo)) [lo, hi] = [lo - 1, lo + 1];
    return { lo, hi, at: (value) => (value - lo) / (hi - lo), ticks: (most) => evenTicks(lo, hi, most) };
}

const powerName = (sign, exponent) =>
    `${sign < 0 ? "−" : ""}${Math.abs(exponent) <= 2 ? short(10 ** exponent) : `10${raised(exponent)}`}`;

/** Logarithmic on both sides of a linear middle from -linear to linear. */
export function symlog(lo, hi, middle) {
    const bend = (value) => Math.asinh(value / middle);
    const from = bend(lo);
    const to = bend(hi);
    const ticks = (most) => {
        const first = Math.round(Math.log10(middle));
        const last = Math.floor(Math.log10(Math.max(Math.abs(lo), Math.abs(hi))));
        const stride = Math.max(1, Math.ceil((2 * (last - first + 1)) / Math.max(1, most - 1)));
        const found = [{ at: 0, name: "0" }];
        for (let k = last; k > first; k -= stride)
            for (const sign of [-1, 1]) found.push({ at: sign * 10 ** k, name: powerName(sign, k) });
        return found.filter((tick) => tick.at >= lo && tick.at <= hi);
    };
    return { lo, hi, at: (value) => (bend(value) - from) / (to - from), ticks };
}

/** Logarithmic, for values above 0. */
export function log(lo, hi) {
    const from = Math.floor(Math.log10(lo));
    const to = Math.max(from + 1, Math.ceil(Math.log10(hi)));
    const ticks = (most) => {
        const stride = Math.max(1, Math.ceil((to - from) / Math.max(1, most)));
        const found = [];
        for (let k = from; k <= to; k += stride) found.push({ at: 10 ** k, name: powerName(1, k) });
        return found;
    };
    return { lo: 10 ** from, hi: 10 ** to, at: (value) => (Math.log10(value) - from) / (to - from), ticks };
}

// Of largest to median size, as much as a linear axis still shows well.
const LINEAR_RANGE = 40;

/** For values of a polynomial: linear where they are of a size, else symmetric logarithmic.  Returns the
 * scale and whether it is linear. */
export function ofValues(values) {
    const sizes = values
        .map(Math.abs)
        .filter((size) => size > 0)
        .sort((a, b) => a - b);
    if (sizes.length === 0) return { scale: linear(-1, 1), even: true };
    const lo = Math.min(0, ...values);
    const hi = Math.max(0, ...values);
    const margin = 0.06 * (hi - lo);
    const middle = sizes[sizes.length >> 1];
    const largest = sizes[sizes.length - 1];
    if (largest <= LINEAR_RANGE * middle) return { scale: linear(lo - margin, hi + margin), even: true };
    const power = 10 ** Math.floor(Math.log10(middle / 3));
    return { scale: symlog(lo < 0 ? 1.6 * lo : -power, hi > 0 ? 1.6 * hi : power, power), even: false };
}

/** What to subtract from values between lo and hi where they agree in their first digits; 0 where they
 * don't. */
export function anchorOf(lo, hi) {
    const size = Math.max(Math.abs(lo), Math.abs(hi));
    const span = hi - lo;
    if (!(span < 1e-3 * size)) return 0;
    const decimals = Math.min(15, Math.max(0, Math.ceil(-Math.log10(Math.max(span, 2 ** -52 * size)))));
    return Number((lo + span / 2).toFixed(decimals));
}
