// Narrow and wide screens, dark and light, and rest for those who asked for it.
import assert from "node:assert/strict";
import { visitTest } from "./harness.mjs";

const PARTS = ["view", "look", "ray", "complex", "take"];
const SMALL = { width: 360, height: 640, hasTouch: true, isMobile: true, deviceScaleFactor: 1 };

/** Controls that are wider than the window, or covered by something when they have been scrolled to. */
async function unreachable() {
    const wrong = [];
    const skipped = (node) => !node.checkVisibility({ visibilityProperty: true }) || node.closest("#gallery");
    for (const node of document.querySelectorAll("button, input, select, textarea, summary, a[href]")) {
        if (skipped(node)) continue;
        node.scrollIntoView({ block: "center", inline: "nearest", behavior: "instant" });
        const { left, right, top, bottom } = node.getBoundingClientRect();
        if (right <= left) continue;
        const [x, y] = [(left + right) / 2, (top + bottom) / 2];
        const there = document.elementFromPoint(x, y);
        const label = node.labels?.[0];
        const isThere = there && (node.contains(there) || there.contains(node) || label?.contains(there));
        const what = `${node.tagName} ${node.id || node.className || node.textContent} at ${[left, top, right, bottom].map(Math.round)}`;
        if (left < -1 || right > innerWidth + 1) wrong.push(`${what} sticks out`);
        else if (!isThere) wrong.push(`${what} is covered by ${there?.tagName} ${there?.id} ${there?.className}`);
    }
    return wrong;
}

const sideways = () => document.scrollingElement.scrollWidth - innerWidth;

for (const [name, size] of [["360x640", SMALL], ["640x360", { ...SMALL, width: 640, height: 360 }]])
    visitTest(`a phone of ${name}: nothing scrolls sideways, all controls can be reached`, size, async (visit) => {
        const { page } = visit;
        assert.equal(await page.evaluate(sideways), 0);
        assert.deepEqual(await page.evaluate(unreachable), []);
        const { width, height } = await visit.box();
        assert.ok(width >= 200 && height >= 150, `the picture has ${width}x${height}`);
        if (await page.locator("#handle").isVisible()) await page.locator("#handle").tap();
        for (const part of PARTS) await visit.unfold(part);
        assert.equal(await page.evaluate(sideways), 0);
        assert.deepEqual(await page.evaluate(unreachable), []);
        await visit.screenshot(`phone panel ${name}`);
        await visit.settled();
    });

visitTest("a desktop: nothing scrolls sideways, all controls can be reached", { width: 1280, height: 800 }, async (visit) => {
    for (const part of PARTS) await visit.unfold(part);
    assert.equal(await visit.page.evaluate(sideways), 0);
    assert.deepEqual(await visit.page.evaluate(unreachable), []);
    await visit.settled();
});

visitTest("text twice as large still fits", { width: 640, height: 480 }, async (visit) => {
    await visit.page.evaluate(() => (document.documentElement.style.fontSize = "200%"));
    assert.equal(await visit.page.evaluate(sideways), 0);
    await visit.settled();
});

visitTest("the canvas follows the window", { width: 900, height: 700 }, async (visit) => {
    const before = await visit.pixels();
    await visit.page.setViewportSize({ width: 1200, height: 560 });
    await visit.until(() => document.querySelector("#picture").width > document.querySelector("#picture").height * 1.5);
    await visit.settled();
    const now = await visit.pixels(), box = await visit.box();
    assert.ok(now.width > before.width && now.height < before.height);
    assert.deepEqual([now.width, now.height], [Math.round(box.width), Math.round(box.height)]);
    assert.ok(Math.abs(now.width / now.height - box.width / box.height) < 0.01, "the picture is distorted");
});

const luminance = () => {
    const [r, g, b] = getComputedStyle(document.body).backgroundColor.match(/[\d.]+/g).map(Number);
    return (0.2126 * r + 0.7152 * g + 0.0722 * b) / 255;
};

visitTest("light and dark as the system has it, and by the button", { colorScheme: "dark" }, async (visit) => {
    const { page } = visit;
    assert.ok((await page.evaluate(luminance)) < 0.3);
    await page.emulateMedia({ colorScheme: "light" });
    assert.ok((await page.evaluate(luminance)) > 0.7);
    await page.locator("#theme").click();
    const chosen = await page.evaluate(luminance);
    await page.locator("#theme").click();
    assert.ok(Math.abs((await page.evaluate(luminance)) - chosen) > 0.4, "the button changes nothing");
    await visit.settled();
});

visitTest("who asked for less motion gets none", { reducedMotion: "reduce" }, async (visit) => {
    const { page } = visit;
    await page.locator("#open-help").click();
    for (const part of PARTS) await page.locator(`#section-${part}`).evaluate((node) => (node.open = true));
    const moving = await page.evaluate(() => {
        const seconds = (text) => Math.max(...text.split(",").map(parseFloat));
        return [...document.querySelectorAll("*")]
            .map((node) => [node, getComputedStyle(node)])
            .filter(([, style]) => seconds(style.transitionDuration) > 0.01 ||
                (style.animationName !== "none" && seconds(style.animationDuration) > 0.01))
            .map(([node]) => `${node.tagName} ${node.className}`);
    });
    assert.deepEqual(moving, []);
    await visit.settled();
});
