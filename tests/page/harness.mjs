// harness.mjs - a visit to the page in a browser: opens it, watches for faults, and asks it what it shows.
//
// A fault is whatever a user could not see but should worry about: an error in the console or in a worker, a breach
// of the Content-Security-Policy, a file that is missing, a request to another server.  Every visit must end with
// none.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { mkdir, readFile } from "node:fs/promises";
import { join } from "node:path";
import { after, test } from "node:test";
import { setTimeout as sleep } from "node:timers/promises";
import { serve } from "./server.mjs";
import { BROWSER, installed, OUT, PAGE } from "./settings.mjs";

const PATIENCE = 20_000; // milliseconds that anything may take before it counts as hung

/** The words of the page in English, by key. */
export const WORDS = JSON.parse(readFileSync(join(PAGE, "texts", "en.json"), "utf8"));

let server = null, browser = null;

async function started() {
    server ??= await serve(PAGE);
    browser ??= await installed("playwright-core").chromium.launch({
        executablePath: BROWSER,
        args: ["--no-sandbox", "--enable-precise-memory-info"],
    });
    return { server, browser };
}

after(async () => {
    await browser?.close();
    await server?.close();
});

/** Adds what goes wrong to a list. */
function watch(context, page, address, faults) {
    page.on("console", (message) => {
        if (["error", "warning"].includes(message.type())) faults.push(`console: ${message.text()}`);
    });
    page.on("pageerror", (error) => faults.push(`uncaught: ${error.stack ?? error}`));
    page.on("crash", () => faults.push("the page crashed"));
    context.on("request", (request) => {
        const url = request.url();
        if (!url.startsWith(address) && !/^(blob|data):/.test(url)) faults.push(`asks another server: ${url}`);
    });
    context.on("response", (response) => {
        if (response.status() >= 400) faults.push(`${response.status()}: ${response.url()}`);
    });
}

/** In the page: the report of the picture, if it is of the present state, and at rest. */
function pictureOf({ picture, ...state }, wanted) {
    const stages = ["plain", "smooth", "full"], last = state.complex ? "smooth" : "full";
    if (!picture || !stages.includes(picture.stage) || (wanted === "last" && picture.stage !== last)) return null;
    const { picture: older, ...drawn } = picture.state;
    const ordered = (object) => JSON.stringify(Object.entries(object).sort());
    return ordered(drawn) === ordered(state) ? { ...picture, state: null } : null;
}

/** In the page: the canvas as text that can be sent. */
function canvasAsText() {
    const { width, height } = document.querySelector("#picture");
    const copy = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
    copy.drawImage(document.querySelector("#picture"), 0, 0);
    const { data } = copy.getImageData(0, 0, width, height);
    let binary = "";
    for (let i = 0; i < data.length; i += 0x8000) binary += String.fromCharCode(...data.subarray(i, i + 0x8000));
    return { width, height, base64: btoa(binary) };
}

function fromText({ width, height, base64 }) {
    return { width, height, data: new Uint8Array(Buffer.from(base64, "base64")) };
}

export class Visit {
    faults = [];

    /** options: { link, width, height, ...of a context of the browser }. */
    static async open({ link = "", width = 1000, height = 700, ready = true, ...options } = {}) {
        const { server, browser } = await started();
        const visit = new Visit();
        visit.address = server.address;
        const { origin } = new URL(server.address);
        visit.context = await browser.newContext({
            viewport: { width, height }, locale: "en-US", colorScheme: "light", acceptDownloads: true, ...options,
        });
        await visit.context.grantPermissions(["clipboard-read", "clipboard-write"], { origin });
        visit.page = await visit.context.newPage();
        visit.page.setDefaultTimeout(PATIENCE);
        watch(visit.context, visit.page, server.address, visit.faults);
        visit.devtools = await visit.context.newCDPSession(visit.page);
        await visit.page.goto(server.address + link);
        if (ready) await visit.settled();
        return visit;
    }

    close() {
        return this.context.close();
    }

    /** The state of the page, with the report of its last picture. */
    state() {
        return this.page.evaluate(() => JSON.parse(JSON.stringify(window.algsurfPage.store.get())));
    }

