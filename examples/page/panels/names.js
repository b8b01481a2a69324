// names.js - surfaces of the catalogue by their names, and by what is like one.
import { SURFACES } from "../state/surfaces.js";

const MOST_WRONG = 3, MOST_LIKE = 3, LONGEST = 40;
const SHORT = 4; // letters: shorter words of a name do not stand for it

const plain = (words) =>
    words.normalize("NFD").replace(/\p{M}/gu, "").replace(/[^\p{L}\d]+/gu, " ").trim().toLowerCase();

/** Letters left out, added, replaced, or swapped with their neighbour, as cli_guess.c counts them. */
function distance(a, b) {
    const d = Array.from({ length: a.length + 1 }, (_, i) => [i]);
    for (let j = 0; j <= b.length; j++) d[0][j] = j;
    for (let i = 1; i <= a.length; i++)
        for (let j = 1; j <= b.length; j++) {
            const same = a[i - 1] === b[j - 1] ? 0 : 1;
            d[i][j] = Math.min(d[i - 1][j - 1] + same, d[i - 1][j] + 1, d[i][j - 1] + 1);
            if (i > 1 && j > 1 && a[i - 1] === b[j - 2] && a[i - 2] === b[j - 1])
                d[i][j] = Math.min(d[i][j], d[i - 2][j - 2] + 1);
        }
    return d[a.length][b.length];
}

const namesOf = ({ name }, text) => [name, plain(text(`name.${name}`))];

/** The surface of that name, or undefined. */
export function surfaceNamed(words, text) {
    const wanted = plain(words);
    return SURFACES.find((surface) => namesOf(surface, text).includes(wanted));
}

/** Surfaces whose names are like these words, the nearest first; none for what is not words alone. */
export function surfacesLike(words, text) {
    if (words.length > LONGEST || /[^\p{L}\p{M}\s'’.-]/u.test(words)) return [];
    const wanted = plain(words), most = Math.min(MOST_WRONG, Math.floor((wanted.length + 2) / 3));
    const far = (surface) => {
        const names = namesOf(surface, text);
        const parts = names[1].split(" ").filter((part) => part.length >= SHORT);
        return Math.min(...[...names, ...parts].map((name) => distance(wanted, name)));
    };
    const near = SURFACES.map((surface) => [far(surface), surface]).filter(([by]) => by <= most);
    return near.sort((a, b) => a[0] - b[0]).slice(0, MOST_LIKE).map(([, surface]) => surface);
}
