// A fitted extent follows the letters of the equation once a slider rests; one that was chosen stays.
import assert from "node:assert/strict";
import { Visit, visitTest } from "./harness.mjs";

/** Gives the letter a a value as its slider does: while it moves, and then at rest. */
function slide(visit, value) {
    return visit.page.evaluate((value) => {
        const { store } = window.algsurfPage, { parameters } = store.get();
        store.set({ parameters: { a: { ...parameters.a, value, to: 100 } } }, { moving: true });
        store.set({}, { moving: false });
    }, value);
}

visitTest("of high degree the extent is a box, which its link keeps and the wheel resizes", {}, async (visit) => {
    await visit.type("x^40 + y^40 + z^40 = 1");
    const { size, kind } = await visit.until(({ extent, equation }) => equation.startsWith("x^40") && extent.size.length === 3 && extent);
    assert.equal(kind, "fitted");
    assert.ok(size.every((x) => x >= 1 && x < 1.2), String(size));
    await visit.settled();
    await visit.page.locator("#copy-link").click();
    const link = await visit.page.evaluate(() => navigator.clipboard.readText());
    assert.match(link, /&extent=fitted:1\.?\d*,/);
    const other = await Visit.open({ link: link.slice(visit.address.length) });
    const read = await other.until(({ picture, extent }) => picture?.hits > 0 && extent);
    assert.deepEqual([read.kind, read.size], ["fitted", size]);
    await other.close();
    await visit.page.evaluate(() => document.querySelector("canvas").dispatchEvent(
        new WheelEvent("wheel", { deltaY: 120, ctrlKey: true, bubbles: true, cancelable: true })));
    const less = await visit.until(({ extent }) => extent.kind !== "fitted" && extent);
    assert.equal(less.kind, "box");
    assert.ok(less.size.every((x, i) => x < size[i]));
});

const radius = ({ extent }) => extent.size[0];

const HEAVY = "(x+y+z+1)^64"; // a tenth of a second each ray
const AWAY = { eye: [90, 80, 70], lookAt: [95, 80, 70], up: [0, 0, 1], fov: 2 };

/** Looks away, so that nothing is seen, and presses the button. */
async function lookAwayAndFit(visit, partial = {}) {
    await visit.page.evaluate((partial) => window.algsurfPage.store.set(partial), { camera: AWAY, ...partial });
    await visit.button("view.fit").first().click();
    return visit.until(({ camera, picture, extent }, away) =>
        camera.eye[0] !== away && picture?.state.camera.eye[0] === camera.eye[0] && picture.hits + picture.undecided > 20 &&
        { size: extent.size[0], camera }, AWAY.eye[0]);
}

visitTest("the view always fits: where nothing is seen, in complex space, behind a plane, where each ray takes long", {}, async (visit) => {
    await lookAwayAndFit(visit);
    await visit.settled();
    await visit.type("x^2 + y^2 + z^2 = 9");
    await visit.until(({ equation }) => equation.endsWith("9"));
    await visit.settled();
    await lookAwayAndFit(visit);
    const empty = { kind: "sphere", size: [0.5], centre: [9, 9, 9] };
    await visit.page.evaluate((camera) => window.algsurfPage.store.set({ camera }), AWAY);
    await visit.until(({ picture }) => picture?.hits === 0 && picture.stage !== "moving");
    assert.ok((await lookAwayAndFit(visit, { extent: empty })).size > 3);
    await visit.settled();
    await visit.page.evaluate(() => window.algsurfPage.store.set({ clip: [[1, 0, 0, -99]] }));
    await visit.until(({ picture }) => picture?.hits === 0 && picture.stage !== "moving");
    await lookAwayAndFit(visit, {});
    await lookAwayAndFit(visit, { complex: { sigma: 0, delta: 0.2, imaginary: {} } });
    await visit.page.evaluate((equation) => window.algsurfPage.store.set({ equation, complex: null }), HEAVY);
    await lookAwayAndFit(visit);
});

visitTest("at rest a fitted extent is fitted again, and one that was chosen stays", {}, async (visit) => {
    await visit.type("x^2+y^2+z^2=a");
    const before = await visit.until(({ extent, parameters }) => parameters?.a && extent.kind === "fitted" && extent.size[0]);
    await slide(visit, 25);
    await visit.until(({ extent }, before) => extent.size[0] > 3 * before, before);
    await visit.settled();
    await visit.page.evaluate(() => {
        const { store } = window.algsurfPage, { extent } = store.get();
        store.set({ extent: { ...extent, kind: "sphere", size: [2] } });
    });
    await slide(visit, 1);
    await visit.finished();
    assert.equal(radius(await visit.state()), 2);
});
