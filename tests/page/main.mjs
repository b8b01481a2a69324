// main.mjs - runs tests, one file after the other, and prints a line for each; tests/check_page calls it.
//
//     node main.mjs FILE...
import { run } from "node:test";

const files = process.argv.slice(2);
let passed = 0, failed = 0;

/** A file that ends in an error is an event as well, named as its path; one that passes is not counted. */
function isFile(event) {
    return files.includes(event.name);
}

function reason({ details }) {
    const error = details.error?.cause ?? details.error;
    return String(error?.message ?? error).split("\n").map((line) => `        ${line}`).join("\n");
}

const acts = {
    "test:pass"(event) {
        if (isFile(event)) return;
        passed++;
        console.log(`ok      ${event.name} (${(event.details.duration_ms / 1000).toFixed(1)} s)`);
    },
    "test:fail"(event) {
        if (isFile(event) && event.details.error?.failureType === "subtestsFailed") return;
        failed++;
        console.log(`FAILED  ${event.name}\n${reason(event)}`);
    },
    "test:stdout": ({ message }) => process.stdout.write(message),
    "test:stderr": ({ message }) => process.stderr.write(message),
};
for await (const { type, data } of run({ files, concurrency: false })) acts[type]?.(data);
console.log(`${passed} passed, ${failed} failed`);
process.exitCode = failed > 0 || passed === 0 ? 1 : 0;
