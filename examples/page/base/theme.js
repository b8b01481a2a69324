// theme.js - light or dark: as the system has it, or as chosen.
import { memory } from "./dom.js";

const dark = matchMedia("(prefers-color-scheme: dark)");

function apply(theme) {
    if (theme) document.documentElement.dataset.theme = theme;
    else delete document.documentElement.dataset.theme;
}

export function loadTheme() {
    const kept = memory.get("theme");
    apply(kept === "light" || kept === "dark" ? kept : null);
}

/** The other one; where that is the system's, the page follows the system again. */
export function switchTheme() {
    const system = dark.matches ? "dark" : "light";
    const now = document.documentElement.dataset.theme ?? system;
    const next = now === "dark" ? "light" : "dark";
    apply(next === system ? null : next);
    memory.set("theme", next === system ? null : next);
}
