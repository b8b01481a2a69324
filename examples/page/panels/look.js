// look.js - the panel "colours and light": both sides, background, the light as a lamp that is dragged.
import { button, choice, row, slider } from "../base/controls.js";
import { element } from "../base/dom.js";

const USUAL = { azimuth: -31, elevation: 30 }; // near the library's own light
const radians = (degrees) => (degrees * Math.PI) / 180;
const within = (x, most) => Math.round(Math.min(Math.max(x, -most), most));

function colourField(onColour) {
    const field = element("input", {
        type: "color",
        input: () => onColour(field.value, true),
        change: () => onColour(field.value, false),
    });
    return field;
}

export function mount(room, { store, text }) {
    const colours = () => store.get().colours;
    const set = (partial, moving = false) => store.set({ colours: { ...colours(), ...partial } }, { moving });

    const outside = colourField((value, moving) => set({ outside: value }, moving));
    const inside = colourField((value, moving) => set({ inside: value }, moving));
    const own = colourField((value, moving) => set({ background: value }, moving));
    own.setAttribute("aria-label", text("look.background.own"));
    const background = choice(
        ["none", "white", "own"].map((value) => [value, text(`look.background.${value}`)]),
        (value) => set({ background: value === "none" ? "none" : value === "white" ? null : own.value }),
    );
    const swap = button(text("look.swap"), () =>
        set({ outside: colours().inside, inside: colours().outside }),
    );

    const lamp = makeLamp(store);
    const angle = (key, most) =>
        slider({
            min: -most, max: most, step: 1, "aria-label": text(`look.${key}`),
            show: (value) => `${Math.round(value)}°`,
            onInput: (value, moving) =>
                store.set({ light: { ...(store.get().light ?? USUAL), [key]: value } }, { moving }),
        });
    const azimuth = angle("azimuth", 180), elevation = angle("elevation", 90);
    const usual = button(text("look.usual"), () => store.set({ light: null }));

    room.append(
        row(text("look.outside"), outside, swap),
        row(text("look.inside"), inside),
        row(text("look.background"), background, own),
        element(
            "div",
            { class: "beside" },
            lamp.node,
            element(
                "div",
                {},
                row(text("look.azimuth.short"), azimuth.range, azimuth.output),
                row(text("look.elevation.short"), elevation.range, elevation.output),
                usual,
            ),
        ),
        element("p", { class: "hint" }, text("look.hint")),
    );

    function follow({ colours: c, light }) {
        outside.value = c.outside;
        inside.value = c.inside;
        background.value = c.background === null ? "white" : c.background === "none" ? "none" : "own";
        own.hidden = background.value !== "own";
        if (background.value === "own") own.value = c.background;
        const at = light ?? USUAL;
        azimuth.follow(at.azimuth);
        elevation.follow(at.elevation);
        usual.disabled = light === null;
        lamp.follow(at);
    }
    follow(store.get());
    store.subscribe(
        (state, { changed }) => (changed.has("colours") || changed.has("light")) && follow(state),
    );
}

/** A ball as seen from the eye; the light is where its bright place is. */
function makeLamp(store) {
    const knob = element("i");
    const node = element("div", { class: "lamp", "aria-hidden": "true" }, knob);
    const drag = (event, moving) => {
        const { left, top, width } = node.getBoundingClientRect();
        let x = (2 * (event.clientX - left)) / width - 1, y = 1 - (2 * (event.clientY - top)) / width;
        const far = Math.hypot(x, y);
        if (far > 0.98) [x, y] = [(0.98 * x) / far, (0.98 * y) / far];
        const elevation = Math.asin(y),
            azimuth = Math.asin(Math.max(-1, Math.min(1, x / Math.cos(elevation))));
        const degrees = (angle) => (angle * 180) / Math.PI;
        store.set(
            { light: { azimuth: within(degrees(azimuth), 180), elevation: within(degrees(elevation), 90) } },
            { moving },
        );
    };
    node.addEventListener("pointerdown", (event) => {
        node.setPointerCapture(event.pointerId);
        drag(event, true);
    });
    node.addEventListener(
        "pointermove",
        (event) => node.hasPointerCapture(event.pointerId) && drag(event, true),
    );
    node.addEventListener("pointerup", (event) => drag(event, false));
    const follow = ({ azimuth, elevation }) => {
        const x = Math.cos(radians(elevation)) * Math.sin(radians(azimuth)), y = Math.sin(radians(elevation));
        node.style.setProperty("--x", `${50 + 46 * x}%`);
        node.style.setProperty("--y", `${50 - 46 * y}%`);
    };
    return { node, follow };
}
