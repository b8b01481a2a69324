// text.js - the words of the page, from texts/LANGUAGE.json; {name} in a text stands for a value.  English
// has keys; of the other languages build leaves a list, in the order of those keys.
//
// Texts in index.html have an attribute data-text="KEY"; data-label, data-title and data-hint="KEY" stand for
// the attributes aria-label, title and placeholder.  A key that a translation lacks is shown in English.
import { memory } from "./dom.js";

export const LANGUAGES = { en: "English", de: "Deutsch", es: "Español" };
const ATTRIBUTES = { label: "aria-label", title: "title", hint: "placeholder" };

async function read(language) {
    const response = await fetch(new URL(`../texts/${language}.json`, import.meta.url));
    if (!response.ok) throw new Error(`texts/${language}.json: ${response.status}`);
    return response.json();
}

function preferred() {
    const asked = [memory.get("language"), ...navigator.languages].filter((name) => typeof name === "string");
    const known = asked.map((name) => name.slice(0, 2).toLowerCase()).filter((name) => name in LANGUAGES);
    return known[0] ?? "en";
}

/** The texts of a language: text(key, {name: value}), with text.language, text.has, text.number, and
 * text.mistake(error): what an error of the library says, the parser's messages being keys themselves. */
export async function loadText(language = preferred()) {
    const [english, own] = await Promise.all([read("en"), language === "en" ? [] : read(language)]);
    const words = new Map(Object.entries(english).map(([key, word], i) => [key, own[i] ?? word]));
    const number = new Intl.NumberFormat(language, { maximumFractionDigits: 3 });
    const text = (key, values = {}) =>
        (words.get(key) ?? key).replace(/\{(\w+)\}/g, (whole, name) => {
            const value = values[name];
            return value === undefined
                ? whole
                : typeof value === "number"
                  ? number.format(value)
                  : String(value);
        });
    text.language = language;
    text.has = (key) => words.has(key);
    text.mistake = ({ code, message }) => {
        const key = [`mistake.${code}`, `mistake: ${message}`].find(text.has);
        return key ? text(key) : message || code;
    };
    text.number = (value) => number.format(value);
    return text;
}

/** Puts the texts into the marked elements of a part of the page. */
export function translate(root, text) {
    for (const marked of root.querySelectorAll("[data-text]")) marked.textContent = text(marked.dataset.text);
    for (const [name, attribute] of Object.entries(ATTRIBUTES))
        for (const marked of root.querySelectorAll(`[data-${name}]`))
            marked.setAttribute(attribute, text(marked.dataset[name]));
}