    /** Until the page has all its parts and a function of the state (and of a value) says so; gives what it says.  Asked from here, since the
     * page's policy forbids it to make functions of texts. */
    async until(holds, value = null, patience = PATIENCE) {
        const call = `(${holds})(window.algsurfPage?.isWhole ? window.algsurfPage.store.get() : {}, ${JSON.stringify(value)})`;
        for (const begin = Date.now(); Date.now() - begin < patience; await sleep(20)) {
            const said = await this.page.evaluate(call);
            if (said) return said;
        }
        throw new Error(`never came true: ${holds}\nfor ${JSON.stringify(value)} and ${JSON.stringify(await this.state())}`);
    }

    /** Until a picture of the present state is shown that is at rest, whole and not coarse; gives its report. */
    settled() {
        return this.until(pictureOf, "plain");
    }

    /** Until the same is shown at its best, and nothing is drawn any more. */
    finished() {
        return this.until(pictureOf, "last");
    }

    /** The same, and half a second later nothing has changed: what a click has asked for has come. */
    async rested() {
        for (let before = null, now = ""; before !== now; now = JSON.stringify(await this.state())) {
            await this.finished();
            before = JSON.stringify(await this.state());
            await sleep(500);
            await this.finished();
        }
    }

    /** Waits for an element to be seen, or to be there. */
    wait(selector, state = "visible") {
        return this.page.locator(selector).first().waitFor({ state });
    }

    /** Text of an element as it is seen. */
    text(selector) {
        return this.page.locator(selector).innerText();
    }

    /** A button by the key of its text. */
    button(key) {
        return this.page.getByRole("button", { name: WORDS[key], exact: true });
    }

    /** Writes an equation as a user does, over what stood there. */
    async type(equation) {
        await this.page.locator("#formula").click();
        await this.page.keyboard.press("Control+A");
        await this.page.keyboard.insertText(equation);
    }

    /** Middle and size of the picture on the screen. */
    async box() {
        const { x, y, width, height } = await this.page.locator("#picture").boundingBox();
        return { x, y, width, height, middleX: x + width / 2, middleY: y + height / 2 };
    }

    /** The pixels of the canvas. */
    async pixels() {
        return fromText(await this.page.evaluate(canvasAsText));
    }

    /** The pixels that the canvas has the moment the next picture with one sample at rest is shown, after the eye
     * went away a little. */
    async pixelsAtRest() {
        await this.page.evaluate(`window.algsurfAsText = ${canvasAsText}`);
        const text = await this.page.evaluate(() => new Promise((done) => {
            const { store } = window.algsurfPage, { camera } = store.get();
            const end = store.subscribe(({ picture }, { changed }) => {
                if (!changed.has("picture") || picture?.stage !== "plain") return;
                end();
                done(window.algsurfAsText());
            });
            store.set({ camera: { ...camera, eye: camera.eye.map((x) => 1.03125 * x) } });
        }));
        return fromText(text);
    }

    /** The picture of the present state that is saved for these options. */
    async image(options) {
        return fromText(await this.page.evaluate(async (options) => {
            const { store, painter } = window.algsurfPage, { picture, ...state } = store.get();
            const { width, height, data } = await painter.image(state, options);
            let binary = "";
            for (let i = 0; i < data.length; i += 0x8000) binary += String.fromCharCode(...data.subarray(i, i + 0x8000));
            return { width, height, base64: btoa(binary) };
        }, options));
    }

    /** The bytes and the name of the file that an act saves. */
    async saved(act) {
        const [download] = await Promise.all([this.page.waitForEvent("download"), act()]);
        return { name: download.suggestedFilename(), bytes: await readFile(await download.path()) };
    }

    /** Opens one of the parts of the panel. */
    async unfold(name) {
        const part = this.page.locator(`#section-${name}`);
        if ((await part.getAttribute("open")) === null) await part.locator("summary").first().click();
        return part;
    }

    async screenshot(name) {
        await mkdir(OUT, { recursive: true });
        await this.page.screenshot({ path: join(OUT, `${name}.png`) });
    }
}

/** A test that visits the page, and finds no fault. */
export function visitTest(name, options, body) {
    test(name, async () => {
        const visit = await Visit.open(options);
        try {
            await body(visit);
            assert.deepEqual(visit.faults, []);
        } catch (error) {
            await visit.screenshot(`failed ${name.replace(/[^\w]+/g, " ").slice(0, 60)}`).catch(() => {});
            if (visit.faults.length > 0) error.message += `\nfaults: ${visit.faults.join("\n")}`;
            throw error;
        } finally {
            await visit.close();
        }
    });
}
