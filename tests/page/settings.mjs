// settings.mjs - folders that tests/check_page tells, and native programs.
import { execFileSync } from "node:child_process";
import { createRequire } from "node:module";
import { join } from "node:path";

const told = (name) => {
    if (!process.env[name]) throw new Error(`${name} is not set: run tests/check_page`);
    return process.env[name];
};

/** The page as built; native programs; what npm installed; where pictures of the tests go. */
export const PAGE = told("CHECK_PAGE_FOLDER"), PROGRAMS = told("CHECK_PAGE_PROGRAMS");
export const MODULES = told("CHECK_PAGE_MODULES"), OUT = told("CHECK_PAGE_OUT");
export const BROWSER = told("CHECK_PAGE_BROWSER"), SOURCE = told("CHECK_PAGE_SOURCE");
export const MONKEY_SECONDS = Number(process.env.CHECK_PAGE_MONKEY ?? 20);

/** A module that npm installed for the tests. */
export const installed = createRequire(join(MODULES, "package.json"));

/** What a native program prints. */
export function native(program, words, options = {}) {
    return execFileSync(join(PROGRAMS, program), words, { encoding: "utf8", stdio: "pipe", ...options });
}
