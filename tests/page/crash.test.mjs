// Workers that crash or run out of memory: a message, and the page goes on.
import assert from "node:assert/strict";
import { visitTest } from "./harness.mjs";

const goesOn = async (visit, equation) => {
    await visit.type(equation);
    await visit.until((state, wanted) => state.equation === wanted, equation);
    const { undecided } = await visit.settled();
    assert.equal(undecided, 0);
};

visitTest("workers that crash are replaced, and it is said", {}, async (visit) => {
    const { page } = visit;
    await page.evaluate(() => {
        const { painter } = window.algsurfPage;
        for (let i = 0; i < painter.statistics.workers; i++) painter.kill(i);
    });
    await page.locator("#notice:not([hidden])").waitFor();
    assert.ok((await visit.text("#notice")).length > 10);
    await goesOn(visit, "x^4 + y^4 + z^4 = 1");
    assert.ok(await page.evaluate(() => window.algsurfPage.painter.statistics.replaced) > 0);
});

visitTest("a crash in the middle of a picture: the picture is drawn again", {}, async (visit) => {
    const { page } = visit;
    await page.evaluate(() => {
        const { store, painter } = window.algsurfPage, { camera } = store.get();
        store.set({ camera: { ...camera, eye: camera.eye.map((x) => 1.25 * x) } });
        painter.kill(0);
    });
    await visit.settled();
    await goesOn(visit, "x^2 + y^2 = z^2 + 1");
});
