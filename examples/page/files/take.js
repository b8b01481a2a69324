// take.js - the panel "take it along": link, command, C program, file, picture, film, triangles.
import { axesOf } from "../picture/camera.js";
import { commandOf, stemOf } from "./command.js";
import { button, choice, numberField, row } from "../base/controls.js";
import { download, element } from "../base/dom.js";
import { filmOf, webmType } from "./film.js";
import { fileOf } from "./jsurf.js";
import { pngOf } from "./png.js";
import { programOf } from "./program.js";

const MOST_SIDE = 16384, MOST_PIXELS = 1 << 27, MOST_PICTURES = 600;
const PIXELS_OF_FILM = 1 << 29;
const CELLS = [64, 128, 256], USUAL_CELLS = 128; // along the longest side: of a mesh
const MESH_TYPES = { stl: "model/stl", glb: "model/gltf-binary" };

/** services: { store, painter, text, notify(text), link(): address of the state, openFile() } */
export class Take {
    #services;
    #abort = null;

    constructor(room, services) {
        this.#services = services;
        const { text } = services;
        this.width = numberField({ label: text("take.width"), min: 1, max: MOST_SIDE, onNumber: () => {} });
        this.height = numberField({ label: text("take.height"), min: 1, max: MOST_SIDE, onNumber: () => {} });
        this.width.follow(1920);
        this.height.follow(1440);
        this.filmWidth = numberField({
            label: text("take.width"),
            min: 1,
            max: MOST_SIDE,
            onNumber: () => {},
        });
        this.filmHeight = numberField({
            label: text("take.height"),
            min: 1,
            max: MOST_SIDE,
            onNumber: () => {},
        });
        this.filmWidth.follow(640);
        this.filmHeight.follow(480);
        this.quality = choice(
            [
                ["standard", text("take.quality.standard")],
                ["full", text("take.quality.full")],
            ],
            () => {},
        );
        this.quality.value = "full";
        this.samples = choice([["4", text("take.samples.4")], ["1", text("take.samples.1")]], () => {});
        this.what = choice([["turn", text("take.film.turn")]], () => {});
        this.pictures = numberField({
            label: text("take.film.pictures"),
            min: 2,
            max: MOST_PICTURES,
            onNumber: () => {},
        });
        this.rate = numberField({ label: text("take.film.rate"), min: 1, max: 60, onNumber: () => {} });
        this.pictures.follow(72);
        this.rate.follow(24);
        const formats = [["apng", text("take.film.apng")], ...(webmType() ? [["webm", "WebM"]] : [])];
        this.format = choice(formats, () => {});
        this.cells = choice(CELLS.map((count) => [count, count]), () => {});
        this.cells.value = USUAL_CELLS;
        this.meshes = Object.keys(MESH_TYPES).map((format) =>
            button(text("take.mesh.save", { format }), () => this.#saveMesh(format)),
        );
        this.meshHint = element("p", { class: "hint" });
        this.meshReport = element("p", { class: "hint", role: "status" });
        this.progress = element("progress", { max: 1, value: 0, "aria-label": text("take.progress") });
        this.working = element(
            "div",
            { hidden: true },
            this.progress,
            button(text("take.cancel"), () => this.#abort?.abort()),
        );
        this.start = [
            button(text("take.png"), () => this.savePicture(), { class: "main" }),
            button(text("take.film"), () => this.#saveFilm()),
            ...this.meshes,
        ];
        this.#build(room);
        this.#follow(services.store.get());
        this.#allow();
        services.store.subscribe((state, { changed }) => {
            if (changed.has("parameters")) this.#follow(state);
            if (changed.has("complex")) this.#allow();
        });
    }

    #build(room) {
        const { text, openFile } = this.#services;
        const times = () => element("span", {}, "×");
        room.append(
            element(
                "div",
                { class: "buttons" },
                this.start[0],
                button(text("take.link"), () => this.copyLink()),
                button(text("take.command"), () => this.#copyCommand()),
                button(text("take.program"), () => this.#copyProgram()),
            ),
            element("h3", {}, text("take.picture")),
            row(text("take.size"), this.width, times(), this.height),
            row(text("take.quality"), this.quality),
            row(text("take.samples"), this.samples),
            element("h3", {}, text("take.film.title")),
            row(text("take.film.what"), this.what),
            row(text("take.size"), this.filmWidth, times(), this.filmHeight),
            row(text("take.film.pictures"), this.pictures),
            row(text("take.film.rate"), this.rate),
            row(text("take.film.format"), this.format),
            element("div", { class: "buttons" }, this.start[1]),
            element("h3", {}, text("take.mesh")),
            this.meshHint,
            row(text("take.mesh.cells"), this.cells),
            element("div", { class: "buttons" }, ...this.meshes),
            this.meshReport,
            this.working,
            element("h3", {}, text("take.file")),
            element("p", { class: "hint" }, text("take.file.hint")),
            element(
                "div",
                { class: "buttons" },
                button(text("take.file.open"), openFile),
                button(text("take.file.save"), () => this.#saveFile()),
            ),
        );
    }

    #follow({ parameters }) {
        const { text } = this.#services,
            before = this.what.value;
        const letters = Object.keys(parameters).map((name) => [
            `let:${name}`,
            text("take.film.let", { name }),
        ]);
        const pairs = [["turn", text("take.film.turn")], ...letters];
        this.what.replaceChildren(...pairs.map(([value, label]) => element("option", { value }, label)));
        this.what.value = pairs.some(([value]) => value === before) ? before : "turn";
    }

    /** Which buttons may be pressed: none while something is saved; complex space has no triangles. */
    #allow() {
        const { store, text } = this.#services, { complex } = store.get();
        for (const start of this.start) start.disabled = this.#abort !== null;
        if (complex) for (const save of this.meshes) save.disabled = true;
        this.meshHint.textContent = text(complex ? "take.mesh.complex" : "take.mesh.hint");
    }

    // ---- words ----

    async #copy(words, said) {
        const { notify, text } = this.#services;
        try {
            await navigator.clipboard.writeText(words);
            notify(text(said));
        } catch {
            this.#offer(words);
        }
    }

    /** Where a page may not write to the clipboard: the words, selected, in a dialog. */
    #offer(words) {
        const { text } = this.#services;
        const area = element("textarea", {
            rows: 8,
            cols: 60,
            readonly: true,
            "aria-label": text("take.copy"),
        });
        area.value = words;
        const close = button(text("close"), () => dialog.close());
        const dialog = element(
            "dialog",
            { class: "sheet", close: () => dialog.remove() },
            element("p", {}, text("take.copy")),
            area,
            close,
        );
        document.body.append(dialog);
        dialog.showModal();
        area.select();
    }

    #options() {
        return {
            width: numberIn(this.width),
            height: numberIn(this.height),
            quality: this.quality.value,
            antialias: Number(this.samples.value),
        };
    }

