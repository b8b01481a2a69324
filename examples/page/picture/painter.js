// painter.js - pictures by several workers; the main thread only puts bands where they belong.
//
//     const painter = new Painter({ onPicture, onStatus, onError });
//     painter.draw(state, { canvas, width, height, moving: false });
//     const { degree } = await painter.ask("compile", "x^2 + y^2 = z^2", {});
//
// A picture is a Drawing (drawing.js): its rows are handed out in bands of some milliseconds, two to a worker
// so that none waits.  What is newer goes first: a picture at rest ends everything of the older one; a moving
// one, coarse enough to be short, is finished unless it is late.  Asks are answered between two bands.  Thumbnails
// make way for both.  While nobody sees the page only what is saved is drawn.
import { Coarseness } from "./coarse.js";
import { Pool } from "./pool.js";
import { Drawing } from "./drawing.js";
import { LIMITS } from "../state/state.js";

const STAGES = [
    { stage: "plain", quality: "standard", antialias: 1 },
    { stage: "smooth", quality: "standard", antialias: 4 },
    { stage: "full", quality: "full", antialias: 4 },
];
const SLOW = 1500; // milliseconds: a first coarse picture that takes longer is drawn by doubles alone
const LATE = 150; // milliseconds: a moving picture that takes longer may be given up
const PATIENCE = 120; // milliseconds after which a picture at rest is shown band by band
const GIVE_WAY = 100; // milliseconds that a band of a thumbnail may keep others waiting
const QUIET = 500; // milliseconds without another wish, before thumbnails go on
const THUMBNAIL_TIME = 2000; // milliseconds for one of its bands, and for all of them; it is given up then
const THIN_SHARE = 1 / 8; // of the height, in samples: with so many, moving pictures show what is thin
const TOO_LONG = { code: "E_TIME", message: "it takes too long" };
const KINDS = ["compile", "fit", "pick", "isolate", "refine", "complexRoots", "nothing", "room", "thumbnail"];

/** What kinds of work go first. */
const ORDER = { shown: 0, thumbnail: 1, image: 2, refined: 3 };

export class Painter {
    #pool;
    #callbacks;
    #coarseness = new Coarseness();
    #drawings = []; // in work
    #request = null; // the newest draw
    #waiting = null; // a moving one that is not begun
    #count = 0; // of requests
    #shown = 0; // number of the request on the canvas
    #quietFrom = 0; // when thumbnails go on
    #since = 0; // when the canvas last changed, or was asked to
    #latest = new Map(); // kind of ask: its newest job
    #thinShown = false;
    #seen = ""; // the state of the last moving picture
    #slow = ""; // the surface whose coarse pictures are drawn by doubles alone

