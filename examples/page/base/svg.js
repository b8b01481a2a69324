// svg.js - SVG elements, made by calls: text is never read as markup.

const SVG = "http://www.w3.org/2000/svg";

/** An element with attributes and children (elements, texts). */
export function svg(tag, attributes = {}, ...children) {
    const made = document.createElementNS(SVG, tag);
    for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, String(value));
    made.append(...children);
    return made;
}
