"""What students are told, typed on purpose: each mistake, each outcome, each threshold.

Numbers that were found by hand are in `tests/expected`.
"""

import json
from itertools import product

import numpy as np
import pytest
import sympy as sp
from declared import EXERCISES, FIGURES, MISTAKES, PREDICTIONS, each
from figure_numbers import TABLES, expected, point

from courseware.answers import Unknown, angle, integer, matrix
from courseware.course import course
from courseware.figures import Figure
from courseware.practice import Exercise, Solution, candidates, judging
from courseware.practice.candidates import Candidate
from courseware.predictions import Buttons, Number, Prediction
from courseware.script import engine

FEEDBACK, PREDICTED, GOALS = map(expected, ("FEEDBACK", "PREDICTED", "GOALS"))
OF_FIGURES = ("READOUTS", "SPECIALS", "LOST", "TITLES", "GOALS")


@pytest.mark.parametrize("chapter", TABLES)
def test_what_is_expected_is_there(chapter):
    module = TABLES[chapter]
    known = {"FEEDBACK": EXERCISES, "PREDICTED": PREDICTIONS, **dict.fromkeys(OF_FIGURES, FIGURES)}
    unknown = {name: getattr(module, name, {}).keys() - there for name, there in known.items()}
    assert not any(unknown.values()), f"take these out of tests/expected/{chapter}.py: {unknown}"


# --- Exercises --------------------------------------------------------------------------------


@each("exercise", "exercises", Exercise)
def test_each_mistake_in_an_exercise_is_told(exercise):
    numbers, examples = FEEDBACK.get(exercise.name, ({}, {}))
    place = f'FEEDBACK["{exercise.name}"] in tests/expected/{exercise.topic}.py'
    words = {mistake.name: mistake.feedback for mistake in exercise.wrong}
    words |= {said: said for said in exercise.likely_slips}
    pairs = {f"{a.name} and {b.name}": b.feedback for a, b in exercise.together}
    meant = {key: [w for name, w in words.items() if name == key or key in w] for key in examples}
    meant |= {key: [f"and also {pairs[key]}"] for key in examples if key in pairs}
    unclear = {key: fits for key, fits in meant.items() if len(fits) != 1}
    assert not unclear, f"{place}: each key is a mistake's name or in the words of one: {unclear}"
    missing = [name for name, said in words.items() if [said] not in meant.values()]
    assert not missing, f"add to {place} what these give, worked out by hand: {missing}"
    if not examples:
        return
    assert numbers.keys() == exercise.given.keys(), f"{place} has other numbers than its text"
    given = {name: exercise.given[name].to_si(option) for name, option in numbers.items()}
    possible = candidates.find_candidates(exercise, given)
    for key, answer in examples.items():
        verdict = judging.judge(exercise, possible, json.dumps(answer))
        named = verdict.result == "wrong" and meant[key][0] in verdict.feedback
        assert named, f"{place}: for {key!r}, {answer} is told: {verdict.feedback}"


# --- Predictions ------------------------------------------------------------------------------


@each("prediction", "predictions", Prediction)
def test_a_prediction_comes_out_as_expected(prediction):
    """By hand, too: its outcome, and the numbers of its usual wrong guesses."""
    answers, home = (
        prediction.answers,
        course().chapters_of("predictions", Prediction)[prediction.name],
    )
    found = answers.format_answer()
    if not isinstance(answers, Buttons):
        found = (found, *(guess for guess, _ in prediction.answers.guesses()))
    assert PREDICTED.get(prediction.name) == found, (
        f"{prediction.name} comes out as {found!r}; what it must be, worked out by hand, goes to "
        f"PREDICTED in tests/expected/{home}.py"
    )


def same(data, guess, other):
    """Whether a guess counts as another one on the page."""
    return engine.call("courseware.isSameGuess", data, guess, other)


@pytest.mark.parametrize(
    ("right", "near", "allowed"),
    [(2, None, 0.1), (-2, None, 0.1), (0, None, 0.05), (2, 0.02, 0.04)],
)
def test_a_guess_is_right_within_a_part_of_the_number(right, near, allowed):
    number = Number("m", right=sp.Float(right), **({} if near is None else {"relative": near}))
    for sign in (-1, 1):
        assert same(number.serialize(), [right + sign * 0.98 * allowed], [right])
        assert not same(number.serialize(), [right + sign * 1.02 * allowed], [right])


