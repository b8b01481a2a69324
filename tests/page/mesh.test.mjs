// Files of triangles: those of the program mesh, byte by byte, for the same extent, letters, planes, colours and cells;
// closed where the surface is; nothing in complex space and where there is nothing; the page goes on meanwhile.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after } from "node:test";
import { visitTest, WORDS } from "./harness.mjs";
import { native } from "./settings.mjs";

const work = mkdtempSync(join(tmpdir(), "check_page"));
after(() => rmSync(work, { recursive: true }));

const TORUS = "#v1&name=torus&equation=(x^2%2By^2%2Bz^2%20%2B%20R^2%20-%20r^2)^2%20=%204R^2%20(x^2%2By^2)" +
    "&let:R=2:1:2.5&let:r=0.75:0.1:1&extent=sphere:3";
const CUT = "#v1&equation=x^2%2Ba*y^2-z^2=b&let:a=0.75:-1:3&let:b=0.5:0:2&extent=box:2,1.5,1@0.25,0,0" +
    "&colour=8ebf61&inside=db99e6&clip=0.75,-0.55,0.4,0.3&clip=0,0,1,0.625";
const SLOW = "?workers=1#v1&equation=x^12%2By^12%2Bz^12-3x^6*y^3*z^3%2Bx*y*z=x^2%2By^2%2Bz^2&extent=sphere:1.5";
const WITH_A_VALUE = ["--equation", "--let", "--extent", "--centre", "--clip", "--colour", "--inside"];

function save(visit, format) {
    return visit.page.getByRole("button", { name: WORDS["take.mesh.save"].replace("{format}", format), exact: true });
}

function cells(visit) {
    return visit.page.getByLabel(WORDS["take.mesh.cells"], { exact: true });
}

/** What the program mesh makes of the present state. */
async function expected(visit, format, count) {
    const words = await visit.page.evaluate(async () => {
        const { commandWords } = await import(new URL("files/command.js", location.href));
        return commandWords(window.algsurfPage.store.get(), { width: 1, height: 1 });
    });
    const taken = words.flatMap((word, i) => (WITH_A_VALUE.includes(word) ? [word, words[i + 1]] : []));
    const path = join(work, `native.${format}`);
    native("mesh", [...taken, "--cells", String(count), "--progress", "never", "--output", path]);
    return readFileSync(path);
}

/** Corners of the triangles of a file, as numbers of points. */
function stlCorners(bytes) {
    assert.doesNotMatch(bytes.toString("latin1", 0, 80), /^solid/);
    const count = bytes.readUInt32LE(80), points = new Map(), corners = [];
    assert.equal(bytes.length, 84 + 50 * count);
    for (let i = 0; i < 3 * count; i++) {
        const at = 84 + 50 * Math.floor(i / 3) + 12 + 12 * (i % 3), point = bytes.toString("hex", at, at + 12);
        if (!points.has(point)) points.set(point, points.size);
        corners.push(points.get(point));
    }
    return corners;
}

function glbParts(bytes) {
    assert.equal(bytes.toString("latin1", 0, 4), "glTF");
    assert.deepEqual([4, 8].map((at) => bytes.readUInt32LE(at)), [2, bytes.length]);
    const length = bytes.readUInt32LE(12), scene = JSON.parse(bytes.toString("utf8", 20, 20 + length));
    return { scene, binary: bytes.subarray(28 + length) };
}

function glbCorners(bytes) {
    const { scene, binary } = glbParts(bytes);
    const { bufferView, count } = scene.accessors[scene.meshes[0].primitives[0].indices];
    const { byteOffset } = scene.bufferViews[bufferView];
    return Array.from({ length: count }, (_, i) => binary.readUInt32LE(byteOffset + 4 * i));
}

/** Triangles, points - edges + triangles, and edges that are not met once in each direction. */
function topology(corners) {
    const edges = new Set(), points = new Set(corners);
    for (let i = 0; i < corners.length; i++) edges.add(corners[i] + 1e9 * corners[i % 3 === 2 ? i - 2 : i + 1]);
    const open = [...edges].filter((edge) => !edges.has((edge % 1e9) * 1e9 + Math.floor(edge / 1e9))).length;
    const triangles = corners.length / 3;
    return { triangles, euler: points.size - (edges.size + open) / 2 + triangles, open };
}

const words = (key, triangles) => WORDS[key].replace("{triangles}", triangles.toLocaleString("en"));
const report = (visit) => visit.text("#take [role=status]");

