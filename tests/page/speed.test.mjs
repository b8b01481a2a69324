// Speed: measured and printed as the table that the page's README shows; asserted are only loose limits, since other
// programs may run beside it.
//
//     tests/check_page --only speed
import assert from "node:assert/strict";
import { Visit, visitTest } from "./harness.mjs";
import { Recorder } from "./recorder.mjs";
import { test } from "node:test";

const BARTH = "#v1&equation=4((3%2Bsqrt(5))/2*x^2-y^2)((3%2Bsqrt(5))/2*y^2-z^2)((3%2Bsqrt(5))/2*z^2-x^2)-" +
    "(2%2Bsqrt(5))(x^2%2By^2%2Bz^2-1)^2&extent=sphere:2&eye=8.33,-5.15,0.52&look-at=0,0,0&up=0,0,1&fov=25";
const TANGLE = "#v1&equation=x^4-5x^2%2By^4-5y^2%2Bz^4-5z^2%2B11.8=0&extent=sphere:4&eye=12,-9,7&look-at=0,0,0&up=0,0,1&fov=25" +
    "&sigma=0&delta=0.2";
const TWO_WORKERS = "?workers=2";
const row = (what, value) => console.log(`| ${what} | ${value} |`);
const rates = (times) => `${(1000 / median(times)).toFixed(1)}, at best ${(1000 / Math.min(...times)).toFixed(1)}`;
const coarse = ({ factor }) => (factor === 1 ? "not coarser" : `${factor} times as coarse`);
const median = (list) => [...list].sort((a, b) => a - b)[list.length >> 1];

/** Milliseconds of pictures of 640x480 as while something moves: one sample a pixel, without what is thinner than a ray;
 * drawn one after the other. */
function fullTimes(visit, change, count) {
    return visit.page.evaluate(async ([change, count]) => {
        const { store, painter } = window.algsurfPage, state = { ...store.get(), thin: false, picture: undefined };
        const turned = (i) => {
            const { eye } = state.camera, angle = 0.02 * i, [c, s] = [Math.cos(angle), Math.sin(angle)];
            return { ...state, camera: { ...state.camera, eye: [c * eye[0] - s * eye[1], s * eye[0] + c * eye[1], eye[2]] } };
        };
        const wedged = (i) => ({ ...state, complex: { ...state.complex, delta: 0.2 + 0.01 * i } });
        const options = { width: 640, height: 480, quality: "standard", antialias: 1 };
        const draw = (i) => painter.image(change === "delta" ? wedged(i) : turned(i), options);
        for (let i = 0; i < 3; i++) await draw(i);
        const times = [];
        for (let i = 0; i < count; i++) {
            const begin = performance.now();
            await draw(i);
            times.push(performance.now() - begin);
        }
        return times;
    }, [change, count]);
}

/** Pictures a second that are shown while the page itself moves something; and the coarseness that it chose. */
async function shownRate(visit, move) {
    const recorder = await Recorder.start(visit);
    await move();
    const moving = (await recorder.stop()).filter(({ stage }) => stage === "moving");
    const rest = moving.slice(Math.floor(moving.length / 4)); // its coarseness is found in the first ones
    const rate = (1000 * (rest.length - 1)) / (rest.at(-1).at - rest[0].at);
    return { rate, factor: median(rest.map(({ factor }) => factor)) };
}

/** The longest time, in milliseconds, that the main thread was busy with one thing meanwhile. */
async function longestTask(visit, act) {
    await visit.page.evaluate(() => {
        window.algsurfTasks = [0];
        new PerformanceObserver((list) => window.algsurfTasks.push(...list.getEntries().map(({ duration }) => duration)))
            .observe({ type: "longtask" });
    });
    await act();
    return visit.page.evaluate(() => Math.max(...window.algsurfTasks));
}

