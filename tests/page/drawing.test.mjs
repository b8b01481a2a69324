// What the plots are drawn from: Bernstein coefficients of a part, scales and their ticks, angles, numbers as text.
import assert from "node:assert/strict";
import { test } from "node:test";
import { part } from "./modules.mjs";

const { convexHull, restrict, samples } = await part("ray/bernstein");
const { anchorOf, linear, log, ofValues, symlog } = await part("ray/axis");
const { short, whole } = await part("base/number");
const { withDelta, withFirstEdge, withLastEdge, withSigma } = await part("complex/sector");
const { planeView, rayIn, wedgeIn } = await part("ray/planeview");

const close = (a, b, within = 1e-12) => assert.ok(Math.abs(a - b) <= within, `${a} is not ${b}`);

test("Bernstein coefficients of a part begin and end on the curve, and hold it in their hull", () => {
    const b = [1, -3, 2, 5]; // on 0..1: (1-t)^3 - 9t(1-t)^2 + 6t^2(1-t) + 5t^3
    const p = (t) => (1 - t) ** 3 - 9 * t * (1 - t) ** 2 + 6 * t * t * (1 - t) + 5 * t ** 3;
    const points = restrict(b, 2, 4, 2.5, 3.25);
    assert.equal(points.length, 4);
    close(points[0][0], 2.5);
    close(points[3][0], 3.25);
    close(points[0][1], p(0.25));
    close(points[3][1], p(0.625));
    const values = points.map((point) => point[1]);
    for (const [t, value] of samples(b, 2, 4, 2.5, 3.25, 20)) {
        close(value, p((t - 2) / 2));
        assert.ok(value >= Math.min(...values) - 1e-12 && value <= Math.max(...values) + 1e-12);
    }
});

test("a convex hull has the corners and nothing else", () => {
    const hull = convexHull([[0, 0], [1, 5], [2, 1], [3, -4], [4, 0]]);
    assert.deepEqual(hull.map(String).sort(), ["0,0", "1,5", "3,-4", "4,0"]);
});

test("ticks lie in the range, and scales bring its ends to 0 and 1", () => {
    for (const scale of [linear(-0.37, 12.2), symlog(-500, 80, 0.1), log(3e-9, 40), linear(1e-9, 1.1e-9)]) {
        close(scale.at(scale.lo), 0);
        close(scale.at(scale.hi), 1);
        for (const most of [2, 5, 12]) {
            const ticks = scale.ticks(most);
            assert.ok(ticks.length >= 1 && ticks.length <= most + 2, `${ticks.length} ticks, ${most} wanted`);
            for (const { at } of ticks) assert.ok(scale.at(at) > -1e-9 && scale.at(at) < 1 + 1e-9);
        }
    }
});

test("values of a size get a linear axis, others a logarithmic one", () => {
    assert.equal(ofValues([-1, 2, 3]).even, true);
    assert.equal(ofValues([0.001, -0.002, 0.001, 500]).even, false);
    assert.equal(ofValues([0, 0]).even, true);
});

test("an anchor is subtracted where first digits agree", () => {
    assert.equal(anchorOf(1, 2), 0);
    const anchor = anchorOf(8.7507625, 8.7507626);
    assert.ok(anchor > 8.7507 && anchor < 8.7508);
});

test("numbers are written with a true minus sign and raised exponents, and all digits if asked", () => {
    assert.equal(short(-0.5), "−0.5");
    assert.equal(short(1.23456e-13, 3), "1.23·10⁻¹³");
    assert.equal(whole(0.1), "0.1");
    assert.equal(whole(8.750762518272953), "8.750762518272953");
});

test("a sector stays within 0..pi whatever is asked for", () => {
    const good = ({ sigma, delta }) => sigma >= 0 && delta >= 0 && sigma + delta <= Math.PI;
    for (const from of [{ sigma: 0, delta: 1e-10 }, { sigma: 1, delta: 0.3 }, { sigma: 2, delta: Math.PI - 2 }])
        for (const move of [withDelta, withFirstEdge, withLastEdge, withSigma])
            for (const angle of [-1, 0, 0.5, 1.1, 2.5, Math.PI, 7, NaN, Infinity])
                assert.ok(good(move(from, angle)), `${move.name} ${angle} ${JSON.stringify(move(from, angle))}`);
    const moved = withFirstEdge({ sigma: 1, delta: 0.5 }, 1.2);
    close(moved.sigma, 1.2);
    close(moved.sigma + moved.delta, 1.5);
});

test("a view holds all points at first, keeps the fixed one in place, and tells 1e-15 apart", () => {
    const points = [{ re: 0, im: 0 }, { re: 9, im: 1 }, { re: 8, im: -1 }];
    const fixed = points[1], wide = planeView(300, 200, points, fixed, 1), near = planeView(300, 200, points, fixed, 2 ** 50);
    for (const { re, im } of points) {
        assert.ok(wide.x(re) > 0 && wide.x(re) < 300);
        assert.ok(wide.y(im) > 0 && wide.y(im) < 200);
    }
    close(near.x(9), wide.x(9));
    close(near.y(1), wide.y(1));
    assert.ok(near.x(9 + 2 ** -49) - near.x(9) > 20);
});

test("the wedge is cut to the view", () => {
    const view = planeView(300, 200, [{ re: -2, im: -2 }, { re: 2, im: 2 }], { re: 0, im: 0 }, 1);
    const angle = ([re, im]) => Math.atan2(im, re);
    const corners = wedgeIn(view, 0.3, 0.9, 1).filter(([re, im]) => Math.hypot(re, im) > 1e-9);
    assert.ok(corners.length >= 2);
    for (const corner of corners) assert.ok(angle(corner) > 0.3 - 1e-9 && angle(corner) < 0.9 + 1e-9);
    for (const corner of wedgeIn(view, 0.3, 0.9, -1)) assert.ok(Math.hypot(...corner) < 1e-9 || angle(corner) < -0.3 + 1e-9);
    const [begin, end] = rayIn(view, 0.3);
    assert.ok(begin === 0 && end > 1.9);
    const away = planeView(300, 200, [{ re: 5, im: 5 }, { re: 6, im: 6 }], { re: 5, im: 5 }, 1);
    assert.equal(rayIn(away, Math.PI), null);
});
