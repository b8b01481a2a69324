// A surface whose rays take a tenth of a second each, the picture hours: something is shown within seconds, the proved
// picture comes row by row, how far it is is told, and it can be left.
import assert from "node:assert/strict";
import { visitTest } from "./harness.mjs";

const ROW = 240_000; // milliseconds, for one row of the proved picture on such a machine
const SOON = 12_000; // milliseconds, on a machine that does other things, too

visitTest("where each ray takes long a coarse picture comes soon, and the next surface at once", {}, async (visit) => {
    const equation = "(x+y+z+1)^64";
    await visit.type(equation);
    const isShown = ({ picture }, wanted) => picture?.state.equation === wanted && { undecided: picture.undecided, hits: picture.hits };
    const { undecided, hits } = await visit.until(isShown, equation, SOON);
    assert.ok(undecided + hits > 20, "the plane is seen");
    await visit.page.waitForFunction(() => /\d.*%/.test(document.querySelector("#waiting").textContent), null,
        { timeout: ROW });
    assert.match(await visit.text("#notice"), /long/);
    const begin = Date.now();
    await visit.type("x^2 + y^2 + z^2 = 1");
    assert.equal((await visit.settled()).undecided, 0);
    assert.ok(Date.now() - begin < SOON, `${Date.now() - begin} ms until the next surface`);
    assert.equal(await visit.page.locator("#notice").isVisible(), false, "nothing takes long any more");
});
