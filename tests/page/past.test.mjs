// Surfaces that were looked at: own ones are kept once they were drawn; the browser's Back and Forward go along them.
import assert from "node:assert/strict";
import { visitTest } from "./harness.mjs";

const OWN = "x^2 + y^2 = z^3 + 1", OTHER = "x^4 + y^4 + z^4 = 2";
const kept = () => [...document.querySelectorAll("#gallery hr ~ *")].length === 0 ? [] :
    [...document.querySelectorAll("#gallery .thumb")].map(({ title }) => title)
        .slice(0, [...document.querySelector("#gallery").children].findIndex(({ tagName }) => tagName === "HR"));
const isShown = ({ equation, name, picture }, wanted) => [equation, name].includes(wanted) && picture?.state.equation === equation;

async function typed(visit, equation) {
    await visit.type(equation);
    await visit.until(isShown, equation);
    await visit.settled();
}

visitTest("an own surface is kept once it was drawn, even if another is opened at once", {}, async (visit) => {
    const { page } = visit;
    await typed(visit, OWN);
    await page.locator("#gallery .thumb").nth(3).click();
    await visit.until(({ name }) => name !== "");
    await page.locator(`#gallery .thumb[title="${OWN}"]`).waitFor();
    await typed(visit, OTHER);
    await page.locator(`#gallery .thumb[title="${OTHER}"]`).waitFor();
    await page.reload();
    await visit.settled();
    assert.deepEqual(await page.evaluate(kept), [OTHER, OWN]);
});

visitTest("what was typed on the way to it is not", {}, async (visit) => {
    const { page } = visit;
    await page.waitForFunction(() => location.hash !== ""); // of the surface that Back goes to
    await page.locator("#formula").click();
    await page.keyboard.press("Control+A");
    for (const sign of "x^2+y^2=z^3") {
        await page.keyboard.type(sign);
        await page.waitForTimeout(250);
    }
    await visit.until(isShown, "x^2+y^2=z^3");
    await page.locator('#gallery .thumb[title="x^2+y^2=z^3"]').waitFor();
    assert.deepEqual(await page.evaluate(kept), ["x^2+y^2=z^3"]);
    await page.waitForTimeout(700);
    await page.goBack();
    await visit.until(isShown, "barth");
});

visitTest("Back goes to the surface before, and Forward to the next one", {}, async (visit) => {
    const { page } = visit;
    await page.waitForFunction(() => location.hash !== "");
    await typed(visit, OWN);
    await page.locator("#gallery .thumb[title='Torus']").click();
    await visit.until(({ name }) => name === "torus");
    await page.locator("#formula").click(); // at once; what is typed a moment later is no part of what was clicked
    await visit.until(isShown, "torus");
    await page.waitForTimeout(800);
    await typed(visit, OTHER);
    await page.waitForTimeout(800);
    for (const wanted of ["torus", OWN, "barth"]) {
        await page.goBack();
        await visit.until(isShown, wanted);
        assert.equal(await page.locator("#formula").inputValue(), (await visit.state()).equation);
        await page.waitForTimeout(800);
    }
    for (const wanted of [OWN, "torus", OTHER]) {
        await page.goForward();
        await visit.until(isShown, wanted);
    }
    await visit.settled();
});

visitTest("a link that cannot be drawn does not catch who goes back", { link: "#v1&name=heart" }, async (visit) => {
    const { page } = visit;
    await page.evaluate(() => (location.hash = "#v1&equation=(((("));
    await page.locator("#notice", { hasText: "cannot be drawn" }).waitFor();
    await page.waitForTimeout(800);
    const { length } = { length: await page.evaluate(() => history.length) };
    await page.locator("#gallery .thumb[title='Torus']").click();
    await visit.until(isShown, "torus");
    await page.waitForTimeout(800);
    assert.equal(await page.evaluate(() => history.length), length + 1);
    await page.goBack();
    await visit.until(isShown, "barth");
    await visit.settled();
});
