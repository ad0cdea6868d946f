// Which numbers a student gets: the same hash as in variants.py; a test holds the two together.

import { ALIKE, IGNORED, SPACES, VARIANTS } from "./constants.js";

const replaceAlike = (text) => [...text].map((sign) => ALIKE[sign] ?? sign).join("");

export const foldName = (name) => replaceAlike(replaceAlike(name).normalize("NFKC"))
  .replace(RegExp(IGNORED, "g"), "").replace(RegExp(SPACES, "g"), " ").replace(/^ | $/g, "")
  .replace(/^([^,]+), ?([^,]+)$/, "$2 $1").toLowerCase().normalize("NFC");

const utf8Bytes = (text) => [...encodeURIComponent(text).matchAll(/%(..)|(.)/g)]
  .map(([, hex, sign]) => (hex ? parseInt(hex, 16) : sign.charCodeAt(0)));

const fnv1a = (text) => utf8Bytes(text)
  .reduce((value, byte) => Math.imul(value ^ byte, 0x01000193), 0x811c9dc5) >>> 0;

export const chooseVariant = (course, exercise, name) => {
  const value = fnv1a([foldName(course), exercise, foldName(name)].join("\n"));
  return ((value ^ value >>> 16) >>> 0) % VARIANTS;
};
