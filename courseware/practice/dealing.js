// Which numbers a student gets: the same hash as in dealing.py; a test holds the two together.

import { VARIANTS } from "./constants.js";

// what Python, browsers and Unicode all take for white space, written out so that all agree
// oxlint-disable-next-line no-control-regex
const SPACES = /[\t-\r\x1c- \x85\xa0\u1680\u2000-\u200a\u2028\u2029\u202f\u205f\u3000\ufeff]+/g;
const UNSEEN = /[\xad\u200b-\u200f\u202a-\u202e\u2060-\u2064]/g;

const ZEROS = [0x660, 0x6f0, 0x966, 0xff10]; // of Arabic, Persian, Hindi and wide digits
const toAsciiDigit = (digit) => {
  const value = ZEROS.map((zero) => digit.codePointAt(0) - zero).find((k) => k >= 0 && k < 10);
  return value === undefined ? digit : String(value);
};

export const foldName = (name) => [...name]
  .map((sign) => /[\ud800-\udfff]/.test(sign) && sign.length === 1 ? "\ufffd" : sign).join("")
  .normalize("NFC").replace(UNSEEN, "").replace(SPACES, " ").replace(/^ | $/g, "")
  .replace(/\u064a/g, "\u06cc").replace(/\u0643/g, "\u06a9").replace(/\p{Nd}/gu, toAsciiDigit)
  .toLowerCase().normalize("NFC");

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
