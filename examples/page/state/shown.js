// shown.js - the surface that is shown: opened, fitted, drawn, and where its camera was before it was moved.
import { suited, zoom } from "../picture/camera.js";
import { compiledWith, fit as fitOf } from "../picture/asking.js";
import { linkOf } from "./link.js";
import { checkedState, constantsOf, radiusOf } from "./state.js";
import { SURFACES, surfaceOf } from "./surfaces.js";

const FOV = 25; // degrees, as cameras have that are fitted
const MOST_SHARP = 2; // device pixels for one of CSS that are drawn
const LOOK = ["colours", "light", "thin", "axes", "box", "complex"];
const DRAWN = ["equation", "parameters", "extent", "clip", "camera", ...LOOK];

/** What extent and camera are fitted to. */
function surfaceIn(state) {
    return JSON.stringify([state.equation, constantsOf(state)]);
}

function isOfCatalogue({ name, equation }) {
    return surfaceOf(name)?.equation === equation;
}

export class Shown {
    onOpen = () => {}; // told the equation that was opened
    #canvas;
    #store;
    #painter;
    #tell;
    #drawnSize = "";
    #home = null; // the camera of the surface before it was moved
    #wanted = null; // the same before it was made to suit the window
    #fitted = ""; // the surface and the extent that this camera was fitted to
    #fittedSurface = ""; // the surface that the extent was fitted to, or that it came with
    #turn = 0; // of what is opened: what was begun before the last one is not shown any more

