// The cutting plane: switched on it faces the viewer; a slider, dragging with Ctrl and dragging after a button move it
// along its normal; what is drawn, saved, copied and linked is cut by it.
import assert from "node:assert/strict";
import { visitTest, WORDS } from "./harness.mjs";
import { difference } from "./png.mjs";

const BALL = "#v1&equation=x^2%2By^2%2Bz^2=1&extent=sphere:1.2&eye=3,-3.6,2.1&look-at=0,0,0&up=0,0,1&fov=25";
const SIDE = "#v1&equation=x^2%2By^2%2Bz^2=1&extent=sphere:1.2&eye=0,-6,0&look-at=0,0,0&up=0,0,1&fov=25";

/** The point of the surface in the middle of the picture. */
function middle(visit) {
    return visit.page.evaluate(() => {
        const { store, painter } = window.algsurfPage, { picture, ...state } = store.get();
        return painter.ask("pick", state, { width: 101, height: 101, x: 50.5, y: 50.5 });
    });
}

async function cut(visit) {
    await visit.unfold("view");
    await visit.page.getByLabel(WORDS.clip, { exact: true }).check();
    await visit.until(({ clip }) => clip.length === 1);
    await visit.settled();
}

async function drag(visit, dx, dy, key = null) {
    const { middleX: x, middleY: y } = await visit.box();
    if (key) await visit.page.keyboard.down(key);
    await visit.page.mouse.move(x, y);
    await visit.page.mouse.down();
    await visit.page.mouse.move(x + dx, y + dy, { steps: 8 });
    await visit.page.mouse.up();
    if (key) await visit.page.keyboard.up(key);
}

visitTest("a plane that is switched on faces the viewer, and keeps what is behind it", { link: BALL }, async (visit) => {
    const whole = await visit.pixels(), before = await middle(visit);
    await cut(visit);
    const { clip, camera } = await visit.state(), [a, b, c, d] = clip[0], far = Math.hypot(...camera.eye);
    assert.ok((a * camera.eye[0] + b * camera.eye[1] + c * camera.eye[2]) / far > 0.9999 * Math.hypot(a, b, c));
    assert.ok(Math.abs(d) < 1e-3);
    const after = await middle(visit);
    assert.deepEqual([before.state, before.side, after.state, after.side], ["hit", 1, "hit", -1]);
    assert.ok(after.t - before.t > 1.99 && after.t - before.t < 2.01, "the eye does not see the far side");
    assert.notEqual(difference(whole, await visit.pixels()), "");
    await visit.screenshot("cut by a plane");
    await visit.page.getByLabel(WORDS.clip, { exact: true }).uncheck();
    await visit.until(({ clip }) => clip.length === 0);
    await visit.settled();
    assert.equal(await visit.page.getByLabel(WORDS["clip.at"]).isVisible(), false);
});

visitTest("arrow keys on the slider move the plane; a button turns it to the viewer", { link: SIDE }, async (visit) => {
    const { page } = visit;
    await cut(visit);
    await page.getByLabel(WORDS["clip.at"]).focus();
    for (let i = 0; i < 10; i++) await page.keyboard.press("ArrowRight");
    await visit.until(({ clip: [[a, b, c, d]] }) => a === 0 && b === -1 && c === 0 && Math.abs(d - 0.12) < 1e-9);
    await page.locator("#picture").focus();
    for (let i = 0; i < 12; i++) await page.keyboard.press("ArrowRight"); // 90 degrees
    await visit.until(({ camera }) => Math.abs(camera.eye[1]) < 1e-3);
    await visit.button("clip.face").click();
    await visit.until(({ clip: [[a, b]] }) => Math.abs(a) === 1 && b === 0);
    await visit.settled();
});

visitTest("Ctrl and dragging moves the plane along its normal, as far as the pointer", { link: SIDE + "&clip=1,0,0,0&clip=0,0,2,1.5" },
    async (visit) => {
        const { camera } = await visit.state(), { height } = await visit.box();
        const pixel = (2 * 6 * Math.tan((12.5 * Math.PI) / 180)) / height;
        await drag(visit, 40, 25, "Control");
        await visit.until(({ clip }) => clip[0][3] !== 0);
        const { clip, camera: after } = await visit.state();
        assert.ok(Math.abs(clip[0][3] - 40 * pixel) < 2 * pixel, `${clip[0][3]}, not ${40 * pixel}`);
        assert.deepEqual([clip[0].slice(0, 3), clip[1], after], [[1, 0, 0], [0, 0, 2, 1.5], camera]);
        await visit.settled();
    });

visitTest("after a button, dragging moves the plane until the button is pressed again", { link: SIDE + "&clip=0,0,1,0" },
    async (visit) => {
        const { camera } = await visit.state();
        await visit.unfold("view");
        await visit.button("clip.drag").click();
        await drag(visit, 0, -50);
        const up = await visit.until(({ clip }) => clip[0][3] > 0.1 && clip[0][3]);
        assert.deepEqual((await visit.state()).camera, camera);
        await visit.button("clip.drag").click();
        await drag(visit, 50, 0);
        await visit.until(({ camera }, old) => JSON.stringify(camera) !== old, JSON.stringify(camera));
        assert.equal((await visit.state()).clip[0][3], up);
        await visit.settled();
    });

visitTest("on a phone the plane's controls fit", { link: BALL, width: 360, height: 640, hasTouch: true }, async (visit) => {
    await visit.page.locator("#handle").click();
    await cut(visit);
    for (const key of ["clip.face", "clip.drag"]) {
        await visit.button(key).scrollIntoViewIfNeeded();
        const { x, width } = await visit.button(key).boundingBox();
        assert.ok(x >= 0 && x + width <= 360, `${key}: ${x} to ${x + width}`);
    }
    await visit.screenshot("cut by a plane on a phone");
});
