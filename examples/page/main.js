// main.js - the page: makes its parts and wires them together.
import { fit as fitOf } from "./picture/asking.js";
import { suited } from "./picture/camera.js";
import { mount as mountCertain } from "./panels/certain.js";
import { mount as mountComplex } from "./complex/complex.js";
import { button, choice } from "./base/controls.js";
import { showAbout, sentenceOf, titleOf } from "./panels/describe.js";
import { debounced, element, memory } from "./base/dom.js";
import { compiledWith, EquationBox } from "./panels/equation.js";
import { openDrops } from "./files/files.js";
import { Gallery } from "./panels/gallery.js";
import { fillHelp } from "./panels/help.js";
import { keepKeys } from "./panels/keys.js";
import { linkOf, stateOfLink } from "./state/link.js";
import { mount as mountLook } from "./panels/look.js";
import { Motion } from "./picture/motion.js";
import { Painter } from "./picture/painter.js";
import { mount as mountRay } from "./ray/ray.js";
import { Sliders } from "./panels/sliders.js";
import { checkedState } from "./state/state.js";
import { Store } from "./base/store.js";
import { surfaceOf, SURFACES } from "./state/surfaces.js";
import { Take } from "./files/take.js";
import { LANGUAGES, loadText, translate } from "./base/text.js";
import { loadTheme, switchTheme } from "./base/theme.js";
import { mount as mountView } from "./panels/view.js";

const MOST_SHARP = 2; // device pixels for one of CSS that are drawn
const DRAWN = ["equation", "parameters", "extent", "clip", "camera", "colours", "light", "thin", "complex"];
const at = (id) => document.getElementById(id);

loadTheme();
const words = loadText(); // comes while workers start
const canvas = at("picture");
let home = null; // the camera of the surface before it was moved
let wanted = null; // the same before it was made to suit the window
let fitted = ""; // what that camera was fitted to

function start() {
    const linked = stateOfLink(location.hash, { ...checkedState({}).state, ...SURFACES[0] });
    const first = linked?.state ?? checkedState(SURFACES[0]).state;
    return { first, linked };
}
const { first, linked } = start();
const store = new Store({ ...first, picture: null });

const painter = new Painter({
    onPicture(report) {
        if (report.stage !== "moving") ["trouble", "slow"].forEach(hideNotice);
        page.firstPicture ??= performance.now();
        store.set({ picture: report }, { moving: report.stage === "moving" });
    },
    onStatus({ kind }) {
        if (kind === "slow") void words.then(() => notify(text("slow"), "slow"));
        if (kind === "replaced") void words.then(() => notify(text("worker.replaced")));
    },
    onError: (error) => words.then(() => notify(text("trouble", { why: error.message ?? error.code }), "trouble")),
});
const page = (window.algsurfPage = { store, painter, firstPicture: null }); // for tests

const text = await words;
document.documentElement.lang = text.language;
translate(document, text);

// ---- what is told ----

let noticed = "";
const hideLater = debounced(4000, () => hideNotice());

/** A line above the picture; of a kind that stays until hideNotice(kind), or for some seconds. */
function notify(words, kind = "") {
    noticed = kind;
    at("notice").textContent = words;
    at("notice").hidden = false;
    if (kind === "") hideLater();
}

function hideNotice(kind = "") {
    if (noticed === kind) at("notice").hidden = true;
}

// ---- pictures ----

function size() {
    const sharp = Math.min(devicePixelRatio || 1, MOST_SHARP);
    return { width: Math.max(1, Math.round(canvas.clientWidth * sharp)), height: Math.max(1, Math.round(canvas.clientHeight * sharp)) };
}

function draw(moving) {
    const { picture, ...state } = store.get();
    painter.draw(state, { canvas, ...size(), moving });
}

function isHome() {
    return JSON.stringify(store.get().camera) === JSON.stringify(home);
}

