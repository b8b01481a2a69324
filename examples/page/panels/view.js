// view.js - the panel "view": extent, axes, cutting plane, thin features, fitting.
import { clipRows } from "./clip.js";
import { button, choice, numberField, row, slider } from "../base/controls.js";
import { element } from "../base/dom.js";
import { isBox, radiusOf } from "../state/state.js";

const DECADES = 2; // of the radius, around the one that was fitted
const THIN_DEGREE = 24; // above it the library draws nothing that is thin

/** services: { store, text, motion, fit(what): "view" chooses extent and camera, "camera" the camera,
 * showBox(box), reset } */
export function mount(room, { store, text, motion, fit, showBox, reset }) {
    const extent = () => store.get().extent;
    const set = (partial, moving = false) => store.set({ extent: { ...extent(), ...partial } }, { moving });
    let base = radiusOf(extent());

    const kind = choice(
        ["fitted", "sphere", "box"].map((value) => [value, text(`view.extent.${value}`)]),
        (value) => changeKind(value),
    );
    function changeKind(value) {
        if (value === "fitted") return void fit("view");
        const { size } = extent();
        const halves = isBox(extent()) ? size : [size[0], size[0], size[0]];
        set({ kind: value, size: value === "box" ? halves : [radiusOf(extent())] });
    }

    const radius = slider({
        min: -DECADES, max: DECADES, step: 0.01,
        show: () => text.number(Number(radiusOf(extent()).toPrecision(3))),
        onInput: (share, moving) => resize((base * 10 ** share) / radiusOf(extent()), moving),
    });
    function resize(times, moving) {
        const size = extent().size.map((x) => Number((x * times).toPrecision(3)));
        set({ kind: isBox(extent()) ? "box" : "sphere", size }, moving);
    }

    const edges = ["x", "y", "z"].map((axis, i) =>
        numberField({
            label: text("view.edge", { axis }),
            min: 1e-6,
            onNumber: (x) => set({ kind: "box", size: extent().size.with(i, x) }),
        }),
    );
    const centre = ["x", "y", "z"].map((axis, i) =>
        numberField({
            label: text("view.centre.of", { axis }),
            onNumber: (x) =>
                set({ kind: isBox(extent()) ? "box" : "sphere", centre: extent().centre.with(i, x) }),
        }),
    );
    const trio = (label, fields) =>
        element(
            "div",
            { class: "row", role: "group", "aria-label": label },
            element("span", { class: "label" }, label),
            ...fields,
        );
    const edgeRow = trio(text("view.edges"), edges);

    const thin = choice(
        [["usual", text("view.thin.usual")], ["yes", text("view.thin.yes")], ["no", text("view.thin.no")]],
        (value) => store.set({ thin: value === "usual" ? null : value === "yes" }),
    );

    const tick = (change) => element("input", { type: "checkbox", change: () => change() });
    const box = tick(() => showBox(box.checked)), axes = tick(() => store.set({ axes: axes.checked }));

    room.append(
        row(text("view.extent"), kind),
        row(text("view.radius"), radius.range, radius.output),
        edgeRow,
        trio(text("view.centre"), centre),
        row(text("view.box"), box),
        row(text("view.axes"), axes),
        ...clipRows({ store, text, motion }),
        row(text("view.thin"), thin),
        element(
            "div",
            { class: "buttons" },
            button(text("view.fit"), () => fit("camera")),
            button(text("view.reset"), reset),
        ),
    );

    function follow(state) {
        const now = radiusOf(state.extent);
        if (Math.abs(Math.log10(now / base)) > DECADES || document.activeElement !== radius.range) base = now;
        radius.follow(Math.log10(now / base));
        kind.value = state.extent.kind;
        edgeRow.hidden = !isBox(state.extent);
        if (isBox(state.extent)) edges.forEach((field, i) => field.follow(state.extent.size[i]));
        centre.forEach((field, i) => field.follow(state.extent.centre[i]));
        box.checked = state.box;
        axes.checked = state.axes;
        thin.value = state.thin === null ? "usual" : state.thin ? "yes" : "no";
        thin.disabled = state.complex !== null || (state.picture?.degree ?? 0) > THIN_DEGREE;
    }
    follow(store.get());
    store.subscribe((state, { changed }) => {
        if (["extent", "thin", "axes", "box", "complex", "picture"].some((key) => changed.has(key))) follow(state);
    });
}
