// help.js - the dialog that shows what pointers do, and the keys.
import { element, fill } from "../base/dom.js";
import { button } from "../base/controls.js";

const KEYS = [
    [["←", "→", "↑", "↓"], "help.turn"],
    [["<", ">"], "help.roll"],
    [["+", "−"], "help.zoom"],
    [["0"], "help.reset"],
    [["E"], "help.equation"],
    [["P"], "help.play"],
    [["[", "]"], "help.next"],
    [["R"], "help.ray"],
    [["C"], "help.complex"],
    [["L"], "help.link"],
    [["S"], "help.save"],
    [["T"], "help.theme"],
    [["W"], "help.wide"],
    [["?"], "help.help"],
    [["Esc"], "help.escape"],
];
const POINTERS = ["drag", "shift", "alt", "cut", "wheel", "ctrlwheel", "pinch", "double", "click"];

export function fillHelp(dialog, text) {
    const key = (name) => element("kbd", {}, name);
    const keys = KEYS.flatMap(([names, what]) => [
        element("dt", {}, ...names.map(key)),
        element("dd", {}, text(what)),
    ]);
    const pointers = POINTERS.flatMap((name) => [
        element("dt", {}, text(`help.${name}.how`)),
        element("dd", {}, text(`help.${name}`)),
    ]);
    fill(
        dialog,
        element("h2", { id: "help-title", tabindex: -1, autofocus: true }, text("help.title")),
        element("div", { class: "lists" }, element("dl", {}, ...pointers), element("dl", {}, ...keys)),
        button(text("close"), () => dialog.close(), { class: "main" }),
    );
}
