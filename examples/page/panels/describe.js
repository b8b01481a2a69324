// describe.js - name, title and the sentences of the surface that is shown, also for those who do not see it.
import { element, fill } from "../base/dom.js";
import { isBox } from "../state/state.js";

const SEEN = 0.001; // the share of pixels above which a surface is seen at all

export function titleOf(state, text) {
    return state.name ? text(`name.${state.name}`) : text("surface.own");
}

/** The part of the panel that tells about the surface. */
export function showAbout(room, state, text) {
    const degree = state.picture
        ? [element("p", { class: "degree" }, text("about.degree", { degree: state.picture.degree }))]
        : [];
    const key = `surface.${state.name}`;
    const words = state.name && text.has(key) ? text(key) : text("about.own");
    fill(room, ...degree, element("p", {}, words));
}

/** The ball or the box that is shown. */
function extentOf({ extent }, text) {
    const told = (x) => String(Number(x.toPrecision(6)));
    const list = (numbers) => `(${numbers.map(told).join(", ")})`;
    const { size, centre } = extent, words = { centre: list(centre) };
    if (isBox(extent)) return text("seen.box", { ...words, size: list(size) });
    return text("seen.sphere", { ...words, radius: told(size[0]) });
}

/** Sentences: name, degree, how much of the picture the surface fills, what is shown of space. */
export function sentenceOf(state, text) {
    const { picture } = state;
    const name = titleOf(state, text);
    if (!picture) return name;
    const share = picture.hits / Math.max(1, picture.rays ?? picture.pixels), extent = extentOf(state, text);
    if (share < SEEN) return `${text("seen.nothing", { name, degree: picture.degree })} ${extent}`;
    const percent = Math.round(100 * share);
    const complex = state.complex ? ` ${text("seen.complex")}` : "";
    return `${text("seen.surface", { name, degree: picture.degree, percent })} ${extent}${complex}`;
}