    copyLink() {
        return this.#copy(this.#services.link(), "take.link.done");
    }

    #copyCommand() {
        return this.#copy(commandOf(this.#services.store.get(), this.#options()), "take.command.done");
    }

    #copyProgram() {
        const state = this.#services.store.get();
        return this.#copy(
            programOf(state, { ...this.#options(), degree: state.picture?.degree ?? 0 }),
            "take.program.done",
        );
    }

    #saveFile() {
        const state = this.#services.store.get();
        download(
            new Blob([fileOf(state, axesOf(state.camera))], { type: "text/plain" }),
            `${stemOf(state)}.jsurf`,
        );
    }

    // ---- pictures ----

    /** Runs what takes long, with progress and a way to cancel it. */
    async #work(use) {
        const { text, notify } = this.#services;
        if (this.#abort) return;
        this.#abort = new AbortController();
        this.working.hidden = false;
        this.#allow();
        this.progress.value = 0;
        try {
            await use({ signal: this.#abort.signal, onProgress: (share) => (this.progress.value = share) });
        } catch (error) {
            if (!this.#abort.signal.aborted) notify(text("take.failed", { why: error.message }));
        } finally {
            this.#abort = null;
            this.working.hidden = true;
            this.#allow();
        }
    }

    savePicture() {
        const { store, painter, text, notify } = this.#services;
        const state = store.get(), options = this.#options();
        if (options.width * options.height > MOST_PIXELS) return notify(text("take.large"));
        return this.#work(async (how) => {
            const picture = await painter.image(plain(state), { ...options, ...how });
            download(
                await pngOf(picture, { alpha: state.colours.background === "none" }),
                `${stemOf(state)}.png`,
            );
        });
    }

    #saveFilm() {
        const { store, painter, text, notify } = this.#services;
        const state = store.get(),
            { quality } = this.#options();
        const [width, height, rate, pictures] = [
            this.filmWidth,
            this.filmHeight,
            this.rate,
            this.pictures,
        ].map(numberIn);
        const [kind, name] = this.what.value.split(":");
        if (width * height * pictures > PIXELS_OF_FILM) return notify(text("take.film.large"));
        return this.#work(async (how) => {
            const format = this.format.value;
            const film = await filmOf(
                painter,
                plain(state),
                { kind, name, pictures },
                { width, height, quality, rate, format },
                how,
            );
            download(film, `${stemOf(state)}.${format === "webm" ? "webm" : "png"}`);
        });
    }

    // ---- triangles ----

    #saveMesh(format) {
        const { store, painter } = this.#services;
        const state = store.get(), cells = Number(this.cells.value);
        this.meshReport.textContent = "";
        return this.#work(async (how) => {
            const made = await painter.mesh(plain(state), { format, cells }, how);
            this.meshReport.textContent = this.#said(made, state.picture);
            if (!made.bytes) return;
            download(new Blob([made.bytes], { type: MESH_TYPES[format] }), `${stemOf(state)}.${format}`);
        });
    }

    /** What the triangles are, and what they cannot show. */
    #said({ triangles, open, doubts }, picture) {
        const { text } = this.#services;
        if (triangles === 0) return text("take.mesh.none");
        const words = [text(open ? "take.mesh.open" : "take.mesh.closed", { triangles })];
        if (doubts) words.push(text("take.mesh.doubts", { doubts }));
        if (picture?.thin) words.push(text("take.mesh.thin"));
        return words.join(" ");
    }
}

/** The whole number in a field. */
function numberIn(field) {
    return Math.round(Number(field.dataset.good));
}

/** Without what is not of the picture. */
function plain({ picture, ...state }) {
    return state;
}
