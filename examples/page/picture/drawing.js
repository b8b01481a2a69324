// drawing.js - one picture in the making: bands of rows, handed out from the top, and where they have come.

const BAND_TIME = 7; // milliseconds
const TILE = 16; // rows; a band of whole tiles has no work twice
const FIRST_ROWS = 16; // as long as nothing is known
const ROUNDS = 2; // bands for each worker, at least

export class Drawing {
    ended = false;
    isVisible = false;
    degree = 0;
    counts = { rays: 0, hits: 0, undecided: 0, exact: 0, thin: 0 };
    workMs = 0; // summed over workers
    begin = performance.now();
    #nextRow = 0;
    #again = []; // bands of workers that crashed
    #done = []; // bands that have come
    #doneRows = 0;
    #retried = false;

    /** options: state, width, height, quality, antialias, order, msPerPixel, workers, onBand, onDone,
     * onFail */
    constructor(options) {
        Object.assign(this, options);
        this.data = new Uint8ClampedArray(4 * this.width * this.height);
    }

    get isHandedOut() {
        return this.#nextRow >= this.height && this.#again.length === 0;
    }

    /** Have all bands come? */
    get isWhole() {
        return this.#doneRows === this.height;
    }

    /** The part of the rows that is done. */
    get share() {
        return this.#doneRows / this.height;
    }

    get workMsPerPixel() {
        return this.#doneRows > 0 ? this.workMs / (this.#doneRows * this.width) : 0;
    }

    /** The next rows to be drawn, { begin, end }; there are some. */
    nextBand() {
        if (this.#again.length > 0) return this.#again.pop();
        const begin = this.#nextRow;
        this.#nextRow = Math.min(this.height, begin + this.#rows());
        return { begin, end: this.#nextRow };
    }

    /** As many as take BAND_TIME: tiles of 16 rows, or a half, a quarter of them ... */
    #rows() {
        const known = this.#doneRows > 0;
        const perRow = (known ? this.workMsPerPixel : this.msPerPixel) * this.width;
        const fair = Math.ceil(this.height / (this.workers * ROUNDS * TILE)) * TILE;
        const rows = Math.min(known ? Infinity : FIRST_ROWS, fair, BAND_TIME / perRow);
        if (rows >= TILE) return Math.floor(rows / TILE) * TILE;
        return rows >= 8 ? 8 : rows >= 4 ? 4 : rows >= 2 ? 2 : 1;
    }

    /** A band has come. */
    take(band, picture) {
        this.data.set(picture.data, 4 * this.width * band.begin);
        this.#done.push(band);
        this.#doneRows += band.end - band.begin;
        this.workMs += picture.ms;
        this.degree = picture.degree;
        for (const name in this.counts) this.counts[name] += picture[name];
        this.onBand(band);
        if (this.isWhole) this.onDone();
    }

    /** A band failed: after a crash or for want of memory it is tried once more; one that had to wait,
     * always. */
    fail(band, error) {
        if (["E_UNBEGUN", "E_CANCELLED"].includes(error.code)) {
            this.#again.push(band);
            return;
        }
        const again = !this.#retried && ["E_CRASH", "E_TRAP", "E_NO_MEMORY"].includes(error.code);
        if (!again && !(this.#again.length > 0 && error.code === "E_CRASH")) return this.onFail(error);
        this.#retried = true;
        this.#again.push(band);
    }

    /** Bands between two rows that have come. */
    doneRows(begin, end) {
        if (this.isWhole) return [{ begin, end }];
        return this.#done.filter((band) => band.begin >= begin && band.end <= end);
    }
}
