// png.js - PNG and animated PNG, written byte by byte: the pixels in the file are those of the library.
//
// A canvas would do, but its pixels are premultiplied by alpha, and lose by it.  Source: PNG, third edition
// (W3C), sections 5, 9 and 11; the chunks acTL, fcTL, fdAT among them.

const SIGNATURE = [137, 80, 78, 71, 13, 10, 26, 10];
const CRC = Uint32Array.from({ length: 256 }, (_, n) => {
    for (let k = 0; k < 8; k++) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
    return n;
});

function crcOf(bytes) {
    let c = 0xffffffff;
    for (const b of bytes) c = CRC[(c ^ b) & 255] ^ (c >>> 8);
    return ~c >>> 0;
}

function chunk(type, ...parts) {
    const length = parts.reduce((all, part) => all + part.length, 0);
    const bytes = new Uint8Array(12 + length), view = new DataView(bytes.buffer);
    view.setUint32(0, length);
    for (let i = 0; i < 4; i++) bytes[4 + i] = type.charCodeAt(i);
    let at = 8;
    for (const part of parts) {
        bytes.set(part, at);
        at += part.length;
    }
    view.setUint32(8 + length, crcOf(bytes.subarray(4, 8 + length)));
    return bytes;
}

function integers(...words) {
    const bytes = new Uint8Array(4 * words.length), view = new DataView(bytes.buffer);
    words.forEach((word, i) => view.setUint32(4 * i, word));
    return bytes;
}

/** Left, above, and the nearer of both and the corner: Paeth's filter, of one byte. */
function paeth(a, b, c) {
    const p = a + b - c, pa = Math.abs(p - a), pb = Math.abs(p - b), pc = Math.abs(p - c);
    return pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
}

/** Rows with Paeth's filter, the first one with that of the left neighbour. */
function filtered(data, width, height, channels) {
    const stride = width * channels, rows = new Uint8Array(height * (stride + 1));
    const row = new Uint8Array(stride), above = new Uint8Array(stride);
    for (let y = 0, to = 0; y < height; y++) {
        above.set(row);
        for (let x = 0, i = 0; x < width; x++)
            for (let c = 0; c < channels; c++, i++) row[i] = data[4 * (y * width + x) + c];
        rows[to++] = 4;
        for (let i = 0; i < stride; i++) {
            const left = i >= channels ? row[i - channels] : 0,
                corner = i >= channels ? above[i - channels] : 0;
            rows[to++] = row[i] - paeth(left, above[i], corner);
        }
    }
    return rows;
}

async function deflated(bytes) {
    const stream = new Blob([bytes]).stream().pipeThrough(new CompressionStream("deflate"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
}

function header(width, height, channels) {
    const bytes = new Uint8Array(13);
    bytes.set(integers(width, height));
    bytes.set([8, channels === 4 ? 6 : 2], 8);
    return chunk("IHDR", bytes);
}

/** A file of a picture { width, height, data: RGBA }; alpha: false leaves alpha out. */
export async function pngOf({ width, height, data }, { alpha }) {
    const channels = alpha ? 4 : 3;
    const pixels = await deflated(filtered(data, width, height, channels));
    const parts = [
        Uint8Array.from(SIGNATURE),
        header(width, height, channels),
        chunk("IDAT", pixels),
        chunk("IEND"),
    ];
    return new Blob(parts, { type: "image/png" });
}

/** An animated file: add() its pictures one after the other, end() gives the file. */
export class Film {
    #parts = [];
    #sequence = 0;

    constructor({ width, height, pictures, rate, alpha }) {
        Object.assign(this, { width, height, rate, channels: alpha ? 4 : 3 });
        const control = chunk("acTL", integers(pictures, 0));
        this.#parts.push(Uint8Array.from(SIGNATURE), header(width, height, this.channels), control);
    }

    async add({ data }) {
        const first = this.#sequence === 0;
        const control = new Uint8Array(26);
        control.set(integers(this.#sequence++, this.width, this.height, 0, 0));
        new DataView(control.buffer).setUint16(20, 1); // shown for 1 / rate of a second
        new DataView(control.buffer).setUint16(22, this.rate);
        const pixels = await deflated(filtered(data, this.width, this.height, this.channels));
        const shown = first ? chunk("IDAT", pixels) : chunk("fdAT", integers(this.#sequence++), pixels);
        this.#parts.push(chunk("fcTL", control), shown);
    }

    end() {
        return new Blob([...this.#parts, chunk("IEND")], { type: "image/png" });
    }
}
