// pool.js - the workers: who has room, who answers, who is replaced.
//
// A worker that crashes, that has taken too much memory, that is stuck in what nobody wants any more, or that
// keeps an ask waiting behind a band is replaced by a new one.  The job that it was at is refused with
// E_CRASH or E_TIME, or with E_UNBEGUN where a band had to give way; so are bands that it had not begun.
// Asks that it had not begun go to another worker.

const MOST_WORKERS = 64;
const AT_ONCE = 2; // bands a worker, so that it never waits for the next one
const WATCH = 200; // milliseconds between two looks at the workers
const UNWANTED = 400; // milliseconds a worker may go on with what was cancelled,
const ASK_TIME = 20e3; // with an ask,
const WAIT_TIME = 3e3; // with a band while an ask waits; a band that is wanted may take as long as it does
const MOST_MEMORY = 512 * 2 ** 20; // bytes that an idle worker may hold
const CANCELLED = { code: "E_CANCELLED", message: "given up for a newer one" };
const UNBEGUN = { code: "E_UNBEGUN", message: "its worker was replaced" };

/** The number of workers: as the address says, else that of the processors less one. */
function usualSize() {
    const asked = Number(new URLSearchParams(location.search).get("workers"));
    if (asked >= 1 && asked <= MOST_WORKERS) return Math.floor(asked);
    return Math.max(1, (navigator.hardwareConcurrency || 2) - 1);
}

function newThread() {
    return new Worker(new URL("worker.js", import.meta.url), { type: "module" });
}

/** The compiled module; from a server that does not know the type of .wasm files, too. */
async function compileModule(url) {
    const response = await fetch(url);
    if (!response.ok) throw new Error(`${url}: ${response.status} ${response.statusText}`);
    if (response.headers.get("Content-Type") === "application/wasm")
        return WebAssembly.compileStreaming(response);
    return WebAssembly.compile(await response.arrayBuffer());
}

// Begun as soon as this file is there, while others are still loaded: the page begins with it.
const module = compileModule(new URL("../algsurf.wasm", import.meta.url));
module.catch(() => {}); // told by each worker that waits for it
const threads = Array.from({ length: usualSize() }, newThread);

export class Pool {
    #workers = [];
    #callbacks;
    #unsent = []; // urgent jobs from before there was a worker
    #count = 0; // of jobs
    #replaced = 0;
    #timer = null;

    constructor(callbacks) {
        this.#callbacks = callbacks;
        for (const thread of threads) this.#workers.push(this.#start(thread));
    }

    get size() {
        return this.#workers.length;
    }

