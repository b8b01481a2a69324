// Screenshots of the main states, to be looked at: build/page-test/pictures.
import { visitTest } from "./harness.mjs";

const DESKTOP = { width: 1280, height: 800 };
const PHONE = { width: 360, height: 640, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };
const KUMMER = "#v1&equation=(x^2%2By^2%2Bz^2-m^2)^2=(3m^2-1)/(3-m^2)((1-z)^2-2x^2)((1%2Bz)^2-2y^2)&let:m=1.14:1.02:1.7&extent=sphere:2.2";

async function lookedInto(visit) {
    const { middleX, middleY } = await visit.box();
    await visit.page.mouse.click(middleX - 38, middleY - 98);
    await visit.page.locator("#ray .ray-facts dd").first().waitFor({ state: "attached" });
    await visit.settled();
    await visit.page.waitForTimeout(800);
}

async function alone(visit, name) {
    for (const part of ["view", "look", "ray", "complex", "take"])
        await visit.page.locator(`#section-${part}`).evaluate((node, open) => (node.open = open), part === name);
    await visit.page.locator(`#section-${name}`).scrollIntoViewIfNeeded();
    await visit.page.waitForTimeout(200);
}

const shots = {
    "first": [DESKTOP, async () => {}],
    "first dark": [{ ...DESKTOP, colorScheme: "dark" }, async () => {}],
    "letters": [{ ...DESKTOP, link: KUMMER }, async () => {}],
    "mistake": [DESKTOP, async (visit) => {
        await visit.type("x^2 + y^2 + (z^2 * w^) = 1");
        await visit.page.locator("#formula[aria-invalid=true]").waitFor();
    }],
    "ray": [DESKTOP, async (visit) => {
        await lookedInto(visit);
        await alone(visit, "ray");
    }],
    "ray below": [{ ...DESKTOP, height: 2000 }, async (visit) => {
        await lookedInto(visit);
        await alone(visit, "ray");
    }],
    "ray below dark": [{ ...DESKTOP, height: 2000, colorScheme: "dark" }, async (visit) => {
        await lookedInto(visit);
        await alone(visit, "ray");
    }],
    "complex": [DESKTOP, async (visit) => {
        await alone(visit, "complex");
        await visit.page.locator(".complex-presets button").nth(1).click();
        await visit.settled();
    }],
    "look": [{ ...DESKTOP, height: 1100 }, async (visit) => alone(visit, "look")],
    "take": [{ ...DESKTOP, height: 1100 }, async (visit) => alone(visit, "take")],
    "certain": [DESKTOP, async (visit) => visit.page.locator(".certain-line").click()],
    "help": [DESKTOP, async (visit) => visit.page.locator("#open-help").click()],
    "wide": [{ width: 1920, height: 1080 }, async () => {}],
    "phone": [PHONE, async () => {}],
    "phone dark panel": [{ ...PHONE, colorScheme: "dark" }, async (visit) => {
        await visit.page.locator("#handle").tap();
        await visit.page.waitForTimeout(500);
    }],
    "phone ray": [PHONE, async (visit) => {
        const { middleX, middleY } = await visit.box();
        await visit.page.touchscreen.tap(middleX - 22, middleY - 60);
        await visit.page.waitForTimeout(1500);
    }],
    "german": [{ ...DESKTOP, locale: "de-DE" }, async () => {}],
};

for (const [name, [options, act]] of Object.entries(shots))
    visitTest(`a picture to look at: ${name}`, options, async (visit) => {
        await act(visit);
        await (name.startsWith("first") ? visit.finished() : visit.settled());
        await visit.page.waitForTimeout(700); // thumbnails
        await visit.screenshot(name);
    });
