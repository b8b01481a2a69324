// Random input: no error in the console, the page answers at the end, and memory does not grow.
//
// The seed is printed; CHECK_PAGE_SEED=N repeats it.
import assert from "node:assert/strict";
import { Visit } from "./harness.mjs";
import { test } from "node:test";
import { MONKEY_SECONDS } from "./settings.mjs";

const MEGABYTE = 2 ** 20;
const MAY_GROW = 24; // megabytes of JavaScript and of wasm, between a third of the time and its end
const LONGEST_QUESTION = 40_000; // milliseconds: the page gives up a question after 20 s, and then answers the next one
const SEED = Number(process.env.CHECK_PAGE_SEED ?? 20), WIDE = 1100, HIGH = 760;

/** Numbers from 0 to 1 (mulberry32). */
function randomFrom(seed) {
    let a = seed;
    return () => {
        a = (a + 0x6d2b79f5) | 0;
        let t = Math.imul(a ^ (a >>> 15), 1 | a);
        t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
        return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
    };
}

const random = randomFrom(SEED);
const below = (n) => Math.floor(random() * n);
const one = (list) => list[below(list.length)];

const KEYS = ["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "+", "-", "0", "?", "Escape", "Tab", "Enter", " ", "p", "[", "]",
    "r", "c", "e", "w", "t", "<", ">", "PageUp", "PageDown", "Home", "End", "Backspace"];
const PIECES = ["x", "y", "z", "a", "b", "^2", "^3", "+", "-", "*", "(", ")", "=", "1", "0.5", "1e300", "sqrt(2)", "pi", " ", "/", "/0", "^64"];
const EQUATIONS = ["x^2+y^2=z^2", "x^3+y^3+z^3=a", "x^2 y^2+y^2 z^2+z^2 x^2=x y z", "(x^2+y^2+z^2+3)^2=16(x^2+y^2)", "x y z = 0",
    "x^8+y^8+z^8=1", "a x^2+b y^2+c z^2=1", "x^64+y^64=1", "z=0", "x^2+y^2+z^2=-1"];

const place = () => [below(WIDE), below(HIGH)];

/** What a user may do; each takes the page. */
const ACTIONS = {
    async drag(page) {
        const [x, y] = [200 + below(400), 200 + below(300)];
        const key = random() < 0.3 ? one(["Shift", "Alt", "Control"]) : null;
        if (key) await page.keyboard.down(key);
        await page.mouse.move(x, y);
        await page.mouse.down();
        await page.mouse.move(x + below(300) - 150, y + below(300) - 150, { steps: 1 + below(10) });
        await page.mouse.up();
        if (key) await page.keyboard.up(key);
    },
    async wheel(page) {
        await page.mouse.move(...place());
        await page.mouse.wheel(0, below(600) - 300);
    },
    async click(page) {
        await page.mouse.click(...place(), { clickCount: 1 + below(2) });
    },
    async key(page) {
        for (let i = below(5); i >= 0; i--) await page.keyboard.press(one(KEYS));
    },
    async equation(page) {
        const text = random() < 0.6 ? one(EQUATIONS) : Array.from({ length: 1 + below(12) }, () => one(PIECES)).join("");
        if (await page.evaluate(() => document.querySelector("dialog[open]") !== null)) await page.keyboard.press("Escape");
        await page.locator("#formula").fill(text);
    },
    async control(page) {
        await page.evaluate(([which, at]) => {
            const controls = [...document.querySelectorAll("input, select")].filter((node) => node.checkVisibility() && node.type !== "file");
            const node = controls[Math.floor(which * controls.length)];
            if (!node) return;
            if (node.type === "checkbox") return node.click();
            if (node.tagName === "SELECT") {
                if (node.closest("#foot")) return; // another language loads the page anew
                node.selectedIndex = Math.floor(at * node.options.length);
            } else if (node.type === "color") {
                node.value = `#${Math.floor(at * 0xffffff).toString(16).padStart(6, "0")}`;
            } else {
                const [low, high] = [Number(node.min || -3), Number(node.max || 3)];
                node.value = String(low + at * (Math.min(high, 50) - low));
            }
            for (const type of ["input", "change"]) node.dispatchEvent(new Event(type, { bubbles: true }));
        }, [random(), random()]);
    },
    async button(page) {
        await page.evaluate((which) => {
            const buttons = [...document.querySelectorAll("button, summary")].filter((node) => node.checkVisibility());
            buttons[Math.floor(which * buttons.length)]?.click();
        }, random());
    },
    async window(page) {
        await page.setViewportSize({ width: one([360, 800, WIDE]), height: one([500, HIGH]) });
    },
    async rest(page) {
        await page.waitForTimeout(below(250));
    },
};
const OFTEN = ["drag", "drag", "wheel", "click", "key", "key", "equation", "control", "control", "button", "rest", "rest"];

/** Bytes that JavaScript and the workers hold, elements of the document, workers. */
async function held({ page, devtools }) {
    await devtools.send("HeapProfiler.collectGarbage");
    const { usedSize } = await devtools.send("Runtime.getHeapUsage");
    const { nodes } = await devtools.send("Memory.getDOMCounters");
    const { memory, workers } = await page.evaluate(() => window.algsurfPage.painter.statistics);
    return { heap: usedSize / MEGABYTE, wasm: memory / MEGABYTE, nodes, workers };
}

const said = ({ heap, wasm, nodes }) => `${heap.toFixed(1)} MB of JavaScript, ${wasm.toFixed(0)} MB of wasm, ${nodes} nodes`;

/** So that memory is compared with the same in view. */
async function calm(visit) {
    const { page } = visit;
    await page.setViewportSize({ width: WIDE, height: HIGH });
    for (let i = 0; i < 3; i++) await page.keyboard.press("Escape");
    await page.evaluate(() => (location.hash = "#v1&equation=x^2%2By^2%2Bz^2=1&extent=sphere:1.2"));
    await visit.until(({ equation }) => equation === "x^2+y^2+z^2=1", null, LONGEST_QUESTION);
    await visit.settled();
    await page.evaluate(() => (location.hash = ""));
}

test(`${MONKEY_SECONDS} seconds of random input, seed ${SEED}`, { timeout: 1000 * MONKEY_SECONDS + 120_000 }, async () => {
    const visit = await Visit.open({ width: WIDE, height: HIGH });
    const { page } = visit;
    page.on("dialog", (dialog) => dialog.dismiss());
    page.on("filechooser", () => {});
    const begin = Date.now(), passed = () => (Date.now() - begin) / 1000 / MONKEY_SECONDS;
    let count = 0, last = "", middle = null;
    try {
        while (passed() < 1) {
            last = one(random() < 0.02 ? ["window"] : OFTEN);
            await ACTIONS[last](page);
            count++;
            assert.deepEqual(visit.faults, [], `after ${count} actions, the last one: ${last}`);
            if (!middle && passed() > 1 / 3) {
                await calm(visit);
                middle = await held(visit);
            }
        }
        await calm(visit);
        const end = await held(visit);
        console.log(`        ${count} actions; after a third: ${said(middle)}; at the end: ${said(end)}`);
        assert.ok(end.heap - middle.heap < MAY_GROW, "memory of JavaScript grows");
        assert.ok(end.wasm - middle.wasm < MAY_GROW * end.workers, "memory of the workers grows");
        assert.ok(end.nodes < 2 * middle.nodes + 2000, "the document grows");
        assert.deepEqual(visit.faults, []);
    } catch (error) {
        await visit.screenshot("failed monkey").catch(() => {});
        throw error;
    } finally {
        await visit.close();
    }
});