    /** onPicture(report), onStatus(status), onError(error) are told what happens. */
    constructor({ onPicture = () => {}, onStatus = () => {}, onError = () => {} } = {}) {
        this.#callbacks = { onPicture, onStatus, onError };
        this.#pool = new Pool({
            onRoom: () => this.#handOut(),
            onStatus: (status) => onStatus(status),
            onError: (error) => onError(error),
        });
        document.addEventListener("visibilitychange", () => this.#handOut());
    }

    get statistics() {
        return { ...this.#pool.statistics, factor: this.#coarseness.factor, drawings: this.#drawings.length };
    }

    // ---- the canvas ----

    /** Shows the state on the canvas, as soon as can be; the newest call wins. */
    draw(state, { canvas, width, height, moving = false }) {
        const [columns, rows] = [width, height].map((x) =>
            Math.min(LIMITS.side, Math.max(1, Math.round(x) || 1)),
        );
        const request = {
            state: structuredClone(state),
            canvas,
            width: columns,
            height: rows,
            moving,
            number: ++this.#count,
        };
        if (this.#shown === this.#count - 1) this.#since = performance.now();
        this.#request = request;
        this.#waiting = null;
        this.#makeWay();
        if (!moving) {
            this.#endAll();
            const isSeen = JSON.stringify(state) === this.#seen; // else a coarse picture comes first
            this.#begin(isSeen ? request : { ...request, moving: true, then: request }, 0);
        } else if (this.#mayBegin()) {
            this.#begin(request, 0);
        } else {
            this.#waiting = request;
        }
    }

    /** How many pictures were asked for. */
    get count() {
        return this.#count;
    }

    /** How far the newest request is: isShown, on the canvas; waitMs, how long it has not been; isDrawn, it is
     * in work, ms for so long, the part `share` of it is done, and isFirst: nothing as good is shown yet. */
    get progress() {
        const drawing = this.#drawings.find((one) => one.request), now = performance.now();
        const isShown = this.#shown === this.#count;
        const waitMs = isShown ? 0 : now - this.#since;
        if (!drawing) return { isShown, waitMs, isDrawn: false, ms: 0, share: 0 };
        const { begin, share, stageNumber } = drawing;
        return { isShown, waitMs, isDrawn: true, ms: now - begin, share, isFirst: stageNumber === 0 };
    }

    /** Draws no more until the next draw(); count: unless there was one since. */
    stop(count = this.#count) {
        if (count !== this.#count) return;
        this.#request = this.#waiting = null;
        this.#endAll();
    }

    /** Ends what is drawn for the canvas. */
    #endAll(which = () => true) {
        for (const drawing of this.#drawings)
            if (drawing.request && which(drawing)) this.#drop(drawing);
    }

    #drop(drawing) {
        drawing.ended = true;
        this.#drawings = this.#drawings.filter((other) => other !== drawing);
        this.#pool.cancel((job) => job.drawing === drawing);
    }

    /** May a moving picture begin?  Not while another one has rows to be handed out, unless that is late. */
    #mayBegin() {
        this.#endAll((drawing) => !drawing.request.moving);
        const open = this.#drawings.filter((drawing) => drawing.request);
        for (const drawing of open) {
            if (performance.now() - drawing.begin < LATE || drawing.share > 0.5) continue;
            this.#coarseness.late(drawing);
            this.#drop(drawing);
        }
        const left = this.#drawings.filter((drawing) => drawing.request);
        return left.length === 0 || (left.length === 1 && left[0].isHandedOut);
    }

    #begin(request, stageNumber) {
        const { state, width, height, moving } = request;
        const step = STAGES[stageNumber];
        const bounded = moving && this.#slow === surfaceIn(state);
        const factor = moving ? this.#coarseness.choose(width, height, this.#pool.size) : 1;
        const shown = moving && state.thin !== true && !this.#thinShown ? { ...state, thin: false } : state;
        const drawing = new Drawing({
            state: shown,
            width: Math.ceil(width / factor),
            height: Math.ceil(height / factor),
            quality: step.quality,
            antialias: step.antialias,
            bounded,
            order: stageNumber === 0 ? ORDER.shown : ORDER.refined,
            msPerPixel: this.#coarseness.msPerPixel,
            workers: this.#pool.size,
            onBand: (band) => this.#show(drawing, band),
            onDone: () => this.#finished(drawing),
            onFail: (error) => this.#failed(drawing, error),
        });
        Object.assign(drawing, { request, stageNumber, factor, stage: moving ? "moving" : step.stage });
        this.#add(drawing);
        if (moving && !bounded) this.#watch(drawing);
    }

    #watch(drawing) {
        setTimeout(() => {
            if (drawing.ended || drawing.isWhole) return;
            if (document.hidden) this.#watch(drawing);
            else this.#tooSlow(drawing);
        }, SLOW);
    }

    /** A coarse picture that is not done in time is begun again, by doubles alone, as coarse as can be. */
    #tooSlow(drawing) {
        const { request } = drawing;
        this.#slow = surfaceIn(request.state);
        this.#coarseness.slowest();
        this.#drop(drawing);
        this.#callbacks.onStatus({ kind: "slow" });
        if (request === this.#request || request.then === this.#request) this.#begin(request, 0);
        else this.#next();
    }

    #add(drawing) {
        this.#drawings.push(drawing);
        this.#drawings.sort((a, b) => a.order - b.order); // stable: older ones first
        this.#handOut();
    }

    /** Bands of a picture at rest are shown as they come, once it is late or over an older one of the same
     * state. */
    #show(drawing, band) {
        const { request, stageNumber } = drawing;
        if (request.moving || (stageNumber === 0 && performance.now() - drawing.begin < PATIENCE)) return;
        if (!drawing.isVisible) {
            drawing.isVisible = true;
            this.#put(drawing, 0, drawing.height);
        } else {
            this.#put(drawing, band.begin, band.end);
        }
    }

    /** Rows of the drawing that are done, onto the canvas. */
    #put(drawing, begin, end) {
        const { canvas, number } = drawing.request;
        if (number < this.#shown) return;
        this.#shown = number;
        this.#since = performance.now();
        const context = canvas.getContext("2d");
        fitBitmap(canvas, context, drawing);
        for (const rows of drawing.doneRows(begin, end)) {
            const data = drawing.data.subarray(4 * drawing.width * rows.begin, 4 * drawing.width * rows.end);
            context.putImageData(new ImageData(data, drawing.width), 0, rows.begin);
        }
    }

    #finished(drawing) {
        const { request, stageNumber } = drawing;
        this.#drawings = this.#drawings.filter((other) => other !== drawing);
        if (!drawing.isVisible) this.#put(drawing, 0, drawing.height);
        if (request.moving || !drawsThin(drawing)) this.#coarseness.learn(drawing);
        if (drawing.stage === "plain") this.#thinShown = drawing.counts.thin > THIN_SHARE * drawing.height;
        this.#report(drawing);
        if (request.moving) this.#seen = JSON.stringify(request.state);
        if (request.then && request.then === this.#request) return this.#begin(request.then, 0);
        if (request !== this.#request || request.moving) return this.#next();
        const last = request.state.complex ? 1 : STAGES.length - 1; // complex space has no full quality
        if (stageNumber < last) this.#begin(request, stageNumber + 1);
    }

    /** Begins the moving picture that waits. */
    #next() {
        const request = this.#waiting;
        if (!request || !this.#mayBegin()) return;
        this.#waiting = null;
        this.#begin(request, 0);
    }

    #report(drawing) {
        const { request, stage, factor, counts, degree } = drawing;
        this.#callbacks.onPicture({
            stage,
            width: drawing.width,
            height: drawing.height,
            factor,
            ms: performance.now() - drawing.begin,
            workers: this.#pool.size,
            degree,
            pixels: drawing.width * drawing.height,
            ...counts,
            state: request.state,
        });
    }

    #failed(drawing, error) {
        this.#drop(drawing);
        this.#callbacks.onError({ ...error, state: drawing.request?.state ?? null });
        this.#next();
    }

    // ---- work for the workers ----

    #handOut() {
        for (const worker of this.#pool.free()) {
            const drawing = this.#drawings.find((one) => !one.isHandedOut && !this.#rests(one));
            if (!drawing) break;
            this.#send(worker, drawing);
            if (drawing.isHandedOut && drawing.request?.moving) this.#next();
        }
    }

    #rests({ order }) {
        if (document.hidden) return order !== ORDER.image;
        return order === ORDER.thumbnail && performance.now() < this.#quietFrom;
    }

    #send(worker, drawing) {
        const band = drawing.nextBand();
        const { state, width, height, quality, antialias, bounded, factor } = drawing;
        const options = {
            width,
            height,
            rowBegin: band.begin,
            rowEnd: band.end,
            quality,
            antialias,
            bounded,
            factor,
        };
        const job = { kind: "band", args: [state, options], drawing, sent: performance.now() };
        const isThumbnail = drawing.order === ORDER.thumbnail;
        const timer = isThumbnail ? setTimeout(() => drawing.onFail(TOO_LONG), THUMBNAIL_TIME) : 0;
        this.#pool
            .send(job, worker)
            .then(
                (picture) => drawing.ended || drawing.take(band, picture),
                (error) => drawing.ended || drawing.fail(band, error),
            )
            .finally(() => clearTimeout(timer));
    }

    /** Soon no worker is kept by a thumbnail. */
    #makeWay() {
        const asked = performance.now();
        const keeps = ({ drawing, sent }) => drawing?.order === ORDER.thumbnail && sent < asked;
        this.#quietFrom = asked + QUIET;
        setTimeout(() => this.#pool.cancel(keeps), GIVE_WAY);
        setTimeout(() => this.#handOut(), QUIET + 1);
    }

    /** A drawing of its own, not for the canvas; resolves to its pixels. */
    #picture(state, options, order, { onProgress, signal } = {}) {
        return new Promise((resolve, reject) => {
            const { width, height, quality, antialias } = options;
            signal?.throwIfAborted();
            const drawing = new Drawing({
                state: structuredClone(state),
                width,
                height,
                quality,
                antialias,
                order,
                msPerPixel: this.#coarseness.msPerPixel,
                workers: this.#pool.size,
                onBand: () => {
                    onProgress?.(drawing.share);
                    const isLong = order === ORDER.thumbnail && drawing.workMs > THUMBNAIL_TIME;
                    if (isLong) drawing.onFail(TOO_LONG);
                },
                onDone: () => end(() => resolve({ width, height, data: drawing.data })),
                onFail: (error) => end(() => reject(error)),
            });
            const abort = () => end(() => reject(signal.reason));
            const end = (settle) => {
                signal?.removeEventListener("abort", abort);
                this.#drop(drawing);
                settle();
            };
            signal?.addEventListener("abort", abort);
            this.#add(drawing);
        });
    }

    /** A picture of any size, for saving; onProgress(share from 0 to 1), signal: an AbortSignal. */
    image(state, { width, height, quality = "standard", antialias = 4, onProgress, signal }) {
        return this.#picture(state, { width, height, quality, antialias }, ORDER.image, {
            onProgress,
            signal,
        });
    }

    /** Triangles for saving, as Engine makes them; by a worker of their own. */
    mesh(state, options, how) {
        return this.#pool.alone("mesh", [state, options], how);
    }

    /** A call of Engine; the last argument may be { latest: true }: an older ask of that kind is given up. */
    ask(kind, ...args) {
        if (!KINDS.includes(kind)) return Promise.reject(new TypeError(`no such ask: ${kind}`));
        const options = args.at(-1)?.latest !== undefined ? args.pop() : {};
        if (kind === "thumbnail") return this.#thumbnail(...args);
        const job = { kind, args: structuredClone(args), urgent: true };
        this.#makeWay();
        if (options.latest) {
            const older = this.#latest.get(kind);
            if (older) this.#pool.cancel((other) => other === older);
            this.#latest.set(kind, job);
        }
        return this.#pool.send(job).catch((error) => {
            if (error.code !== "E_CRASH") throw error;
            return this.#pool.send(job); // by another worker, once
        });
    }

    async #thumbnail(state, { width, height }) {
        const { extent, camera } = state;
        const whole = Array.isArray(extent?.size) && extent.size.length > 0 && Array.isArray(camera?.eye);
        const fitted = whole ? {} : await this.ask("fit", state, { width, height });
        const shown = { ...state, axes: false, box: false, extent: fitted.extent ?? extent, camera: fitted.camera ?? camera };
        const look = { width, height, quality: "standard", antialias: 4 };
        return this.#picture(shown, look, ORDER.thumbnail);
    }

    /** For tests: what a worker that crashes does. */
    kill(number) {
        this.#pool.kill(number);
    }
}

/** What a state's surface depends on. */
function surfaceIn({ equation, parameters }) {
    return JSON.stringify([equation, Object.entries(parameters ?? {}).map(([name, p]) => [name, p.value])]);
}

/** Does the drawing look for thin features, which moving pictures do without as a rule? */
function drawsThin({ state, stageNumber }) {
    return stageNumber > 0 || (state.thin ?? true);
}

/** Gives the canvas the size of the drawing, and what it showed, scaled, if it is to be replaced bit by
 * bit. */
function fitBitmap(canvas, context, { width, height, isWhole }) {
    if (canvas.width === width && canvas.height === height) return;
    const older = isWhole || canvas.width * canvas.height === 0 ? null : document.createElement("canvas");
    if (older) {
        older.width = canvas.width;
        older.height = canvas.height;
        older.getContext("2d").drawImage(canvas, 0, 0);
    }
    canvas.width = width;
    canvas.height = height;
    if (older) context.drawImage(older, 0, 0, width, height);
}
