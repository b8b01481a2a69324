// Complex space: the paper's presets are drawn, its sliders change the picture while they move, all is proved.
import assert from "node:assert/strict";
import { visitTest } from "./harness.mjs";
import { drawnPixels } from "./png.mjs";
import { Recorder } from "./recorder.mjs";

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
