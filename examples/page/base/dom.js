// dom.js - elements and files: text goes in as text, never as markup.

/** An element with attributes, listeners (functions, by the event's name) and children (elements, texts). */
export function element(tag, attributes = {}, ...children) {
    const made = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) {
        if (typeof value === "function") made.addEventListener(name, value);
        else if (value === true) made.setAttribute(name, "");
        else if (value !== false && value !== undefined && value !== null)
            made.setAttribute(name, String(value));
    }
    made.append(...children);
    return made;
}

/** An element of SVG, likewise, without listeners. */
export function svg(tag, attributes = {}, ...children) {
    const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
    for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, String(value));
    made.append(...children);
    return made;
}

/** The same children again, others gone. */
export function fill(parent, ...children) {
    parent.replaceChildren(...children);
    return parent;
}

/** Hands a file to the user. */
export function download(blob, name) {
    const address = URL.createObjectURL(blob);
    const anchor = element("a", { href: address, download: name });
    document.body.append(anchor);
    anchor.click();
    anchor.remove();
    setTimeout(() => URL.revokeObjectURL(address), 60_000);
}

/** Calls `act` once nothing has asked for it during so many milliseconds. */
export function debounced(milliseconds, act) {
    let timer = 0;
    return (...values) => {
        clearTimeout(timer);
        timer = setTimeout(() => act(...values), milliseconds);
    };
}

/** Is the panel a sheet below the picture?  As in page.css. */
export const narrow = matchMedia("(max-width: 859px)");

/** What the browser keeps for this page; it may refuse to. */
export const memory = {
    get(key) {
        try {
            return JSON.parse(localStorage.getItem(`algsurf.${key}`));
        } catch {
            return null;
        }
    },
    set(key, value) {
        try {
            localStorage.setItem(`algsurf.${key}`, JSON.stringify(value));
        } catch {
            // Private windows have no storage: the page works without it.
        }
    },
};
