"""Reads a typed answer: a number, a list, or a calculation such as `sqrt(3)/2`. Runs nothing.

`reading.js` is the same reader in the same order; `tests/answers.json` holds both to one table.

- A product without a sign, `2pi`, ranks as `*`. By that rule `1/2pi` is pi/2, which few mean:
  a division followed by such a product is refused, and so is `√2pi`. `√` takes one thing.
- `30°` is 30 times pi/180. `,` `،` `;` `؛` and new lines separate; the last one may be left over.
- Rows, `1, 2; 3, 4`, are lists in a list; rows of one number each, `1; 2; 3`, are one flat list.
- In `[ ]` and `{ }` blanks separate as well, where nothing but numbers and lists stands inside.

A comma that touches a digit on both sides, as in `0,5`, may be decimal; all others separate.
It is decided for each pair of brackets by the first of these rules that fits:

1. A decimal point anywhere in the text, or a run as in `1,2,3`: it separates.
2. A `;`, or a comma with a space after it, beside it: it is decimal, `0,5, 1,5` and `0,5; 1,5`.
3. Brackets around it, or one more comma of any kind: it separates, `[0,5]`.
4. Otherwise, alone and outside brackets: it is decimal, `0,5`.

Refused, because both are likely: `[1,2; 3,4]`, `1,5/2` without brackets, and `1,000`.
"""

import math
import re
from dataclasses import dataclass, field
from typing import NoReturn, TypeAlias

__all__ = ["PROBLEMS", "Reading", "read"]

Value: TypeAlias = "float | list[Value]"

PROBLEMS = {
    "empty": "Nothing is typed yet. Type a number or a list, for example 0.5 or [1, 2, 3].",
    "long": "The text “{about}…” is too long: at most 1000 characters are read. Type a number or"
    " a list, for example 0.5 or [1, 2, 3].",
    "deep": "Too many brackets inside each other at “{about}”: at most 20 are read. A matrix"
    " needs two, for example [[1, 2], [3, 4]].",
    "brackets": "The bracket “{about}” has no partner. Close each bracket with its own kind, for"
    " example [1, 2] or (1 + 2)/3.",
    "missing": "A number is missing at “{about}”. For example, type 1 + 2 or [1, 2, 3].",
    "adjacent": "Something is missing between the numbers in “{about}”. Put a comma between the"
    " numbers of a list, for example 1, 2, and * in a product, for example 2*pi. Put each row in"
    " brackets, for example [[1, 2], [3, 4]].",
    "comma": "The comma in “{about}” can be read in two ways. Write decimals with a point, for"
    " example 0.5, and put a space after a comma that separates, for example 1, 2.",
    "thousands": "The number “{about}” can be read in two ways. Write no mark between thousands,"
    " for example 1000.5. Write decimals with a point, for example 1.571. In a list, put a comma"
    " and a space between numbers, for example 1, 200.",
    "parentheses": "The product in “{about}” can be read in two ways. Add parentheses: for"
    " example, 1/(2pi) or (1/2)pi, and sqrt(2pi) or sqrt(2)*pi.",
    "power": "Powers such as “{about}” cannot be read. Type a product, for example 3*3 for 3²,"
    " or 1e-3 for 10⁻³.",
    "function": "The function “{about}” cannot be read. Calculate it and type the result, for"
    " example 0.5 for sin(30°).",
    "unit": "The unit “{about}” cannot be read. Type the number without its unit, for example"
    " 0.5; the unit is given beside the box.",
    "equals": "The part “{about}” is not needed. Type only the number, for example 0.5 for"
    " v = 0.5.",
    "list": "The calculation “{about}” has a list in it, which cannot be read. Calculate each"
    " number, for example [2, 4] for 2*[1, 2].",
    "zero": "The calculation “{about}” divides by zero, so it has no value. Type a number, for"
    " example 0.5.",
    "root": "The calculation “{about}” takes the square root of a negative number, so it has no"
    " real value. An example that has one: sqrt(2).",
    "overflow": "The number in “{about}” is too large. Numbers up to 1e308 can be read.",
    "nan": "The word “{about}” is not a number. Type a number, for example 0.5.",
    "infinity": "“{about}” is not a finite number. Type a number, for example 0.5.",
    "unknown": "The part “{about}” cannot be read. Type a number or a list, for example 0.5,"
    " pi/2, sqrt(3)/2 or [1, 2, 3].",
}

