// notice.js - a line above the picture: of a kind that stays until it is hidden, or for some seconds.
import { debounced } from "./dom.js";

const SECONDS = 4;

export class Notice {
    #line;
    #kind = "";
    #hideLater = debounced(1000 * SECONDS, () => this.hide());

    constructor(line) {
        this.#line = line;
    }

    show(words, kind = "") {
        this.#kind = kind;
        this.#line.textContent = words;
        this.#line.hidden = false;
        if (kind === "") this.#hideLater();
    }

    hide(...kinds) {
        if (kinds.length === 0 ? this.#kind === "" : kinds.includes(this.#kind)) this.#line.hidden = true;
    }
}
