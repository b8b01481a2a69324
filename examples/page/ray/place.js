// place.js - the place of the picture through which the ray goes that is looked into: the event "place" of
// motion.js chooses it, a cross shows it.
import { svg } from "../base/dom.js";

const ARM = 11; // pixels

function cross() {
    const arms = `M${-ARM} 0H-4M4 0H${ARM}M0 ${-ARM}V-4M0 4V${ARM}`;
    const size = 2 * ARM + 4;
    return svg(
        "svg",
        {
            class: "ray-cross",
            width: size,
            height: size,
            viewBox: `${-size / 2} ${-size / 2} ${size} ${size}`,
        },
        svg("path", { class: "ray-cross-rim", d: arms }),
        svg("path", { class: "ray-cross-arms", d: arms }),
    );
}

/** Watches a canvas. */
export class Place {
    #share = null; // of the picture's width and height, so that it stays where it is when the size changes
    #size;

    /** onChange(): there is another place. */
    constructor(canvas, onChange) {
        this.canvas = canvas;
        this.onChange = onChange;
        this.#size = { width: canvas.width, height: canvas.height };
        this.cross = cross();
        this.cross.setAttribute("aria-hidden", "true");
        this.cross.style.display = "none";
        canvas.parentElement.append(this.cross);
        canvas.addEventListener("place", ({ detail }) => this.#goTo(detail.x, detail.y));
        new ResizeObserver(() => this.#show()).observe(canvas);
    }

    #goTo(x, y) {
        const inside = (share) => Math.min(1 - 1e-9, Math.max(0, share));
        this.#share = [inside(x), inside(y)];
        this.#show();
        this.onChange();
    }

    /** The size of the picture at rest, in which pixels count; is it another one? */
    resize({ width, height }) {
        const changed = width !== this.#size.width || height !== this.#size.height;
        this.#size = { width, height };
        return changed && this.#share !== null;
    }

    /** The pixel, from 0,0 in the upper left corner, and the picture's size; null when there is none yet. */
    get() {
        if (!this.#share) return null;
        const { width, height } = this.#size;
        return {
            width,
            height,
            x: Math.floor(this.#share[0] * width),
            y: Math.floor(this.#share[1] * height),
        };
    }

    /** To a pixel; nothing given: the middle. */
    move(x = this.#size.width >> 1, y = this.#size.height >> 1) {
        this.#goTo((x + 0.5) / this.#size.width, (y + 0.5) / this.#size.height);
    }

    clear() {
        this.#share = null;
        this.#show();
        this.onChange();
    }

    /** Whether the cross is to be seen. */
    set visible(visible) {
        this.cross.classList.toggle("ray-cross-away", !visible);
    }

    #show() {
        this.cross.style.display = this.#share ? "" : "none";
        if (!this.#share) return;
        const { offsetLeft, offsetTop, clientWidth, clientHeight } = this.canvas;
        this.cross.style.left = `${offsetLeft + this.#share[0] * clientWidth}px`;
        this.cross.style.top = `${offsetTop + this.#share[1] * clientHeight}px`;
    }
}
