// number.js - numbers as the panels write them: a true minus sign, powers of ten with an exponent above.

const RAISED = { 0: "⁰", 1: "¹", 2: "²", 3: "³", 4: "⁴", 5: "⁵", 6: "⁶", 7: "⁷", 8: "⁸", 9: "⁹", "-": "⁻" };

/** An integer as an exponent. */
export const raised = (integer) => [...String(integer)].map((digit) => RAISED[digit]).join("");

function withPower(text) {
    const [mantissa, exponent] = text.split("e");
    if (exponent === undefined) return mantissa;
    return `${mantissa}·10${raised(Number(exponent))}`;
}

/** At most `digits` significant ones, without zeros at the end. */
export function short(value, digits = 4) {
    if (!Number.isFinite(value)) return value > 0 ? "∞" : value < 0 ? "−∞" : "?";
    return withPower(String(Number(value.toPrecision(digits)))).replace(/^-/, "−");
}

/** All digits that tell a double from its neighbours. */
export const whole = (value) => short(value, 17);

/** An enclosure. */
export const between = (lo, hi) => `[${whole(lo)}, ${whole(hi)}]`;

/** An integer as an index. */
export const lowered = (integer) => [...String(integer)].map((digit) => "₀₁₂₃₄₅₆₇₈₉"[digit]).join("");
