// Typing: an equation becomes a picture; a mistake is told under its column while the last good picture stays; free
// letters become sliders.
import assert from "node:assert/strict";
import { drawnPixels } from "./png.mjs";
import { visitTest } from "./harness.mjs";

visitTest("an equation that is typed is drawn", {}, async (visit) => {
    const before = await visit.pixels();
    await visit.type("x^4 + y^4 + z^4 = 1");
    await visit.until(({ equation }) => equation === "x^4 + y^4 + z^4 = 1");
    const { degree, undecided, hits } = await visit.settled();
    assert.equal(degree, 4);
    assert.equal(undecided, 0);
    assert.ok(hits > 10_000, `${hits} hits`);
    const now = await visit.pixels();
    assert.ok(drawnPixels(now) > 10_000);
    assert.notDeepEqual(now.data, before.data);
});

visitTest("a mistake is told under its column, and the last good picture stays", {}, async (visit) => {
    await visit.type("x^2 + y^2 + z^2 = 1");
    await visit.until(({ equation }) => equation === "x^2 + y^2 + z^2 = 1");
    await visit.finished();
    const before = await visit.pixels();
    await visit.type("x^2 + y^2 + ) z^2 = 1");
    await visit.page.locator("#formula[aria-invalid=true]").waitFor();
    assert.match(await visit.text("#mistake"), /13/);
    assert.equal(await visit.page.locator("#mirror mark").textContent(), ")");
    const [mark, box] = await visit.page.evaluate(() =>
        ["#mirror mark", "#formula"].map((name) => document.querySelector(name).getBoundingClientRect().toJSON()));
    const padding = 13, column = (mark.left - box.left - padding) / mark.width;
    assert.ok(Math.abs(column - 12) < 0.2, `marked at column ${column}, not 12`);
    assert.equal((await visit.state()).equation, "x^2 + y^2 + z^2 = 1");
    assert.deepEqual((await visit.pixels()).data, before.data);
    await visit.type("x^2 + y^2 + 2z^2 = 1");
    await visit.until(({ equation }) => equation === "x^2 + y^2 + 2z^2 = 1");
    assert.equal(await visit.page.locator("#formula").getAttribute("aria-invalid"), "false");
    assert.equal(await visit.text("#mistake"), "");
});

const REFUSED = {
    "a degree that is too high": "x^65 + y^2 = 1",
    "an exponent that is enormous": "x^99999999999999999999",
    "brackets without end": "(".repeat(3000),
    "markup": "<img src=x onerror=alert(1)>",
    "division by zero": "1/0 x + y = z",
    "a number out of range": "1e999 x = y",
    "letters of another alphabet": "х^2 + у^2 = 1",
    "a joke": "\u202e\u0000😀",
};

visitTest("what is no surface of degree 1 to 64 is refused in words", {}, async (visit) => {
    const { equation } = await visit.state();
    for (const [what, text] of Object.entries(REFUSED)) {
        await visit.type(text);
        await visit.wait("#formula[aria-invalid=true]").catch(() => assert.fail(`${what} is not refused`));
        const said = await visit.text("#mistake");
        assert.ok(said.length > 10, `${what}: '${said}'`);
        assert.doesNotMatch(said, /undefined|NaN|null|\[object|E_[A-Z]/, what);
        assert.equal((await visit.state()).equation, equation, what);
        await visit.type("");
    }
});

visitTest("free letters become sliders that can be moved, given a range, and played", {}, async (visit) => {
    const { page } = visit;
    await visit.type("x^2 + a y^2 + z^2 = b");
    await visit.until(({ parameters }) => "a" in parameters && "b" in parameters);
    await visit.settled();
    const before = await visit.pixels();
    await page.locator("#parameter-a").focus();
    for (let i = 0; i < 3; i++) await page.keyboard.press("PageUp");
    await visit.until(({ parameters }) => parameters.a.value > 1);
    await visit.settled();
    assert.notDeepEqual((await visit.pixels()).data, before.data);

    const [value, from, to] = await page.locator(".parameter").first().locator("input[type=number]").all();
    await from.fill("-1");
    await to.fill("7");
    await to.press("Tab");
    await value.fill("3.25");
    await value.press("Enter");
    await visit.until(({ parameters: { a } }) => a.value === 3.25 && a.from === -1 && a.to === 7);
    await value.fill("50");
    await value.press("Enter");
    await visit.until(({ parameters: { a } }) => a.value === 50 && a.to === 50);

    const play = page.locator(".parameter").nth(1).locator("button");
    await play.click();
    const seen = new Set();
    for (let i = 0; i < 20; i++) {
        seen.add((await visit.state()).parameters.b.value);
        await page.waitForTimeout(30);
    }
    assert.ok(seen.size > 5, `${seen.size} values while it plays`);
    await play.click();
    await visit.settled();
});
