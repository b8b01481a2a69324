// Complex space: the paper's presets are drawn, its sliders change the picture while they move, all is proved.
import assert from "node:assert/strict";
import { visitTest } from "./harness.mjs";
import { drawnPixels } from "./png.mjs";
import { Recorder } from "./recorder.mjs";

/** The share of pixels that are drawn, of those at the picture's edge, and of the ones of each side's colour. */
function shares({ width, height, data }) {
    const seen = { all: 0, edge: 0, warm: 0, cold: 0 };
    for (let i = 0; i < width * height; i++) {
        const [r, , b, a] = data.subarray(4 * i, 4 * i + 4), x = i % width, y = Math.floor(i / width);
        if (a < 128) continue;
        seen.all++;
        seen[r > b ? "warm" : "cold"]++;
        if (x === 0 || y === 0 || x === width - 1 || y === height - 1) seen.edge++;
    }
    return Object.fromEntries(Object.entries(seen).map(([key, count]) => [key, count / (width * height)]));
}

const PHONE = { width: 360, height: 640, hasTouch: true, isMobile: true, deviceScaleFactor: 1 };
for (const [where, size] of [["a desktop", { width: 900, height: 640 }], ["a phone", PHONE]])
    visitTest(`the paper's presets are seen whole, with both sides, and differ from real space: ${where}`, size, async (visit) => {
        const presets = visit.page.locator(".complex-presets button"), options = { width: 120, height: 90, antialias: 1 };
        for (let i = 0; i < (await presets.count()); i++) {
            await presets.nth(i).evaluate((node) => node.click());
            await visit.until(({ complex, picture }) => complex && JSON.stringify(picture?.state.complex) === JSON.stringify(complex));
            await visit.settled();
            const name = `${i}, ${await presets.nth(i).textContent()}`, picture = await visit.pixels();
            const { all, edge, warm, cold } = shares(picture);
            assert.ok(all > 0.08 && all < 0.75, `${name}: ${all} of the picture`);
            assert.equal(edge, 0, `${name} is cut`);
            assert.ok(Math.min(warm, cold) > 0.004, `${name}: ${warm} and ${cold}`);
            const complex = await visit.image(options);
            const real = await visit.page.evaluate(() => window.algsurfPage.store.set({ complex: null })).then(() => visit.image(options));
            const other = complex.data.filter((value, k) => Math.abs(value - real.data[k]) > 40).length / complex.data.length;
            assert.ok(other > 0.03, `${name}: only ${other} differs from real space`);
        }
    });

visitTest("the paper's presets are drawn", { width: 900, height: 640 }, async (visit) => {
    await visit.unfold("complex");
    const presets = await visit.page.locator(".complex-presets button").all();
    assert.ok(presets.length >= 4);
    for (const preset of presets) {
        await preset.click();
        await visit.until(({ complex }) => complex !== null);
        const { undecided, hits } = await visit.settled();
        const name = await preset.textContent();
        assert.equal(undecided, 0, name);
        assert.ok(hits > 5000, `${name}: ${hits} hits`);
        assert.ok(drawnPixels(await visit.pixels()) > 5000, name);
    }
});

visitTest("its sliders draw while they move; it is switched off again", {}, async (visit) => {
    const { page } = visit;
    await visit.unfold("complex");
    await page.locator(".complex-switch input").check();
    await visit.until(({ complex }) => complex !== null);
    await visit.settled();
    const before = await visit.state(), recorder = await Recorder.start(visit);
    const delta = page.locator("#complex .number-field", { hasText: "δ" }).locator("input[type=range]");
    await delta.focus();
    for (let i = 0; i < 20; i++) {
        await page.keyboard.press("ArrowRight");
        await page.waitForTimeout(20);
    }
    await visit.until(({ complex }, old) => complex.delta > old, before.complex.delta);
    await visit.finished();
    const stages = (await recorder.stop()).map(({ stage }) => stage);
    assert.ok(stages.includes("moving") && stages.includes("smooth"), `stages: ${stages}`);
    await page.locator(".complex-switch input").uncheck();
    await visit.until(({ complex }) => complex === null);
    await visit.settled();
});

visitTest("a sweep plays and stops", {}, async (visit) => {
    const { page } = visit;
    await visit.unfold("complex");
    await page.locator(".complex-presets button").first().click();
    await visit.settled();
    const play = page.locator("#complex button[aria-pressed]").first();
    await play.click();
    const seen = new Set();
    for (let i = 0; i < 30; i++) {
        seen.add(JSON.stringify((await visit.state()).complex));
        await page.waitForTimeout(30);
    }
    assert.ok(seen.size > 5, `${seen.size} states while it plays`);
    await play.click();
    await visit.settled();
});
