// Which numbers a student gets: the same hash as in dealing.py; a test holds the two together.

import { ALIKE, IGNORED, SPACES, VARIANTS } from "./constants.js";

const replaceAlike = (text) => [...text].map((sign) => ALIKE[sign] ?? sign).join("");

export const foldName = (name) => {
  const whole = [...name].map((sign) => /[\ud800-\udfff]/.test(sign) && sign.length === 1 ? "\ufffd" : sign).join("");
  return replaceAlike(replaceAlike(whole).normalize("NFKC"))
    .replace(RegExp(IGNORED, "g"), "").replace(RegExp(SPACES, "g"), " ").replace(/^ | $/g, "")
    .replace(/^([^,]+), ?([^,]+)$/, "$2 $1").toLowerCase().normalize("NFC");
};

// Which numbers a student has, in four digits: to see that a name is written as before.
export const describeNumberSet = (course, name) => String(fnv1a([foldName(course), foldName(name)].join("\n")) % 10000)
  .padStart(4, "0");

const utf8Bytes = (text) => [...encodeURIComponent(text).matchAll(/%(..)|(.)/g)]
  .map(([, hex, sign]) => (hex ? parseInt(hex, 16) : sign.charCodeAt(0)));

const fnv1a = (text) => utf8Bytes(text)
  .reduce((value, byte) => Math.imul(value ^ byte, 0x01000193), 0x811c9dc5) >>> 0;

export const dealVariant = (course, exercise, name) => {
  const value = fnv1a([foldName(course), exercise, foldName(name)].join("\n"));
  return ((value ^ value >>> 16) >>> 0) % VARIANTS;
};
