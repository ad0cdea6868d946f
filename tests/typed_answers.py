"""Answers as people type them, drawn from a seed: right ones, mistakes, near misses and rubbish."""

import math
import random
import re
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from courseware.units import ROWS

PERSIAN, ARABIC, WIDE = "۰۱۲۳۴۵۶۷۸۹", "٠١٢٣٤٥٦٧٨٩", "０１２３４５６７８９"
DIGITS = 7  # decimals at most: far more than any tolerance needs


@dataclass(frozen=True)
class TypedAnswer:
    """A text typed as an answer, and what it is: "right", a mistake's name, "near" or "rubbish"."""

    text: str
    kind: str


def in_digits(text, digits):
    return text.translate({ord("0") + k: digit for k, digit in enumerate(digits)})


# --- one number -----------------------------------------------------------------------------------


def decimal(x, unknown, r):
    text = f"{x:.{r.randrange(unknown.decimals + 1, DIGITS) if unknown.decimals else 0}f}"
    return r.choice([text, text, f"+{text}" if x >= 0 else text])


def scientific(x, unknown, r):
    return f"{x:.{DIGITS}{r.choice('eE')}}"


def fraction(x, unknown, r):
    ratio = Fraction(x).limit_denominator(5000)
    return f"{ratio.numerator}/{ratio.denominator}"


def times_pi(x, unknown, r):
    number = f"{x / math.pi:.{DIGITS}f}"
    return number + r.choice(["*pi", "π", "pi", "*np.pi", "·π"])


def root(x, unknown, r):
    sign, square = "-" if x < 0 else "", f"{x * x:.12f}"
    return sign + r.choice([f"sqrt({square})", f"√{square}", f"√({square})", f"np.sqrt({square})"])


def calculation(x, unknown, r):
    part = r.randrange(-9, 10) / 4
    return r.choice(
        [
            f"({x - part:.{DIGITS}f} + {part})" if part >= 0 else f"({x:.{DIGITS}f})",
            f"2*{x / 2:.{DIGITS}f}",
            f"{3 * x:.{DIGITS}f}/3",
        ]
    )


NUMBERS = [*[decimal] * 4, scientific, fraction, times_pi, root, calculation]


def with_unit(x, unknown, r):
    """A number with its unit written, or another unit of that size."""
    unit = r.choice(ROWS[unknown.unit])
    number, words = unit.from_si(x), r.choice(unit.words)
    if words == "1/s":
        words = r.choice(["1/s", " 1 / s"])
    size = DIGITS + max(0, math.ceil(-math.log10(unit.by / unit.times)))
    return (
        f"{number:.{size}f}" + r.choice(["", " ", "\u00a0"] if words[:1] != "1" else [" "]) + words
    )


# --- several numbers ------------------------------------------------------------------------------


def is_plain(text):
    """Whether blanks may separate a number from others."""
    return re.fullmatch(r"[+-]?[0-9]+(\.[0-9]+)?", text) is not None


def joined(texts, r):
    """Numbers in a row; only plain ones may be separated by blanks."""
    plain = all(map(is_plain, texts))
    between = r.choice([", ", ", ", ",", "; ", ",\t", "، ", *[" ", "  ", "\t", "\n"] * plain])
    brackets = ["[]", "[]", "  ", *["()", "{}"] * bool(between.strip())]
    start, end = r.choice(brackets)
    return start + between.join(texts) + end


def nested(rows, r):
    plain = all(is_plain(text) for row in rows for text in row)
    start, end = r.choice(["[]", "()", "{}"])
    comma, between = r.choice([(", ", ", "), (",", ","), (", ", ",\n "), (", ", "; ")])
    if plain and r.random() < 0.3:
        start, comma, between, end = "[", " ", "\n ", "]"
    inner = between.join(start + comma.join(row) + end for row in rows)
    return r.choice(["{}", "{}", "np.array({})"]).format(start + inner + end)


def bare_rows(rows, r):
    plain = all(is_plain(text) for row in rows for text in row)
    ways = [(", ", "; "), (", ", "\n"), *[("\t", "\n"), (" ", "; ")] * plain]
    comma, between = r.choice(ways)
    return between.join(comma.join(row) for row in rows)


def in_words(texts, labels, r):
    between = r.choice([", ", "; ", "\n"])
    sign = r.choice([" = ", "=", ": ", " ≈ "])
    return between.join(f"{label}{sign}{text}" for label, text in zip(labels, texts, strict=True))


# --- the whole text -------------------------------------------------------------------------------


def with_commas(text):
    """A text in which commas separate, with decimal commas instead."""
    return re.sub(r"(?<=\d)\.(?=\d)", ",", text.replace(", ", "; "))


PLAIN = [*[lambda text: text] * 6, lambda text: f"  {text}\t", lambda text: f"\u200f{text}"]
DRESSED = [
    *PLAIN,
    lambda text: f"≈ {text}",
    lambda text: f"={text}",
    lambda text: text.replace("-", "−"),
    lambda text: text.replace("-", "–"),
    lambda text: re.sub(r"(?<=\d)\.(?=\d)", "٫", in_digits(text, PERSIAN)),
    lambda text: re.sub(r"(?<=\d)\.(?=\d)", "٫", in_digits(text, ARABIC)),
    lambda text: in_digits(text, PERSIAN),
    lambda text: in_digits(text, WIDE),
    lambda text: text.replace(" ", "\u00a0"),
    lambda text: text if re.search(",(?! )|;", text) else with_commas(text),
    lambda text: f"{text}." if re.search(r"(?<![\d.])\d*\.\d+$", text) else text,
]