LONGEST, DEEPEST = 1000, 20
PAIRS = {"(": ")", "[": "]", "{": "}"}
LISTS = ("[", "{")
SIGNS = ("+", "-", "*", "/")
PI = ("pi", "π")
FRACTIONS = {"½": 1 / 2, "¼": 1 / 4, "¾": 3 / 4, "⅓": 1 / 3, "⅔": 2 / 3}
NOT_FINITE = {"nan": "nan", "inf": "infinity", "infinity": "infinity", "∞": "infinity"}
DEGREES = ("°", "deg", "degree", "degrees")
WRAPPERS = ("array", "asarray", "matrix", "float", "int", "float64", "float32", "int64", "int32")
FUNCTIONS = (
    *("sin", "cos", "tan", "cot", "asin", "acos", "atan", "arcsin", "arccos", "arctan"),
    *("sinh", "cosh", "tanh", "exp", "log", "ln", "abs", "hypot", "pow"),
)

INVISIBLE = re.compile(
    "[\u061c\u180e\u200b-\u200f\u202a-\u202e\u2060\u2066-\u2069\ufe00-\ufe0f\ufeff]"
)
ALIKE = {
    " ": "\t\v\f\u00a0\u1680\u2000\u2001\u2002\u2003\u2004\u2005\u2006\u2007\u2008\u2009\u200a"
    "\u202f\u205f\u3000",
    "\n": "\r\u0085\u2028\u2029",
    "-": "\u02d7\u2010\u2011\u2012\u2013\u2014\u2015\u2212\u2796\ufe58\ufe63\uff0d",
    "+": "\u2795\ufb29\uff0b",
    "*": "×·∙⋅∗✕✖\u2062\uff0a",
    "/": "÷∕⁄➗\uff0f",
    ".": "٫\uff0e",
    "'": "_’‘ʼ٬\uff07",
    ",": "\uff0c",
    "،": "、",
    ";": "؛\uff1b",
    "=": "≈≃≅≡\uff1d",
    "°": "º˚",
    "^": "\uff3e",
    **{bracket: chr(ord(bracket) + 0xFEE0) for bracket in "()[]{}"},
    **{chr(0x30 + k): chr(0x660 + k) + chr(0x6F0 + k) + chr(0xFF10 + k) for k in range(10)},
    **{chr(0x61 + k): chr(0x41 + k) for k in range(26)},
}
PLAIN = {odd: plain for plain, odds in ALIKE.items() for odd in odds}

LETTERS = "a-zµ\u00c0-\u02af\u0370-\u058f\u05d0-\u05ea\u0620-\u064a\u066e-\u06d3\u0900-\u1fff"
TOKEN = re.compile(
    r"(?P<gap>[ \n]+)"
    r"|(?P<number>\.*[0-9][0-9.]*(?:'[0-9][0-9.]*)*(?:e[+-]?[0-9]+)?)"
    rf"|(?:(?:np|numpy|math)\.)?(?P<name>sqrt|[π∞]|[{LETTERS}][{LETTERS}0-9]*)"
    r"|(?P<power>\*\*|[\^²³¹\u2070-\u207f])"
    r"|(?P<sign>.)",
    re.DOTALL,
)
MARKED = re.compile(r".*'.*|[1-9][0-9]{0,2}(?:\.[0-9]{3}){2,}")  # 1'000 and 1.000.000
THOUSANDS = re.compile(  # 1,000 and 1,000.5 and 1.000,5
    r"[1-9][0-9]{0,2},[0-9]{3}(?:\.[0-9]*)?|[1-9][0-9]{0,2}\.[0-9]{3},[0-9]+"
)


@dataclass(frozen=True)
class Reading:
    """What was read: a value, or the code of a problem and the piece of text it is about."""

    value: "Value | None" = None
    problem: str = ""
    about: str = ""


@dataclass
class Token:
    """A number, a name, a power, or a sign whose kind is the sign itself."""

    kind: str
    text: str
    shown: str  # as it was typed; of a bracket, with all that stands inside
    gap: str = ""  # the white space before it
    inside: list["Token"] = field(default_factory=list)


class Refused(Exception):
    """Ends the reading: the code of the problem, and the piece of text."""


def refuse(problem: str, about: str) -> NoReturn:
    raise Refused(problem, about[:20])


def read(text: str) -> Reading:
    """Read a typed answer: a number, a nested list of numbers, or the problem with it."""
    try:
        if len(text) > LONGEST:
            refuse("long", text)
        level = nest(tokens(INVISIBLE.sub("", text)))
        return Reading(group(level, "", "") if level else refuse("empty", ""))
    except Refused as refused:
        return Reading(None, *refused.args)


def tokens(shown: str) -> list[Token]:
    """Numbers, names and signs of a text, in order."""
    found: list[Token] = []
    gap = ""
    for match in TOKEN.finditer("".join(PLAIN.get(c, c) for c in shown)):
        kind = str(match.lastgroup)
        text, typed = match[kind], shown[match.start() : match.end()]
        if kind == "gap":
            gap = text
            continue
        if kind == "number" and MARKED.fullmatch(text):
            refuse("thousands", typed)
        if kind == "number" and text.count(".") > 1:
            refuse("unknown", typed)
        if kind == "sign" or text == "sqrt":
            kind = "√" if text == "sqrt" else text
        found.append(Token(kind, text, typed, gap))
        gap = ""
        if kind == "=":
            refuse("equals", piece(found))
    return found


