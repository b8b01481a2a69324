// A click on the surface looks into its ray: numbers as the native program intersect has them, all roots, each method.
import assert from "node:assert/strict";
import { visitTest } from "./harness.mjs";
import { native } from "./settings.mjs";

const BARTH = "#v1&equation=4((3%2Bsqrt(5))/2*x^2-y^2)((3%2Bsqrt(5))/2*y^2-z^2)((3%2Bsqrt(5))/2*z^2-x^2)-" +
    "(2%2Bsqrt(5))(x^2%2By^2%2Bz^2-1)^2&extent=sphere:2";

/** What the engine says of the pixel at a place of the window. */
function pickAt(visit, place) {
    return visit.page.evaluate(([x, y]) => {
        const { store, painter } = window.algsurfPage, canvas = document.querySelector("#picture");
        const { left, top, width: wide, height: high } = canvas.getBoundingClientRect();
        const { width, height } = canvas;
        const at = { width, height, x: Math.floor(((x - left) / wide) * width), y: Math.floor(((y - top) / high) * height) };
        return painter.ask("pick", store.get(), at);
    }, place);
}

/** The same, in the same extent: with another part of the ray the last bits of a position may be others. */
function nativeHit(equation, { origin, direction, tMin, tMax }) {
    const input = [...origin, ...direction, tMin, tMax].map(String).join(" ");
    const options = ["--equation", equation, "--extent", "sphere:2"];
    const [head, row] = native("intersect", options, { input }).trim().split("\n");
    const names = head.replace("#", "").trim().split("\t");
    return Object.fromEntries(row.split("\t").map((value, i) => [names[i], value]));
}

visitTest("a click on the surface shows the hit that intersect finds", { link: BARTH }, async (visit) => {
    const { page } = visit, { middleX, middleY } = await visit.box(), { equation } = await visit.state();
    for (const [dx, dy] of [[0, 0], [60, -40], [-90, 30]]) {
        const place = [middleX + dx, middleY + dy];
        const pick = await pickAt(visit, place);
        assert.equal(pick.state, "hit", "the test clicks beside the surface");
        await page.mouse.click(...place);
        await page.waitForFunction((t) => document.querySelector("#ray").textContent.includes(t), String(pick.t));
        const hit = nativeHit(equation, pick.ray);
        assert.equal(hit.state, "hit");
        assert.equal(Number(hit.t), pick.t);
        assert.deepEqual([hit.t_lo, hit.t_hi].map(Number), [pick.tLo, pick.tHi]);
        assert.deepEqual([hit.x, hit.y, hit.z].map(Number), pick.position);
        assert.deepEqual([hit.nx, hit.ny, hit.nz].map(Number), pick.normal);
        assert.equal(Number(hit.multiplicity), pick.multiplicity);
        const shown = await page.locator("#ray .ray-facts").textContent();
        for (const value of [...pick.position, ...pick.normal].filter((x) => Math.abs(x) > 0.001))
            assert.ok(shown.includes(String(Number(Math.abs(value).toPrecision(6)))), `${value} is not in: ${shown}`);
    }
    await visit.settled();
});

visitTest("of the ray one sees its polynomial, all complex roots, and each method step by step", { link: BARTH }, async (visit) => {
    const { page } = visit, { middleX, middleY } = await visit.box();
    const place = [middleX + 60, middleY - 40], pick = await pickAt(visit, place);
    await page.mouse.click(...place);
    const ray = page.locator("#ray");
    await ray.locator(".ray-coefficients li").first().waitFor({ state: "attached" });
    assert.equal(await ray.locator(".ray-coefficients li").count(), pick.degree + 1);
    await ray.locator("h3", { hasText: /method|found/i }).first().waitFor();
    assert.ok((await ray.locator("svg").count()) >= 2, "a plot and a plane");
    const roots = await page.evaluate(async ([x, y]) => {
        const { store, painter } = window.algsurfPage, { width, height } = document.querySelector("#picture");
        const { left, top, width: wide, height: high } = document.querySelector("#picture").getBoundingClientRect();
        const at = { width, height, x: Math.floor(((x - left) / wide) * width), y: Math.floor(((y - top) / high) * height) };
        return painter.ask("complexRoots", store.get(), at);
    }, place);
    assert.equal(roots.reduce((sum, root) => sum + root.multiplicity, 0), 6);
    for (const { re, im, box } of roots)
        assert.ok(box[0] <= re && re <= box[1] && box[2] <= im && im <= box[3], "a root outside of its box");
    const text = await ray.textContent();
    for (const method of [/brent/i, /bisection/i, /regula falsi/i]) assert.match(text, method);
    const steppers = ray.locator(".ray-stepper input[type=range]:visible");
    assert.ok((await steppers.count()) >= 1);
    for (const stepper of await steppers.all()) {
        await stepper.focus();
        for (const key of ["End", "Home", "ArrowRight"]) await page.keyboard.press(key);
    }
    assert.doesNotMatch(await ray.textContent(), /NaN|undefined|\[object/);
});

visitTest("a click beside the surface says that nothing is hit there", { link: "#v1&equation=x^2%2By^2%2Bz^2=0.04&extent=sphere:2" },
    async (visit) => {
        const { x, y } = await visit.box();
        await visit.page.mouse.click(x + 30, y + 30);
        await visit.page.locator("#ray .ray-verdict:not(:empty)").waitFor();
        assert.doesNotMatch(await visit.text("#ray"), /Normal|Multiplicity/);
        await visit.settled();
    });
