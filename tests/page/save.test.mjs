// Saving: a large picture shows progress and can be cancelled; a film has all its pictures, those of render --sweep.
import assert from "node:assert/strict";
import { visitTest, WORDS } from "./harness.mjs";

const SPHERE = "#v1&equation=x^2%2By^2%2Bz^2=a&let:a=1:0.5:1&extent=sphere:1.2";

async function fill({ page }, key, which, value) {
    await page.locator("#take").getByLabel(WORDS[key], { exact: true }).nth(which).fill(String(value));
}

visitTest("saving a large picture shows progress, and is cancelled", { link: SPHERE }, async (visit) => {
    const { page } = visit;
    await visit.unfold("take");
    await fill(visit, "take.width", 0, 8000);
    await fill(visit, "take.height", 0, 6000);
    let downloads = 0;
    page.on("download", () => downloads++);
    await visit.button("take.png").click();
    const progress = page.locator("#take progress");
    await progress.waitFor();
    for (let value = 0; value === 0; value = await progress.evaluate((node) => node.value)) await page.waitForTimeout(50);
    await visit.button("take.cancel").click();
    await progress.waitFor({ state: "hidden" });
    await visit.type("x^2 + y^2 = z^2 + 1");
    await visit.until(({ equation }) => equation === "x^2 + y^2 = z^2 + 1");
    await visit.settled();
    assert.equal(downloads, 0);
});

visitTest("a film has as many pictures as asked for", { link: SPHERE }, async (visit) => {
    const { page } = visit;
    await visit.unfold("take");
    await fill(visit, "take.width", 1, 64);
    await fill(visit, "take.height", 1, 48);
    await page.getByLabel(WORDS["take.film.what"], { exact: true }).selectOption("let:a");
    await page.getByLabel(WORDS["take.film.pictures"], { exact: true }).fill("5");
    await page.getByLabel(WORDS["take.film.pictures"], { exact: true }).press("Tab");
    const { name, bytes } = await visit.saved(() => visit.button("take.film").click());
    assert.match(name, /\.png$/);
    const control = bytes.indexOf("acTL");
    assert.ok(control > 0, "it is not animated");
    assert.equal(bytes.readUInt32BE(control + 4), 5);
    assert.equal(bytes.toString("latin1").split("fcTL").length - 1, 5);
});
