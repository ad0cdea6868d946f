"""The variants of an exercise, and the hash that deals one to a student.

The hash is 32-bit FNV-1a over the UTF-8 of course, exercise and name, joined by line feeds; the
page computes the same. Names are compared in small letters, in Unicode's form NFKC, without
invisible characters, with one form of each apostrophe, hyphen and digit and of the letters of
Arabic that look like Persian ones, each run of spaces one; "Curie, Marie" is "Marie Curie".
"""

import hashlib
import json
import random
import re
import unicodedata
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from courseware.errors import CourseError
from courseware.practice.bank import all_exercises, find_exercise
from courseware.practice.candidates import Candidate, find_candidates, find_clash
from courseware.practice.exercises import Exercise

VARIANTS, FEWEST = 64, 14  # sets of numbers; the fewest that a secret must find
ATTEMPTS = 200  # for each variant: an exercise that needs more should draw otherwise
# what Python, browsers and Unicode all take for white space, written out so that all agree
SPACES = "[\t-\r\x1c- \x85\xa0\u1680\u2000-\u200a\u2028\u2029\u202f\u205f\u3000\ufeff]+"
IGNORED = "[\xad\u061c\u200b-\u200f\u202a-\u202e\u2060-\u206f]"
ALIKE = {  # each character, and its plain form
    odd: plain
    for plain, odds in {
        "'": "’‘‛ʼʻ`´′",
        "-": "‐‑‒–—―−˗",
        "i": "ıİ",
        "ی": "يى",
        "ک": "ك",
        "ه": "ة",
        "ا": "أإٱ",
        **{str(k): chr(0x660 + k) + chr(0x6F0 + k) + chr(0x966 + k) for k in range(10)},
    }.items()
    for odd in odds
}
_TO_PLAIN = str.maketrans(ALIKE)


@dataclass(frozen=True)
class Variant:
    """One set of numbers, as formulas take them, and all that can be answered to them."""

    numbers: Mapping[str, Any]
    candidates: tuple[Candidate, ...]


def fold_name(name: str) -> str:
    """Return a student's name as it is hashed."""
    plain = unicodedata.normalize("NFKC", name.translate(_TO_PLAIN)).translate(_TO_PLAIN)
    tidy = re.sub(SPACES, " ", re.sub(IGNORED, "", plain)).strip(" ")
    ordered = re.sub("^([^,]+), ?([^,]+)$", r"\2 \1", tidy)
    return unicodedata.normalize("NFC", ordered.lower())


def fnv1a(text: str) -> int:
    """Return the 32-bit FNV-1a hash of the text's UTF-8 bytes."""
    value = 0x811C9DC5
    for byte in text.encode("utf-8"):
        value = (value ^ byte) * 0x01000193 & 0xFFFFFFFF
    return value


def choose_variant(course: str, exercise: str, name: str) -> int:
    """Return the number of a student's variant: the hash, its halves folded together."""
    value = fnv1a("\n".join((fold_name(course), exercise, fold_name(name))))
    return (value ^ value >> 16) % VARIANTS


def find_variant(course: str, exercise: str, name: str = "") -> Variant:
    """Return a student's variant, by default that of somebody without a name."""
    return all_variants(exercise)[choose_variant(course, exercise, name)]


def all_variants(name: str, secret: str = "") -> tuple[Variant, ...]:
    """Draw the variants of an exercise by a fixed seed: each different, no two answers alike.

    A teacher's secret draws others, none of which is on the page; where an exercise has few
    numbers, these are fewer than 64.
    """
    return _variants(name, secret)


@cache
def _variants(name: str, secret: str) -> tuple[Variant, ...]:
    exercise = find_exercise(name)
    draw, met = random.Random(f"{name} {secret}" if secret else name), Counter[str]()
    public = {tuple(v.numbers.values()) for v in all_variants(name)} if secret else set()
    found: dict[tuple[Any, ...], Variant] = {}
    for _ in range(ATTEMPTS * VARIANTS):
        numbers = {
            name: given.to_si(given.options[int(draw.random() * len(given.options))])
            for name, given in exercise.given.items()
        }
        key = tuple(numbers.values())
        if key in found or key in public or not exercise.when(**numbers):
            continue
        variant, clash = _make_variant(exercise, numbers)
        met[clash] += 1
        if not clash:
            found[key] = variant
        if len(found) == VARIANTS:
            break
    if len(found) >= (needed := FEWEST if secret else VARIANTS):
        return tuple(found.values())
    raise CourseError(
        f"{name}: only {len(found)} sets of numbers, needed are {needed}: more options in given; "
        f"too close to tell apart, how often: { {pair: n for pair, n in met.items() if pair} }"
    )


def _make_variant(exercise: Exercise, numbers: Mapping[str, Any]) -> tuple[Variant, str]:
    """Return a variant, and two of its candidates that an answer could mean, or ""."""
    try:
        with np.errstate(divide="ignore", invalid="ignore"):  # `find_clash` tells infinities
            possible = find_candidates(exercise, numbers)
    except np.linalg.LinAlgError:
        return Variant(numbers, ()), "a mistake that has no answer"
    return Variant(numbers, possible), find_clash(exercise, possible)


@cache
def version() -> str:
    """Return the bank's version, which changes when any text, number or tolerance does."""
    parts = [
        (
            exercise.name,
            exercise.text,
            exercise.solution.text,
            [vars(unknown) for unknown in exercise.unknowns],
            [exercise.format_given(variant.numbers) for variant in all_variants(exercise.name)],
        )
        for exercise in all_exercises().values()
    ]
    return hashlib.sha256(json.dumps(parts).encode()).hexdigest()[:8]
