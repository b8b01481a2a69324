// parts.js - all of the page but the picture and the equation: makes the parts and wires them together.
import { choice } from "./base/controls.js";
import { debounced, element, memory, narrow } from "./base/dom.js";
import { LANGUAGES } from "./base/text.js";
import { switchTheme } from "./base/theme.js";
import { mount as mountComplex } from "./complex/complex.js";
import { openDrops } from "./files/files.js";
import { Take } from "./files/take.js";
import { mount as mountCertain } from "./panels/certain.js";
import { showAbout, sentenceOf, titleOf } from "./panels/describe.js";
import { Gallery } from "./panels/gallery.js";
import { fillHelp } from "./panels/help.js";
import { keepKeys } from "./panels/keys.js";
import { mount as mountLook } from "./panels/look.js";
import { Sliders } from "./panels/sliders.js";
import { mount as mountNothing } from "./panels/nothing.js";
import { keepPast } from "./panels/past.js";
import { mount as mountView } from "./panels/view.js";
import { mount as mountWaiting } from "./panels/waiting.js";
import { Motion } from "./picture/motion.js";
import { mount as mountRay } from "./ray/ray.js";

const AGAIN = 32; // pixels between two taps at the same place
const at = (id) => document.getElementById(id);

function openPanel(text, isOpen = true) {
    document.body.classList.toggle("open", isOpen);
    at("handle").setAttribute("aria-expanded", String(isOpen));
    at("handle").firstElementChild.textContent = text(isOpen ? "panel.close" : "panel.open");
}

/** Where the panel is a sheet, the sliders lie over the picture. */
function placeSliders() {
    if (narrow.matches) at("stage").append(at("sliders"));
    else at("about").after(at("sliders"));
}

function showSection(text, name) {
    document.body.classList.remove("wide");
    const section = at(`section-${name}`), isStill = matchMedia("(prefers-reduced-motion: reduce)").matches;
    section.open = true;
    openPanel(text);
    section.scrollIntoView({ block: "start", behavior: isStill ? "auto" : "smooth" });
    return section;
}

/** Another language: the page is loaded anew, with the same state. */
function languagesOf(text, shown) {
    const languages = choice(Object.entries(LANGUAGES), (language) => {
        memory.set("language", language);
        history.replaceState(null, "", shown.link);
        location.reload();
    });
    languages.value = text.language;
    languages.setAttribute("aria-label", text("foot.language"));
    return languages;
}

/** Sections of the panel, the gallery, and what moves the picture. */
function mountSections({ store, painter, text, canvas, shown, box, notice }) {
    const services = { store, painter, text, canvas, notify: (words) => notice.show(words) };
    const open = (state, how) => shown.open(state, how), link = () => shown.link;
    const gallery = new Gallery(at("gallery"), { ...services, open });
    keepPast({ ...services, box, gallery, shown });
    const sliders = new Sliders(at("sliders"), services);
    const motion = new Motion(canvas, { ...services, home: () => shown.home });
    const openFile = (state) => shown.openLink({ state, hasCamera: true });
    const files = openDrops(document.body, { ...services, drop: at("drop"), open: openFile });
    const take = new Take(at("take"), { ...services, link, openFile: files.choose });
    const reset = () => store.set({ camera: shown.home });
    narrow.addEventListener("change", placeSliders);
    placeSliders();
    const fit = (what) => shown.fit(what), showBox = (box) => shown.showBox(box);
    mountView(at("view"), { ...services, motion, fit, showBox, reset });
    mountWaiting(at("waiting"), { ...services, stage: at("stage") });
    mountNothing(at("nothing"), { ...services, fit: (what) => shown.fit(what) });
    mountLook(at("look"), services);
    mountCertain(at("certain"), services);
    const ray = mountRay(at("ray"), { ...services, line: at("hit") });
    mountComplex(at("complex"), { ...services, open });
    fillHelp(at("help"), text);
    at("foot").append(languagesOf(text, shown), element("span", {}, text("foot.about")));
    return { gallery, sliders, motion, take, ray };
}

/** Buttons and keys. */
function listen({ text, canvas, box }, { gallery, sliders, motion, take, ray }) {
    const look = () => {
        showSection(text, "ray");
        ray.look();
    };
    let last = null; // the place that was looked at
    canvas.addEventListener("place", ({ detail: { x, y } }) => {
        const { clientWidth, clientHeight } = canvas;
        const isAgain = last && Math.hypot((x - last.x) * clientWidth, (y - last.y) * clientHeight) < AGAIN;
        if (!narrow.matches || (isAgain && !at("hit").hidden)) look();
        last = { x, y };
    });
    at("hit").addEventListener("click", look);
    at("handle").addEventListener("click", () => {
        openPanel(text, !document.body.classList.contains("open"));
        ray.look();
    });
    at("copy-link").addEventListener("click", () => take.copyLink());
    at("open-save").addEventListener("click", () =>
        showSection(text, "take").querySelector("button").focus({ preventScroll: true }),
    );
    at("theme").addEventListener("click", switchTheme);
    at("open-help").addEventListener("click", () => at("help").showModal());
    keepKeys({
        motion,
        gallery,
        sliders,
        ray: () => canvas.dispatchEvent(new CustomEvent("place", { detail: { x: 0.5, y: 0.5 } })),
        complex: () => showSection(text, "complex").querySelector("input")?.focus(),
        equation: () => box.focus(),
        link: () => take.copyLink(),
        save: () => at("open-save").click(),
        theme: switchTheme,
        wide: () => document.body.classList.toggle("wide"),
        help: () => at("help").showModal(),
        escape: () => {
            openPanel(text, false);
            canvas.focus();
        },
    });
}

/** Titles and sentences follow the picture that is seen. */
function follow({ store, text, canvas }) {
    const seen = ({ picture, ...state }) => ({ ...(picture?.state ?? state), picture });
    const tellLater = debounced(1200, () => (at("seen").textContent = sentenceOf(seen(store.get()), text)));
    let told = ""; // what the part about the surface says
    function tell(state, moving) {
        const about = JSON.stringify([state.name, state.equation, state.picture?.degree]);
        if (about !== told) {
            at("title").textContent = titleOf(state, text);
            document.title = `${titleOf(state, text)} – algsurf`;
            showAbout(at("about"), state, text);
        }
        if (about !== told || !moving) canvas.setAttribute("aria-label", sentenceOf(state, text));
        told = about;
        if (!moving) tellLater();
    }
    tell(seen(store.get()), false);
    store.subscribe((state, { changed, moving }) => changed.has("picture") && tell(seen(state), moving));
}

/** services: { store, painter, text, canvas, shown, box, notice } */
export function makeParts(services) {
    listen(services, mountSections(services));
    follow(services);
}
