// asking.js - questions that must be answered soon, whatever else is being worked on.
import { initialState } from "../state/state.js";

const PATIENCE = 600; // milliseconds that an answer may be kept waiting by a picture that takes long
const LONGEST_FIT = 1500; // milliseconds

/** What compile says; a picture that keeps all workers busy for long is given up for it. */
export async function compile(painter, equation, values) {
    const timer = setTimeout(() => painter.stop(), PATIENCE);
    try {
        return await painter.ask("compile", equation, values);
    } finally {
        clearTimeout(timer);
    }
}

/** Extent and camera that suit a state, or null when that takes too long. */
export function fit(painter, state, size) {
    return new Promise((resolve, reject) => {
        const timer = setTimeout(() => {
            resolve(null);
            painter.ask("fit", initialState(), size, { latest: true }).catch(() => {}); // takes its place, and ends it
        }, LONGEST_FIT);
        painter
            .ask("fit", state, size, { latest: true })
            .then(resolve, reject)
            .finally(() => clearTimeout(timer));
    });
}
