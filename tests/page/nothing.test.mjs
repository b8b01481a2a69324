// An empty picture says why, and can be filled; names of the catalogue open their surfaces, and what is like one is
// told.
import assert from "node:assert/strict";
import { visitTest, WORDS } from "./harness.mjs";

const EMPTY = {
    "x^2 + y^2 + z^2 + 1": "It has no real point.",
    "x^2 + 1": "It has no real point.",
    "x^4 + y^4 + z^4 - x^2*y^2 + x*y + x + 9": "It has no real point.",
    "x^2 + y^2 + z^2 = 100": "Nothing of it lies in the ball of radius 2.",
};

for (const [equation, why] of Object.entries(EMPTY))
    visitTest(`an empty picture says why: ${equation}`, { link: `#v1&equation=${encodeURIComponent(equation)}&extent=sphere:2` },
        async (visit) => {
            await visit.wait("#nothing");
            assert.equal((await visit.text("#nothing p")), why);
            const fit = visit.page.locator("#nothing button");
            assert.equal(await fit.count(), why.includes("real") ? 0 : 1);
            if (!why.includes("real")) {
                await fit.click();
                await visit.until(({ extent }) => extent.size[0] > 9);
            } else {
                await visit.type("x^2 + y^2 + z^2 = 1");
            }
            await visit.until(({ picture }) => picture?.hits > 1000);
            assert.equal(await visit.page.locator("#nothing").isVisible(), false);
            await visit.settled();
        });

visitTest("what lies behind the eye, or in a box elsewhere, or in no sector, is told", {}, async (visit) => {
    const set = (partial) => visit.page.evaluate((partial) => window.algsurfPage.store.set(partial), partial);
    await visit.type("x^2 + y^2 + z^2 = 1");
    await visit.until(({ equation }) => equation === "x^2 + y^2 + z^2 = 1");
    await set({ camera: { eye: [5, 0, 0], lookAt: [9, 0, 0], up: [0, 0, 1], fov: 25 } });
    await visit.page.locator("#nothing", { hasText: WORDS["nothing.view"] }).waitFor();
    await visit.screenshot("nothing is seen");
    await set({ extent: { kind: "box", size: [1, 1, 1], centre: [9, 0, 0] } });
    await visit.page.locator("#nothing", { hasText: WORDS["nothing.box"] }).waitFor();
    await set({ complex: { sigma: 0.1, delta: 0, imaginary: {} } });
    await visit.page.locator("#nothing", { hasText: WORDS["nothing.sector"] }).waitFor();
    await set({ complex: null });
    await visit.page.locator("#nothing button").click();
    await visit.until(({ picture }) => picture.hits > 1000);
    await visit.settled();
});

visitTest("a name of the catalogue that is typed opens its surface", {}, async (visit) => {
    const { page } = visit;
    for (const [typed, wanted] of [["heart", "heart"], ["Boy's surface", "boy"], ["klein bottle", "klein"]]) {
        await visit.type(typed);
        await page.keyboard.press("Enter");
        await visit.until(({ name }, wanted) => name === wanted, wanted);
        assert.notEqual(await page.locator("#formula").inputValue(), typed);
    }
    await visit.type("BARTH"); // without Enter
    await visit.until(({ name }) => name === "barth");
    await visit.settled();
});

visitTest("a name that is the beginning of another waits for the rest", {}, async (visit) => {
    await visit.page.locator("#formula").click();
    await visit.page.keyboard.press("Control+A");
    await visit.page.keyboard.type("barth decic", { delay: 60 });
    await visit.page.keyboard.press("Enter");
    await visit.until(({ name }) => name === "decic");
    await visit.settled();
});

visitTest("a word that is like a name suggests it, and draws nothing", {}, async (visit) => {
    const { page } = visit, { equation } = await visit.state();
    for (const [typed, wanted] of [["shpere", "sphere"], ["hart", "heart"], ["bottle", "klein"], ["umbrela", "whitney"], ["klein botle", "klein"]]) {
        await visit.type(typed);
        await page.locator("#mistake button", { hasText: WORDS[`name.${wanted}`] }).waitFor();
        assert.equal((await visit.state()).equation, equation, typed);
    }
    await visit.screenshot("a suggestion");
    await page.locator("#mistake button", { hasText: WORDS["name.klein"] }).click();
    await visit.until(({ name }) => name === "klein");
    assert.equal(await visit.text("#mistake"), "");
    await visit.type("foo");
    await page.locator("#mistake", { hasText: WORDS["mistake.CONSTANT"] }).waitFor();
    assert.equal(await page.locator("#mistake button").count(), 0);
    await visit.type("xyz"); // an equation
    await visit.until(({ equation }) => equation === "xyz");
    await visit.settled();
});

visitTest("of a surface that has points it is never said that it has none", {}, async (visit) => {
    const told = await visit.page.evaluate(async () => {
        const { SURFACES } = await import(new URL("state/surfaces.js", location.href));
        const { painter, store } = window.algsurfPage, { picture, ...rest } = store.get();
        const own = ["x^2 + y^2", "(x^2 + y^2 + z^2 + 1)(x - 1e5)", "(x^2 + y^2 + 1)(z^2 - 1e-8)", "x^2 + (y - 1e3)^2 + (z - 2)^2", "x^3 + 1e9"];
        const states = [...SURFACES, ...own.map((equation) => ({ equation, parameters: {} }))];
        const ask = (state) => painter.ask("nothing", { ...rest, ...state, clip: [] });
        return Promise.all(states.map(async (state) => [state.equation, await ask(state)]));
    });
    for (const [equation, why] of told) assert.notEqual(why, "nowhere", equation);
});
