// files.js - files of SURFER opened: by dropping them on the page, or by a dialog.
import { element } from "../base/dom.js";
import { LARGEST, stateOfFile } from "./jsurf.js";
import { checkedState } from "../state/state.js";

/** Java writes the bytes of ISO 8859-1; a text that is UTF-8 was written by other means. */
function decoded(bytes) {
    try {
        return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
    } catch {
        return new TextDecoder("latin1").decode(bytes);
    }
}

/** services: { text, notify, drop: what is shown while a file is above the page, open(state) } */
export function openDrops(room, { text, notify, drop, open }) {
    async function read(file) {
        try {
            if (file.size > LARGEST) return notify(text("file.large"));
            const { state, bad } = checkedState(stateOfFile(decoded(await file.arrayBuffer())));
            if (bad.includes("equation")) return notify(text("file.none"));
            open(state);
            if (bad.length > 0) notify(text("link.bad", { what: bad.join(", ") }));
        } catch (error) {
            notify(text(error.key ?? "file.none", error.values));
        }
    }

    const isFile = (event) => event.dataTransfer?.types.includes("Files");
    room.addEventListener("dragover", (event) => {
        if (!isFile(event)) return;
        event.preventDefault();
        drop.hidden = false;
    });
    room.addEventListener("dragleave", (event) => {
        if (!event.relatedTarget) drop.hidden = true;
    });
    room.addEventListener("drop", (event) => {
        if (!isFile(event)) return;
        event.preventDefault();
        drop.hidden = true;
        const [file] = event.dataTransfer.files;
        if (file) void read(file);
    });

    const input = element("input", { type: "file", accept: ".jsurf,text/plain", change: () => {
        if (input.files[0]) void read(input.files[0]);
        input.value = "";
    } });
    return { choose: () => input.click() };
}