def write(rows, exercise, r):
    """An answer in one of the many ways to type it."""
    size, unknowns = len(exercise.unknowns), exercise.unknowns
    styles = [r.choice(NUMBERS)] * size
    if all(unknown.unit for unknown in unknowns) and r.random() < 0.25:
        styles = [with_unit] * size
    styles = [
        way if unknown.decimals else decimal for way, unknown in zip(styles, unknowns, strict=True)
    ]
    texts = [
        [way(x, unknown, r) for way, x, unknown in zip(styles, row, unknowns, strict=True)]
        for row in rows
    ]
    if len(rows) > 1:
        text = (
            r.choice([nested, bare_rows])(texts, r)
            if size > 1
            else joined([text for [text] in texts], r)
        )
    elif exercise.shape:
        columns = exercise.shape[1]
        matrix = [texts[0][k : k + columns] for k in range(0, size, columns)]
        text = r.choice([nested, nested, bare_rows])(matrix, r)
    elif size > 1:
        labels = [unknown.label for unknown in unknowns]
        if all(map(str.isidentifier, labels)) and r.random() < 0.2:
            return r.choice(PLAIN)(in_words(texts[0], labels, r))
        text = joined(texts[0], r)
    else:
        [[text]] = texts
        if r.random() < 0.2:
            return r.choice(PLAIN)(in_words([text], [unknowns[0].label], r))
        text = r.choice(["{}", "{}", "{}", "[{}]", "({})"]).format(text)
    return r.choice(DRESSED)(text)


def near(rows, exercise, r):
    """An answer that is a little off, or rounded."""
    rows, off = np.array(rows), r.choice([2, 5, 9, 11, 30])
    tolerances = np.array(
        [[u.allowed(x) for u, x in zip(exercise.unknowns, row, strict=True)] for row in rows]
    )
    rows = rows + off * tolerances * r.choice([-1, 1])
    if not exercise.unknowns[0].decimals:
        rows = np.round(rows) + 1
    return rows


RUBBISH = [
    *[
        "",
        " ",
        "?",
        "no idea",
        "ich weiß es nicht",
        "نمی‌دانم",
        "👍",
        "ada@example.org",
        "1.2.3",
        "--1",
    ],
    *[
        "=1+1",
        "=SUM(A1:A3)",
        "@SUM(1)",
        "+1+1",
        "-1+1",
        '=HYPERLINK("http://x.y")',
        "\t=1",
        "0;=cmd",
    ],
    *[
        '"',
        '"0.5"',
        '="0.5"',
        "'=0.5",
        "'0.5",
        "1,2;3\t4",
        "a,b;c",
        "[1, 2",
        "1, 2]]",
        "[[1], [2, 3]]",
    ],
    *[
        "12° 30′",
        "12°30'15\"",
        "12 deg 30 min",
        "N 12°",
        "sin(30°)",
        "1e400",
        "1/0",
        "sqrt(-1)",
        "nan",
    ],
    *[
        "inf",
        "2^3",
        "10**-3",
        "3 banana",
        "1 m/s³",
        "0x1f",
        "1_000",
        "1'000.5",
        "1 000,5",
        "1.000,5",
    ],
    *[
        "½",
        "⅓π",
        "x = y = 1",
        "0.5 or 1",
        "about 0.5",
        "0.5 I think",
        "answer: 0.5",
        "0.5!",
        "~0.5",
    ],
    *[
        "\ufeff0.5",
        "0.5\x85",
        "\x1c0.5",
        "0.5\u2028",
        "0\u20605",
        "９．５",
        "٫٥",
        "1" * 400,
        "9" * 2000,
    ],
    *[
        "[" * 30,
        "√" * 500 + "4",
        "0.5" + " " * 3000,
        "1, " * 200,
        "<b>1</b>",
        "&lt;1",
        "{right}",
        "$&",
    ],
]


def draw(seed, exercise, variant, count):
    """Answers to an exercise with the numbers of a variant."""
    r = random.Random(f"{seed} {exercise.name}")
    right = [c for c in variant.candidates if c.name == "right"]
    wrong = [c for c in variant.candidates if c.name[0] == "M"]
    found = []
    for _ in range(count):
        part = r.random()
        if part < 0.4:
            found.append(TypedAnswer(write(r.choice(right).rows, exercise, r), "right"))
        elif part < 0.65 and wrong:
            candidate = r.choice(wrong)
            found.append(TypedAnswer(write(candidate.rows, exercise, r), candidate.name))
        elif part < 0.8:
            rows = near(r.choice(right).rows, exercise, r)
            found.append(TypedAnswer(write(rows, exercise, r), "near"))
        else:
            found.append(TypedAnswer(r.choice(RUBBISH), "rubbish"))
    return found