/** What a fitted camera depends on. */
function fittedTo({ equation, parameters, extent }) {
    return JSON.stringify([equation, Object.entries(parameters).map(([name, p]) => [name, p.value]), extent]);
}

/** The state's link: without a camera where who opens it gets the same one, made to suit that window. */
function link() {
    const state = store.get();
    const isKnown = surfaceOf(state.name)?.equation === state.equation || fitted === fittedTo(state);
    return new URL(linkOf(state, isKnown ? home : null), location.href).href;
}

/** The camera before it is moved; it is made to suit the window, now and when the window changes. */
function setHome(camera) {
    wanted = camera;
    home = suited(camera, canvas.clientWidth, canvas.clientHeight);
    return home;
}

new ResizeObserver(() => {
    if (!wanted) return; // no surface is open yet
    const stays = isHome();
    setHome(wanted);
    if (stays) store.set({ camera: home });
    else draw(false);
}).observe(canvas);

// ---- surfaces ----

/** Shows a state: of the catalogue, of a link, of a file; `camera`: it is as it was, else it suits the window. */
function open(state, { camera = null } = {}) {
    const checked = checkedState(state).state;
    const own = surfaceOf(checked.name)?.camera;
    const base = setHome(own ?? checked.camera);
    store.set({ ...checked, camera: camera ?? base });
    box.show(checked.equation);
}

/** A surface that was just typed: what is shown, and from where, is chosen. */
async function openTyped(partial) {
    const { extent } = store.get();
    const asked = { ...store.get(), ...partial, extent: { ...extent, kind: "fitted" }, picture: null };
    const found = await fitOf(painter, asked, size());
    if (found) showFitted({ ...partial, clip: [], extent: found.extent }, found.camera);
    else store.set({ ...partial, clip: [] });
    remember();
}
const remember = debounced(4000, () => box.isSettled && gallery.remember(store.get()));

function showFitted(partial, camera) {
    home = wanted = camera;
    fitted = fittedTo({ ...store.get(), ...partial });
    store.set({ ...partial, camera });
}

/** what: "view" chooses extent and camera anew, "camera" the camera. */
async function fit(what) {
    const state = store.get();
    const extent = what === "view" ? { ...state.extent, kind: "fitted" } : state.extent;
    try {
        const found = await fitOf(painter, { ...state, extent, picture: null }, size());
        if (found) showFitted({ extent: what === "view" ? found.extent : extent }, found.camera);
    } catch (error) {
        if (error.code !== "E_CANCELLED") notify(text("trouble", { why: error.message }));
    }
}

async function openLink(read) {
    const { state, hasCamera, bad, unknown, newer } = read;
    try {
        const { parameters } = await compiledWith(painter, state.equation, state.parameters);
        const known = surfaceOf(state.name);
        const isKnown = known !== undefined && known.equation === state.equation;
        const whole = { ...state, name: isKnown ? state.name : "", parameters };
        if (hasCamera) open(whole, { camera: state.camera });
        else if (isKnown) open(whole);
        else {
            open(whole);
            await fit(state.extent.kind === "fitted" ? "view" : "camera");
        }
    } catch (error) {
        open(SURFACES[0]);
        return notify(text("link.equation", { why: error.message || text(`mistake.${error.code}`) }));
    }
    const said = [];
    if (newer) said.push(text("link.newer"));
    if (unknown.length > 0) said.push(text("link.unknown", { what: unknown.slice(0, 5).join(", ") }));
    if (bad.length > 0) said.push(text("link.bad", { what: bad.slice(0, 5).join(", ") }));
    if (said.length > 0) notify(said.join(" "));
}

// ---- the parts ----

