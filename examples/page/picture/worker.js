// worker.js - a worker of the page: an Engine, and the jobs that painter.js sends it.
//
//     { start: module }                               a compiled WebAssembly.Module; answered by
//                                                     { ready: true }
//     { job, kind, args, urgent }                     kind: "band", or a call of Engine
//     { cancel: [job, ...] }                          those not begun are answered { job, cancelled: true }
//     { crash: true }                                 for tests: throws, as a worker that crashes does
//
// A job that is begun is told by { begun: job }, how far a mesh is by { job, share }.  Each job is answered by
// { job, result } or { job, error: { code, message, ... } }.  Between two jobs messages are read, so that a
// cancelled one is not begun; urgent ones come first.
import { Engine, EngineError } from "./engine.js";

let engine = null;
const jobs = [];
const tick = new MessageChannel(); // setTimeout would wait for some milliseconds
let waiting = false;

function plain(error) {
    if (error instanceof EngineError) return { ...error, code: error.code, message: error.message };
    return { code: "E_INTERNAL", message: String(error?.message ?? error) };
}

/** What a job gives, and the buffers that go with it. */
function done({ job, kind, args }) {
    if (kind === "band") {
        const picture = engine.render(...args);
        return [picture, [picture.data.buffer]];
    }
    if (kind === "mesh") {
        const made = engine.mesh(...args, (share) => postMessage({ job, share }));
        return [made, made.bytes ? [made.bytes.buffer] : []];
    }
    if (!["compile", "fit", "pick", "isolate", "refine", "complexRoots", "nothing", "room"].includes(kind))
        throw new EngineError("E_ARGUMENT", `no such call: ${kind}`);
    return [engine[kind](...args), []];
}

/** The next job, and then the next tick. */
tick.port1.onmessage = () => {
    waiting = false;
    const first = jobs.findIndex((job) => job.urgent);
    const [job] = jobs.splice(first >= 0 ? first : 0, 1);
    if (!job) return;
    postMessage({ begun: job.job });
    try {
        const [result, buffers] = done(job);
        postMessage({ job: job.job, result, memory: engine.memoryBytes }, buffers);
    } catch (error) {
        postMessage({ job: job.job, error: plain(error) });
    }
    goOn();
};

function goOn() {
    if (waiting || jobs.length === 0) return;
    waiting = true;
    tick.port2.postMessage(null);
}

function cancel(numbers) {
    for (const number of numbers) {
        const at = jobs.findIndex(({ job }) => job === number);
        if (at < 0) continue;
        jobs.splice(at, 1);
        postMessage({ job: number, cancelled: true });
    }
}

onmessage = ({ data }) => {
    if (data.start) {
        engine = new Engine(data.start);
        postMessage({ ready: true });
    } else if (data.cancel) {
        cancel(data.cancel);
    } else if (data.crash) {
        setTimeout(() => {
            throw new Error("a crash that was asked for");
        });
    } else {
        jobs.push(data);
        goOn();
    }
};
