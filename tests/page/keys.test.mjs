// Keys alone: Tab reaches every control and shows where it is; arrows, + - 0 move the picture; ? and Escape.
import assert from "node:assert/strict";
import { visitTest } from "./harness.mjs";

/** Marks what can be reached by Tab now, and gives how many that are. */
function mark() {
    const wanted = "a[href], button, input, select, textarea, summary, [tabindex]";
    const all = [...document.querySelectorAll(wanted)].filter((node) => {
        const isSeen = node.checkVisibility({ visibilityProperty: true }) && node.getClientRects().length > 0;
        return isSeen && node.tabIndex >= 0 && !node.disabled;
    });
    all.forEach((node, i) => (node.dataset.checked = String(i)));
    return all.map((node) => `${node.tagName} ${node.id} ${node.getAttribute("aria-label") ?? node.textContent}`.slice(0, 60));
}

/** The element that has the focus: its number, and whether one sees it. */
function focused() {
    const node = document.activeElement;
    if (!node || node === document.body) return null;
    const { outlineStyle, outlineWidth } = getComputedStyle(node);
    const { left, top, right, bottom } = node.getBoundingClientRect();
    return {
        number: node.dataset.checked ?? null,
        what: `${node.tagName} ${node.id} ${node.className}`,
        isMarked: outlineStyle !== "none" && parseFloat(outlineWidth) >= 1,
        isInside: right > 0 && bottom > 0 && left < innerWidth && top < innerHeight,
    };
}

visitTest("Tab reaches every control, and the focus is seen", {}, async (visit) => {
    const { page } = visit;
    for (const name of ["view", "look", "ray", "complex", "take"]) await visit.unfold(name);
    await page.evaluate(() => document.activeElement.blur());
    const names = await page.evaluate(mark), reached = new Set();
    assert.ok(names.length > 40, `${names.length} controls`);
    for (let i = 0; i < names.length + 30; i++) {
        await page.keyboard.press("Tab");
        const now = await page.evaluate(focused);
        if (!now) continue;
        assert.ok(now.isMarked, `one does not see that ${now.what} has the focus`);
        assert.ok(now.isInside, `${now.what} has the focus outside of the window`);
        reached.add(now.number);
    }
    const missed = names.filter((_, i) => !reached.has(String(i)));
    assert.deepEqual(missed, []);
});

visitTest("arrows turn, + and - zoom, 0 goes back, ? tells the keys, Escape closes", {}, async (visit) => {
    const { page } = visit, first = (await visit.state()).camera;
    await page.locator("#picture").focus();
    for (const key of ["ArrowLeft", "ArrowUp", "ArrowRight", "ArrowDown", "+", "-", "<", ">"]) {
        const { camera } = await visit.state();
        await page.keyboard.press(key);
        await visit.until((state, old) => JSON.stringify(state.camera) !== old, JSON.stringify(camera));
    }
    await page.keyboard.press("0");
    await visit.until(({ camera }, old) => JSON.stringify(camera) === old, JSON.stringify(first));
    await page.keyboard.press("?");
    await page.locator("#help[open]").waitFor();
    assert.ok((await visit.text("#help")).length > 200);
    await page.keyboard.press("Escape");
    await page.locator("#help:not([open])").waitFor({ state: "attached" });
    await visit.settled();
});

visitTest("a surface is drawn, looked into and saved by keys alone", {}, async (visit) => {
    const { page } = visit;
    const go = async (selector) => {
        for (let i = 0; i < 150; i++) {
            if (await page.evaluate((s) => document.activeElement?.matches(s), selector)) return;
            await page.keyboard.press("Tab");
        }
        assert.fail(`Tab does not reach ${selector}`);
    };
    await go("#formula");
    await page.keyboard.press("Control+A");
    await page.keyboard.type("x^2+y^2=z^2+1");
    await page.keyboard.press("Enter");
    await visit.until(({ equation }) => equation === "x^2+y^2=z^2+1");
    await go("#section-ray > summary");
    if ((await page.locator("#section-ray").getAttribute("open")) === null) await page.keyboard.press("Enter");
    await go("#ray button");
    await page.keyboard.press("Enter");
    await page.locator("#ray .ray-facts dd").first().waitFor();
    await visit.settled();
});