/** Turns by a key in each frame of the screen, for some seconds. */
function turnFor(visit, seconds) {
    return visit.page.evaluate(async (seconds) => {
        const { store } = window.algsurfPage, end = performance.now() + 1000 * seconds;
        for (let i = 0; performance.now() < end; i++) {
            const { camera } = store.get(), [x, y, z] = camera.eye, [c, s] = [Math.cos(0.02), Math.sin(0.02)];
            store.set({ camera: { ...camera, eye: [c * x - s * y, s * x + c * y, z] } }, { moving: true });
            await new Promise(requestAnimationFrame);
        }
        store.set({}, { moving: false });
    }, seconds);
}

function sweepFor(visit, seconds) {
    return visit.page.evaluate(async (seconds) => {
        const { store } = window.algsurfPage, begin = performance.now();
        for (let passed = 0; passed < seconds; passed = (performance.now() - begin) / 1000) {
            const { complex } = store.get();
            store.set({ complex: { ...complex, delta: 0.2 + 0.1 * passed } }, { moving: true });
            await new Promise(requestAnimationFrame);
        }
        store.set({}, { moving: false });
    }, seconds);
}

test("pictures a second", async () => {
    const size = { width: 640 + 344, height: 480 + 160 };
    const barth = await Visit.open({ link: TWO_WORKERS + BARTH, ...size });
    row("Barth sextic, 640x480, every pixel, pictures a second", rates(await fullTimes(barth, "turn", 40)));
    let turned = null;
    const busy = await longestTask(barth, async () => (turned = await shownRate(barth, () => turnFor(barth, 2.5))));
    row(`the same as shown while it turns, ${coarse(turned)}`, turned.rate.toFixed(1));
    row("the longest that it does not answer meanwhile, ms", busy === 0 ? "less than 50" : busy.toFixed(0));
    assert.ok(busy < 500, "the main thread is blocked");
    assert.deepEqual(barth.faults, []);
    await barth.close();
    const tangle = await Visit.open({ link: TWO_WORKERS + TANGLE, ...size });
    row("Tangle in complex space, 640x480, every pixel, pictures a second", rates(await fullTimes(tangle, "delta", 15)));
    const swept = await shownRate(tangle, () => sweepFor(tangle, 2.5));
    row(`the same as shown while a slider moves, ${coarse(swept)}`, swept.rate.toFixed(1));
    assert.deepEqual(tangle.faults, []);
    await tangle.close();
    assert.ok(turned.rate > 10 && swept.rate > 5, "moving pictures are slow");
});

test("from the address to the first picture", async () => {
    const times = [];
    for (let i = 0; i < 3; i++) {
        const visit = await Visit.open({ link: TWO_WORKERS, ready: false, width: 984, height: 640 });
        await visit.until(({ picture }) => picture !== null && picture !== undefined);
        times.push(await visit.page.evaluate(() => performance.now()));
        await visit.settled();
        await visit.close();
    }
    row("first picture after the address, ms", Math.round(median(times)));
    assert.ok(median(times) < 5000);
});

visitTest("from the last letter to the picture", { link: TWO_WORKERS, width: 984, height: 640 }, async (visit) => {
    const { page } = visit, times = [];
    for (const equation of ["x^2+y^2+z^2=1", "x^4+y^4+z^4=1", "x^2+y^2=z^2+1", "x^3+y^3+z^3=1", "x^2 y^2+z^2=1"]) {
        await page.evaluate((wanted) => {
            const { store } = window.algsurfPage;
            window.algsurfTyped = new Promise((done) => {
                let begin = 0;
                document.querySelector("#formula").addEventListener("input", () => (begin = performance.now()));
                const end = store.subscribe(({ picture }, { changed }) => {
                    if (!changed.has("picture") || picture?.state.equation !== wanted) return;
                    end();
                    done(performance.now() - begin);
                });
            });
        }, equation);
        await visit.type(equation);
        times.push(await page.evaluate(() => window.algsurfTyped));
        await visit.settled();
    }
    row("from the last letter to the picture, ms", Math.round(median(times)));
    assert.ok(median(times) < 3000);
});