const services = { store, painter, text, canvas, notify };
const box = new EquationBox(
    { box: at("formula"), mirror: at("mirror"), mistake: at("mistake") },
    { ...services, onSurface: openTyped },
);
const gallery = new Gallery(at("gallery"), { ...services, open });
const sliders = new Sliders(at("sliders"), services);
const reset = () => store.set({ camera: home });
const motion = new Motion(canvas, { ...services, home: () => home });
const files = openDrops(document.body, { ...services, drop: at("drop"), open: (state) => openLink({ state, hasCamera: true, bad: [], unknown: [] }) });
const take = new Take(at("take"), { ...services, link, openFile: files.choose });
mountView(at("view"), { ...services, motion, fit, reset });
mountLook(at("look"), services);
mountCertain(at("certain"), services);
mountRay(at("ray"), services);
mountComplex(at("complex"), { ...services, open });
fillHelp(at("help"), text);

// ---- the panel ----

function openPanel(isOpen = true) {
    document.body.classList.toggle("open", isOpen);
    at("handle").setAttribute("aria-expanded", String(isOpen));
    at("handle").firstElementChild.textContent = text(isOpen ? "panel.close" : "panel.open");
}

function showSection(name) {
    document.body.classList.remove("wide");
    const section = at(`section-${name}`);
    section.open = true;
    openPanel();
    section.scrollIntoView({ block: "start", behavior: matchMedia("(prefers-reduced-motion: reduce)").matches ? "auto" : "smooth" });
    return section;
}

at("handle").addEventListener("click", () => openPanel(!document.body.classList.contains("open")));
at("copy-link").addEventListener("click", () => take.copyLink());
at("open-save").addEventListener("click", () => showSection("take").querySelector("button").focus());
at("theme").addEventListener("click", switchTheme);
at("open-help").addEventListener("click", () => at("help").showModal());
canvas.addEventListener("place", () => showSection("ray"));

const languages = choice(Object.entries(LANGUAGES), (language) => {
    memory.set("language", language);
    history.replaceState(null, "", link());
    location.reload();
});
languages.value = text.language;
languages.setAttribute("aria-label", text("foot.language"));
at("foot").append(languages, element("span", {}, text("foot.about")));

keepKeys({
    motion,
    gallery,
    sliders,
    ray: () => canvas.dispatchEvent(new CustomEvent("place", { detail: { x: 0.5, y: 0.5 } })),
    complex: () => showSection("complex").querySelector("input")?.focus(),
    equation: () => box.focus(),
    link: () => take.copyLink(),
    save: () => at("open-save").click(),
    theme: switchTheme,
    wide: () => document.body.classList.toggle("wide"),
    help: () => at("help").showModal(),
    escape: () => {
        openPanel(false);
        canvas.focus();
    },
});

// ---- following the state ----

const tellLater = debounced(1200, () => (at("seen").textContent = sentenceOf(store.get(), text)));
const keepAddress = debounced(600, () => history.replaceState(null, "", link()));

let told = ""; // what the part about the surface says

function follow(state, changed, moving) {
    if (changed.has("name") || changed.has("equation")) {
        at("title").textContent = titleOf(state, text);
        document.title = `${titleOf(state, text)} – algsurf`;
    }
    const about = `${state.name} ${state.picture?.degree}`;
    if (about !== told) showAbout(at("about"), state, text);
    told = about;
    if (changed.has("picture") && !moving) {
        canvas.setAttribute("aria-label", sentenceOf(state, text));
        tellLater();
    }
}

store.subscribe((state, { changed, moving }) => {
    follow(state, changed, moving);
    const isDrawn = DRAWN.some((key) => changed.has(key)) || changed.size === 0;
    if (!isDrawn) return;
    draw(moving);
    keepAddress();
});

// The event's address: that of the page may by now be the one that keepAddress wrote.
window.addEventListener("hashchange", ({ newURL }) => {
    const read = stateOfLink(new URL(newURL).hash, checkedState(SURFACES[0]).state);
    if (read) void openLink(read);
});

if (linked) void openLink(linked);
else open(SURFACES[0]);
if (isSecureContext && "serviceWorker" in navigator) void navigator.serviceWorker.register("offline.js", { scope: "./" });