    get statistics() {
        const memory = this.#workers.reduce((sum, worker) => sum + worker.memory, 0);
        return { workers: this.size, replaced: this.#replaced, memory };
    }

    /** Workers with room for a band, those with least to do first. */
    *free() {
        for (let load = 0; load < AT_ONCE; load++)
            for (const worker of this.#workers) if (worker.ready && worker.jobs.size === load) yield worker;
    }

    /** Resolves to the answer; without a worker: an ask, for the one with least to do. */
    send(job, worker = this.#leastBusy()) {
        return new Promise((resolve, reject) => {
            Object.assign(job, { number: ++this.#count, resolve, reject, cancelled: false });
            if (!worker) this.#unsent.push(job);
            else this.#post(worker, job);
        });
    }

    #leastBusy() {
        const ready = this.#workers.filter((worker) => worker.ready);
        return ready.sort((a, b) => a.jobs.size - b.jobs.size)[0];
    }

    #post(worker, job) {
        if (worker.jobs.size === 0) worker.since = performance.now();
        worker.jobs.set(job.number, job);
        worker.thread.postMessage({ job: job.number, kind: job.kind, args: job.args, urgent: job.urgent });
        this.#timer ??= setInterval(() => this.#watch(), WATCH);
    }

    /** Jobs that nobody wants any more are refused with E_CANCELLED, and not begun. */
    cancel(isMeant) {
        for (const job of this.#unsent.filter(isMeant)) job.reject(CANCELLED);
        this.#unsent = this.#unsent.filter((job) => !isMeant(job));
        for (const worker of this.#workers) {
            const meant = [...worker.jobs.values()].filter((job) => !job.cancelled && isMeant(job));
            for (const job of meant) {
                job.cancelled = true;
                job.unwantedSince = performance.now();
                job.reject(CANCELLED);
            }
            if (meant.length) worker.thread.postMessage({ cancel: meant.map((job) => job.number) });
        }
    }

    /** The answer of a worker of its own, that ends with it: nobody waits behind what takes long.
     * onProgress(share from 0 to 1), signal: an AbortSignal. */
    alone(kind, args, { onProgress, signal }) {
        const thread = newThread();
        return new Promise((resolve, reject) => {
            signal.addEventListener("abort", () => reject(signal.reason));
            thread.onerror = (event) => {
                event.preventDefault();
                reject({ code: "E_CRASH", message: `a worker stopped: ${event.message}` });
            };
            thread.onmessage = ({ data: { share, result, error } }) => {
                if (share !== undefined) onProgress(share);
                else if (error) reject(error);
                else if (result) resolve(result);
            };
            module.then((start) => {
                thread.postMessage({ start });
                thread.postMessage({ job: 1, kind, args });
            }, reject);
        }).finally(() => thread.terminate());
    }

    // ---- starting and replacing ----

    #start(thread = newThread()) {
        const worker = { thread, ready: false, jobs: new Map(), at: 0, since: performance.now(), memory: 0 };
        thread.onmessage = ({ data }) => this.#hear(worker, data);
        thread.onerror = (event) => {
            event.preventDefault();
            this.#replace(worker, { code: "E_CRASH", message: `a worker stopped: ${event.message}` });
        };
        module.then(
            (start) => thread.postMessage({ start }),
            (error) => this.#callbacks.onError({ code: "E_LOAD", message: error.message }),
        );
        return worker;
    }

    #hear(worker, data) {
        worker.since = performance.now();
        if (data.begun) {
            worker.at = data.begun;
            return;
        }
        worker.at = 0;
        if (data.ready) {
            worker.ready = true;
            this.#callbacks.onStatus({ kind: "ready", workers: this.size });
            for (const job of this.#unsent.splice(0)) this.#post(worker, job);
        } else {
            this.#answer(worker, data);
        }
        this.#callbacks.onRoom();
    }

    #answer(worker, { job: number, result, error, memory = worker.memory }) {
        const job = worker.jobs.get(number);
        worker.jobs.delete(number);
        worker.memory = memory;
        if (worker.jobs.size === 0 && memory > MOST_MEMORY) this.#replace(worker, null);
        if (!job || job.cancelled) return;
        if (error?.code === "E_NO_MEMORY") this.#replace(worker, { code: "E_CRASH", message: error.message });
        if (error) job.reject(error);
        else if (result !== undefined) job.resolve(result);
    }

    /** A new worker for this one; the job that it was at is refused for that reason. */
    #replace(worker, reason) {
        const position = this.#workers.indexOf(worker);
        if (position < 0) return;
        worker.thread.terminate();
        this.#workers[position] = this.#start();
        this.#replaced++;
        for (const [number, job] of worker.jobs) {
            if (job.cancelled) continue;
            if (number === worker.at) job.reject(reason ?? UNBEGUN);
            else if (job.urgent) this.#unsent.push(job);
            else job.reject(UNBEGUN);
        }
        if (reason && reason !== UNBEGUN) this.#callbacks.onStatus({ kind: "replaced", ...reason });
    }

    /** Looks for workers that are stuck. */
    #watch() {
        const now = performance.now();
        for (const worker of [...this.#workers]) {
            const jobs = [...worker.jobs.values()], current = worker.jobs.get(worker.at);
            if (jobs.length === 0) continue;
            const silent = now - worker.since;
            const unwanted = current?.cancelled && now - current.unwantedSince > UNWANTED;
            const waits = !current?.urgent && jobs.some((job) => job.urgent && !job.cancelled);
            if (unwanted && silent > UNWANTED) this.#replace(worker, null);
            else if (current && waits && silent > WAIT_TIME) this.#replace(worker, UNBEGUN);
            else if ((!current || current.urgent) && silent > ASK_TIME)
                this.#replace(worker, { code: "E_TIME", message: "it takes too long" });
        }
        if (this.#workers.every((worker) => worker.jobs.size === 0)) {
            clearInterval(this.#timer);
            this.#timer = null;
        }
    }

    /** For tests: the worker throws, as one that crashes does. */
    kill(number) {
        this.#workers[number]?.thread.postMessage({ crash: true });
    }
}
