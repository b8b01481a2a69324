// After the first visit the page works without a network, and it weighs little.
import assert from "node:assert/strict";
import { readdirSync, readFileSync, statSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { gzipSync } from "node:zlib";
import { visitTest } from "./harness.mjs";
import { PAGE } from "./settings.mjs";

const BUDGET = 400_000; // as in tests/cli_page

function filesOf(folder) {
    return readdirSync(folder).flatMap((name) => {
        const path = join(folder, name);
        return statSync(path).isDirectory() ? filesOf(path) : [path];
    });
}

test("all files of the page take at most 400 KB compressed", () => {
    const files = filesOf(PAGE);
    const sizes = files.map((path) => gzipSync(readFileSync(path), { level: 9 }).length);
    const sum = sizes.reduce((a, b) => a + b);
    console.log(`        ${files.length} files, ${(sum / 1000).toFixed(1)} KB compressed`);
    assert.ok(sum <= BUDGET, `${sum} bytes`);
});

visitTest("without a network it opens again, draws what is typed, and speaks German", {}, async (visit) => {
    const { page, context } = visit;
    await page.evaluate(() => navigator.serviceWorker.ready.then(({ active }) => active.state));
    await page.waitForFunction(async () => {
        const names = await caches.keys();
        const files = await Promise.all(names.map(async (name) => (await (await caches.open(name)).keys()).length));
        return files.some((count) => count > 40);
    });
    await page.waitForLoadState("networkidle"); // the first visit, without the worker, still loads
    await context.setOffline(true);
    await page.reload();
    await visit.settled();
    await visit.type("x^2 + y^2 = z^2 + 1");
    await visit.until(({ equation }) => equation === "x^2 + y^2 = z^2 + 1");
    await visit.settled();
    await page.evaluate(() => localStorage.setItem("algsurf.language", '"de"'));
    await page.reload();
    await visit.settled();
    assert.equal(await page.evaluate(() => document.documentElement.lang), "de");
});