def piece(some: list[Token]) -> str:
    """The tokens as they were typed."""
    return some[0].shown + "".join(t.gap.replace("\n", " ") + t.shown for t in some[1:])


def nest(flat: list[Token]) -> list[Token]:
    """Put what stands in brackets inside the opening bracket; settle commas and blanks."""
    point = any(t.kind == "number" and "." in t.text for t in flat)
    levels: list[list[Token]] = [[]]
    opened: list[Token] = []
    for token in flat:
        level = levels[-1]
        if not opened and "\n" in token.gap and level and level[-1].kind != ";":
            level.append(Token(";", ";", " "))
        if token.kind in PAIRS:
            if len(opened) == DEEPEST:
                refuse("deep", token.shown)
            token.inside = level[-1:]  # until it closes: what stands before it
            level.append(token)
            opened.append(token)
            levels.append([])
        elif token.kind in PAIRS.values():
            if not opened or PAIRS[opened[-1].kind] != token.kind:
                refuse("brackets", token.shown)
            start = opened.pop()
            root = start.kind == "(" and any(t.kind == "√" for t in start.inside)
            start.shown = piece([start, *level, token])
            start.inside = blanks(commas(level, "√" if root else start.kind, point), start.kind)
            levels.pop()
        else:
            level.append(token)
    if opened:
        refuse("brackets", opened[-1].shown)
    return commas(levels[0], "", point)


def commas(level: list[Token], opener: str, point: bool) -> list[Token]:
    """Join numbers at decimal commas, by the four rules."""
    kinds = [t.kind for t in level]
    touching = [
        i
        for i in range(1, len(level) - 1)
        if kinds[i - 1 : i + 2] == ["number", ",", "number"]
        and level[i].gap + level[i + 1].gap == ""
        and "e" not in level[i - 1].text
    ]
    if not touching:
        return level
    first = piece(level[touching[0] - 1 : touching[0] + 2])
    run = any(i + 2 in touching for i in touching)
    spaced = "،" in kinds or any(
        kinds[i] == "," and level[i + 1].gap != "" for i in range(len(level) - 1)
    )
    worked = any(
        kinds[i] in SIGNS and kinds[i - 1] not in (*SIGNS, ",", ";", "√")
        for i in range(1, len(level))
    )
    if point or run:
        decimal = False
    elif opener == "√":
        decimal = True
    elif spaced or ";" in kinds:
        decimal = True
        if opener and not spaced:
            refuse("comma", first)
    else:
        decimal = not opener
        if decimal and worked:
            refuse("comma", first)
        decimal = decimal and kinds.count(",") == 1
    for i in touching:
        if doubtful(level[i - 1], level[i + 1], not opener or decimal):
            refuse("thousands", piece(level[i - 1 : i + 2]))
    if not decimal:
        return level
    joined: list[Token] = []
    for i, token in enumerate(level):
        if i - 1 in touching:
            last = joined.pop()
            both = last.text + "." + token.text
            joined.append(Token("number", both, last.shown + "," + token.shown, last.gap))
        elif i not in touching:
            joined.append(token)
    return joined


def doubtful(left: Token, right: Token, anyhow: bool = False) -> bool:
    """Whether two numbers may be one with a mark between thousands; 000 is no number alone."""
    looks = THOUSANDS.fullmatch(left.text + "," + right.text) is not None
    return looks and (anyhow or right.text[0] == "0")


def blanks(level: list[Token], opener: str) -> list[Token]:
    """Put commas where blanks separate: between plain numbers or lists in [ ] and { }."""
    starts: list[int] = []
    for i, token in enumerate(level):
        before = level[i - 1].kind if i else ";"
        if before in ("+", "-"):
            plain = token.kind == "number" and not token.gap
        else:
            plain = token.kind in ("number", "+", "-", ";", *LISTS)
            if ";" not in (before, token.kind):
                plain = plain and token.gap != ""
                starts.append(i)
        if not plain or opener not in LISTS:
            return level
    for i in reversed(starts):
        token = level[i]
        if token.kind == "number" and doubtful(level[i - 1], token):
            refuse("thousands", piece(level[i - 1 : i + 1]))
        if token.kind not in LISTS and "\n" in token.gap:
            refuse("adjacent", piece(level[i - 1 : i + 1]))
        level = [*level[:i], Token(",", ",", " "), *level[i:]]
    return level


