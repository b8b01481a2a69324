// main.js - shows the first picture, and then makes the rest of the page (parts.js), which this does not
// need.
import { Notice } from "./base/notice.js";
import { loadText, translate } from "./base/text.js";
import { loadTheme } from "./base/theme.js";
import { EquationBox } from "./panels/equation.js";
import { Painter } from "./picture/painter.js";
import { stateOfLink } from "./state/link.js";
import { Shown } from "./state/shown.js";
import { checkedState } from "./state/state.js";
import { Store } from "./state/store.js";
import { SURFACES } from "./state/surfaces.js";

const PATIENCE = 1500; // milliseconds that the rest waits for the first picture
const at = (id) => document.getElementById(id);

loadTheme();
const words = loadText(); // comes while workers start
const usual = checkedState(SURFACES[0]).state;
const linked = stateOfLink(location.hash, usual);
const store = new Store({ ...usual, picture: null }); // not the link's, until it is known to be a surface
const notice = new Notice(at("notice"));

let hasPicture = () => {};
const firstPicture = new Promise((resolve) => (hasPicture = resolve));
const painter = new Painter({
    onPicture(report) {
        if (report.stage !== "moving") notice.hide("trouble", "slow");
        page.firstPicture ??= performance.now();
        store.set({ picture: report }, { moving: report.stage === "moving" });
        hasPicture();
    },
    onStatus({ kind }) {
        if (kind === "slow") void words.then((text) => notice.show(text("slow"), "slow"));
        if (kind === "replaced") void words.then((text) => notice.show(text("worker.replaced")));
    },
    onError: ({ message, code }) =>
        words.then((text) => notice.show(text("trouble", { why: message ?? code }), "trouble")),
});
const page = (window.algsurfPage = { store, painter, firstPicture: null, isWhole: false }); // for tests

const text = await words;
document.documentElement.lang = text.language;
translate(document, text);

const canvas = at("picture");
const shown = new Shown(canvas, { store, painter, tell: (say) => notice.show(say(text)) });
const open = (state) => shown.open(state);
const box = new EquationBox(
    { box: at("formula"), mirror: at("mirror"), mistake: at("mistake") },
    { store, painter, text, onSurface: (partial) => shown.openTyped(partial), open },
);
shown.onOpen = (equation) => box.show(equation);
if (linked) void shown.openLink(linked);
else shown.open(usual);

await Promise.race([firstPicture, new Promise((resolve) => setTimeout(resolve, PATIENCE))]);
const { makeParts } = await import("./parts.js");
makeParts({ store, painter, text, canvas, shown, box, notice });
page.isWhole = true;
if (isSecureContext && "serviceWorker" in navigator)
    void navigator.serviceWorker.register("offline.js", { scope: "./" });
