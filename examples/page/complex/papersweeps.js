// papersweeps.js - what Sanjuan-Estrada, Casado and Garcia show of complex space (Rendering (complex)
// algebraic surfaces, figures 2 to 11), as sweeps: surface, coefficient p_k with an imaginary part, delta in
// degrees. The paper prints neither the imaginary parts nor where the eye stands: these are ours, those of
// the target gallery-complex (examples/gallery_complex.cmake), where something vanishes or appears, but for
// the sphere and Boy's surface: narrower sectors show what was there and what comes around it.

const ball = (radius, centre = [0, 0, 0]) => ({ kind: "sphere", size: [radius], centre });
const camera = (eye, lookAt, fov) => ({ eye, lookAt, up: [0, 0, 1], fov });

const SPHERE = { extent: ball(2), camera: camera([2.6, -3.2, 1.9], [0, 0, 0], 56) };
const TANGLE = { extent: ball(3.7), camera: camera([6.12, -12.51, 7.19], [-0.05, -0.16, -0.22], 33) };
const WHITNEY = { extent: ball(2), camera: camera([5.263, -2.382, 1.736], [0, 0, 0], 46) };
const STEINER = { extent: ball(0.8), camera: camera([1.2, -1.7, 1.31], [-0.01, 0.02, 0.05], 40) };
const BOY = { extent: ball(1.9, [0, 0, 1]), camera: camera([3.9, -5, 1.3], [0, 0, 1], 36) };

const imaginary = (k, to) => ({ what: "imaginary", k, from: 0, to });

/** Each: name of the surface in the catalogue, its view, sigma and delta, imaginary parts, and the sweep. */
export const PAPER_SWEEPS = [
    {
        surface: "sphere",
        view: SPHERE,
        delta: 20,
        imaginary: { 0: 0.3 },
        sweep: { what: "delta", from: 0, to: 30 },
    },
    { surface: "tangle", view: TANGLE, delta: 1, imaginary: { 0: 2 }, sweep: imaginary(0, 2) },
    { surface: "tangle", view: TANGLE, delta: 10, imaginary: { 2: 0.3 }, sweep: imaginary(2, 0.3) },
    { surface: "whitney", view: WHITNEY, delta: 10, imaginary: { 0: 1.5 }, sweep: imaginary(0, 1.5) },
    { surface: "steiner", view: STEINER, delta: 5, imaginary: {}, sweep: { what: "delta", from: 0, to: 5 } },
    ...[10, 10, 4, 2, 0.5].map((part, k) => ({
        surface: "boy",
        view: BOY,
        delta: 3,
        imaginary: { [k]: part },
        sweep: imaginary(k, part),
    })),
];
