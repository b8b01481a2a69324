// The catalogue: at least 40 surfaces that can all be drawn, with a name and two sentences in each language; those that
// were typed are kept; SURFER's files are opened and saved.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { Visit, visitTest } from "./harness.mjs";
import { SOURCE } from "./settings.mjs";

const TEXTS = join(SOURCE, "examples", "page", "texts");

const names = (visit) => visit.page.evaluate(async () =>
    (await import(new URL("state/surfaces.js", location.href))).SURFACES.map(({ name }) => name));

visitTest("at least 40 surfaces, with a name and two sentences in each language", {}, async (visit) => {
    const all = await names(visit);
    assert.ok(all.length >= 40, `${all.length} surfaces`);
    assert.equal(new Set(all).size, all.length);
    for (const file of readdirSync(TEXTS)) {
        const words = JSON.parse(readFileSync(join(TEXTS, file), "utf8"));
        for (const name of all) {
            assert.ok(words[`name.${name}`], `${file}: no name.${name}`);
            const sentences = (words[`surface.${name}`] ?? "").match(/[.!?](\s|$)/g) ?? [];
            assert.ok(sentences.length >= 2, `${file}: surface.${name}: ${words[`surface.${name}`]}`);
        }
    }
    await visit.settled();
});

visitTest("texts have the same keys and the same places for values in each language", {}, async () => {
    const read = (file) => JSON.parse(readFileSync(join(TEXTS, file), "utf8"));
    const english = read("en.json"), places = (text) => (text.match(/\{\w+\}/g) ?? []).sort().join();
    for (const file of readdirSync(TEXTS)) {
        const words = read(file);
        assert.deepEqual(Object.keys(english).filter((key) => !(key in words)), [], `${file} lacks`);
        assert.deepEqual(Object.keys(words).filter((key) => !(key in english)), [], `${file} has, and English has not`);
        for (const [key, text] of Object.entries(words)) assert.equal(places(text), places(english[key]), `${file}: ${key}`);
    }
});

visitTest("each surface of the catalogue is drawn, and fills its picture", {}, async (visit) => {
    const drawn = await visit.page.evaluate(async () => {
        const { SURFACES } = await import(new URL("state/surfaces.js", location.href));
        const { painter, store } = window.algsurfPage, { picture, ...rest } = store.get();
        return Promise.all(SURFACES.map(async (surface) => {
            const state = { ...rest, ...surface, clip: [], light: null, thin: null, complex: null };
            try {
                const { data } = await painter.image(state, { width: 88, height: 66, antialias: 1 });
                return [surface.name, data.filter((value, i) => i % 4 === 3 && value > 0).length];
            } catch (error) {
                return [surface.name, error.message];
            }
        }));
    });
    for (const [name, count] of drawn) assert.ok(count > 300, `${name}: ${count} pixels`);
});

visitTest("a thumbnail opens its surface; a typed one is kept for the next visit", {}, async (visit) => {
    const { page } = visit;
    const second = page.locator("#gallery button.thumb").nth(1);
    await second.click();
    await visit.until(({ name }, wanted) => name === wanted, (await names(visit))[1]);
    await visit.settled();
    assert.equal(await second.getAttribute("aria-current"), "true");
    await visit.type("x^2 + y^2 = z^3 + 1");
    await visit.until(({ equation }) => equation === "x^2 + y^2 = z^3 + 1");
    await page.locator("#gallery button.thumb[title='x^2 + y^2 = z^3 + 1']").waitFor();
    await page.goto(visit.address);
    await page.locator("#gallery button.thumb[title='x^2 + y^2 = z^3 + 1']").click();
    await visit.until(({ equation }) => equation === "x^2 + y^2 = z^3 + 1");
    await visit.settled();
});

/** Opens a file by the page's own button. */
async function openFile(visit, path) {
    await visit.unfold("take");
    const [chooser] = await Promise.all([visit.page.waitForEvent("filechooser"), visit.button("take.file.open").click()]);
    await chooser.setFiles(path);
}

const FILE = `surface_equation=x^2*y^2+y^2*z^2+z^2*x^2-a*x*y*z-0.05
surface_parameter_a=0.75
scale_factor=0.2
background_color=0.2 0.4 0.6
`;

visitTest("a file of SURFER is opened, and saved so that it is the same again", {}, async (visit) => {
    await openFile(visit, { name: "mine.jsurf", mimeType: "text/plain", buffer: Buffer.from(FILE) });
    await visit.until(({ equation }) => equation.includes("0.05"));
    const { picture, ...first } = await visit.state();
    assert.equal(first.parameters.a.value, 0.75);
    await visit.settled();
    const { name, bytes } = await visit.saved(() => visit.button("take.file.save").click());
    assert.match(name, /\.jsurf$/);
    const other = await Visit.open({});
    await openFile(other, { name, mimeType: "text/plain", buffer: bytes });
    await other.until(({ equation }) => equation.includes("0.05"));
    await other.settled();
    const size = { width: 160, height: 120, quality: "standard", antialias: 1 };
    const [a, b] = [await visit.image(size), await other.image(size)];
    const different = a.data.filter((value, i) => Math.abs(value - b.data[i]) > 40).length;
    assert.ok(different < 0.01 * a.data.length, `${different} bytes differ`);
    assert.deepEqual(other.faults, []);
    await other.close();
});

visitTest("what is no such file is refused in words", {}, async (visit) => {
    const { equation } = await visit.state();
    for (const bytes of ["", "\u0000\u0001\u0002", "surface_equation=((((", `surface_equation=x^99999`, "<script>alert(1)</script>"]) {
        await openFile(visit, { name: "bad.jsurf", mimeType: "text/plain", buffer: Buffer.from(bytes) });
        await visit.wait("#notice:not([hidden])").catch(() => assert.fail(`nothing is said of '${bytes}'`));
        assert.doesNotMatch(await visit.text("#notice"), /undefined|\[object/);
        await visit.page.evaluate(() => (document.querySelector("#notice").hidden = true));
        await visit.settled();
    }
    assert.equal((await visit.state()).equation, equation);
});
