// gallery.js - the catalogue as thumbnails, those looked at lately before it; each is drawn when it is first
// seen.
import { element, fill, memory } from "../base/dom.js";
import { checkedState } from "../state/state.js";
import { SURFACES } from "../state/surfaces.js";

const RECENT = 8;
const SIZE = { width: 176, height: 132 };

export class Gallery {
    #room;
    #services;
    #observer;
    #buttons = []; // { button, state, key }
    #pictures = new Map(); // key: canvas
    #recent;

    /** services: { store, painter, text, open(state) } */
    constructor(room, services) {
        this.#room = room;
        this.#services = services;
        this.#recent = this.#remembered();
        this.#observer = new IntersectionObserver((entries) => this.#seen(entries), {
            root: room,
            rootMargin: "0px 200px",
        });
        room.addEventListener("keydown", (event) => this.#key(event));
        room.addEventListener("wheel", (event) => this.#wheel(event), { passive: false });
        this.#build();
        services.store.subscribe((state, { changed }) => {
            if (changed.has("name") || changed.has("equation")) this.#mark();
        });
    }

    /** Own surfaces, the newest first, from the browser's memory: checked like those of links. */
    #remembered() {
        const kept = memory.get("recent");
        const states = (Array.isArray(kept) ? kept : []).slice(0, RECENT).map((raw) => checkedState(raw));
        return states.filter(({ bad }) => bad.length === 0).map(({ state }) => state);
    }

    /** Keeps an own surface that was looked at, in the place of one with the equation `instead`. */
    remember(state, instead) {
        if (this.#recent[0]?.equation === state.equation) return;
        const others = this.#recent.filter(({ equation }) => ![state.equation, instead].includes(equation));
        this.#recent = [state, ...others].slice(0, RECENT);
        memory.set("recent", this.#recent);
        this.#build();
    }

    /** Opens the surface so many places after this one. */
    step(by) {
        const { store, open } = this.#services;
        const at = SURFACES.findIndex(({ name }) => name === store.get().name);
        open(SURFACES[(Math.max(at, by < 0 ? 0 : -1) + by + SURFACES.length) % SURFACES.length]);
    }

    // ---- what is seen ----

    #build() {
        const recent = this.#recent.map((state) => this.#button(state, state.equation, state.equation));
        const named = SURFACES.map((state) =>
            this.#button(state, this.#services.text(`name.${state.name}`), state.name),
        );
        this.#observer.disconnect();
        this.#buttons = [...recent, ...named];
        const nodes = [...recent.map(({ button }) => button), ...named.map(({ button }) => button)];
        if (recent.length > 0) nodes.splice(recent.length, 0, element("hr"));
        fill(this.#room, ...nodes);
        for (const { button } of this.#buttons) this.#observer.observe(button);
        this.#mark();
    }

    #button(state, label, key) {
        const button = element(
            "button",
            {
                type: "button",
                class: "thumb",
                title: label,
                tabindex: -1,
                click: () => this.#services.open(state),
            },
            element("span", {}, label),
        );
        const canvas = this.#pictures.get(key);
        if (canvas) button.prepend(canvas);
        else button.prepend(element("canvas", { ...SIZE, "aria-hidden": "true" }));
        return { button, state, key };
    }

    #mark() {
        const { name, equation } = this.#services.store.get();
        let current = null;
        for (const entry of this.#buttons) {
            const is =
                name !== ""
                    ? entry.state.name === name
                    : entry.state.equation === equation && entry.state.name === "";
            entry.button.setAttribute("aria-current", String(is));
            if (is) current ??= entry;
        }
        const target = current ?? this.#buttons[0];
        for (const { button } of this.#buttons) button.tabIndex = button === target.button ? 0 : -1;
        if (current) this.#reveal(current.button);
    }

    #reveal(button) {
        const { scrollLeft, clientWidth } = this.#room;
        const { offsetLeft, offsetWidth } = button;
        const left = offsetLeft - this.#room.offsetLeft;
        if (left < scrollLeft || left + offsetWidth > scrollLeft + clientWidth)
            this.#room.scrollLeft = left - (clientWidth - offsetWidth) / 2;
    }

    async #seen(entries) {
        for (const { isIntersecting, target } of entries) {
            const entry = this.#buttons.find(({ button }) => button === target);
            if (!isIntersecting || !entry || this.#pictures.has(entry.key)) continue;
            const canvas = target.querySelector("canvas");
            this.#pictures.set(entry.key, canvas);
            try {
                const plain = { ...checkedState({}).state, ...entry.state };
                const picture = await this.#services.painter.ask("thumbnail", plain, SIZE);
                canvas.getContext("2d").putImageData(new ImageData(picture.data, picture.width), 0, 0);
            } catch {
                this.#pictures.delete(entry.key); // drawn when it is next seen
            }
        }
    }

    // ---- moving along ----

    #key(event) {
        const at = this.#buttons.findIndex(({ button }) => button === document.activeElement);
        const to = { ArrowLeft: at - 1, ArrowRight: at + 1, Home: 0, End: this.#buttons.length - 1 }[
            event.key
        ];
        if (at < 0 || to === undefined || event.ctrlKey || event.altKey) return;
        event.preventDefault();
        event.stopPropagation();
        const { button } = this.#buttons[Math.min(Math.max(to, 0), this.#buttons.length - 1)];
        button.focus();
        this.#reveal(button);
    }

    #wheel(event) {
        if (event.deltaX !== 0 || event.ctrlKey) return;
        event.preventDefault();
        this.#room.scrollLeft += event.deltaY;
    }
}
