"""Judging: every answer of every variant, and what is said of it."""

import json
import math
from itertools import product

import numpy as np
import pytest
from declared import EXERCISES, each, typed

from courseware.answers import Unknown
from courseware.practice import Exercise, judging, variants
from courseware.practice.candidates import outcomes
from courseware.script import engine as script

each_exercise = each("exercise", "exercises", Exercise)


@each_exercise
def test_every_candidate_of_every_variant_is_named(exercise):
    dealt = variants.all_variants(exercise.name)
    assert len(dealt) == variants.VARIANTS
    different = len({tuple(variant.numbers.values()) for variant in dealt})
    assert different == variants.VARIANTS, (
        f"{different} different sets of numbers, {variants.VARIANTS} needed: more options for them"
    )
    for variant in dealt:
        lost = {m.name for m in exercise.wrong} - {c.name for c in variant.candidates}
        assert not lost, f"with {variant.numbers} nobody can make {lost}"
    answers = [
        (number, candidate)
        for number, variant in enumerate(dealt)
        for candidate in variant.candidates
    ]
    verdicts = judged(exercise, [(number, typed(c.rows, exercise)) for number, c in answers])
    for (number, candidate), verdict in zip(answers, verdicts, strict=True):
        if (
            candidate.name.removeprefix("slip:") in exercise.likely_slips
        ):  # beside another of its number
            assert candidate.name.removeprefix("slip:") in verdict.feedback
        else:
            assert verdict.name == candidate.name, (dealt[number].numbers, candidate)
        wanted = "right" if candidate.name == "right" else "wrong"
        wanted = "partly" if candidate.name.startswith("unit:") else wanted
        assert verdict.result == wanted


@each_exercise
def test_what_an_answer_should_be_written_like_can_be_read(exercise):
    like = script.call("courseware.formatExample", judging.serialize_exercise(exercise))
    (verdict,) = judged(exercise, [(0, like)])
    if exercise.accept == "all":  # how many there are is asked, too: of several two are shown
        assert np.shape(json.loads(like.replace("\u00a0", ""))) in (
            (2,),
            (2, len(exercise.unknowns)),
        )
    else:
        assert verdict.result != "unread"
    (told,) = judged(exercise, [(0, "[[[1], [2], [3]]]")])
    assert told.result == "unread"
    assert f"Write it like {like}." in told.feedback


@pytest.mark.parametrize("name", ["bicycle-2", "bicycle-4", "bicycle-5"])
@pytest.mark.parametrize("sign", ["°", ""])
def test_a_right_angle_in_whole_degrees_is_nobody_s_mistake(name, sign):
    exercise = EXERCISES[name]
    right = [
        np.degrees(variant.candidates[0].rows[0][0]) for variant in variants.all_variants(name)
    ]
    answers = [(k, f"{x:.0f}{sign}") for k, x in enumerate(right) if abs(x) >= 10]
    assert len(answers) > 40
    named = {verdict.name for verdict in judged(exercise, answers)}
    assert named <= {"near", "right", "unit:degrees"}


def judged(exercise, answers):
    """The verdicts on answers, each with the number of its variant."""
    candidates = [variant.candidates for variant in variants.all_variants(exercise.name)]
    return judging.judge_all(exercise, candidates, answers)


@each_exercise
def test_what_is_no_documented_mistake_is_mostly_named(exercise):
    """A name that is hardly ever used would be dead."""
    for words in exercise.likely_slips:
        named = [
            any(c.name == f"slip:{words}" for c in variant.candidates)
            for variant in variants.all_variants(exercise.name)
        ]
        assert sum(named) >= variants.VARIANTS / 4, (
            f"'{words}' is named in {sum(named)} of {variants.VARIANTS} variants only: "
            "in the others it gives what another answer gives"
        )


@each_exercise
def test_whole_turns_more_or_less_do_not_matter(exercise):
    """So the page and the sheets say of all angles."""
    assert all(ask.circle for ask in exercise.unknowns if ask.unit == "rad")
    turn = np.array([2 * math.pi * ask.circle for ask in exercise.unknowns])
    answers = [
        (k, typed(np.array(v.candidates[0].rows) + turns * turn, exercise))
        for k, v in enumerate(variants.all_variants(exercise.name))
        for turns in (1, -2)
    ]
    assert {verdict.name for verdict in judged(exercise, answers)} == {"right"}


@each("exercise", "exercises", Exercise, only=lambda e: len(e.unknowns) == 1 and e.accept == "one")
def test_right_answers_of_two_decimals_are_never_called_a_mistake(exercise):
    rights = [v.candidates[0].rows for v in variants.all_variants(exercise.name)]
    answers = [(k, typed(np.round(rows, 2), exercise)) for k, rows in enumerate(rights)]
    named = {v.name for v in judged(exercise, answers)} - {"right", "near"}
    assert not named, (
        f"{exercise.name}: the right answer with two decimals is called {named}: take other "
        "numbers, in which that mistake is further off"
    )


@each("exercise", "exercises", Exercise, only=lambda e: e.wrong and e.accept != "all")
def test_what_a_mistake_gives_is_never_called_very_close(exercise):
    """However few of its digits are typed, and in whichever unit the judge knows."""
    ones = np.ones(len(exercise.unknowns))
    units = [np.array(o.factors) for n, o in outcomes(exercise).items() if n.startswith("unit:")]
    answers = []
    for number, variant in enumerate(variants.all_variants(exercise.name)):
        for rows in (c.rows for c in variant.candidates if outcomes(exercise)[c.name].why):
            for factors, digits in product([ones, *units], range(5)):
                answer = (np.array(rows) * factors).round(digits)
                off = abs(answer - np.array(rows) * factors)
                allowed = list(map(Unknown.allowed, exercise.unknowns, rows[0], factors))
                if len(rows) == 1 and (off < allowed).all():
                    answers.append((number, typed(answer, exercise)))
    near = [a for a, v in zip(answers, judged(exercise, answers), strict=True) if v.name == "near"]
    assert answers
    assert not near


def test_a_mistake_in_whole_degrees_is_that_mistake():
    """The mean of two angles is as round as the right angle, rounded."""
    for name in ("bicycle-2", "bicycle-4"):
        exercise = EXERCISES[name]
        means = [
            (k, np.degrees(c.rows[0][0]))
            for k, v in enumerate(variants.all_variants(name))
            for c in v.candidates
            if c.name == "M18"
        ]
        whole = [(k, f"{x:.0f}{sign}") for k, x in means if x % 1 < 1e-9 for sign in ("°", "")]
        assert len(whole) > 20
        assert all("averaged" in v.feedback for v in judged(exercise, whole))