def group(level: list[Token], opener: str, shown: str) -> Value:
    """The value of what stands in one pair of brackets, or outside all: a list, or one value."""
    rows = [
        [calculate(item, opener) for item in split(row, (",", "،"))] for row in split(level, (";",))
    ]
    if not rows:
        refuse("missing", shown)
    lists: list[Value] = [*rows]
    items = rows[0] if len(rows) == 1 else lists
    if all(len(row) == 1 for row in rows):
        items = [row[0] for row in rows]
    return items[0] if len(items) == 1 and opener not in LISTS else items


def split(level: list[Token], separators: tuple[str, ...]) -> list[list[Token]]:
    """Cut at the separators; one at the end may be left over."""
    parts: list[list[Token]] = [[]]
    for token in level:
        if token.kind not in separators:
            parts[-1].append(token)
        elif parts[-1]:
            parts.append([])
        else:
            refuse("missing", token.shown)
    return parts if parts[-1] else parts[:-1]


def calculate(item: list[Token], opener: str) -> Value:
    """The value of one item: a list, or a sum of products of signed factors."""
    i = 0

    def number(value: Value) -> float:
        if isinstance(value, list):
            refuse("list", piece(item))
        if not math.isfinite(value):
            refuse("overflow", piece(item))
        return value

    def total() -> Value:
        nonlocal i
        value = product()
        while i < len(item) and item[i].kind in ("+", "-"):
            sign = item[i]
            if opener in LISTS and sign.gap and i + 1 < len(item) and not item[i + 1].gap:
                refuse("adjacent", piece(item[i - 1 : i + 2]))  # [1 -pi]
            i += 1
            left, right = number(value), number(product())
            value = number(left + right if sign.kind == "+" else left - right)
        if i < len(item):
            refuse("power" if item[i].kind == "power" else "unknown", item[i].shown)
        return value if isinstance(value, list) else value + 0.0  # no -0

    def product() -> Value:
        nonlocal i
        value = factor()
        divided = False
        while i < len(item):
            kind = item[i].kind
            if kind in ("*", "/"):
                i += 1
                left, right = number(value), number(factor())
                if kind == "/" and right == 0:
                    refuse("zero", piece(item))
                value = number(left / right if kind == "/" else left * right)
                divided = kind == "/"
            elif multiplies():
                loose = i > 1 and item[i - 2].kind == "√" and item[i - 1].kind != "("
                if divided or loose:
                    refuse("parentheses", piece(item))
                left, right = number(value), number(factor())
                value = number(left * right)
            else:
                break
        return value

    def multiplies() -> bool:
        """Whether a factor follows without a sign; what cannot follow is refused."""
        token = item[i]
        if token.kind == "name" and not known(token.text):
            refuse("unit", piece(item[i:]))
        if token.kind == "number" and doubtful(item[i - 1], token, True):
            refuse("thousands", piece(item[i - 1 : i + 1]))
        value = token.kind in ("number", *FRACTIONS, *LISTS)
        follows = token.kind in ("name", "√", "(")
        if value or (follows and opener in LISTS and token.gap):
            refuse("adjacent", piece(item[i - 1 : i + 1]))
        return follows

    def factor() -> Value:
        nonlocal i
        signs: list[str] = []
        while i < len(item) and item[i].kind in ("+", "-", "√"):
            signs.append(item[i].kind)
            i += 1
        if i == len(item):
            refuse("missing", item[-1].shown)
        value = atom()
        for sign in reversed(signs):
            operand = number(value)
            if sign == "√" and operand < 0:
                refuse("root", piece(item))
            value = math.sqrt(operand) if sign == "√" else -operand if sign == "-" else operand
        if i < len(item) and item[i].text in DEGREES:
            i += 1
            value = number(value) * (math.pi / 180)
        return value

    def atom() -> Value:
        nonlocal i
        token = item[i]
        i += 1
        called = i < len(item) and item[i].kind == "("
        if token.kind == "number":
            return number(float(token.text))
        if token.kind in FRACTIONS:
            return FRACTIONS[token.kind]
        if token.kind in PAIRS:
            return group(token.inside, token.kind, token.shown)
        if token.text in PI:
            return math.pi
        if token.text in WRAPPERS and called:
            i += 1
            return group(item[i - 1].inside, "(", item[i - 1].shown)
        if token.text in NOT_FINITE:
            refuse(NOT_FINITE[token.text], token.shown)
        if token.kind == "name" and (called or known(token.text)):
            refuse("function", token.shown)
        if token.kind in SIGNS:
            refuse("missing", token.shown)
        refuse("power" if token.kind == "power" else "unknown", token.shown)

    return total()


def known(name: str) -> bool:
    """Whether a name is no unit; sin30 and atan2 are functions as well."""
    return name in (*PI, *WRAPPERS, *NOT_FINITE) or name.rstrip("0123456789") in FUNCTIONS