def test_a_ghost_is_right_within_a_distance_and_round_the_circle():
    ghost = {"kind": "ghost", "near": 2, "units": ["m", "°"]}
    for sign, turn in product((-1, 1), (0, 360)):
        assert same(ghost, [1 + sign * 1.98, turn], [1, 0])
        assert same(ghost, [1, turn + sign * 1.98], [1, 0])
        assert not same(ghost, [1 + sign * 2.02, turn], [1, 0])
        assert not same(ghost, [1, turn + sign * 2.02], [1, 0])
    assert not same(ghost, [361, 0], [1, 0])  # metres do not go round


# --- Goals of figures ---------------------------------------------------------------------------


@each("figure", "figures", Figure, only=lambda figure: figure.goal)
def test_a_goal_is_just_reached_and_just_missed(figure):
    goals = figure.goals
    home = course().chapters_of("figures", Figure)[figure.name]
    tries = GOALS.get(figure.name, ())
    assert len(tries) == len(goals), (
        f'add to GOALS["{figure.name}"] in tests/expected/{home}.py for each of its {len(goals)} '
        "goals settings that just reach it, and settings that just miss it"
    )
    for goal, compiled, settings in zip(goals, figure.compiled["goals"], tries, strict=True):
        for reaches, some in zip((True, False), settings, strict=True):
            assert some, f"{goal.words} no settings that {'reach' if reaches else 'miss'} it"
            for setting in some:
                [values] = figure.compute([point(figure, setting)])
                assert values[compiled["at"]] == reaches, f"{goal.words} {setting}"


# --- Thresholds of the judge --------------------------------------------------------------------

METRES, AREA, CURVATURE = (Unknown("x", unit) for unit in ("m", "m²", "1/m"))
ANGLE, TURNED, RATE = angle("θ"), Unknown("ω", "rad"), Unknown("ω", "rad/s")
FINE = Unknown("D", "m", tolerance=6e-5)
CLOSE, NONE, DEGREE = "very close", "none of the mistakes", 180 / np.pi


def asking(*asks, right, shape=(), likely_slips=None, accept="one", wrong=None):
    """An exercise without a text, whose answer is fixed."""
    return Exercise(
        "test-1",
        title="",
        text="",
        given={},
        unknowns=asks,
        right=lambda: right,
        wrong=wrong or {},
        solution=Solution(""),
        likely_slips={
            words: lambda value=value: value for words, value in (likely_slips or {}).items()
        },
        shape=shape,
        accept=accept,
    )


def feedback_on(exercise, text):
    """What somebody is told who types this."""
    return judging.judge(exercise, candidates.find_candidates(exercise, {}), text).feedback


# asked; what is right; about which answer; how far off it may be, each number; what is told then
THRESHOLDS = {
    "metres": (METRES, 0.2123, 0.2123, 6e-4, candidates.RIGHT),
    "a thousandth": (METRES, -50.123, -50.123, 0.050123, candidates.RIGHT),
    "angle": (ANGLE, 3.1, 3.1, 9e-4, candidates.RIGHT),
    "angle beyond a turn": (ANGLE, 3.1, 3.1 - 4 * np.pi, 9e-4, candidates.RIGHT),
    "whole number": (integer("n"), 5000, 5000, 1e-9, candidates.RIGHT),
    "four decimals": (FINE, 0.0321, 0.0321, 6e-5, candidates.RIGHT),
    "close": (METRES, 0.2123, 0.2123, 6e-3, CLOSE),
    "two close": ((METRES, ANGLE), (0.2123, 1), (0.2123, 1), (6e-3, 9e-3), CLOSE),
    "cm": (METRES, 0.2123, 21.23, 0.06, "(cm)"),
    "cm²": (AREA, 0.2123, 2123, 6, "(cm)"),
    "1/cm": (CURVATURE, 0.2123, 0.002123, 6e-6, "(cm)"),
    "degrees": (ANGLE, 1.1, 1.1 * DEGREE, 9e-4 * DEGREE, "(degrees)"),
    "turns": (ANGLE, 1.1, 1.1 / (2 * np.pi), 9e-4 / (2 * np.pi), "(turns)"),
    "cm, degrees": (
        (METRES, ANGLE),
        (0.2123, 1.1),
        (21.23, 1.1 * DEGREE),
        (0.06, 9e-4 * DEGREE),
        "(cm and degrees)",
    ),
    "sign": (METRES, 0.2123, -0.2123, 6e-4, "the size is right, the sign is not"),
    "twice": (METRES, 0.2123, 0.4246, 6e-4, "twice the right"),
    "half": (METRES, 0.2123, 0.10615, 6e-4, "half the right"),
    "swapped": ((METRES, METRES), (0.2, 0.5), (0.5, 0.2), (6e-4, 6e-4), "in the wrong order"),
    "half a turn": (ANGLE, 1.1, 1.1 + np.pi, 9e-4, "off by half a turn"),
    "a turn more": (TURNED, 1.1, 1.1 + 2 * np.pi, 7.3832e-3, "off by a whole turn"),
    "a turn less": (TURNED, 1.1, 1.1 - 2 * np.pi, 5.1832e-3, "off by a whole turn"),
    "one of two": ((METRES, RATE), (0.2, 0.5), (0.2, 9), (6e-4, 0), "Already right: x."),
}


