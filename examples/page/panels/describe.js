// describe.js - name, title and the sentences of the surface that is shown, also for those who do not see it.
import { element, fill } from "../base/dom.js";

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

/** One sentence: name, degree, how much of the picture the surface fills, what is proved. */
export function sentenceOf(state, text) {
    const { picture } = state;
    const name = titleOf(state, text);
    if (!picture) return name;
    const share = picture.hits / Math.max(1, picture.rays ?? picture.pixels);
    if (share < SEEN) return text("seen.nothing", { name, degree: picture.degree });
    const percent = Math.round(100 * share);
    const complex = state.complex ? ` ${text("seen.complex")}` : "";
    return `${text("seen.surface", { name, degree: picture.degree, percent })}${complex}`;
}
