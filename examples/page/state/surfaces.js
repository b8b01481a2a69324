// surfaces.js - the catalogue: equation, letters with value and range, what is shown, from where, colours.
//
// Names and two sentences about each are in texts/: "name.KEY" and "surface.KEY".  Views are those that the
// program render chooses, some of them turned; all are for pictures that are wider than high.

// Sides differ in hue and are equally light, so that brightness tells of form alone.
const PALETTES = {
    blue: ["#69b5ff", "#f6a245"],
    violet: ["#b5a6f9", "#dbaa38"],
    gold: ["#dbaa38", "#b5a6f9"],
    slate: ["#99b5d3", "#fa9969"],
    copper: ["#fa9969", "#99b5d3"],
    leaf: ["#8ebf61", "#db99e6"],
    plum: ["#db99e6", "#8ebf61"],
    teal: ["#4bc2c4", "#fe957c"],
    red: ["#ed5050", "#99b5d3"],
};

function surface(name, palette, equation, view) {
    const { radius, centre = [0, 0, 0], eye, at = [0, 0, 0], up = [0, 0, 1], fov = 25, letters = {} } = view;
    const [outside, inside] = PALETTES[palette];
    const range = ([value, from, to]) => ({ value, from, to });
    const entries = Object.entries(letters).map(([letter, numbers]) => [letter, range(numbers)]);
    return Object.freeze({
        name,
        equation,
        parameters: Object.fromEntries(entries),
        extent: { kind: "sphere", size: [radius], centre },
        camera: { eye, lookAt: at, up, fov },
        colours: { outside, inside, background: "none" },
    });
}