@pytest.mark.parametrize(
    ("asks", "right", "about", "allowed", "words"), THRESHOLDS.values(), ids=THRESHOLDS
)
def test_a_threshold_holds_from_both_sides(asks, right, about, allowed, words):
    exercise = asking(*(asks if isinstance(asks, tuple) else (asks,)), right=right)
    offs = np.diag(np.atleast_1d(allowed))
    for off, sign in product(offs[offs.any(axis=1)], (-1, 1)):
        inside, outside = (
            json.dumps((about + sign * size * off).tolist()) for size in (0.98, 1.02)
        )
        assert words in feedback_on(exercise, inside)
        assert words not in feedback_on(exercise, outside)


SQUARE = asking(*matrix("R", 2, 2), right=[[0.1, 0.2], [0.3, 0.4]], shape=(2, 2))
EITHER = asking(METRES, right=[[0.2], [0.3]], accept="any")
TWO = asking(METRES, RATE, right=[0.2, 0.5])


def wrongly(right, asks=METRES, **also):
    """An exercise of one number, with numbers that people give who slip by some word."""
    words = {name.replace("_", " "): value for name, value in also.items()}
    return asking(asks, right=right, likely_slips=words)


# exercise, what is typed, words that are told, words that are not
ORDER = {
    "transposed": (SQUARE, "[[0.1, 0.3], [0.2, 0.4]]", "rows and columns", NONE),
    "any of two": (EITHER, "0.3", "other right answers", "Not yet"),
    "a slip of two": (EITHER, "-0.3", "the sign is not", NONE),
    "a mistake before a slip": (wrongly(0.2, by_a=-0.2), "-0.2", "you get by a", "the sign"),
    "both of one number": (wrongly(0.2, by_a=0.4, by_b=0.4), "0.4", "get by a, or by b", "twice"),
    "a mistake before close": (wrongly(0.2, by_a=0.2031), "0.2031", "you get by a", CLOSE),
    "rounded before a mistake": (wrongly(0.2168, by_a=0.22), "0.220", CLOSE, "by a"),
    "two of four decimals": (wrongly(0.21234, FINE, by_a=0.21), "0.2100", CLOSE, "by a"),
    "one decimal is no rounding": (wrongly(0.21234, FINE, by_a=0.2), "0.2", "by a", CLOSE),
    "two digits in cm": (wrongly(0.1046), "10", CLOSE, NONE),
    "a decimal in cm": (wrongly(0.0946, FINE), "9.5", CLOSE, NONE),
    "all decimals in cm": (wrongly(0.1046), "10.000", NONE, CLOSE),
    "whole degrees": (wrongly(30.53 / DEGREE, ANGLE), "31°", CLOSE, NONE),
    "a mistake in other units": (wrongly(0.2, by_a=0.47), "47", "by a. And it is in other", NONE),
    "few decimals": (wrongly(0.2123), "0.95", "Give three decimals", CLOSE),
    "enough decimals": (wrongly(0.2123), "0.900", NONE, "Give three decimals"),
    "a round answer": (wrongly(0.2), "0.9", NONE, "Give three decimals"),
    "four are asked": (wrongly(0.21234, FINE), "0.9", "Give four decimals", CLOSE),
    "a whole number": (asking(integer("n"), right=5), "4.9", "Asked is a whole number.", CLOSE),
    "of two units": (TWO, "[0.5, 0.2]", NONE, "in the wrong order"),
}


@pytest.mark.parametrize(("exercise", "typed", "says", "not_said"), ORDER.values(), ids=ORDER)
def test_what_is_told_first(exercise, typed, says, not_said):
    found = feedback_on(exercise, typed)
    assert says in found
    assert not_said not in found


def test_answers_are_alike_up_to_both_their_tolerances():
    """Then numbers are not dealt: what is typed between them could mean either."""
    mistake = MISTAKES["M12"]
    for size, alike in ((1.98, "right and M12"), (2.02, "")):
        exercise = asking(METRES, right=0.2, wrong={mistake: lambda: 0.2})
        other = Candidate("M12", ((0.2 + size * 6e-4,),))
        assert candidates.find_clash(exercise, [Candidate("right", ((0.2,),)), other]) == alike
