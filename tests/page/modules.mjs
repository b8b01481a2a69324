// modules.mjs - modules of the page that need no browser, loaded by node.
import { cpSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after } from "node:test";
import { PAGE } from "./settings.mjs";

// Node takes files named .js for modules where a package says so, and the page is none.
const folder = mkdtempSync(join(tmpdir(), "page-"));
after(() => rmSync(folder, { recursive: true }));
writeFileSync(join(folder, "package.json"), '{"type": "module"}');
cpSync(PAGE, folder, { recursive: true });

/** The exports of a module by its path without ".js". */
export const part = (name) => import(join(folder, `${name}.js`));
