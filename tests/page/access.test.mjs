// For everyone: what axe-core finds (names, roles, contrast AA, ...), and a sentence that describes the picture.
import assert from "node:assert/strict";
import { visitTest } from "./harness.mjs";
import { installed } from "./settings.mjs";

const RULES = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"];

/** What is wrong now, one line each. */
async function broken({ page }) {
    await page.evaluate(installed("axe-core").source);
    const { violations } = await page.evaluate((values) => window.axe.run({ runOnly: { type: "tag", values } }), RULES);
    return violations.flatMap(({ id, help, nodes }) => nodes.map(({ target }) => `${id}: ${help}: ${target}`));
}

for (const colorScheme of ["light", "dark"])
    visitTest(`axe finds nothing: ${colorScheme}, all parts open`, { colorScheme }, async (visit) => {
        const { page } = visit, { middleX, middleY } = await visit.box();
        await visit.type("x^2 + y^2 + a z^2 = 1");
        await visit.until(({ parameters }) => "a" in parameters);
        await page.mouse.click(middleX, middleY);
        await page.locator("#ray .ray-facts dd").first().waitFor();
        for (const name of ["view", "look", "complex", "take"]) await visit.unfold(name);
        await page.locator(".complex-switch input").check();
        await visit.settled();
        assert.deepEqual(await broken(visit), []);
        await visit.type("x^2 + ) y");
        await page.locator("#formula[aria-invalid=true]").waitFor();
        assert.deepEqual(await broken(visit), []);
    });

visitTest("axe finds nothing: help", {}, async (visit) => {
    await visit.page.locator("#open-help").click();
    await visit.page.locator("#help[open]").waitFor();
    assert.deepEqual(await broken(visit), []);
});

visitTest("axe finds nothing: a phone", { width: 360, height: 640, hasTouch: true, isMobile: true }, async (visit) => {
    assert.deepEqual(await broken(visit), []);
});

visitTest("a sentence describes the picture", { link: "#v1&equation=x^2%2By^2%2Bz^2=1" }, async (visit) => {
    await visit.until(() => document.querySelector("#seen").textContent !== "");
    const name = await visit.page.locator("#picture").getAttribute("aria-label");
    const seen = await visit.page.locator("#seen").textContent();
    assert.match(`${name} ${seen}`, /degree 2/);
    assert.ok(seen.trim().length > 30, seen);
});
