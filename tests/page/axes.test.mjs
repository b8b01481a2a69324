// Axes and the box with numbers: switched on in the panel they are drawn, the box in the picture; they are in the
// link, and come back from it.  What is shown of space is told in words.
import assert from "node:assert/strict";
import { Visit, visitTest, WORDS } from "./harness.mjs";
import { difference } from "./png.mjs";

const PHONE = { width: 360, height: 640, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };
const BALL = "#v1&equation=x^2%2By^2%2Bz^2=1&extent=sphere:1.25@0.5,0,-0.25";

async function switched(visit, key, isOn) {
    await visit.unfold("view");
    await visit.page.getByLabel(WORDS[key], { exact: true }).setChecked(isOn);
    await visit.finished();
}

/** Pixels at the border of a picture that are not of the background. */
function atBorder({ width, height, data }) {
    let count = 0;
    for (let y = 0; y < height; y++)
        for (let x = 0; x < width; x += y === 0 || y === height - 1 || x === width - 1 ? 1 : width - 1)
            if (data[4 * (y * width + x) + 3] !== 0) count++;
    return count;
}

visitTest("axes are drawn, and no more once they are switched off", { link: BALL }, async (visit) => {
    await visit.finished();
    const before = await visit.pixels();
    await switched(visit, "view.axes", true);
    const { camera, axes } = await visit.state(), on = await visit.pixels();
    assert.equal(axes, true);
    assert.notEqual(difference(before, on), "");
    await switched(visit, "view.axes", false);
    assert.deepEqual((await visit.state()).camera, camera);
    assert.equal(difference(before, await visit.pixels()), "");
});

visitTest("the box is whole in the picture, in the link, and comes back from it", { link: BALL }, async (visit) => {
    await switched(visit, "view.box", true);
    await visit.until(({ camera }) => camera.eye[0] !== 0);
    await visit.finished();
    assert.equal(atBorder(await visit.pixels()), 0);
    await visit.button("view.fit").first().click();
    await visit.rested();
    const { picture, ...state } = await visit.state(), pixels = await visit.pixels();
    assert.equal(atBorder(pixels), 0);
    await visit.screenshot("a box with numbers");
    await visit.page.locator("#copy-link").click();
    const link = await visit.page.evaluate(() => navigator.clipboard.readText());
    assert.match(link, /&box=yes(&|$)/);
    assert.doesNotMatch(link, /axes=/);
    const other = await Visit.open({ link: link.slice(visit.address.length) });
    await other.finished();
    const { picture: otherPicture, ...otherState } = await other.state();
    assert.deepEqual(otherState, state);
    assert.equal(difference(await other.pixels(), pixels), "");
    await other.unfold("view");
    assert.equal(await other.page.getByLabel(WORDS["view.box"], { exact: true }).isChecked(), true);
    assert.deepEqual(other.faults, []);
    await other.close();
});

visitTest("on a phone, too", { ...PHONE, link: `${BALL}&axes=yes&box=yes` }, async (visit) => {
    await visit.finished();
    await visit.screenshot("axes on a phone");
    const on = await visit.pixels();
    await visit.page.evaluate(() => window.algsurfPage.store.set({ axes: false, box: false }));
    await visit.finished();
    assert.notEqual(difference(on, await visit.pixels()), "");
});

visitTest("pictures that are saved have them", { link: BALL }, async (visit) => {
    const [without, with_] = await visit.page.evaluate(async () => {
        const { store, painter } = window.algsurfPage, { picture, ...state } = store.get();
        const size = { width: 90, height: 60, antialias: 1 };
        const drawn = [state, { ...state, axes: true }].map((one) => painter.image(one, size));
        return (await Promise.all(drawn)).map(({ data }) => [...data]);
    });
    assert.notDeepEqual(without, with_);
});

visitTest("radius and centre of what is shown are told", { link: BALL }, async (visit) => {
    await visit.finished();
    const told = await visit.page.locator("#picture").getAttribute("aria-label");
    assert.match(told, /radius 1\.25 about \(0\.5, 0, -0\.25\)/);
    await visit.until(() => document.querySelector("#seen").textContent.includes("radius 1.25 about (0.5, 0, -0.25)"));
    await visit.page.evaluate(() => window.algsurfPage.store.set({ extent: { kind: "box", size: [1, 2, 1.5], centre: [0, 0, 0] } }));
    await visit.until(() => document.querySelector("#seen").textContent.includes("half edges (1, 2, 1.5) about (0, 0, 0)"));
});

visitTest("a link with axes that are neither is told", { link: `${BALL}&box=perhaps` }, async (visit) => {
    assert.equal((await visit.state()).box, false);
    assert.match(await visit.text("#notice"), /box/);
});