visitTest("a torus is saved closed, with Euler's number 0, as mesh makes it", { link: TORUS }, async (visit) => {
    await visit.unfold("take");
    for (const [format, cornersOf] of [["stl", stlCorners], ["glb", glbCorners]]) {
        const begin = Date.now(), { name, bytes } = await visit.saved(() => save(visit, format).click());
        console.log(`128 cells of a torus as .${format}: ${Date.now() - begin} ms, ${bytes.length} bytes`);
        assert.equal(name, `torus.${format}`);
        const { triangles, euler, open } = topology(cornersOf(bytes));
        assert.deepEqual([euler, open], [0, 0]);
        assert.ok(triangles > 50_000);
        assert.ok(bytes.equals(await expected(visit, format, 128)), `not the bytes of mesh: .${format}`);
        assert.ok((await report(visit)).startsWith(words("take.mesh.closed", triangles)));
    }
});

visitTest("letters, a box, planes, colours and cells count", { link: CUT }, async (visit) => {
    await visit.unfold("take");
    await cells(visit).selectOption("64");
    const { name, bytes } = await visit.saved(() => save(visit, "glb").click());
    assert.equal(name, "surface.glb");
    assert.ok(bytes.equals(await expected(visit, "glb", 64)));
    const { scene, binary } = glbParts(bytes);
    const colours = scene.materials.map((material) => material.pbrMetallicRoughness.baseColorFactor.join());
    assert.equal(new Set(colours).size, 2);
    const { count, min, max } = scene.accessors[0];
    for (let i = 0; i < count; i++) {
        const [x, y, z] = [0, 4, 8].map((at) => binary.readFloatLE(12 * i + at));
        assert.ok(0.75 * x - 0.55 * y + 0.4 * z < 0.3001 && z < 0.6251, `beyond a plane: ${[x, y, z]}`);
    }
    assert.ok(min.every((x, i) => x > [-1.7501, -1.5001, -1.0001][i]) && max.every((x) => x < 2.2501));
    const { triangles, open } = topology(glbCorners(bytes));
    assert.ok(open > 0);
    assert.ok((await report(visit)).startsWith(words("take.mesh.open", triangles)));

    await visit.page.evaluate(() => {
        const { store } = window.algsurfPage, { parameters } = store.get();
        store.set({ parameters: { ...parameters, b: { ...parameters.b, value: 0.25 } } });
    });
    const other = await visit.saved(() => save(visit, "glb").click());
    assert.ok(!other.bytes.equals(bytes));
    assert.ok(other.bytes.equals(await expected(visit, "glb", 64)));
});

visitTest("complex space has no triangles, and it is said", { link: TORUS }, async (visit) => {
    await visit.unfold("take");
    const hint = visit.page.locator("#take .hint").first();
    for (const complex of [true, false]) {
        await visit.page.evaluate((complex) => window.algsurfPage.store.set({
            complex: complex ? { sigma: 0, delta: 0.2, imaginary: {} } : null,
        }), complex);
        for (const format of ["stl", "glb"]) assert.equal(await save(visit, format).isDisabled(), complex);
        assert.equal(await hint.textContent(), WORDS[complex ? "take.mesh.complex" : "take.mesh.hint"]);
        assert.ok(await visit.button("take.png").isEnabled());
    }
});

visitTest("where nothing is there is no file, and it is said", { link: TORUS.replace("sphere:3", "sphere:1") }, async (visit) => {
    let downloads = 0;
    visit.page.on("download", () => downloads++);
    await visit.unfold("take");
    for (const format of ["stl", "glb"]) {
        await save(visit, format).click();
        await visit.page.locator("#take [role=status]", { hasText: WORDS["take.mesh.none"] }).waitFor();
        await visit.until(() => document.querySelector("#take progress").parentNode.hidden);
    }
    assert.equal(downloads, 0);
});

visitTest("meanwhile the page draws, and it can be cancelled", { link: SLOW }, async (visit) => {
    const { page } = visit;
    let downloads = 0;
    page.on("download", () => downloads++);
    await visit.unfold("take");
    await cells(visit).selectOption("256");
    await save(visit, "stl").click();
    const progress = page.locator("#take progress");
    for (let value = 0; value === 0; value = await progress.evaluate((node) => node.value)) await page.waitForTimeout(5);
    await visit.type("x^2 + y^2 + z^2 = 1");
    await visit.until(({ equation }) => equation === "x^2 + y^2 + z^2 = 1");
    await visit.settled();
    assert.ok(await progress.isVisible(), "it was ready too soon to tell");
    assert.ok(await save(visit, "glb").isDisabled());
    await visit.button("take.cancel").click();
    await progress.waitFor({ state: "hidden" });
    assert.ok(await save(visit, "glb").isEnabled());
    assert.equal(downloads, 0);
});
