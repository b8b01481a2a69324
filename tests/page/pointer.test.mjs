// The mouse: dragging turns about any axis without a pole, the wheel zooms at the pointer, a double click goes back.
import assert from "node:assert/strict";
import { Recorder } from "./recorder.mjs";
import { visitTest } from "./harness.mjs";

const minus = (a, b) => a.map((x, i) => x - b[i]);
const distance = (a, b) => Math.hypot(...minus(a, b));
const BALL = "#v1&equation=x^2%2By^2%2Bz^2=1&extent=sphere:1.2&eye=3,-3.6,2.1";
const BARTH = "#v1&name=barth&equation=4((3%2Bsqrt(5))/2*x^2-y^2)((3%2Bsqrt(5))/2*y^2-z^2)((3%2Bsqrt(5))/2*z^2-x^2)-" +
    "(2%2Bsqrt(5))(x^2%2By^2%2Bz^2-1)^2&extent=sphere:2";

async function drag(visit, dx, dy, { steps = 8, x, y, key = null } = {}) {
    const { middleX, middleY } = await visit.box();
    const fromX = x ?? middleX, fromY = y ?? middleY;
    if (key) await visit.page.keyboard.down(key);
    await visit.page.mouse.move(fromX, fromY);
    await visit.page.mouse.down();
    await visit.page.mouse.move(fromX + dx, fromY + dy, { steps });
    await visit.page.mouse.up();
    if (key) await visit.page.keyboard.up(key);
}

visitTest("dragging turns: coarse pictures on the way, a full one at the end", { link: BARTH }, async (visit) => {
    const before = await visit.state(), recorder = await Recorder.start(visit);
    await drag(visit, 160, 40, { steps: 20 });
    await visit.until(({ camera }, eye) => JSON.stringify(camera.eye) !== eye, JSON.stringify(before.camera.eye));
    await visit.finished();
    const { camera } = await visit.state(), stages = (await recorder.stop()).map(({ stage }) => stage);
    assert.ok(stages.includes("moving"), `stages: ${stages}`);
    assert.deepEqual(stages.slice(-3), ["plain", "smooth", "full"]);
    assert.ok(Math.abs(distance(camera.eye, camera.lookAt) / distance(before.camera.eye, before.camera.lookAt) - 1) < 1e-4);
});

visitTest("a surface can be turned over and over: there is no pole", { link: BARTH }, async (visit) => {
    const seen = [];
    for (let i = 0; i < 12; i++) {
        await drag(visit, 0, 150);
        const { camera } = await visit.state();
        const way = minus(camera.lookAt, camera.eye);
        const dot = way.reduce((sum, x, k) => sum + x * camera.up[k], 0) / Math.hypot(...way) / Math.hypot(...camera.up);
        assert.ok(Math.abs(dot) < 0.999, "the camera looks along its upward axis");
        seen.push(camera.eye[2] / Math.hypot(...way));
    }
    assert.ok(Math.max(...seen) > 0.8 && Math.min(...seen) < -0.8, `heights of the eye: ${seen.map((x) => x.toFixed(2))}`);
    await visit.settled();
});

visitTest("the wheel zooms at the pointer; a double click goes back", { link: BALL }, async (visit) => {
    const { page } = visit, before = await visit.state(), box = await visit.box();
    const x = box.middleX + 70, y = box.middleY - 50;
    const under = () => page.evaluate(({ x, y }) => {
        const { store, painter } = window.algsurfPage, canvas = document.querySelector("#picture");
        const { left, top, width: wide, height: high } = canvas.getBoundingClientRect();
        const { width, height } = canvas;
        return painter.ask("pick", store.get(), { width, height, x: ((x - left) / wide) * width, y: ((y - top) / high) * height });
    }, { x, y });
    const first = await under();
    assert.equal(first.state, "hit");
    await page.mouse.move(x, y);
    for (let i = 0; i < 4; i++) await page.mouse.wheel(0, -120);
    await visit.until(({ camera }, old) => JSON.stringify(camera) !== old, JSON.stringify(before.camera));
    await visit.settled();
    const second = await under();
    assert.equal(second.state, "hit");
    const away = distance(first.position, second.position);
    assert.ok(away < 0.06, `the point under the pointer moved by ${away}`);
    const size = (camera) => Math.tan((camera.fov * Math.PI) / 360) * distance(camera.eye, camera.lookAt);
    const { camera } = await visit.state();
    assert.ok(size(before.camera) / size(camera) > 1.5, "it did not get larger");
    await page.mouse.dblclick(x, y);
    await visit.until(({ camera }, old) => JSON.stringify(camera) === old, JSON.stringify(before.camera));
    await visit.settled();
});

visitTest("Shift moves, Alt turns the light, Ctrl and the wheel change what is shown", { link: BARTH }, async (visit) => {
    const { page } = visit, before = await visit.state();
    await drag(visit, 60, 0, { key: "Shift" });
    const moved = (await visit.state()).camera;
    assert.ok(distance(minus(moved.lookAt, moved.eye), minus(before.camera.lookAt, before.camera.eye)) < 1e-9);
    assert.ok(distance(moved.eye, before.camera.eye) > 0.01);
    await drag(visit, 60, 0, { key: "Alt" });
    assert.notEqual((await visit.state()).light, null);
    await page.keyboard.down("Control");
    await page.mouse.wheel(0, 120);
    await page.keyboard.up("Control");
    await visit.until(({ extent }) => extent.kind === "sphere" && extent.size[0] < 2);
    await visit.settled();
});
