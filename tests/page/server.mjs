// server.mjs - the page from a sub-folder of a plain web server on this machine: no special headers, no fallback.
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, join, normalize } from "node:path";

export const SUBFOLDER = "/some/where/";
const TYPES = {
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript",
    ".css": "text/css",
    ".json": "application/json",
    ".webmanifest": "application/manifest+json",
    ".svg": "image/svg+xml",
    ".png": "image/png",
    ".wasm": "application/wasm",
};

/** { address, close() }: the files of a folder. */
export async function serve(folder) {
    const server = createServer(async (request, response) => {
        const path = normalize(decodeURIComponent(new URL(request.url, "http://here").pathname));
        const name = path.slice(SUBFOLDER.length) || "index.html";
        try {
            if (!path.startsWith(SUBFOLDER)) throw new Error("outside");
            const body = await readFile(join(folder, name));
            response.writeHead(200, { "Content-Type": TYPES[extname(name)] ?? "application/octet-stream" });
            response.end(body);
        } catch {
            response.writeHead(404).end();
        }
    });
    await new Promise((done) => server.listen(0, "127.0.0.1", done));
    return {
        address: `http://127.0.0.1:${server.address().port}${SUBFOLDER}`,
        close() {
            server.closeAllConnections();
            return new Promise((done) => server.close(done));
        },
    };
}
