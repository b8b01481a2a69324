// program.js - a complete C program that draws a state with the library, and writes a PAM or PPM picture.
import { axesOf } from "../picture/camera.js";
import { stemOf } from "./command.js";
import { isBox, isInOwnColours, radiusOf } from "../state/state.js";

const EDGE = 0.45, DISTANCE = 16; // of a light that is told by angles, as render has it

/** A string literal; other bytes than printable ASCII are octal, three digits, so that nothing can follow. */
function literal(text) {
    const bytes = [...new TextEncoder().encode(text)];
    const one = (b) => {
        if (b === 34 || b === 92 || b === 63) return `\\${String.fromCharCode(b)}`;
        return b >= 32 && b < 127 ? String.fromCharCode(b) : `\\${b.toString(8).padStart(3, "0")}`;
    };
    const pieces = [];
    for (let i = 0; i < bytes.length; i += 80) pieces.push(`"${bytes.slice(i, i + 80).map(one).join("")}"`);
    return pieces.join("\n                           ") || '""';
}

const number = (x) => String(x);
const braces = (numbers) => `{${numbers.map(number).join(", ")}}`;
const bytesOf = (colour) => `{${[1, 3, 5].map((i) => `0x${colour.slice(i, i + 2)}`).join(", ")}}`;
const scaled = (v, x) => v.map((c) => c * x);
const sum = (...vectors) => [0, 1, 2].map((i) => vectors.reduce((all, v) => all + v[i], 0));
const cross = (a, b) =>
    [0, 1, 2].map((i) => a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3]);

/** Place and edges of the wide light, as render makes it of two angles. */
function lightOf(state) {
    const { right, up, forward } = axesOf(state.camera);
    const aside = (state.light.azimuth * Math.PI) / 180, above = (state.light.elevation * Math.PI) / 180;
    const direction = sum(
        scaled(right, Math.cos(above) * Math.sin(aside)),
        scaled(forward, -Math.cos(above) * Math.cos(aside)),
        scaled(up, Math.sin(above)),
    );
    const far = DISTANCE * radiusOf(state.extent), way = scaled(direction, -far);
    let u = cross(way, up);
    if (!(Math.hypot(...u) > 1e-6 * far)) u = cross(way, right);
    const across = Math.hypot(...u);
    return {
        position: sum(state.extent.centre, scaled(direction, far)),
        edgeU: scaled(u, (EDGE * far) / across),
        edgeV: scaled(cross(u, way), EDGE / across),
    };
}

function colourLines(name, colour) {
    return [`    const unsigned char ${name}_srgb[3] = ${bytesOf(colour)};`];
}

function clipLines({ clip }) {
    if (clip.length === 0) return [];
    const planes = clip.map(([a, b, c, d]) => `{${braces([a, b, c])}, ${number(d)}}`);
    return [
        `    const algsurf_plane planes[] = {${planes.join(", ")}};`,
        `    check(algsurf_scene_set_clip(scene, planes, ${clip.length}));`,
    ];
}

function lightLines(state) {
    if (!state.light) return [];
    const { position, edgeU, edgeV } = lightOf(state);
    return [
        `    const algsurf_light light = {.position = ${braces(position)},`,
        "                                 .colour = {1, 1, 1},",
        `                                 .edge_u = ${braces(edgeU)},`,
        `                                 .edge_v = ${braces(edgeV)}};`,
        "    check(algsurf_scene_set_lights(scene, &light, 1));",
    ];
}

function thinLines(state) {
    const isThin = !state.complex && (state.thin ?? true);
    return isThin ? ["    check(algsurf_scene_set_thin(scene, material.outside));"] : [];
}

function complexLines(state) {
    if (!state.complex) return [];
    const { sigma, delta, imaginary } = state.complex;
    const parts = Object.entries(imaginary).map(([k, v]) => `[${k}] = ${number(v)}`);
    const sector = `.sector = {${number(sigma)}, ${number(delta)}}`;
    const indent = "                                         ";
    const spaceLines = parts.length
        ? [
              `${indent}${sector},`,
              `${indent}.imaginary = imaginary,`,
              `${indent}.imaginary_count = sizeof imaginary / sizeof *imaginary};`,
          ]
        : [`${indent}${sector}};`];
    return [
        ...(parts.length ? [`    const double imaginary[] = {${parts.join(", ")}};`] : []),
        "    const algsurf_complex_space space = {.size = sizeof space,",
        ...spaceLines,
        "    check(algsurf_scene_set_complex_space(scene, &space));",
    ];
}

function sideLines({ outside, inside }) {
    return [
        ...colourLines("outside", outside),
        ...colourLines("inside", inside),
        "    check(algsurf_srgb_decode(outside_srgb, material.outside));",
        "    check(algsurf_srgb_decode(inside_srgb, material.inside));",
    ];
}

