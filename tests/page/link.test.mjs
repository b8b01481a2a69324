// Links: one that is copied gives the same state elsewhere; one of a malicious kind harms nobody, and is told.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Visit, visitTest } from "./harness.mjs";

const RICH = "#v1&equation=x^2%2Ba*y^2-z^2=b&let:a=0.75:-1:3&let:b=0.5:0:2&extent=box:2,1.5,1@0.25,0,0" +
    "&eye=7,-5,3&look-at=0.25,0,0&up=0,0,1&fov=30&colour=8ebf61&inside=db99e6&background=102030&light=-40:35&thin=no";

visitTest("a link gives its state", { link: RICH }, async (visit) => {
    const { picture, ...state } = await visit.state();
    assert.equal(picture.undecided, 0);
    assert.deepEqual(state.parameters, { a: { value: 0.75, from: -1, to: 3 }, b: { value: 0.5, from: 0, to: 2 } });
    assert.deepEqual(state.extent, { kind: "box", size: [2, 1.5, 1], centre: [0.25, 0, 0] });
    assert.deepEqual(state.camera, { eye: [7, -5, 3], lookAt: [0.25, 0, 0], up: [0, 0, 1], fov: 30 });
    assert.deepEqual(state.colours, { outside: "#8ebf61", inside: "#db99e6", background: "#102030" });
    assert.deepEqual(state.light, { azimuth: -40, elevation: 35 });
    assert.equal(state.thin, false);
    assert.equal(await visit.page.locator("#formula").inputValue(), "x^2+a*y^2-z^2=b");
});

visitTest("a link that is copied gives the same state elsewhere", { link: RICH }, async (visit) => {
    const { page } = visit, { middleX, middleY } = await visit.box();
    await page.mouse.move(middleX, middleY);
    await page.mouse.down();
    await page.mouse.move(middleX + 90, middleY - 30, { steps: 5 });
    await page.mouse.up();
    await visit.finished();
    await page.locator("#copy-link").click();
    const link = await page.evaluate(() => navigator.clipboard.readText());
    assert.ok(link.startsWith(visit.address), link);
    const { picture, ...state } = await visit.state();
    const other = await Visit.open({ link: link.slice(visit.address.length) });
    await other.finished();
    const { picture: otherPicture, ...otherState } = await other.state();
    assert.deepEqual(otherState, state);
    assert.deepEqual((await other.pixels()).data, (await visit.pixels()).data);
    assert.deepEqual(other.faults, []);
    await other.close();
});

visitTest("a link that is opened while the page is open is followed", {}, async (visit) => {
    await visit.page.evaluate((link) => (location.hash = link), "#v1&equation=x^2%2By^2=z^3");
    await visit.until(({ equation }) => equation === "x^2+y^2=z^3");
    await visit.settled();
});

visitTest("such a link is followed even if the page writes its own address at that moment", {}, async (visit) => {
    await visit.page.evaluate((link) => {
        location.hash = link;
        history.replaceState(null, "", "#v1&equation=x=0");
    }, "#v1&equation=x^2%2By^2=z^3");
    await visit.until(({ equation }) => equation === "x^2+y^2=z^3");
    await visit.settled();
});

const TOLD = {
    "a field of a newer version": ["#v1&equation=x^2%2By^2=1&warp=9", /warp/],
    "a newer version": ["#v7&equation=x^2%2By^2=1&warp=9", /newer|warp/],
    "numbers that are none": ["#v1&equation=x^2%2By^2=1&eye=NaN,1,Infinity&fov=1e999", /camera|eye/],
    "an extent without end": ["#v1&equation=x^2%2By^2=1&extent=sphere:1e308", /extent/],
    "a degree that is too high": ["#v1&equation=x^100000", /./],
    "an equation that explodes": ["#v1&equation=(x%2By%2Bz%2B1)^64*(x-y-z-2)^64", /./],
    "brackets without end": [`#v1&equation=${"(".repeat(5000)}`, /./],
    "half a megabyte": [`#v1&equation=${"x%2B".repeat(125_000)}1`, /./],
    "script in the equation": ["#v1&equation=%3Cimg%20src%3Dx%20onerror%3Dwindow.harmed%3D1%3E", /./],
    "script in the name": ["#v1&name=%3Cscript%3Ewindow.harmed%3D1%3C/script%3E&equation=x=0", null],
    "script in a letter": ["#v1&equation=x=a&let:%3Csvg%20onload%3Dharmed%3D1%3E=1:0:2", /./],
    "letters of JavaScript": ["#v1&equation=x=1&let:__proto__=1:0:2&let:constructor=1:0:2&toString=1&__proto__=2", /./],
    "colours that are styles": ["#v1&equation=x=1&colour=fff;background:url(//evil.example)&inside=zzzzzz", /colour/],
    "escapes that are none": ["#v1&equation=%E0%A4%A&%%%=%", /./],
    "a sector without sense": ["#v1&equation=x^2%2By^2%2Bz^2=1&sigma=-1&delta=99&imag=99:1", /complex|sector/],
    "planes without sense": ["#v1&equation=x^2%2By^2%2Bz^2=1&clip=0,0,0,0", /clip|plane/],
};

for (const [what, [link, told]] of Object.entries(TOLD))
    test(`a link with ${what} harms nobody${told ? ", and it is said" : ""}`, async () => {
        const visit = await Visit.open({ link, ready: false });
        const { page } = visit;
        page.on("dialog", (dialog) => visit.faults.push(`dialog: ${dialog.message()}`));
        try {
            await visit.settled();
            if (told) {
                const said = `${await visit.text("#notice")} ${await page.locator("#mistake").textContent()}`;
                assert.match(said.trim(), told);
                assert.ok(said.length > 12 && said.length < 1000, said);
                assert.doesNotMatch(said, /undefined|\[object|NaN/);
            }
            assert.equal(await page.evaluate(() => window.harmed), undefined);
            assert.equal(await page.evaluate(() => Object.prototype.value), undefined);
            assert.equal(await page.evaluate(() => document.querySelectorAll("img[onerror], svg[onload]").length), 0);
            await visit.type("x^2 + y^2 + z^2 = 2");
            await visit.until(({ equation }) => equation === "x^2 + y^2 + z^2 = 2");
            await visit.settled();
            assert.deepEqual(visit.faults, []);
        } catch (error) {
            await visit.screenshot(`failed link ${what}`).catch(() => {});
            error.message += `\n${visit.faults.join("\n")}`;
            throw error;
        } finally {
            await visit.close();
        }
    });
