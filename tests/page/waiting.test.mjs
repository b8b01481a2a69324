// While a picture is on its way: what is told is of the picture that is seen, which is marked as old; what takes long
// can be stopped; thumbnails keep nobody waiting; what nobody sees rests.
import assert from "node:assert/strict";
import { Visit, visitTest, WORDS } from "./harness.mjs";
import { test } from "node:test";

const HEAVY = "(x+y+z+1)^64"; // a tenth of a second each ray
const own = (equation) => ({
    name: "", equation, parameters: {}, extent: { kind: "sphere", size: [1.2], centre: [0, 0, 0] }, clip: [],
    camera: { eye: [2.93, -3.6, 2.14], lookAt: [0, 0, 0], up: [0, 0, 1], fov: 25 },
    colours: { outside: "#69b5ff", inside: "#f6a245", background: "none" }, light: null, thin: null, complex: null,
});

/** In the page: what is told, and of what. */
const told = () => ({
    title: document.querySelector("#title").textContent,
    tab: document.title,
    sentence: document.querySelector("#picture").getAttribute("aria-label"),
    about: document.querySelector("#about").textContent,
    isOld: document.querySelector("#stage").classList.contains("old"),
    waiting: document.querySelector("#waiting").innerText,
    picture: window.algsurfPage.store.get().picture.state.equation,
});

visitTest("all that is told is of the picture that is seen, which is marked as old until the new one comes", {}, async (visit) => {
    const { page } = visit;
    await visit.finished();
    await page.evaluate((state) => window.algsurfPage.store.set(state), own(HEAVY));
    const until = Date.now() + 15_000;
    let old = 0, now;
    do {
        now = await page.evaluate(told);
        const name = now.picture === HEAVY ? WORDS["surface.own"] : WORDS["name.barth"];
        assert.equal(now.title, name);
        assert.ok(now.tab.startsWith(name) && now.sentence.startsWith(name), JSON.stringify(now));
        if (now.picture !== HEAVY && now.isOld) {
            old++;
            assert.match(now.waiting, /^Drawing …/);
            if (old === 2) await visit.screenshot("an old picture");
        }
        await page.waitForTimeout(50);
    } while (now.picture !== HEAVY && Date.now() < until);
    assert.ok(old > 3, `seen as old ${old} times`);
    await page.waitForFunction(() => !document.querySelector("#stage").classList.contains("old"));
    assert.equal((await page.evaluate(told)).title, WORDS["surface.own"]);
});

visitTest("what takes long can be stopped", { link: `#v1&equation=${encodeURIComponent(HEAVY)}`, ready: false }, async (visit) => {
    const { page } = visit;
    await visit.wait("#waiting button");
    await visit.until(({ picture }) => picture);
    await page.waitForFunction(() => window.algsurfPage.painter.progress.isDrawn);
    await visit.button("stop").click();
    await page.locator("#waiting").waitFor({ state: "hidden" });
    assert.equal(await visit.text("#notice"), WORDS.stopped);
    assert.equal(await page.evaluate(() => window.algsurfPage.painter.progress.isDrawn), false);
    await visit.type("x^2 + y^2 + z^2 = 1");
    assert.equal((await visit.settled()).undecided, 0);
});

test("a thumbnail never holds the only worker", async () => {
    const visit = await Visit.open({ link: "?workers=1" });
    const { page } = visit;
    await page.evaluate((kept) => localStorage.setItem("algsurf.recent", JSON.stringify(kept)), [own(HEAVY)]);
    await page.reload();
    await visit.settled();
    await page.waitForTimeout(600); // the thumbnail is at work by now
    for (let i = 0; i < 3; i++) {
        const begin = Date.now();
        await visit.type(`x^2 + y^2 + z^2 = 1.${i}`);
        await visit.until(({ picture, equation }, i) => equation.endsWith(`.${i}`) && picture.state.equation === equation, i);
        assert.ok(Date.now() - begin < 8000, `${Date.now() - begin} ms`);
        await visit.page.waitForTimeout(300);
    }
    const drawn = () => [...document.querySelectorAll("#gallery canvas")].filter((canvas) => {
        const copy = new OffscreenCanvas(176, 132).getContext("2d", { willReadFrequently: true });
        copy.drawImage(canvas, 0, 0);
        return copy.getImageData(0, 0, 176, 132).data.some((x) => x > 0);
    }).length;
    for (let count = 0; count < 4; count = await page.evaluate(drawn)) await page.waitForTimeout(100);
    await visit.finished();
    assert.deepEqual(visit.faults, []);
    await visit.close();
});

/** The page behaves as if nobody saw it, or again as if somebody did. */
const hide = (visit, hidden) => visit.page.evaluate((hidden) => {
    Object.defineProperty(document, "hidden", { configurable: true, get: () => hidden });
    document.dispatchEvent(new Event("visibilitychange"));
}, hidden);

visitTest("a tab that nobody sees rests, but saves what was to be saved", {}, async (visit) => {
    const { page } = visit;
    await visit.type("x^2 + a y^2 + z^2 = 1");
    await visit.until(({ parameters }) => parameters?.a);
    await visit.settled();
    await page.keyboard.press("Escape");
    await page.keyboard.press("p");
    await page.waitForTimeout(100);
    await hide(visit, true);
    await page.waitForTimeout(300);
    const seen = () => ({ value: window.algsurfPage.store.get().parameters.a.value,
        ms: window.algsurfPage.store.get().picture.ms, drawn: window.algsurfPage.painter.count });
    const before = await page.evaluate(seen);
    await page.waitForTimeout(800);
    assert.deepEqual(await page.evaluate(seen), before);
    const { data } = await visit.image({ width: 32, height: 24, antialias: 1 });
    assert.ok(data.some((x) => x > 0));
    await hide(visit, false);
    await page.waitForTimeout(300);
    assert.notEqual((await page.evaluate(seen)).value, before.value);
    await page.keyboard.press("p");
    await visit.finished();
    await hide(visit, true);
    await page.locator("#gallery button.thumb").nth(5).click();
    await page.waitForTimeout(700);
    assert.equal((await visit.state()).picture.state.name, "");
    await hide(visit, false);
    assert.equal((await visit.finished()).undecided, 0);
});

visitTest("a sweep of complex space rests, too", {}, async (visit) => {
    const { page } = visit;
    await visit.unfold("complex");
    await page.locator(".complex-presets button").first().click();
    await visit.settled();
    await visit.button("complex.play").click();
    const delta = () => window.algsurfPage.store.get().complex.delta;
    await visit.until(({ complex }) => complex.delta !== 70);
    await hide(visit, true);
    const before = await page.evaluate(delta);
    await page.waitForTimeout(400);
    assert.equal(await page.evaluate(delta), before);
    await hide(visit, false);
    await visit.until(({ complex }, before) => complex.delta !== before, before);
    await visit.button("complex.play").click();
    await visit.settled();
});