function backgroundLines({ background }) {
    if (background === "none") return ["    check(algsurf_scene_set_background(scene, NULL));"];
    if (background === null) return [];
    return [
        ...colourLines("background", background),
        "    double background[3];",
        "    check(algsurf_srgb_decode(background_srgb, background));",
        "    check(algsurf_scene_set_background(scene, background));",
    ];
}

/** The text of the file. */
export function programOf(state, { width, height, quality = "standard", antialias = 4 }) {
    const { eye, lookAt, up, fov } = state.camera, { size, centre } = state.extent;
    const letters = Object.entries(state.parameters);
    const given = letters.length > 0 ? "constants" : "NULL", shape = isBox(state.extent) ? "BOX" : "SPHERE";
    const drawn = state.complex ? "standard" : quality;
    const isClear = state.colours.background === "none", channels = isClear ? 4 : 3;
    const edges = isBox(state.extent) ? size : [size[0], 0, 0];
    const file = `${stemOf(state)}.${isClear ? "pam" : "ppm"}`;
    const head = isClear
        ? `"P7\\nWIDTH %d\\nHEIGHT %d\\nDEPTH 4\\nMAXVAL 255\\nTUPLTYPE RGB_ALPHA\\nENDHDR\\n"`
        : `"P6\\n%d %d\\n255\\n"`;
    const constants = letters.map(([name, p]) => `{${literal(name)}, ${number(p.value)}}`).join(", ");
    return [
        `/* Draws ${file} with libalgsurf:  cc -O2 program.c -lalgsurf && ./a.out`,
        " * or, in the library's folder:    " +
            "cc -O2 -Iinclude program.c $(find lib -name '*.c') -lm -pthread && ./a.out */",
        "#include <stdio.h>",
        "#include <stdlib.h>",
        "#include <algsurf/algsurf.h>",
        "",
        "static void check(algsurf_status status) {",
        "    if (status == ALGSURF_OK) return;",
        '    fprintf(stderr, "%s\\n", algsurf_status_text(status));',
        "    exit(1);",
        "}",
        "",
        "int main(void) {",
        `    enum { WIDTH = ${width}, HEIGHT = ${height} };`,
        `    const char *equation = ${literal(state.equation)};`,
        ...(letters.length > 0 ? [`    const algsurf_constant constants[] = {${constants}};`] : []),
        "    algsurf_surface *surface;",
        `    check(algsurf_surface_from_equation(equation, ${given}, ${letters.length}, &surface, NULL));`,
        "",
        "    /* what is shown, and from where */",
        "    algsurf_scene *scene;",
        "    algsurf_camera camera;",
        `    const algsurf_extent extent = {ALGSURF_EXTENT_${shape}, ${braces(centre)}, ${braces(edges)}};`,
        `    const double eye[3] = ${braces(eye)}, look_at[3] = ${braces(lookAt)}, up[3] = ${braces(up)};`,
        "    check(algsurf_scene_create(surface, &scene));",
        `    check(algsurf_camera_pinhole(eye, look_at, up, ${number(fov)}, &camera));`,
        "    check(algsurf_scene_set_extent(scene, &extent));",
        "    check(algsurf_scene_set_camera(scene, &camera));",
        ...clipLines(state),
        "",
        "    /* colours and light */",
        "    algsurf_light usual[ALGSURF_MAX_LIGHTS];",
        "    algsurf_lighting lighting = {.size = sizeof lighting};",
        "    check(algsurf_scene_get_lighting(scene, usual, &lighting));",
        "    algsurf_material material = *lighting.material;",
        ...(isInOwnColours(state) ? [] : sideLines(state.colours)),
        "    check(algsurf_scene_set_material(scene, &material));",
        ...backgroundLines(state.colours),
        ...lightLines(state),
        ...thinLines(state),
        ...complexLines(state),
        `    check(algsurf_scene_set_quality(scene, ALGSURF_QUALITY_${drawn.toUpperCase()}));`,
        `    check(algsurf_scene_set_antialias(scene, ${antialias}));`,
        "    check(algsurf_scene_set_antialias_threshold(scene, 0.1));",
        "",
        `    static unsigned char pixels[${channels} * WIDTH * HEIGHT];`,
        "    const algsurf_render_options options = {",
        "        .size = sizeof options, .width = WIDTH, .height = HEIGHT};",
        "    const algsurf_picture picture = {",
        `        .size = sizeof picture, .pixels = pixels, .format = ALGSURF_RGB${isClear ? "A" : ""}8};`,
        "    check(algsurf_render(scene, &options, &picture, NULL));",
        "",
        `    FILE *file = fopen("${file}", "wb");`,
        "    if (!file) return 1;",
        `    fprintf(file, ${head}, WIDTH, HEIGHT);`,
        "    fwrite(pixels, sizeof pixels, 1, file);",
        "    algsurf_scene_free(scene);",
        "    algsurf_surface_free(surface);",
        "    return fclose(file) == 0 ? 0 : 1;",
        "}",
        "",
    ].join("\n");
}
