"""Judging: every answer of every variant, and what is said of it, in Python and on the page."""

import base64
import json
import math
import zlib

import numpy as np
import pytest
from declared import EXERCISES, each, typed

from book.odometry.exercises import resolution, rolled
from courseware import practice
from courseware.practice import Exercise, candidates, dealing, judging, rendering
from courseware.practice.candidates import Candidate
from courseware.script import engine as script

each_exercise = each("exercise", "exercises", Exercise)


@each_exercise
def test_every_candidate_of_every_variant_is_named(exercise):
    dealt = dealing.variants(exercise.name)
    assert len(dealt) == dealing.VARIANTS
    different = len({tuple(variant.numbers.values()) for variant in dealt})
    assert different == dealing.VARIANTS, (
        f"{different} different sets of numbers, {dealing.VARIANTS} needed: more options in `given`"
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
        if candidate.name.removeprefix("slip:") in exercise.also:  # beside another of its number
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
    right = [np.degrees(variant.candidates[0].rows[0][0]) for variant in dealing.variants(name)]
    answers = [(k, f"{x:.0f}{sign}") for k, x in enumerate(right) if abs(x) >= 10]
    assert len(answers) > 40
    named = {verdict.name for verdict in judged(exercise, answers)}
    assert named <= {"near", "right", "unit:degrees"}


def judged(exercise, answers):
    """The verdicts on answers, each with the number of its variant."""
    variants = [variant.candidates for variant in dealing.variants(exercise.name)]
    return judging.judge_all(exercise, variants, answers)


@each_exercise
def test_what_is_no_documented_mistake_is_mostly_named(exercise):
    """A name that is hardly ever used would be dead."""
    for words in exercise.also:
        named = [
            any(c.name == f"slip:{words}" for c in variant.candidates)
            for variant in dealing.variants(exercise.name)
        ]
        assert sum(named) >= dealing.VARIANTS / 4, (
            f"'{words}' is named in {sum(named)} of {dealing.VARIANTS} variants only: "
            "in the others it gives what another answer gives"
        )


@each_exercise
def test_an_answer_as_the_solution_prints_it_is_right(exercise):
    """Four decimals, as printed, are within the tolerance."""
    rights = [v.candidates[0].rows for v in dealing.variants(exercise.name)]
    answers = [(k, typed(np.round(rows, 4), exercise)) for k, rows in enumerate(rights)]
    assert {verdict.name for verdict in judged(exercise, answers)} == {"right"}


@each_exercise
def test_whole_turns_more_or_less_do_not_matter(exercise):
    """So the page and the sheets say of all angles."""
    assert all(ask.circle for ask in exercise.unknowns if ask.unit == "rad")
    turn = np.array([2 * math.pi * ask.circle for ask in exercise.unknowns])
    answers = [
        (k, typed(np.array(v.candidates[0].rows) + turns * turn, exercise))
        for k, v in enumerate(dealing.variants(exercise.name))
        for turns in (1, -2)
    ]
    assert {verdict.name for verdict in judged(exercise, answers)} == {"right"}


JUDGE = """(({ exercise, answers }) => answers.map(([k, text]) =>
  courseware.judgeAnswer(exercise, exercise.variants[k].candidates, text)))"""


def test_the_tolerance_is_a_part_of_a_large_answer():
    """What rounding on the way makes grows with the answer; an angle stays on its circle."""
    rate, turned = EXERCISES["wheels-3"].unknowns[0], practice.angle("φ")
    assert (rate.allowed(0.1), rate.allowed(-50)) == (9e-4, 0.05)
    assert turned.allowed(3) == 9e-4
    assert practice.whole("n").allowed(5000) == 1e-9


ROUNDED = EXERCISES["differential-drive-1"]


@pytest.mark.parametrize(
    ("answer", "name", "words"),
    [
        (lambda right: f"{right:.2f}", "near", "very close. Keep all digits on the way, and give"),
        (lambda right: f"{right + 0.2:.2f}", "", "Give three decimals: with fewer"),
        (lambda right: f"{right + 0.2:.3f}", "", "none of the mistakes known here gives this."),
    ],
)
def test_two_decimals_are_told_of_first(answer, name, words):
    """Neither accused of a mistake, nor left without a word."""
    exact = [
        (number, variant.candidates[0].rows[0][0])
        for number, variant in enumerate(dealing.variants(ROUNDED.name))
        if abs(variant.candidates[0].rows[0][0] * 100 % 1 - 0.5) < 0.3  # no round number
    ]
    verdicts = judged(ROUNDED, [(number, answer(right)) for number, right in exact])
    heard = [v for v in verdicts if v.name == name]
    assert len(heard) > len(verdicts) / 2  # the others meet something by chance
    assert all(words in v.feedback for v in heard)
    assert {v.name for v in verdicts if f"{v.name}".startswith("M")} <= {"M12", "M31"}


@each("exercise", "exercises", Exercise, only=lambda e: len(e.unknowns) == 1 and e.accept == "one")
def test_right_answers_of_two_decimals_are_never_called_a_mistake(exercise):
    rights = [v.candidates[0].rows for v in dealing.variants(exercise.name)]
    answers = [(k, typed(np.round(rows, 2), exercise)) for k, rows in enumerate(rights)]
    named = {v.name for v in judged(exercise, answers)} - {"right", "near"}
    assert not named, (
        f"{exercise.name}: the right answer with two decimals is called {named}: take other "
        "numbers, in which that mistake is further off"
    )


@pytest.mark.parametrize(
    ("name", "decimals"), [("bicycle-2", "four"), ("odometry-2", "four"), ("euler-1", "three")]
)
def test_words_on_digits_follow_the_tolerance(name, decimals):
    exercise = EXERCISES[name]
    assert ("to four decimals" in judging.format_prompt(exercise)) == (decimals == "four")
    rights = [np.array(v.candidates[0].rows) for v in dealing.variants(name)]
    count = max(ask.decimals for ask in exercise.unknowns)
    off = 5 * max(ask.tolerance for ask in exercise.unknowns)
    rounded = [(k, typed(np.round(right, count - 1), exercise)) for k, right in enumerate(rights)]
    few = [v for v in judged(exercise, rounded) if v.name == "near"]
    assert few
    assert all(f"give {decimals} decimals" in verdict.feedback for verdict in few)
    enough = judged(exercise, [(k, typed(right + off, exercise)) for k, right in enumerate(rights)])
    close = [verdict.feedback for verdict in enough if verdict.name == "near"]
    assert close  # the others may be a mistake that is as near
    assert not any("decimals" in feedback for feedback in close)


def test_a_zero_at_the_end_is_a_decimal():
    exercise = EXERCISES["differential-drive-1"]
    named = [Candidate("right", ((0.2123,),))]
    for text, is_told in (("0.215", False), ("0.210", False), ("0.21", True), ("5.210", False)):
        assert ("decimals" in judging.judge(exercise, named, text).feedback) == is_told, text


def test_a_mistake_in_whole_degrees_is_said_beside_the_rounding():
    """It may be the right angle, rounded, or the mean of two angles, which is as round."""
    for name in ("bicycle-2", "bicycle-4"):
        exercise = EXERCISES[name]
        means = [
            (k, np.degrees(c.rows[0][0]))
            for k, v in enumerate(dealing.variants(name))
            for c in v.candidates
            if c.name == "M18"
        ]
        whole = [(k, f"{x:.0f}{sign}") for k, x in means if x % 1 < 1e-9 for sign in ("°", "")]
        assert len(whole) > 20
        assert all("averaged" in v.feedback for v in judged(exercise, whole))


def test_a_whole_number_is_asked_for_where_none_is_typed():
    exercise = EXERCISES["odometry-5"]
    for k, variant in enumerate(dealing.variants(exercise.name)):
        exact = resolution(rolled, **variant.numbers)
        [verdict] = judged(exercise, [(k, f"{exact:.2f}")])
        assert verdict.feedback.endswith("Asked is a whole number.")


def test_two_mistakes_of_one_number_are_both_said():
    exercise = EXERCISES["euler-3"]
    for variant in dealing.variants(exercise.name):
        left_handed = next(c for c in variant.candidates if c.name == "M7")
        says = judging.judge(
            exercise, variant.candidates, typed(left_handed.rows, exercise)
        ).feedback
        assert "left-handed turns" in says
        assert "transpose" in says


def test_a_mistake_in_degrees_is_named():
    exercise = EXERCISES["differential-drive-1"]
    for number, variant in enumerate(dealing.variants(exercise.name)):
        wrong = next(c for c in variant.candidates if c.name == "M12").rows[0][0]
        [verdict] = judged(exercise, [(number, repr(wrong * 180 / math.pi))])
        assert verdict.name == "M12"
        assert "other units (degrees)" in verdict.feedback


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("euler-7", "in the wrong order in both sequences"),
        ("frames-5", "in the inverse of the product"),
        (
            "elbow-arm-6",
            "p_x is left out and the arm is taken to stand in the plane of y and z, alth",
        ),
        ("bicycle-6", "on the circle of the right R"),
        ("odometry-3", "only the heading that is answered"),
        ("odometry-3", "half the wheel distance"),
        ("odometry-3", "degrees are handed"),
        ("differential-drive-3", "degrees are handed"),
        ("differential-drive-5", "degrees are handed"),
        ("planar-arm-2", "rate of its own joint, and also with l_2 where l_3 belongs"),
        ("planar-arm-1", "when in ẋ each link turns only at the rate of its own joint"),
        ("euler-7", "with left-handed turns in both sequences"),
        ("odometry-2", "with 65535 numbers"),
        ("frames-4", "in one of the two inverses"),
        ("frames-5", "in one of the two inverses"),
        ("frames-4", "when only T_bc is inverted"),
        ("odometry-5", "rounded down"),
        ("odometry-7", "starts with heading 0"),
        ("odometry-7", "heading at the start is forgotten"),
    ],
)
def test_further_forms_of_mistakes_are_named(name, words):
    exercise, named = EXERCISES[name], set()
    meant = candidates.outcomes(exercise)
    for number, variant in enumerate(dealing.variants(name)):
        for form in (c for c in variant.candidates if words in meant[c.name].feedback):
            [verdict] = judged(exercise, [(number, typed(form.rows, exercise))])
            assert words in verdict.feedback
            named.add(number)
    assert len(named) > 0.9 * dealing.VARIANTS  # in the others it is right by chance


