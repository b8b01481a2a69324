// The page's pixels are those of the native program render, byte for byte: at rest with one sample, in a PNG that is
// saved, and in what the copied command and the copied C program draw.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after } from "node:test";
import { visitTest, WORDS } from "./harness.mjs";
import { decodePng, decodePnm, difference } from "./png.mjs";
import { native, PROGRAMS, SOURCE } from "./settings.mjs";

const work = mkdtempSync(join(tmpdir(), "check_page"));
after(() => rmSync(work, { recursive: true }));

/** States that between them use everything that a picture depends on. */
const LINKS = {
    "a sphere": "#v1&equation=x^2%2By^2%2Bz^2=1&extent=sphere:1.2",
    "letters, a box, colours, a light": "#v1&equation=x^2%2Ba*y^2-z^2=b&let:a=0.75:-1:3&let:b=0.5:0:2&extent=box:2,1.5,1@0.25,0,0" +
        "&eye=7,-5,3&look-at=0.25,0,0&up=0,0,1&fov=30&colour=8ebf61&inside=db99e6&background=102030&light=-40:35&thin=no",
    "what is thin": "#v1&equation=x^2*z%2By^2*z=x^2*y*0.5&extent=sphere:1.5&eye=4,-5,2&look-at=0,0,0&up=0,0,1&fov=25",
    "complex space": "#v1&equation=x^4-5x^2%2By^4-5y^2%2Bz^4-5z^2%2B11.8=0&extent=sphere:4&eye=12,-9,7&look-at=0,0,0&up=0,0,1" +
        "&fov=25&sigma=0&delta=0.2&imag=0:0.5",
    "axes and a box": "#v1&equation=x^4-5x^2%2By^4-5y^2%2Bz^4-5z^2%2B11.8=0&extent=sphere:3.7&eye=12,-19,12&look-at=0,0,0" +
        "&up=0,0,1&fov=25&background=white&axes=yes&box=yes",
    "two cutting planes": "#v1&equation=x^4-5x^2%2By^4-5y^2%2Bz^4-5z^2%2B11.8=0&extent=sphere:4&eye=12,-9,7&look-at=0,0,0" +
        "&up=0,0,1&fov=25&clip=0.75,-0.55,0.4,0.3&clip=0,0,1,1.5",
};

/** Words of the command for the present state, from the page's own module. */
function wordsOf(visit, options) {
    return visit.page.evaluate(async (options) => {
        const { commandWords } = await import(new URL("files/command.js", location.href));
        return commandWords(window.algsurfPage.store.get(), options);
    }, options);
}

function drawn(words) {
    const path = join(work, "native.png");
    native("render", [...words.slice(1, -2), "--progress", "never", "--output", path]);
    return decodePng(readFileSync(path));
}

/** What a command for a shell draws. */
function drawnBy(command) {
    const env = { ...process.env, PATH: `${PROGRAMS}:${process.env.PATH}` };
    execFileSync("sh", ["-c", command], { cwd: work, env, stdio: "pipe" });
    return decodePng(readFileSync(join(work, /--output (\S+)$/.exec(command)[1])));
}

for (const [what, link] of Object.entries(LINKS))
    visitTest(`at rest with one sample the canvas is what render draws: ${what}`, { link, width: 700, height: 500 }, async (visit) => {
        const canvas = await visit.pixelsAtRest();
        const { width, height } = canvas;
        const expected = drawn(await wordsOf(visit, { width, height, quality: "standard", antialias: 1 }));
        assert.equal(difference(canvas, expected), "");
        await visit.settled();
    });

for (const [what, link] of Object.entries(LINKS))
    visitTest(`a PNG that is saved is what the copied command draws: ${what}`, { link }, async (visit) => {
        const { page } = visit;
        await visit.unfold("take");
        const take = page.locator("#take");
        await take.getByLabel(WORDS["take.width"]).first().fill("333");
        await take.getByLabel(WORDS["take.height"]).first().fill("250");
        const { name, bytes } = await visit.saved(() => visit.button("take.png").click());
        assert.match(name, /\.png$/);
        await visit.button("take.command").click();
        const command = await page.evaluate(() => navigator.clipboard.readText());
        const saved = decodePng(bytes);
        assert.deepEqual([saved.width, saved.height], [333, 250]);
        assert.equal(difference(saved, drawnBy(command)), "");
    });

for (const what of ["a sphere", "letters, a box, colours, a light", "complex space", "two cutting planes"])
    visitTest(`the C program that is copied compiles without a warning and draws the same: ${what}`, { link: LINKS[what] },
        async (visit) => {
            const { page } = visit;
            await visit.unfold("take");
            await page.locator("#take").getByLabel(WORDS["take.width"]).first().fill("333");
            await page.locator("#take").getByLabel(WORDS["take.height"]).first().fill("250");
            await visit.button("take.program").click();
            const text = await page.evaluate(() => navigator.clipboard.readText());
            const here = mkdtempSync(join(work, "program"));
            writeFileSync(join(here, "picture.c"), text);
            const library = join(PROGRAMS, "..", "libalgsurf.a");
            const flags = ["-std=c11", "-Wall", "-Wextra", "-Werror", "-O1", `-I${join(SOURCE, "include")}`];
            execFileSync("cc", [...flags, "picture.c", library, "-lm", "-lpthread", "-o", "picture"], { cwd: here });
            execFileSync("./picture", { cwd: here });
            const made = readdirSync(here).filter((name) => /\.(pam|ppm)$/.test(name));
            assert.equal(made.length, 1);
            await visit.button("take.command").click();
            const command = await page.evaluate(() => navigator.clipboard.readText());
            assert.equal(difference(decodePnm(readFileSync(join(here, made[0]))), drawnBy(command)), "");
        });

visitTest("after a storm of changes the canvas shows the last one, and no band of an older one",
    { link: LINKS["letters, a box, colours, a light"], width: 800, height: 560 }, async (visit) => {
        await visit.page.evaluate(async () => {
            const { store } = window.algsurfPage;
            for (let i = 0; i < 60; i++) {
                const { camera, parameters } = store.get(), value = 0.5 + 0.01 * (i % 37);
                const eye = [7 * Math.cos(i), 7 * Math.sin(i), 3];
                store.set({ camera: { ...camera, eye }, parameters: { ...parameters, a: { ...parameters.a, value } } },
                    { moving: i % 5 !== 0 });
                await new Promise((next) => setTimeout(next, 3 * (i % 7)));
            }
            store.set({}, { moving: false });
        });
        await visit.finished();
        const { width, height, ...shown } = await visit.pixels();
        const expected = await visit.image({ width, height, quality: "full", antialias: 4 });
        assert.equal(difference({ width, height, ...shown }, expected), "");
    });
