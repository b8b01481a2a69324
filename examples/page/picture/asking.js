// asking.js - questions that must be answered soon, whatever else is being worked on.
import { constantsOf, initialState, isName, LIMITS, usualRange } from "../state/state.js";

const PATIENCE = 600; // milliseconds that an answer may be kept waiting by a picture that takes long
const LONGEST_FIT = 1500; // milliseconds

/** What compile says; a picture that keeps all workers busy for long is given up for it. */
async function compile(painter, equation, values) {
    const { count } = painter, timer = setTimeout(() => painter.stop(count), PATIENCE);
    try {
        return await painter.ask("compile", equation, values);
    } finally {
        clearTimeout(timer);
    }
}

/** Values for the free letters of an equation: those known, 1 for new ones; and what compile says then. */
export async function compiledWith(painter, equation, known) {
    if (equation.length > LIMITS.equation) throw Object.assign(new Error(), { code: "LONG" });
    const compiled = await compile(painter, equation, constantsOf({ parameters: known }));
    if (compiled.letters.length > LIMITS.parameters) throw Object.assign(new Error(), { code: "LETTERS" });
    const parameters = {};
    for (const name of compiled.letters.filter(isName)) {
        const [from, to] = usualRange(1);
        parameters[name] = known[name] ?? { value: 1, from, to };
    }
    if (compiled.missing.length === 0) return { parameters, compiled };
    return { parameters, compiled: await compile(painter, equation, constantsOf({ parameters })) };
}

/** Extent and camera that suit a state, or null when that takes too long. */
export function fit(painter, state, size) {
    return new Promise((resolve, reject) => {
        const timer = setTimeout(() => {
            resolve(null);
            // Takes its place, and ends it.
            painter.ask("fit", initialState(), size, { latest: true }).catch(() => {});
        }, LONGEST_FIT);
        painter
            .ask("fit", state, size, { latest: true })
            .then(resolve, reject)
            .finally(() => clearTimeout(timer));
    });
}