EDGE = (0.99, 0.999, 1 - 1e-9, 1, 1 + 1e-9, 1.001, 1.01)  # in tolerances


def answers_to(exercise, variant):
    """What might be typed: candidates, a little off the right one, at the edge, something else."""
    random = np.random.default_rng(0)
    scale = np.array([ask.tolerance for ask in exercise.unknowns])
    texts = ["[1, 2, 3, 4, 5]", "", "what", *(typed(c.rows, exercise) for c in variant.candidates)]
    right = np.array(variant.candidates[0].rows)
    for size in (0.5, *EDGE, 9, 11, 1000):
        texts.append(typed(right + size * scale * random.choice([-1, 1], right.shape), exercise))
    turned = np.array([2 * math.pi if ask.circle else 0.0 for ask in exercise.unknowns])
    return [*texts, typed(right + turned, exercise), typed(right[:, ::-1], exercise)]


@pytest.mark.parametrize("every", [8, pytest.param(1, marks=pytest.mark.slow)])
@each_exercise
def test_page_and_grade_agree_also_at_the_edge(exercise, every):
    """The data that a page gets, unpacked, and the candidates that `grade` makes: one verdict."""
    answers = [
        (number, text)
        for number, variant in list(enumerate(dealing.variants(exercise.name)))[::every]
        for text in answers_to(exercise, variant)
    ]
    data = json.loads(zlib.decompress(base64.b64decode(rendering.pack([exercise]))))[exercise.name]
    found = script.call(JUDGE, {"exercise": data, "answers": answers})
    assert [judging.Verdict(**verdict) for verdict in found] == judged(exercise, answers)
