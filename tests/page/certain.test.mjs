// The line under the picture says what is proved of it, and explains it.
import assert from "node:assert/strict";
import { visitTest } from "./harness.mjs";

const SINGULAR = "#v1&equation=x^2*y^2%2By^2*z^2%2Bz^2*x^2=x*y*z&extent=sphere:1";

for (const [what, link] of [["the first surface", ""], ["Steiner's surface", SINGULAR]])
    visitTest(`the line says that all pixels are decided: ${what}`, { link }, async (visit) => {
        const { degree, pixels, undecided, workers } = await visit.settled();
        assert.equal(undecided, 0);
        const line = await visit.text(".certain-line");
        const number = pixels.toLocaleString("en-US");
        assert.match(line, new RegExp(`degree ${degree} · [\\d,]+ ms · ${workers} workers? · ${number} pixels, all decided`));
    });

visitTest("a click on it explains it in five sentences", {}, async (visit) => {
    const line = visit.page.locator(".certain-line");
    await line.click();
    const sentences = await visit.page.locator(".certain-why li").allInnerTexts();
    assert.equal(sentences.length, 5);
    for (const sentence of sentences) assert.ok(sentence.length > 30, sentence);
    await line.click();
    await visit.page.locator(".certain-why").waitFor({ state: "hidden" });
});

for (const width of [360, 520, 760, 1000, 1280])
    visitTest(`the picture keeps its size whatever the line says: ${width} pixels wide`, { width, height: 700 }, async (visit) => {
        const sizes = await visit.page.evaluate(() => {
            const line = document.querySelector(".certain-line"), stage = document.querySelector("#stage"), words = line.textContent;
            const sizes = ["", words, words.replace("ms", "0000 ms"), `${words} · 123,456 by exact integers`].map((text) => {
                line.textContent = text;
                return `${stage.clientWidth}x${stage.clientHeight}`;
            });
            line.hidden = true;
            sizes.push(`${stage.clientWidth}x${stage.clientHeight}`);
            line.hidden = false;
            line.textContent = words;
            return sizes;
        });
        assert.equal(new Set(sizes).size, 1, sizes.join(" "));
        await visit.settled();
    });
