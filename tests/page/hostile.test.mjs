// What comes from others, in links and files: it never becomes a command of a terminal, and is read in a time that
// grows as its length does.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { test } from "node:test";
import { Visit, visitTest, WORDS } from "./harness.mjs";
import { part } from "./modules.mjs";

const { commandOf } = await part("files/command");
const { fileOf, stateOfFile } = await part("files/jsurf");
const { linkOf, stateOfLink } = await part("state/link");
const { checkedState, initialState } = await part("state/state");

const UNPRINTED = ["\0", "\x03", "\n", "\r", "\t", "\x1b[2J", "\x7f", "\x9b", "\u2028", "\u2029", "\u202e", "\u200b", "\ufeff"];

test("links, files and what is kept are refused where they hold what is not printed", () => {
    for (const sign of UNPRINTED) {
        const equation = `x^2${sign}echo harmed`, name = JSON.stringify(sign);
        assert.equal(stateOfLink(linkOf({ ...initialState(), equation }), initialState()).refused, true, name);
        assert.equal(stateOfLink(`#v1&equation=x=a&${encodeURIComponent(sign)}=1`, initialState()).refused, true, name);
        assert.equal(stateOfLink(linkOf({ ...initialState(), name: sign }), initialState()).refused, true, name);
        assert.deepEqual(checkedState({ equation }).bad, ["equation"], name);
        const code = `\\u${sign.charCodeAt(0).toString(16).padStart(4, "0")}`;
        assert.throws(() => stateOfFile(`surface_equation=x^2${code}echo harmed`), { key: "unprintable" }, name);
        assert.throws(() => stateOfFile(`surface_equation=x\nsurface_parameter_a${code}=1`), { key: "unprintable" }, name);
    }
});

test("a command is one line of printable characters, whatever the state", () => {
    const size = { width: 64, height: 48 };
    for (const sign of [...UNPRINTED, "'", "\\", "$(echo harmed)", "`echo harmed`", "!!", "; echo harmed", " && x"]) {
        const parameters = { [`a${sign}`]: { value: 1, from: 0, to: 2 } };
        const line = commandOf({ ...initialState(), equation: `x = 1${sign}`, parameters }, size);
        assert.match(line, /^[ -~\u2212]+$/u);
        const words = execFileSync("sh", ["-c", `render() { printf '%s\\n' "$@"; }; ${line}`], { encoding: "utf8" }).split("\n");
        assert.equal(words[0], "--equation");
        const wanted = UNPRINTED.includes(sign) ? /^x = 1 / : sign;
        assert.ok(typeof wanted === "string" ? words[1] === `x = 1${wanted}` : wanted.test(words[1]), words[1]);
        assert.ok(words.includes(`surface.png`), line);
    }
});

test("letters with a backslash come back from a file", () => {
    const parameters = { "\\phi": { value: 1, from: 0, to: 2 }, φ: { value: 3, from: 0, to: 4 } };
    const text = fileOf({ ...initialState(), parameters }, { right: [1, 0, 0], up: [0, 1, 0], forward: [0, 0, -1], distance: 5 });
    assert.deepEqual(Object.keys(stateOfFile(text).parameters), Object.keys(parameters));
});

const TERMINAL = "#v1&equation=x%03%0Aecho%20harmed%20%3E%20harmed";

visitTest("a link with an end of a line is refused, and nothing of it can be copied", { link: TERMINAL }, async (visit) => {
    const { page } = visit;
    assert.equal(await visit.text("#notice"), WORDS.unprintable);
    assert.equal((await visit.state()).name, "barth");
    await visit.unfold("take");
    for (const key of ["take.command", "take.link", "take.program"]) {
        await visit.button(key).click();
        const copied = await page.evaluate(() => navigator.clipboard.readText());
        assert.ok(copied.length > 100 && !copied.includes("harmed"), copied);
        if (key !== "take.program") assert.match(copied, /^[ -~]+$/);
    }
    await visit.type("x^2 + y^2 + z^2 = 2");
    await visit.until(({ equation }) => equation === "x^2 + y^2 + z^2 = 2");
    await page.evaluate((link) => (location.hash = link), TERMINAL);
    await page.waitForFunction((words) => document.querySelector("#notice").textContent === words, WORDS.unprintable);
    assert.equal((await visit.state()).equation, "x^2 + y^2 + z^2 = 2");
});

visitTest("an equation that is pasted in several lines becomes one", {}, async (visit) => {
    await visit.type("x^2 + y^2\n+ z^2\u2062z\t= 1");
    await visit.until(({ equation }) => equation === "x^2 + y^2 + z^2*z = 1");
    await visit.settled();
});

test("an equation that is none is never what is copied, even while its link is looked at", async () => {
    const visit = await Visit.open({ link: "#v1&equation=echo%20(harmed", ready: false });
    await visit.page.waitForFunction(() => window.algsurfPage);
    for (let i = 0; i < 40; i++) {
        assert.doesNotMatch((await visit.state()).equation, /harmed/);
        await visit.page.waitForTimeout(25);
    }
    assert.match(await visit.text("#notice"), /cannot be drawn/);
    await visit.close();
});

// ---- long texts ----

const SIGNS = [" ", "\t", "\\", "\\\\ ", "=", ":", "a", "1 ", "#", "\n", "\r", "\\\n", "%", "&", "@", ",", "(", "\u2028", "\f", "a=\n", "let:a=1&"];
const READERS = {
    file: (text) => stateOfFile(text),
    "file's equation": (text) => stateOfFile(`surface_equation=${text}`),
    "file's matrix": (text) => stateOfFile(`surface_equation=x\nrotation_matrix=${text}`),
    "file's letter": (text) => stateOfFile(`surface_equation=x\nsurface_parameter_${text}`),
    link: (text) => stateOfLink(`#v1&${text}`, initialState()),
    "link's extent": (text) => stateOfLink(`#v1&extent=${text}`, initialState()),
    "link's letter": (text) => stateOfLink(`#v1&let:${text}`, initialState()),
    state: (text) => checkedState({ equation: text, name: text, parameters: { [text]: 1 }, colours: { outside: text } }),
    command: (text) => commandOf({ ...initialState(), equation: text }, { width: 1, height: 1 }),
};

test("hostile texts of 20 kB and 200 kB are read in a time that grows as their length does", () => {
    const kinds = SIGNS.flatMap((sign) => ["", "\u2028", "\\", "="].map((end) => [sign, end]));
    for (const [what, read] of Object.entries(READERS))
        for (const length of [20_000, 200_000]) {
            let longest = 0, name = "";
            for (const [sign, end] of kinds) {
                const text = sign.repeat(Math.ceil(length / sign.length)) + end;
                const begin = performance.now();
                try {
                    read(text);
                } catch (error) {
                    if (!error.key) throw error;
                }
                const ms = performance.now() - begin;
                if (ms > longest) [longest, name] = [ms, JSON.stringify([sign, end])];
            }
            assert.ok(longest < length / 200, `${what}: ${length} characters of ${name} take ${longest} ms`);
        }
});
