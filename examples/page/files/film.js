// film.js - an animation: the pictures of a turn, or of a letter that goes through its range, one after the
// other.
import { circle } from "../picture/camera.js";
import { Film } from "./png.js";

const WEBM = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm"];

/** The kind of WebM that this browser records, or undefined. */
export function webmType() {
    if (typeof MediaRecorder === "undefined" || !HTMLCanvasElement.prototype.captureStream) return undefined;
    return WEBM.find((type) => MediaRecorder.isTypeSupported(type));
}

/** State number i of a sweep { kind: "turn" | "let", name, pictures }, as render --sweep has it. */
export function stateAt(state, sweep, i) {
    if (sweep.kind === "turn")
        return { ...state, camera: circle(state.camera, (2 * Math.PI * i) / sweep.pictures) };
    const p = state.parameters[sweep.name];
    const share = sweep.pictures > 1 ? i / (sweep.pictures - 1) : 0;
    const value = p.from + (p.to - p.from) * share;
    return { ...state, parameters: { ...state.parameters, [sweep.name]: { ...p, value } } };
}

/** A sink for the pictures of a WebM, which is recorded as it plays. */
class Recording {
    constructor({ width, height, rate }) {
        this.canvas = document.createElement("canvas");
        Object.assign(this.canvas, { width, height });
        this.rate = rate;
        this.pictures = [];
    }

    async add(picture) {
        this.pictures.push(await createImageBitmap(new ImageData(picture.data, picture.width)));
    }

    async end(signal) {
        const context = this.canvas.getContext("2d"),
            parts = [];
        const recorder = new MediaRecorder(this.canvas.captureStream(this.rate), {
            mimeType: webmType(),
            videoBitsPerSecond: 12e6,
        });
        recorder.addEventListener("dataavailable", ({ data }) => parts.push(data));
        const stopped = new Promise((resolve) => recorder.addEventListener("stop", resolve));
        context.fillStyle = "#fff"; // a film has no alpha
        recorder.start();
        for (const picture of [...this.pictures, this.pictures.at(-1)]) {
            if (signal.aborted) break;
            context.fillRect(0, 0, this.canvas.width, this.canvas.height);
            context.drawImage(picture, 0, 0);
            await new Promise((resolve) => setTimeout(resolve, 1000 / this.rate));
        }
        recorder.stop();
        await stopped;
        for (const picture of this.pictures) picture.close();
        signal.throwIfAborted();
        return new Blob(parts, { type: "video/webm" });
    }
}

/** The file; onProgress(share from 0 to 1), signal: an AbortSignal. */
export async function filmOf(painter, state, sweep, options, { onProgress, signal }) {
    const { width, height, rate, format, quality } = options;
    const alpha = state.colours.background === "none";
    const film =
        format === "webm"
            ? new Recording({ width, height, rate })
            : new Film({ width, height, rate, alpha, pictures: sweep.pictures });
    for (let i = 0; i < sweep.pictures; i++) {
        const part = (share) => onProgress((i + share) / sweep.pictures);
        const picture = await painter.image(stateAt(state, sweep, i), {
            width,
            height,
            quality,
            antialias: 4,
            onProgress: part,
            signal,
        });
        await film.add(picture);
    }
    return film.end(signal);
}
