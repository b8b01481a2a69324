// Workers that crash or run out of memory: a message, and the page goes on.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { visitTest } from "./harness.mjs";
import { PAGE } from "./settings.mjs";

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

/** The module with a limit of its memory, in pages of 64 KB: section 5 has one memory, flags, least and most. */
function withLimit(module, pages) {
    const at = module.indexOf(Buffer.from([5, 3, 1, 0]));
    assert.ok(at > 0 && pages < 128, "the section of the memory looks different");
    return Buffer.concat([module.subarray(0, at), Buffer.from([5, 4, 1, 1, module[at + 4], pages]), module.subarray(at + 5)]);
}

visitTest("workers that run out of memory: it is said, and what needs less is drawn", { serviceWorkers: "block" }, async (visit) => {
    const { page } = visit, module = withLimit(readFileSync(join(PAGE, "algsurf.wasm")), 36);
    await page.route("**/algsurf.wasm", (route) => route.fulfill({ body: module, contentType: "application/wasm" }));
    await page.reload();
    await visit.settled();
    await visit.type("(x+y+z+1)^40 = 2");
    await visit.until(() => document.querySelector("#mistake").textContent + document.querySelector("#notice").textContent !== "");
    assert.match(`${await page.locator("#mistake").textContent()} ${await page.locator("#notice").textContent()}`, /memory|stopped|started/);
    await goesOn(visit, "x^2 + y^2 + z^2 = 1");
    visit.faults = visit.faults.filter((fault) => !fault.includes("blocked by Playwright")); // as the option above asks
});
