// Runs a program for WebAssembly's system interface (WASI) in node, as a shell would run it:
//
//     node --no-warnings wasm_run.mjs PROGRAM ARGUMENT...
//
// It sees the whole file system, and relative names start in the working directory.
import { readFile } from "node:fs/promises";
import { WASI } from "node:wasi";

const [program, ...args] = process.argv.slice(2);
const wasi = new WASI({
    version: "preview1",
    args: [program, ...args],
    env: { PWD: process.cwd() },
    preopens: { "/": "/", ".": "." },
    returnOnExit: true,
});
const { instance } = await WebAssembly.instantiate(await readFile(program), wasi.getImportObject());
process.exitCode = wasi.start(instance);
