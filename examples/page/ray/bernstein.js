// bernstein.js - for drawing only: Bernstein coefficients on a part of an interval, and their convex hull.
// What the page says of cells and roots is what the library proved; nothing is decided here.

/** b on 0..1 brought to 0..u (de Casteljau). */
function head(b, u) {
    const row = [...b];
    const first = [row[0]];
    for (let n = row.length - 1; n > 0; n--) {
        for (let k = 0; k < n; k++) row[k] += u * (row[k + 1] - row[k]);
        first.push(row[0]);
    }
    return first;
}

const mirrored = (b) => [...b].reverse();

/** b on lo..hi brought to from..to; returns points [t, b]. */
export function restrict(b, lo, hi, from, to) {
    const upper = head(b, (to - lo) / (hi - lo));
    const kept = to > lo ? (to - from) / (to - lo) : 0;
    const part = mirrored(head(mirrored(upper), kept));
    const n = part.length - 1;
    return part.map((value, k) => [n === 0 ? from : from + ((to - from) * k) / n, value]);
}

/** Values of the polynomial with coefficients b on lo..hi, at count + 1 places evenly from from to to, as
 * points [t, value]. */
export function samples(b, lo, hi, from, to, count) {
    return Array.from({ length: count + 1 }, (_, i) => {
        const t = from + ((to - from) * i) / count;
        return [t, head(b, (t - lo) / (hi - lo)).pop()];
    });
}

const turn = (a, b, c) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);

function half(points) {
    const chain = [];
    for (const point of points) {
        while (chain.length > 1 && turn(chain[chain.length - 2], chain[chain.length - 1], point) <= 0)
            chain.pop();
        chain.push(point);
    }
    return chain;
}

/** The corners of the convex hull of points in order of their abscissae. */
export function convexHull(points) {
    if (points.length < 3) return points;
    return [...half(points).slice(0, -1), ...half(mirrored(points)).slice(0, -1)];
}
