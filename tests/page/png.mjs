// png.mjs - the pixels of PNG, PPM and PAM files with 8 bits a sample, as written by the programs and by the page.
import { inflateSync } from "node:zlib";

const CHANNELS = { 2: 3, 6: 4 };

function chunksOf(file) {
    const chunks = [];
    for (let at = 8; at < file.length; ) {
        const length = file.readUInt32BE(at);
        chunks.push({ name: file.toString("latin1", at + 4, at + 8), data: file.subarray(at + 8, at + 8 + length) });
        at += length + 12;
    }
    return chunks;
}

/** The filter of a row undone, in place. */
function restore(filter, row, above, step) {
    for (let i = 0; i < row.length; i++) {
        const left = i >= step ? row[i - step] : 0, up = above[i], corner = i >= step ? above[i - step] : 0;
        const p = left + up - corner;
        const distances = [Math.abs(p - left), Math.abs(p - up), Math.abs(p - corner)];
        const paeth = [left, up, corner][distances.indexOf(Math.min(...distances))];
        row[i] += [0, left, up, (left + up) >> 1, paeth][filter];
    }
}

/** { width, height, data: RGBA } of a PNG file; opaque when it has no alpha. */
export function decodePng(file) {
    const chunks = chunksOf(file);
    const head = chunks.find(({ name }) => name === "IHDR").data;
    const width = head.readUInt32BE(0), height = head.readUInt32BE(4), channels = CHANNELS[head[9]];
    if (head[8] !== 8 || !channels || head[12] !== 0) throw new Error(`PNG of another kind: ${head.toString("hex")}`);
    const packed = inflateSync(Buffer.concat(chunks.filter(({ name }) => name === "IDAT").map(({ data }) => data)));
    const data = new Uint8Array(4 * width * height).fill(255);
    let above = new Uint8Array(width * channels);
    for (let y = 0; y < height; y++) {
        const at = y * (width * channels + 1);
        const row = new Uint8Array(packed.subarray(at + 1, at + 1 + width * channels));
        restore(packed[at], row, above, channels);
        for (let x = 0; x < width; x++)
            for (let c = 0; c < channels; c++) data[4 * (y * width + x) + c] = row[channels * x + c];
        above = row;
    }
    return { width, height, data };
}

/** The same of a PPM or PAM file. */
export function decodePnm(file) {
    const pam = /^P7\nWIDTH (\d+)\nHEIGHT (\d+)\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\n/;
    const head = file.toString("latin1", 0, 200), [all, w, h] = pam.exec(head) ?? /^P6\n(\d+) (\d+)\n255\n/.exec(head);
    const width = Number(w), height = Number(h), samples = file.subarray(all.length);
    if (head[1] === "7") return { width, height, data: samples };
    const data = new Uint8Array(4 * width * height).fill(255);
    for (let i = 0; i < width * height; i++) for (let c = 0; c < 3; c++) data[4 * i + c] = samples[3 * i + c];
    return { width, height, data };
}

/** "" when two pictures are the same byte for byte, else what differs. */
export function difference(a, b) {
    if (a.width !== b.width || a.height !== b.height) return `${a.width}x${a.height}, not ${b.width}x${b.height}`;
    let count = 0, first = -1;
    for (let i = 0; i < a.data.length; i += 4)
        if ([0, 1, 2, 3].some((c) => a.data[i + c] !== b.data[i + c])) {
            count++;
            if (first < 0) first = i;
        }
    if (count === 0) return "";
    const place = `${(first / 4) % a.width},${Math.floor(first / 4 / a.width)}`;
    return `${count} pixels differ, first at ${place}: ${a.data.slice(first, first + 4)}, not ${b.data.slice(first, first + 4)}`;
}

/** How many pixels are not the background's, which is that of the corner. */
export function drawnPixels({ data }) {
    let count = 0;
    for (let i = 0; i < data.length; i += 4) if ([0, 1, 2, 3].some((c) => data[i + c] !== data[c])) count++;
    return count;
}
