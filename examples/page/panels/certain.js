// certain.js - the line that says what is proved of the picture, and, unfolded, what that means.
import { element } from "../base/dom.js";
import { freshId } from "../base/widgets.js";

const SENTENCES = ["decided", "doubles", "integers", "first", "samples"];

function lineOf(report, text) {
    const { degree, ms, workers, pixels, undecided, exact } = report;
    const parts = [
        text("certain.degree", { degree }),
        text("certain.ms", { ms: Math.max(1, Math.round(ms)) }),
        text(workers === 1 ? "certain.worker" : "certain.workers", { workers }),
        undecided === 0 ? text("certain.all", { pixels }) : text("certain.some", { pixels, undecided }),
    ];
    if (exact > 0) parts.push(text("certain.exact", { exact }));
    return parts.join(" · ");
}

/** Puts the line into an element; it follows store.get().picture, the painter's last report. */
export function mount(room, { store, text }) {
    const id = freshId("certain");
    const line = element("button", {
        type: "button",
        class: "certain-line",
        "aria-expanded": "false",
        "aria-controls": id,
    });
    const sentences = SENTENCES.map((name) => element("li", {}, text(`certain.why.${name}`)));
    const why = element("ol", { id, class: "certain-why", tabindex: 0, hidden: true }, ...sentences);
    const unfold = (open) => {
        why.hidden = !open;
        line.setAttribute("aria-expanded", String(open));
    };
    line.addEventListener("click", () => unfold(why.hidden));
    room.addEventListener("keydown", (event) => {
        if (event.key !== "Escape" || why.hidden) return;
        event.stopPropagation();
        unfold(false);
        line.focus();
    });
    const follow = ({ picture }) => {
        line.hidden = !picture;
        if (!picture) return;
        line.textContent = lineOf(picture, text);
        line.classList.toggle("certain-open", picture.undecided > 0);
    };
    room.append(line, why);
    follow(store.get());
    store.subscribe((state, { changed }) => changed.has("picture") && follow(state));
}
