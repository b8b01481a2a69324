// Mistakes: what the parser says of an equation has words in every language.
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { test } from "node:test";
import { visitTest } from "./harness.mjs";

const root = new URL("../../", import.meta.url);
const read = (name) => readFileSync(new URL(name, root), "utf8");

/** The strings of the parser's sources that are neither lists of words nor in tables of signs. */
function messages() {
    const said = new Set();
    for (const name of readdirSync(new URL("lib/equation/", root)).filter((file) => file.endsWith(".c"))) {
        const code = read(`lib/equation/${name}`)
            .replace(/\/\*[^]*?\*\//g, "")
            .replace(/^#include.*$/gm, "")
            .replace(/static const char [A-Z]+\[\] =\s*("[^"]*"\s*)+;/g, (list) => (/[:,]|known/.test(list) ? list : ""))
            .replace(/listed\(\s*("[^"]*"\s*)+/g, "")
            .replace(/\{("[^"]*"\s*)+,/g, "")
            .replace(/"\s*\n\s*"/g, "");
        for (const [, string] of code.matchAll(/"((?:[^"\\]|\\.)*)"/g)) 
            if (/\w \w/.test(string) && !/^(alpha beta|vartheta) /.test(string)) said.add(string);
    }
    return [...said];
}

test("every message of the parser has words in every language", () => {
    const all = messages();
    assert.ok(all.length > 50, `${all.length} messages`);
    for (const language of ["en", "de", "es"]) {
        const texts = JSON.parse(read(`examples/page/texts/${language}.json`));
        assert.deepEqual(all.filter((message) => !texts[`mistake: ${message}`]), [], language);
    }
});

test("no words are left of messages that are gone", () => {
    const sources = readdirSync(new URL("lib/equation/", root)).map((name) => read(`lib/equation/${name}`)).join("");
    const joined = sources.replace(/"\s*\n\s*"/g, "");
    const keys = Object.keys(JSON.parse(read("examples/page/texts/en.json"))).filter((key) => key.startsWith("mistake: "));
    assert.deepEqual(keys.filter((key) => !joined.includes(`"${key.slice(9)}"`)), []);
});

visitTest("a mistake is told in the reader's language", { locale: "de-DE" }, async (visit) => {
    await visit.type("x^2 + y^2 + ) z^2 = 1");
    await visit.page.locator("#formula[aria-invalid=true]").waitFor();
    assert.match(await visit.text("#mistake"), /^Spalte 13: (erwartet|eine schließende)/);
});
