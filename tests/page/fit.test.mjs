// A fitted extent follows the letters of the equation once a slider rests; one that was chosen stays.
import assert from "node:assert/strict";
import { visitTest } from "./harness.mjs";

/** Gives the letter a a value as its slider does: while it moves, and then at rest. */
function slide(visit, value) {
    return visit.page.evaluate((value) => {
        const { store } = window.algsurfPage, { parameters } = store.get();
        store.set({ parameters: { a: { ...parameters.a, value, to: 100 } } }, { moving: true });
        store.set({}, { moving: false });
    }, value);
}

const radius = ({ extent }) => extent.size[0];

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
