// Text as every part shows it.

const escaped = (text) => String(text).replace(/[&<>"]/g, (sign) =>
  ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[sign]);

const trueMinus = (text) => text.replace("-", "\u2212");

// A number's text and its unit: 30°, 2 m, 2.
const withUnit = (text, unit) => !unit || JOINED.includes(unit) ? text + unit : `${text} ${unit}`;

// A text as HTML. Its symbols are letters with an index, as "θ̇_1", and one above, as "θ_1^away".
const symbols = (text, written = "<i>$1</i><sub>$2</sub>") =>
  escaped(text).replace(/(\p{L}[\u0300-\u036f]*)_([0-9A-Za-z]+)/gu, written)
    .replace(/<\/sub>\^([0-9A-Za-z]+|[+\u2212-])/g, "</sub><sup>$1</sup>");
