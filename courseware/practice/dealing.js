// Which numbers a student gets: the same hash as in dealing.py; a test holds the two together.

// what Python, browsers and Unicode all take for white space, written out so that all agree
const SPACES = /[\t-\r\x1c- \x85\xa0\u1680\u2000-\u200a\u2028\u2029\u202f\u205f\u3000\ufeff]+/g;
const UNSEEN = /[\xad\u200b-\u200f\u202a-\u202e\u2060-\u2064]/g;

const ZEROS = [0x660, 0x6f0, 0x966, 0xff10]; // of Arabic, Persian, Hindi and wide digits
const ourDigit = (digit) => {
  const value = ZEROS.map((zero) => digit.codePointAt(0) - zero).find((k) => k >= 0 && k < 10);
  return value === undefined ? digit : String(value);
};

const foldedName = (name) => [...name]
  .map((sign) => /[\ud800-\udfff]/.test(sign) && sign.length === 1 ? "\ufffd" : sign).join("")
  .normalize("NFC").replace(UNSEEN, "").replace(SPACES, " ").replace(/^ | $/g, "")
  .replace(/\u064a/g, "\u06cc").replace(/\u0643/g, "\u06a9").replace(/\p{Nd}/gu, ourDigit)
  .toLowerCase().normalize("NFC");

// Which numbers a student has, in four digits: to see that a name is written as before.
const numberSet = (course, name) => String(fnv1a([foldedName(course), foldedName(name)].join("\n")) % 10000)
  .padStart(4, "0");

const utf8 = (text) => [...encodeURIComponent(text).matchAll(/%(..)|(.)/g)]
  .map(([, hex, sign]) => (hex ? parseInt(hex, 16) : sign.charCodeAt(0)));

const fnv1a = (text) => utf8(text)
  .reduce((value, byte) => Math.imul(value ^ byte, 0x01000193), 0x811c9dc5) >>> 0;

const dealtVariant = (course, exercise, name) => {
  const value = fnv1a([foldedName(course), exercise, foldedName(name)].join("\n"));
  return ((value ^ value >>> 16) >>> 0) % VARIANTS;
};

Object.assign(part, { dealtVariant });