/** In the order in which they are shown. */
export const SURFACES = [
    surface("barth", "blue",
        "4((3+sqrt(5))/2*x^2 - y^2)((3+sqrt(5))/2*y^2 - z^2)((3+sqrt(5))/2*z^2 - x^2) - " +
            "(2+sqrt(5))(x^2+y^2+z^2-1)^2",
        { radius: 2, eye: [8.33, -5.15, 0.52] }),
    surface("clebsch", "blue",
        "81(x^3+y^3+z^3) - 189(x^2 y+x^2 z+y^2 x+y^2 z+z^2 x+z^2 y) + 54x y z + 126(x y+x z+y z) - " +
            "9(x^2+y^2+z^2) - 9(x+y+z) + 1",
        { radius: 2.3, eye: [10.14, -3.7, 3.28], at: [-0.03, -0.08, 0], up: [1, 1, 1] }),
    surface("cayley", "leaf", "4(x^2 + y^2 + z^2) + 16x y z = 1",
        { radius: 1.1, eye: [2.04, -3.465, 1.66], at: [-0.11, -0.16, -0.16], up: [-1, -1, -1] }),
    surface("kummer", "slate", "(x^2+y^2+z^2 - m^2)^2 = (3m^2-1)/(3-m^2) ((1-z)^2 - 2x^2)((1+z)^2 - 2y^2)",
        { radius: 2.2, eye: [8.03, -2.36, 6.52], at: [-0.03, 0.06, 0.07],
            letters: { m: [1.14, 1.02, 1.7] } }),
    surface("togliatti", "violet",
        "64(x-1)(x^4 - 4x^3 - 10x^2 y^2 - 4x^2 + 16x - 20x y^2 + 5y^4 + 16 - 20y^2) - " +
            "5sqrt(5-sqrt(5))(2z - sqrt(5-sqrt(5)))(4(x^2+y^2-z^2) + (1+3sqrt(5)))^2",
        { radius: 6, eye: [15.85, -20.83, 11.98], at: [0.07, -0.16, -0.36] }),
    surface("labs", "blue",
        "x(x^6 - 21x^4 y^2 + 35x^2 y^4 - 7y^6) + 7z((x^2+y^2)^3 - 8z^2 (x^2+y^2)^2 + 16z^4 (x^2+y^2)) " +
            "- 64z^7 - (z + 51.94261459481465076650)((z+1)(x^2+y^2) - 0.07852820149698521536z^3 - " +
            "4.15836059228801701763z^2 - 4.14714348896551232572z - 1.18816593807147873508)^2",
        { radius: 5, eye: [16.35, -14.02, 8.86], at: [0.14, -0.12, -0.41] }),
    surface("endrass", "teal",
        "64(x^2-1)(y^2-1)((x+y)^2-2)((x-y)^2-2) = (4(1+sqrt(2))(x^2+y^2)^2 - (8(2+sqrt(2))z^2 + " +
            "2(2+7sqrt(2)))(x^2+y^2) + 16z^4 - 8(1-2sqrt(2))z^2 + 1 + 12sqrt(2))^2",
        { radius: 4.3, eye: [4.61, -1.92, 20.18], at: [-0.23, 0.09, 0.06], up: [-0.7071, 0.2947, 0.6428] }),
    surface("chmutov", "slate",
        "(2(2(2x^2-1)^2-1)^2-1) + (2(2(2y^2-1)^2-1)^2-1) + (2(2(2z^2-1)^2-1)^2-1) + 1",
        { radius: 1.75, eye: [3.773, -5.558, 3.186], at: [0.004, -0.074, -0.127] }),
    surface("decic", "blue",
        "8(x^2 - (7+3sqrt(5))/2*y^2)(y^2 - (7+3sqrt(5))/2*z^2)(z^2 - (7+3sqrt(5))/2*x^2)(x^4+y^4+z^4 " +
            "- 2x^2 y^2 - 2x^2 z^2 - 2y^2 z^2) + (11+5sqrt(5))/2*(x^2+y^2+z^2-1)^2 (x^2+y^2+z^2 - " +
            "(3-sqrt(5))/2)^2",
        { radius: 2, eye: [6.08, -6.08, 5.17] }),
    surface("sarti", "violet",
        "243(33sqrt(5)((x^2 y^2+z^2)-(x^2 z^2+y^2))((x^2 z^2+y^2)-(x^2+y^2 z^2))((x^2 " +
            "y^2+z^2)-(x^2+y^2 z^2)) + 19((x^2 y^2+z^2)(x^2 z^2+y^2)((x^2 y^2+z^2)+(x^2 z^2+y^2)) + (x^2 " +
            "z^2+y^2)(x^2+y^2 z^2)((x^2 z^2+y^2)+(x^2+y^2 z^2)) + (x^2+y^2 z^2)(x^2 y^2+z^2)((x^2+y^2 " +
            "z^2)+(x^2 y^2+z^2))) + 10((x^2 y^2+z^2)^3+(x^2 z^2+y^2)^3+(x^2+y^2 z^2)^3) - " +
            "14(x^4+y^4+z^4+1)((x^2 y^2+z^2)(x^2 z^2+y^2)+(x^2 z^2+y^2)(x^2+y^2 z^2)+(x^2+y^2 z^2)(x^2 " +
            "y^2+z^2)) + 2(x^4+y^4+z^4+1)^2 (x^2 y^2+x^2 z^2+y^2 z^2+x^2+y^2+z^2) - 6(x^4+y^4+z^4+1)((x^2 " +
            "y^2+z^2)^2+(x^2 z^2+y^2)^2+(x^2+y^2 z^2)^2) - 352x^2 y^2 z^2 (x^2 y^2+x^2 z^2+y^2 " +
            "z^2+x^2+y^2+z^2) + 336x^2 y^2 z^2 (x^4+y^4+z^4+1) + 48(x^2 y^2+z^2)(x^2 z^2+y^2)(x^2+y^2 " +
            "z^2)) = 22(x^2+y^2+z^2+1)^6",
        { radius: 4, eye: [11.12, -14.66, 8.76], at: [-0.06, -0.03, 0.03] }),
    surface("boy", "blue",
        "64(1-z)^3 z^3 - 48(1-z)^2 z^2 (3x^2+3y^2+2z^2) + 12(1-z)z(27(x^2+y^2)^2 - 24z^2 (x^2+y^2) + " +
            "36sqrt(2) y z (y^2-3x^2) + 4z^4) + (9x^2+9y^2-2z^2)(-81(x^2+y^2)^2 - 72z^2 (x^2+y^2) + " +
            "108sqrt(2) x z (x^2-3y^2) + 4z^4)",
        { radius: 1.9, centre: [0, 0, 1], eye: [-0.395, 0.884, -4.559], at: [0.16, 0.051, 0.992],
            up: [0, 1, 0] }),
    surface("steiner", "copper", "x^2 y^2 + x^2 z^2 + y^2 z^2 + x y z = 0",
        { radius: 0.8, eye: [1.03, -1.79, 1.17], at: [-0.01, 0.02, 0.05] }),
    surface("crosscap", "plum", "4x^2 (x^2+y^2+z^2+z) + y^2 (y^2+z^2-1) = 0",
        { radius: 1.3, eye: [2.677, -3.611, 2.144], at: [-0.054, -0.036, 0.009] }),
    surface("klein", "copper",
        "(x^2+y^2+z^2+2y-1)((x^2+y^2+z^2-2y-1)^2 - 8z^2) + 16x z(x^2+y^2+z^2-2y-1) = 0",
        { radius: 6.3, centre: [0, 0.26, 0], eye: [-5.08, -11.43, 9.63], at: [-0.07, 0.58, 0.38],
            up: [0.0668, 0.1603, 0.9848] }),
    surface("whitney", "blue", "x^2 z + y^2 = 0",
        { radius: 2, eye: [5.263, -2.382, 1.736], at: [0.382, 0.059, -0.705] }),
    surface("cartan", "violet", "z(x^2+y^2) = x^3",
        { radius: 3.5, eye: [6.57, -8.71, 5.31], at: [-0.09, 0, 0.11] }),
    surface("plucker", "slate", "z(x^2+y^2) = x^2 - y^2",
        { radius: 1.6, eye: [4.907, 0.549, 3.768], at: [-0.111, -0.1, 0.174],
            up: [-0.1722, -0.0223, 0.9848] }),
    surface("cusp", "violet", "z^3 + x z + y = 0",
        { radius: 2, eye: [-7.033, 2.384, 3.92], at: [-0.171, 0.031, -0.296] }),
    surface("swallowtail", "leaf", "256z^3 - 128x^2 z^2 + 16x^4 z + 144x y^2 z - 4x^3 y^2 - 27y^4 = 0",
        { radius: 6, eye: [-16.94, -2.3, 11.72], at: [-0.18, -0.13, -0.28], up: [0.1722, 0.0223, 0.9848] }),
    surface("monkey", "copper", "z = x^3 - 3x y^2",
        { radius: 1.4, eye: [4.262, -3.22, 4.489], at: [0.053, 0.024, -0.032], up: [-0.205, 0.158, 0.9659] }),
    surface("fermat", "plum", "x^3 + y^3 + z^3 = 1",
        { radius: 3.5, eye: [0.39, 14.18, 9.92], at: [-0.26, 0.09, -0.11], up: [-0.008, -0.1735, 0.9848] }),
    surface("markov", "slate", "x^2 + y^2 + z^2 = x y z + k",
        { radius: 4.2, eye: [9.8, -12.94, 6.97], at: [0.12, -0.27, -0.6], letters: { k: [3.9, 0, 6] } }),
    surface("hyperboloid", "blue", "x^2 + y^2 - z^2 = a",
        { radius: 2.5, eye: [6.43, -8.41, 4.8], at: [0.05, -0.07, -0.18], letters: { a: [0.5, -1, 1] } }),
    surface("sphere", "blue", "x^2 + y^2 + z^2 = 1",
        { radius: 1.2, eye: [2.93, -3.6, 2.14] }),
    surface("torus", "copper", "(x^2+y^2+z^2 + R^2 - r^2)^2 = 4R^2 (x^2+y^2)",
        { radius: 3.6, eye: [5.43, -9.05, 6.76], at: [0.12, -0.19, -0.33],
            letters: { R: [2.5, 1, 2.5], r: [0.9, 0.1, 1] } }),
    surface("cyclide", "teal", "(x^2+y^2+z^2 + 8 - d^2)^2 = 4((3x-d)^2 + 8y^2)",
        { radius: 7.1, centre: [-0.88, 0, 0], eye: [12.38, 1.75, 13.5], at: [-0.85, 0.03, -0.03],
            up: [-0.3392, -0.0439, 0.9397], letters: { d: [1.5, 0.2, 4] } }),
    surface("cassini", "leaf", "((x+a)^2+y^2)((x-a)^2+y^2) + z^2 = b",
        { radius: 2, eye: [3.502, -4.416, 2.631], at: [0.092, 0.049, -0.035],
            letters: { a: [1, 0, 1.5], b: [1.1, 0.2, 2] } }),
    surface("lemniscate", "violet", "(x^2+y^2+z^2)^2 = 2*2.7^2*(x^2 - y^2 - z^2)",
        { radius: 4, eye: [3.39, -12.35, 4.25], at: [0.16, 0.02, -0.06] }),
    surface("tangle", "teal", "x^4 - 5x^2 + y^4 - 5y^2 + z^4 - 5z^2 + a = 0",
        { radius: 3.7, eye: [6.12, -12.51, 7.19], at: [-0.05, -0.16, -0.22], letters: { a: [11.8, 6, 18] } }),
    surface("chair", "leaf", "(x^2+y^2+z^2 - 0.95*5^2)^2 = 0.8((z-5)^2 - 2x^2)((z+5)^2 - 2y^2)",
        { radius: 6, eye: [15.9, -18, 7], at: [-0.05, -0.03, 0.03] }),
    surface("pillow", "plum", "x^4 + y^4 + z^4 = x^2 + y^2 + z^2",
        { radius: 1.9, eye: [4.03, -5.89, 3.24], at: [0, -0.07, -0.12] }),
    surface("cube", "slate", "x^4 + y^4 + z^4 = 1",
        { radius: 1.5, eye: [3.028, -4.582, 2.745], at: [0, -0.041, -0.067] }),
    surface("genus2", "blue", "2y(y^2-3x^2)(1-z^2) + (x^2+y^2)^2 - (9z^2-1)(1-z^2) = 0",
        { radius: 2.2, eye: [3.501, -4.218, 4.581], at: [0.2, 0.104, -0.046],
            up: [-0.1571, 0.2057, 0.9659] }),
    surface("rings", "copper",
        "((x^2+y^2-1)^2+z^2)((y^2+z^2-1)^2+x^2)((z^2+x^2-1)^2+y^2) = a^2 (1 + 3(x^2+y^2+z^2))",
        { radius: 1.4, eye: [3.529, -2.73, 2.683], at: [-0.028, 0.011, 0.05],
            up: [-0.069, 0.0532, 0.9962], letters: { a: [0.03, 0.01, 0.15] } }),
    surface("decocube", "leaf",
        "((x^2+y^2-0.64)^2+(z^2-1)^2)((y^2+z^2-0.64)^2+(x^2-1)^2)((z^2+x^2-0.64)^2+(y^2-1)^2) = a",
        { radius: 1.7, eye: [3.617, -4.773, 2.764], at: [0, -0.038, -0.064],
            letters: { a: [0.02, 0.005, 0.1] } }),
    surface("hunt", "teal", "4(x^2+y^2+z^2-13)^3 + 27(3x^2+y^2-4z^2-12)^2 = 0",
        { radius: 7.2, eye: [7.22, -9.69, -0.8], at: [-0.11, -0.1, 0.18], up: [0.3035, -0.3973, 0.866] }),
    surface("dome", "violet", "(x^2+y^2-z^2)^2 = 4y^2 (1-z^2)",
        { radius: 2.4, eye: [3.791, -5.228, 2.894], at: [-0.088, -0.15, -0.139] }),
    surface("heart", "red", "(x^2 + 9/4 y^2 + z^2 - 1)^3 = x^2 z^3 + 9/80 y^2 z^3",
        { radius: 1.6, eye: [1.37, -5.34, 0.96], at: [0.03, 0.03, 0.15] }),
    surface("dingdong", "copper", "x^2 + y^2 = (1-z) z^2",
        { radius: 3.5, eye: [6.18, -8.09, 3.56], at: [0.3, -0.39, -1.04] }),
    surface("zitrus", "gold", "x^2 + z^2 = y^3 (1-y)^3",
        { radius: 0.61, centre: [0, 0.51, 0], eye: [0.517, -0.34, 0.416], at: [-0.071, 0.43, -0.044] }),
    surface("octdong", "plum", "x^2 + y^2 + z^4 = z^2",
        { radius: 1.3, eye: [2.729, -3.573, 2.164], at: [-0.007, 0.009, 0.024] }),
    surface("zeck", "slate", "x^2 + y^2 = z^3 (1-z)",
        { radius: 0.72, centre: [0, 0, 0.475], eye: [1.226, -1.605, 1.524], at: [-0.021, 0.028, 0.549] }),
    surface("kolibri", "teal", "x^3 + x^2 z^2 = y^2",
        { radius: 3.5, eye: [9.63, -12.65, 7.57], at: [-0.03, -0.01, 0.02] }),
    surface("calypso", "blue", "x^2 + y^2 z = z^2",
        { radius: 3.5, eye: [8.89, -11.8, 7.13], at: [-0.11, -0.03, 0.09] }),
    surface("calyx", "leaf", "x^2 + y^2 z^3 = z^4",
        { radius: 3.5, eye: [8.46, -11.2, 6.95], at: [-0.13, 0.04, 0.24] }),
    surface("crixxi", "violet", "(y^2 + z^2 - 1)^2 + (x^2 + y^2 - 1)^3 = 0",
        { radius: 2.5, eye: [3.758, -4.902, 2.986], at: [-0.005, 0.023, 0.045] }),
    surface("daisy", "gold", "(x^2 - y^3)^2 = (z^2 - y^2)^3",
        { radius: 2.4, eye: [6.6, -8.41, 4.96], at: [0.14, 0.05, -0.1] }),
    surface("distel", "leaf", "x^2 + y^2 + z^2 + c (x^2+y^2)(x^2+z^2)(y^2+z^2) = 1",
        { radius: 0.99, eye: [2.489, -3.123, 1.992], at: [0.042, 0.079, 0.079],
            letters: { c: [1000, 0, 2000] } }),
    surface("dullo", "copper", "(x^2+y^2+z^2)^2 = x^2+y^2",
        { radius: 1.6, eye: [2.046, -2.679, 1.499], at: [0.024, -0.031, -0.082] }),
    surface("durchblick", "blue", "x^3 y + x z^3 + y^3 z + z^3 + 5z = 0",
        { radius: 6, centre: [0, -1.71, 0], eye: [16.85, -23.84, 13.2], at: [-0.04, -1.74, 0] }),
    surface("eistuete", "plum", "(x^2+y^2)^3 = 4x^2 y^2 (z^2+1)",
        { radius: 3.5, eye: [9.71, -12.75, 7.61], at: [-0.02, -0.02, 0] }),
    surface("limao", "gold", "x^2 = y^3 z^3",
        { radius: 3.5, eye: [9.4, -12.3, 7.46], at: [-0.03, 0.03, 0.09] }),
    surface("himmel", "blue", "x^2 = y^2 z^2",
        { radius: 3.5, eye: [9.41, -12.45, 7.49], at: [-0.08, -0.02, 0.07] }),
    surface("nepali", "red", "(x y - z^3 - 1)^2 = (1 - x^2 - y^2)^3",
        { radius: 2.4, centre: [0, 0, -0.43], eye: [2.281, -2.985, 0.914], at: [0.104, -0.135, -0.788] }),
    surface("stern", "blue", "400(x^2 y^2 + y^2 z^2 + x^2 z^2) = (1 - x^2 - y^2 - z^2)^3",
        { radius: 1.1, eye: [2.271, -2.831, 1.827], at: [0.044, 0.085, 0.085] }),
    surface("subway", "slate", "x^2 y^2 + (z^2-1)^3 = 0",
        { radius: 3, eye: [5.684, -7.149, 4], at: [0.219, 0.005, -0.272] }),
    surface("twilight", "violet", "(z^3-2)^2 + (x^2+y^2-3)^3 = 0",
        { radius: 4.1, centre: [0, 0, 0.28], eye: [4.643, -6.079, 3.925], at: [-0.003, 0.004, 0.292] }),
    surface("visavis", "copper", "x^2 - x^3 + y^2 + y^4 + z^3 - z^4 = 0",
        { radius: 3.5, eye: [9.39, -11.62, 6.92], at: [0.37, 0.2, -0.14] }),
    surface("xano", "teal", "x^4 + z^3 = y z^2",
        { radius: 1.2, eye: [3.367, 2.827, 1.852], at: [-0.051, 0.215, -0.189] }),
    surface("zweiloch", "slate", "x^3 y + x z^3 + y^3 z + z^3 + 7z^2 + 5z = 0",
        { radius: 9.3, centre: [0, -1.71, 0], eye: [26.07, -36.06, 20.46], at: [-0.11, -1.79, 0] }),
    surface("seepferdchen", "leaf", "(x^2-y^3)^2 = (x+y^2) z^3",
        { radius: 2.5, eye: [6.75, -8.11, 5.21], at: [0.3, 0.33, 0.17] }),
    surface("solitude", "plum", "x^2 y z + x y^2 + y^3 + y^3 z = x^2 z^2",
        { radius: 3.5, eye: [11.18, 8.5, 7.01], at: [-0.09, -0.1, 0.28] }),
];

/** The surface of that name, or undefined. */
export function surfaceOf(name) {
    return SURFACES.find((surface) => surface.name === name);
}
