// Runs a program for WebAssembly's system interface (WASI) in node, as a shell would run it:
//
//     node --no-warnings wasm_run.mjs PROGRAM ARGUMENT...
//
// It sees the working directory, and for arguments that are absolute names the folder of the root that they are in.
// (Not the root itself: wasi-libc takes "/" and "." for the same.)
import { readFile } from "node:fs/promises";
import { WASI } from "node:wasi";

const [program, ...args] = process.argv.slice(2);
const folders = args.filter((arg) => /^\/[^/]+\//.test(arg)).map((arg) => `/${arg.split("/")[1]}`);
const wasi = new WASI({
    version: "preview1",
    args: [program, ...args],
    preopens: { ".": ".", ...Object.fromEntries(folders.map((folder) => [folder, folder])) },
    returnOnExit: true,
});
const imports = { wasi_snapshot_preview1: wasi.wasiImport }; // getImportObject() is not there before node 19.8
const { instance } = await WebAssembly.instantiate(await readFile(program), imports);
process.exitCode = wasi.start(instance);
