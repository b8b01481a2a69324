// record.js - a sweep as a film: an animated PNG, every picture drawn with antialiasing, there and back.
import { Film } from "./png.js";
import { complexAt, thereAndBack } from "../complex/sweep.js";

const RATE = 15; // pictures a second
const THERE = 30; // pictures from one end to the other, both ends included
const SIZE = { width: 480, height: 360 };

/** Draws the film of a sweep of a state; onProgress(share), signal as for painter.image(). */
export async function filmOf(painter, state, sweep, { onProgress, signal }) {
    const last = THERE - 1;
    const draw = async (i) => {
        const complex = complexAt(state.complex, sweep, thereAndBack(i, 2 * last));
        const options = { ...SIZE, quality: "standard", antialias: 4, signal };
        const picture = await painter.image({ ...state, complex }, options);
        signal.throwIfAborted();
        onProgress((i + 1) / THERE);
        return picture;
    };
    const pictures = [];
    for (let i = 0; i <= last; i++) pictures.push(await draw(i));
    const all = [...pictures, ...pictures.slice(1, -1).reverse()];
    const alpha = state.colours.background === "none";
    const film = new Film({ ...SIZE, pictures: all.length, rate: RATE, alpha });
    for (const picture of all) await film.add(picture);
    return film.end();
}