    /** tell(say): say(text) gives what is to be told, once there are words */
    constructor(canvas, { store, painter, tell }) {
        this.#canvas = canvas;
        this.#store = store;
        this.#painter = painter;
        this.#tell = tell;
        store.subscribe((state, { changed, moving }) => {
            if (changed.size > 0 && !DRAWN.some((key) => changed.has(key))) return;
            this.#draw(moving);
            if (!moving) void this.#fitAgain();
        });
        new ResizeObserver(() => this.#resized()).observe(canvas);
    }

    /** The camera of the surface before it was moved. */
    get home() {
        return this.#home;
    }

    get #isHome() {
        return JSON.stringify(this.#store.get().camera) === JSON.stringify(this.#home);
    }

    /** The state's link: without a camera where who opens it gets the same one, made to suit that window. */
    get link() {
        const state = this.#store.get();
        const isChosen = !isOfCatalogue(state) && this.#fitted !== fittedTo(state);
        return new URL(linkOf(state, isChosen ? null : this.#home), location.href).href;
    }

    // ---- pictures ----

    #size() {
        const sharp = Math.min(devicePixelRatio || 1, MOST_SHARP);
        const pixels = (length) => Math.max(1, Math.round(length * sharp));
        return { width: pixels(this.#canvas.clientWidth), height: pixels(this.#canvas.clientHeight) };
    }

    #draw(moving) {
        const { picture, ...state } = this.#store.get(), size = this.#size();
        this.#drawnSize = JSON.stringify(size);
        this.#painter.draw(state, { canvas: this.#canvas, ...size, moving });
    }

    #setHome(camera) {
        this.#wanted = camera;
        this.#home = suited(camera, this.#canvas.clientWidth, this.#canvas.clientHeight);
        return this.#home;
    }

    #resized() {
        if (!this.#wanted || JSON.stringify(this.#size()) === this.#drawnSize) return;
        const stays = this.#isHome;
        this.#setHome(this.#wanted);
        if (stays) this.#store.set({ camera: this.#home });
        else this.#draw(false);
    }

    // ---- opened ----

    /** Shows a state: of the catalogue, of a link, of a file; `camera`: it is as it was, else it suits the
     * window. */
    open(state, { camera = null } = {}) {
        const checked = checkedState(state).state;
        const base = this.#setHome(surfaceOf(checked.name)?.camera ?? checked.camera);
        this.#fittedSurface = surfaceIn(checked);
        this.#turn++;
        this.#store.set({ ...checked, camera: camera ?? base });
        this.onOpen(checked.equation);
    }

    /** What stateOfLink read. */
    async openLink({ state, hasCamera, bad = [], unknown = [], newer = false, refused = false }) {
        if (refused) {
            if (!this.#home) this.open(SURFACES[0]);
            return this.#tell((text) => text("unprintable"));
        }
        const turn = ++this.#turn;
        try {
            const { parameters } = await compiledWith(this.#painter, state.equation, state.parameters);
            if (turn !== this.#turn) return;
            const whole = { ...state, name: isOfCatalogue(state) ? state.name : "", parameters };
            this.open(whole, { camera: hasCamera ? state.camera : null });
            if (!hasCamera && whole.name === "")
                await this.fit(state.extent.kind === "fitted" ? "view" : "camera");
        } catch (error) {
            if (turn !== this.#turn) return;
            this.open(SURFACES[0]);
            return this.#tell((text) => text("link.equation", { why: text.mistake(error) }));
        }
        const list = (names) => ({ what: names.slice(0, 5).join(", ") });
        const said = [];
        if (newer) said.push(["link.newer"]);
        if (unknown.length > 0) said.push(["link.unknown", list(unknown)]);
        if (bad.length > 0) said.push(["link.bad", list(bad)]);
        if (said.length > 0) this.#tell((text) => said.map((words) => text(...words)).join(" "));
    }

    /** A surface that was just typed: what is shown, and from where, is chosen. */
    async openTyped(partial) {
        const turn = ++this.#turn;
        this.#fittedSurface = surfaceIn(partial);
        const found = await this.#ask(partial);
        if (turn !== this.#turn) return;
        if (found) this.#show({ ...partial, clip: [], extent: found.extent }, found.camera);
        else this.#store.set({ ...partial, clip: [] });
    }

    // ---- fitted ----

    /** Extent and camera for the state with these members, or null. */
    async #ask(partial = {}, kind = "fitted") {
        const state = { ...this.#store.get(), ...partial, picture: null };
        const found = await fitOf(this.#painter, { ...state, extent: { ...state.extent, kind } }, this.#size());
        return found && { ...found, camera: await this.#withBox({ ...state, ...found }) };
    }

    /** The state's camera, or where the box is drawn one for which all is so small that it is in the picture. */
    async #withBox({ picture, ...state }) {
        const times = state.box ? await this.#painter.ask("room", state, this.#size()).catch(() => 1) : 1;
        return times < 1 ? zoom(state.camera, times) : state.camera;
    }

    #show(partial, home, camera = home) {
        this.#home = this.#wanted = home;
        const state = { ...this.#store.get(), ...partial };
        this.#fitted = fittedTo(state);
        this.#fittedSurface = surfaceIn(state);
        this.#store.set({ ...partial, camera });
    }

    /** what: "view" chooses extent and camera anew, "camera" the camera, unless nothing is seen. */
    async fit(what) {
        const { extent, clip, picture } = this.#store.get(), turn = this.#turn;
        const isEmpty = picture?.hits + picture?.undecided + picture?.thin === 0;
        const isAnew = what === "view" || isEmpty;
        const asked = this.#ask({}, isAnew ? "fitted" : extent.kind);
        const found = await asked.catch(({ code }) => code !== "E_CANCELLED" && null);
        if (found === false || turn !== this.#turn) return;
        const { extent: fitted, camera } = found ?? { extent, camera: this.#wholeExtent() };
        this.#show({ extent: fitted, clip: isEmpty ? [] : clip }, camera);
    }

    /** Draws the box or not; all becomes smaller until it is in the picture. */
    async showBox(box) {
        this.#store.set({ box });
        const state = this.#store.get(), camera = await this.#withBox(state);
        if (this.#store.get().camera === state.camera) this.#store.set({ camera });
    }

    /** Where fitting takes too long: a camera that looks the same way, and shows all of the extent. */
    #wholeExtent() {
        const { extent, camera } = this.#store.get();
        const back = camera.eye.map((x, i) => x - camera.lookAt[i]), lookAt = extent.centre;
        const far = radiusOf(extent) / Math.sin((FOV * Math.PI) / 360) / Math.hypot(...back);
        const eye = back.map((x, i) => lookAt[i] + far * x);
        const { clientWidth, clientHeight } = this.#canvas;
        return suited({ ...camera, eye, lookAt, fov: FOV }, clientWidth, clientHeight);
    }

    /** At rest, once letters have other values: a fitted extent is fitted to them; a camera that was moved
     * stays. */
    async #fitAgain() {
        const before = this.#store.get(), surface = surfaceIn(before);
        if (before.extent.kind !== "fitted" || surface === this.#fittedSurface) return;
        this.#fittedSurface = surface; // also where fitting fails, or takes too long
        const found = await this.#ask().catch(() => null);
        const { extent, camera } = this.#store.get();
        if (!found || extent !== before.extent || surfaceIn(this.#store.get()) !== surface) return;
        if (JSON.stringify(found.extent) === JSON.stringify(extent)) return;
        this.#show({ extent: found.extent }, found.camera, this.#isHome ? found.camera : camera);
    }
}

/** What a fitted camera depends on. */
function fittedTo(state) {
    return JSON.stringify([surfaceIn(state), state.extent]);
}
