// Touch: one finger turns, two zoom and move, a tap looks into the ray; the page itself does not scroll or zoom.
import assert from "node:assert/strict";
import { visitTest, WORDS } from "./harness.mjs";

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

visitTest("a tap shows the hit in one line, a second one its mathematics", { ...PHONE, link: "#v1&equation=x^2%2By^2%2Bz^2=1" }, async (visit) => {
    const { page } = visit, { middleX: x, middleY: y, width } = await visit.box();
    const isOpen = () => page.locator("body.open #section-ray[open] .ray-facts dd").count();
    await touch(visit, [[x, y]]);
    await visit.wait("#hit");
    assert.match(await visit.text("#hit"), /^\([-−\d., ]+\), proved/);
    const shown = await page.locator("#hit").boundingBox();
    assert.ok(shown.height < 45 && shown.width < width, `${shown.width}x${shown.height}`);
    await visit.screenshot("a tap");
    assert.equal(await isOpen(), 0);
    await touch(visit, [[x + 4, y - 3]]);
    await page.locator("#ray .ray-facts dd").first().waitFor();
    assert.equal(await page.locator("#hit").isVisible(), false);
    await page.locator("#handle").tap();
    const { x: left, y: top } = await visit.box();
    await touch(visit, [[left + 3, top + 3]]); // beside the surface
    await page.locator("#hit", { hasText: WORDS["ray.verdict.miss"] }).waitFor();
    await page.locator("#hit").tap();
    // Of the smaller picture above the panel this place is outside of the extent.
    const misses = new RegExp(`${WORDS["ray.verdict.miss"]}|${WORDS["ray.outside"]}`);
    await page.locator("#ray .ray-verdict", { hasText: misses }).waitFor();
    await page.locator("#handle").tap();
    await touch(visit, [[x, y]]);
    await visit.wait("#hit");
    await touch(visit, line([x, y], [x - 90, y - 60]));
    await page.locator("#hit").waitFor({ state: "hidden" });
});

const SMALL = { ...PHONE, width: 360, height: 640, link: "#v1&equation=(x%2Ba)^2%2By^2%2Bb*z^2=1&let:a=0:-1:1&let:b=1:0:2" };

visitTest("sliders lie over the picture, which keeps its size, and move it", SMALL, async (visit) => {
    const { page } = visit, box = await visit.box();
    const slide = await page.locator("#parameter-a").boundingBox();
    assert.ok(slide.y > box.y && slide.y + slide.height < box.y + box.height, JSON.stringify(slide));
    assert.ok(slide.width > 120, `${slide.width} pixels wide`);
    await visit.screenshot("phone sliders");
    const { x, y, width, height } = slide;
    await page.touchscreen.tap(x + 0.9 * width, y + height / 2);
    await visit.until(({ parameters }) => parameters.a.value > 0.5);
    await visit.settled();
    await page.setViewportSize({ width: 1000, height: 700 });
    await page.locator("#panel #parameter-a").waitFor();
    await visit.settled();
});

visitTest("what saves is seen where it opens, and help tells gestures first", SMALL, async (visit) => {
    const { page } = visit;
    await page.locator("#open-save").tap();
    await page.waitForTimeout(800);
    const panel = await page.locator("#panel").boundingBox(), save = await visit.button("take.png").boundingBox();
    assert.ok(save.y > panel.y && save.y + save.height < panel.y + panel.height, JSON.stringify([panel, save]));
    await visit.screenshot("phone save");
    await page.locator("#handle").tap();
    await page.locator("#open-help").tap();
    const first = await page.locator("#help dt").first().boundingBox();
    assert.equal(await page.locator("#help dt").first().textContent(), WORDS["help.drag.how"]);
    assert.ok(first.y > 0 && first.y < 200);
    await visit.screenshot("phone help");
});
