// Touch: one finger turns, two zoom and move, a tap looks into the ray; the page itself does not scroll or zoom.
import assert from "node:assert/strict";
import { visitTest } from "./harness.mjs";

const PHONE = { width: 390, height: 740, hasTouch: true, isMobile: true, deviceScaleFactor: 1 };
const distance = (a, b) => Math.hypot(...a.map((x, i) => x - b[i]));

/** fingers: for each a list of places [x, y], all equally long. */
async function touch({ devtools, page }, ...fingers) {
    const at = (i) => fingers.map((places, id) => ({ x: places[i][0], y: places[i][1], id }));
    const send = (type, touchPoints) => devtools.send("Input.dispatchTouchEvent", { type, touchPoints });
    await send("touchStart", at(0));
    for (let i = 1; i < fingers[0].length; i++) {
        await send("touchMove", at(i));
        await page.waitForTimeout(16);
    }
    await send("touchEnd", []);
}

const line = (from, to, steps = 12) =>
    Array.from({ length: steps + 1 }, (_, i) => from.map((x, k) => x + ((to[k] - x) * i) / steps));

visitTest("one finger turns the surface, not the page", PHONE, async (visit) => {
    const { camera } = await visit.state(), { middleX: x, middleY: y } = await visit.box();
    await touch(visit, line([x, y], [x - 90, y - 60]));
    await visit.until((state, eye) => JSON.stringify(state.camera.eye) !== eye, JSON.stringify(camera.eye));
    await visit.settled();
    assert.equal(await visit.page.evaluate(() => window.scrollY + window.visualViewport.offsetTop), 0);
});

visitTest("two fingers zoom", PHONE, async (visit) => {
    const size = ({ camera: { fov, eye, lookAt } }) => Math.tan((fov * Math.PI) / 360) * distance(eye, lookAt);
    const before = size(await visit.state()), { middleX: x, middleY: y } = await visit.box();
    await touch(visit, line([x - 30, y], [x - 90, y]), line([x + 30, y], [x + 90, y]));
    await visit.settled();
    const after = size(await visit.state());
    assert.ok(before / after > 2 && before / after < 4.5, `${before / after} times as large`);
    assert.equal(await visit.page.evaluate(() => window.visualViewport.scale), 1);
});

visitTest("a tap looks into the ray", PHONE, async (visit) => {
    const { middleX: x, middleY: y } = await visit.box();
    await touch(visit, [[x, y]]);
    await visit.page.locator("#section-ray[open]").waitFor({ state: "attached" });
    await visit.page.locator("#ray .ray-facts dd").first().waitFor({ state: "attached" });
});
