// Text as every part shows it.

import { TIGHT_UNITS } from "./constants.js";

export const escapeHtml = (text) => String(text).replace(/[&<>"]/g, (sign) =>
  ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[sign]);

// A number's text as it is set: a minus, and a sign for infinity.
export const trueMinus = (text) => text.replace("-", "\u2212").replace("Infinity", "∞");

// A number's text and its unit: 30°, 2 m, 2.
export const withUnit = (text, unit) => !unit || TIGHT_UNITS.includes(unit) ? text + unit : `${text} ${unit}`;

// A text as HTML. Its symbols are letters with an index, as "θ̇_1", and one above, as "θ_1^away".
export const renderSymbols = (text, written = "<i>$1</i><sub>$2</sub>") =>
  escapeHtml(text).replace(/(\p{L}[\u0300-\u036f]*)_([0-9\p{L}]+)/gu, written)
    .replace(/<\/sub>\^([0-9A-Za-z]+|[+\u2212-])/g, "</sub><sup>$1</sup>");

export const formatNumber = (number, digits) => trueMinus(String(Number(number.toPrecision(digits))));

// What stays the same is not touched: a page is laid out anew for each text that is written.
export const writeText = (element, text) => { if (element.textContent !== text) element.textContent = text; };

export const fillTemplate = (text, values) => text.replace(/\{([\w.:]+)\}/g, (_, name) => values[name]);
