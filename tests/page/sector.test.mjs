// The sector of complex space over the plane of roots is dragged and moved by keys; its sweeps are recorded, and
// shown as stills to those who want no motion.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { visitTest } from "./harness.mjs";

const SPHERE = "#v1&name=sphere&equation=x^2%2By^2%2Bz^2%20-%201&extent=sphere:1.2";
const degrees = (radians) => (radians * 180) / Math.PI;

/** The plane of roots of the ray through the middle, scrolled to. */
async function plane({ page }) {
    await page.locator("#picture").focus();
    await page.evaluate(() =>
        document.querySelector("#picture").dispatchEvent(new CustomEvent("place", { detail: { x: 0.5, y: 0.5 } })),
    );
    await page.locator("#ray .plane .root").first().waitFor();
    await page.locator("#ray .plane").scrollIntoViewIfNeeded();
}

async function drag(visit, handle, dx, dy) {
    const { page } = visit;
    await visit.settled();
    const grip = page.locator(".wedge-grip").nth(handle);
    await grip.hover(); /* waits for it to stay in its place: complex space, once on, moves what is below it */
    const { x, y, width, height } = await grip.boundingBox();
    await page.mouse.down();
    await page.mouse.move(x + width / 2 + dx, y + height / 2 + dy, { steps: 5 });
    await page.mouse.up();
}

visitTest("both edges of the sector are dragged; complex space is then on", { link: SPHERE }, async (visit) => {
    await plane(visit);
    assert.equal((await visit.state()).complex, null);
    await drag(visit, 1, 0, -60);
    const { delta } = await visit.until(({ complex }) => complex);
    assert.ok(degrees(delta) > 15 && degrees(delta) < 60, `${degrees(delta)} degrees`);
    await drag(visit, 0, 0, -15);
    const after = await visit.until(({ complex }) => complex.sigma > 0 && complex);
    assert.ok(Math.abs(after.sigma + after.delta - delta) < 1e-12, "the other edge stays");
    await visit.settled();
});

visitTest("keys move an edge by a degree, shift and keys by a tenth, home and end as far as can be", { link: SPHERE },
    async (visit) => {
        const { page } = visit, handle = page.locator(".wedge-handle").nth(1);
        await plane(visit);
        await handle.focus();
        for (const [key, wanted] of [["ArrowUp", 1], ["ArrowUp", 2], ["Shift+ArrowDown", 1.9], ["PageUp", 11.9], ["End", 180]]) {
            await page.keyboard.press(key);
            const { complex } = await visit.state();
            assert.ok(Math.abs(degrees(complex.delta) - wanted) < 1e-6, `${key}: ${degrees(complex.delta)}`);
            assert.ok(Math.abs(Number(await handle.getAttribute("aria-valuenow")) - wanted) < 0.006);
        }
        await page.keyboard.press("Home");
        assert.equal((await visit.state()).complex.delta, 0);
        await visit.settled();
    });

visitTest("the root that is seen is marked where the sector holds it", { link: SPHERE }, async (visit) => {
    await plane(visit);
    assert.equal(await visit.page.locator("#ray .root-chosen").count(), 1);
    await visit.page.locator(".wedge-handle").nth(1).focus();
    await visit.page.keyboard.press("End");
    await visit.page.locator(".wedge-handle").nth(0).focus();
    for (let i = 0; i < 5; i++) await visit.page.keyboard.press("ArrowUp"); // no root has an argument of 5 degrees
    await visit.page.locator("#ray .root-chosen").waitFor({ state: "detached" });
    assert.match(await visit.text("#ray"), /No root lies in the sector: proved/);
    await visit.settled();
});

visitTest("a sweep is recorded there and back, as an animated PNG", { link: SPHERE }, async (visit) => {
    const { page } = visit;
    await visit.unfold("complex");
    await page.locator(".complex-presets button").first().click();
    await visit.settled();
    const coming = page.waitForEvent("download", { timeout: 120_000 });
    await visit.button("complex.record").click();
    const film = await coming;
    assert.equal(film.suggestedFilename(), "sphere-delta.png");
    const file = await readFile(await film.path());
    const at = file.indexOf("acTL");
    assert.equal(file.readUInt32BE(at + 4), 58);
    assert.equal(file.toString("latin1").split("fcTL").length - 1, 58);
});

visitTest("recording is given up on request", { link: SPHERE }, async (visit) => {
    await visit.unfold("complex");
    await visit.page.locator(".complex-presets button").first().click();
    await visit.settled();
    await visit.button("complex.record").click();
    await visit.button("complex.record.cancel").click();
    await visit.button("complex.record").waitFor();
    assert.equal(await visit.page.locator(".sweep [role=status]").textContent(), "");
});

visitTest("who wants no motion gets one picture after the other", { link: SPHERE, reducedMotion: "reduce" }, async (visit) => {
    await visit.unfold("complex");
    await visit.page.locator(".complex-presets button").first().click();
    await visit.settled();
    const seen = [];
    for (let i = 0; i < 3; i++) {
        await visit.button("complex.still").click();
        seen.push(degrees((await visit.state()).complex.delta));
        await visit.settled();
        assert.equal(degrees((await visit.state()).complex.delta), seen[i], "it moves by itself");
    }
    for (const [i, delta] of seen.entries()) assert.ok(Math.abs(delta - (30 * (i + 1)) / 8) < 1e-9, `${delta}`);
});

visitTest("a ray is asked about only while its section is open", { link: SPHERE }, async (visit) => {
    const { page } = visit;
    await plane(visit);
    await visit.settled();
    await page.evaluate(() => {
        const { painter } = window.algsurfPage, { ask } = painter;
        window.asked = [];
        painter.ask = (...values) => {
            window.asked.push(values[0]);
            return ask.apply(painter, values);
        };
    });
    await page.locator("#section-ray > summary").click();
    await page.locator("#picture").focus();
    await page.keyboard.press("ArrowLeft");
    await visit.settled();
    assert.deepEqual(await page.evaluate(() => window.asked.filter((kind) => kind === "pick")), []);
    await page.locator("#section-ray > summary").click();
    await visit.until(() => window.asked.includes("complexRoots"));
});
