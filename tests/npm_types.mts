// Compiled, never run, by cli_npm: what the types of the npm package allow, and what they do not.
import { load, compile, AlgsurfError, HIT, Picture, Rays, Surface } from "algsurf";

const module: WebAssembly.Module = await compile();
const algsurf = await load(module);
const version: string = algsurf.version;
const values: number[] = algsurf.realRoots(new Float64Array([-2, 0, 1]), { lo: 0 }).map((r) => r.root);
const widths = algsurf.complexRoots([1, [2, 3]]).map(({ box }) => box.re[1] - box.re[0]);
const surface: Surface = algsurf.surface("x^2 + y^2 = a", { a: 2 });
const same: Surface = algsurf.surfaceFromTerms([[2, 0, 0, 1], [0, 2, 0, 1], [0, 0, 0, -2]]);
const rays: Rays = { origin: [[0], [0], [0]], direction: [[1], [0], [0]], tMin: [1] };
const hits = algsurf.firstHits(surface, rays, { box: [1, 1, 1] });
const x: number = hits.state[0] === HIT ? hits.position[0][0] : NaN;
const picture: Picture = algsurf.render(same, {
    width: 4,
    height: 3,
    rows: [0, 2],
    camera: { eye: [4, 3, 2], orthographic: 3 },
    extent: { sphere: 2, centre: [0, 0, 1] },
    quality: "full",
    complexSpace: { delta: 1, imaginary: [1] },
    distances: true,
});
const image = new ImageData(picture.data, picture.width, picture.height);
const t: number | undefined = picture.t?.[0];
surface[Symbol.dispose]();
try {
    algsurf.surface("x $ y");
} catch (error) {
    if (error instanceof AlgsurfError) console.log(error.code, error.status + 1, error.offset ?? 0);
}
console.log(version, values, widths, x, image, t, algsurf.memoryBytes);

// @ts-expect-error no such option
algsurf.render(same, { width: 4, height: 3, colour: "red" });
// @ts-expect-error a sphere or a box
algsurf.firstHits(same, rays, { radius: 2 });
// @ts-expect-error surfaces come from load()
new Surface();
// @ts-expect-error no text
algsurf.realRoots("1 2 3");
