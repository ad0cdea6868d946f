"""The practice bank: every exercise, every variant, every mistake."""

import base64
import json
import math
import re
import unicodedata
import zlib
from datetime import UTC, datetime
from html import escape, unescape

import numpy as np
import pytest
from declared import COURSE, EXERCISES, each, table

import robokin
from courseware import practice
from courseware.course import course
from courseware.errors import CourseError
from courseware.line_breaks import prevent_breaks
from courseware.practice import Exercise, Mistake, candidates, dealing, judging, notebook, rendering
from courseware.practice.bank import all_exercises, all_mistakes
from courseware.practice.formatting import render_paragraphs, render_symbols
from courseware.script import engine as script

each_exercise = each("exercise", "exercises", Exercise)
each_mistake = each("mistake", "exercises", Mistake)


def users(mistake):
    """The exercises in which a mistake can be made."""
    return [exercise for exercise in EXERCISES.values() if mistake in exercise.wrong]


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
def test_texts_can_be_filled(exercise):
    for variant in dealing.variants(exercise.name):
        for template in (exercise.text, exercise.solution_text):
            filled = exercise.fill(template, variant.numbers)
            assert "{" not in filled
            assert not re.search(r"\bnan\b", filled)


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


def plain(html):
    return unescape(re.sub("<[^>]+>", "", html))


@each_exercise
def test_no_line_ends_inside_a_number_with_its_unit(exercise):
    """In the text as Python writes it and as the page does; nothing else changes in it."""
    variant = dealing.variants(exercise.name)[0]
    text = exercise.fill(exercise.text, variant.numbers)
    for html in (render_paragraphs(text), script.call("courseware.renderParagraphs", text)):
        shown = plain(html)
        assert not re.search(r"\d (?:cm|m|s|rad|N)\b|[=] \d| = −?\d", shown)
        if "[[" not in text:  # on the page a matrix
            assert shown.replace("\u00a0", " ") == plain(render_symbols(text.replace("\n\n", "")))


def test_short_formulas_and_units_stay_together():
    said = prevent_breaks(
        "a = 3 cm and b = −0.5 m/s in rad, x = (a longer formula) in 2 ways, 5 °/s"
    )
    kept = ["a = 3 cm", "b = −0.5 m/s", "in rad", "x = (a", "5 °/s"]
    assert all(part.replace(" ", "\u00a0") in said for part in kept)
    assert "longer formula) in 2 ways" in said


def last_made(code, numbers):
    """The last new name that our own code gives a value, run with the chapters' imports."""
    modules = {name: getattr(robokin, name) for name in robokin.__all__}
    space = {"np": np, **modules, **numbers}
    before = {*space, "__builtins__"}
    exec(code, space)
    return [space[name] for name in space if name not in before][-1]


@each_mistake
def test_a_mistake_is_used_and_its_line_makes_it(mistake):
    """The line, run with the document's numbers, gives what the exercise calls that mistake."""
    shown_in = [exercise for exercise in users(mistake) if exercise.example]
    assert shown_in, "no exercise with an example has it"
    exercise = shown_in[0]
    numbers = {**exercise.example, **exercise.derive(**exercise.example)}
    found = last_made(mistake.line, numbers)
    wrong = exercise.evaluate(exercise.wrong[mistake], exercise.example)
    np.testing.assert_allclose(np.ravel(found), np.ravel(wrong), rtol=1e-12, atol=1e-12)
    right = exercise.evaluate(exercise.right, exercise.example)
    assert not np.allclose(right, wrong, atol=1e-6)


@each_mistake
def test_a_mistake_runs_as_printed(mistake):
    """The numbers and the line, copied from the page, give what the page says they give."""
    view = practice.mistake(mistake.name)
    page_text = practice.example(view.exercise.name).data["text/markdown"]
    given = re.search("```python\n(.*)\n```", page_text, re.DOTALL)[1]
    longest = max(map(len, given.splitlines()))
    assert longest <= 80, (
        f"the example of {view.exercise.name} prints {longest} characters in a line, at most 80: "
        "give it shorter numbers"
    )
    numbers = {}
    exec(given, {"np": np}, numbers)
    found = last_made(mistake.line, numbers)
    says = re.findall(r"-?[0-9.]+", view.result.replace("\u2212", "-"))
    # both are rounded to four decimals; a product with the largest number here, 2, doubles that
    wanted = np.array(says, dtype=float)
    told = f"the line of {mistake.name} must give what its formula gives: {mistake.line}"
    np.testing.assert_allclose(np.ravel(found), wanted, atol=1.5e-4, rtol=0, err_msg=told)


@each_mistake
def test_a_mistake_says_all_it_must(mistake):
    assert mistake.unnoticed, f"say where {mistake.name} happens to be right, as `unnoticed`"
    assert mistake.why, f"say why {mistake.name} is wrong, as `why`"
    assert not mistake.feedback.endswith("."), f"`feedback` of {mistake.name}: no stop at its end"
    told = mistake.document, mistake.place, mistake.nth, mistake.stands, mistake.should
    assert all(told) or not any((*told, mistake.explained)), (
        f"{mistake.name} stands in a document, and needs all of `document`, `place`, `nth`, "
        f"`stands` and `should`, or in none: {told}"
    )
    # an erratum marks what changes, and marks nothing that stands there already
    assert bool(mistake.document) == ("«" in mistake.should), (
        f"mark in `should` of {mistake.name} what changes, in « »"
    )
    longest = max(map(len, mistake.line.splitlines()))
    assert longest <= 80, (
        f"`line` of {mistake.name} has {longest} characters in a line, at most 80: break it"
    )


@pytest.mark.parametrize("chapter", practice.all_topics())
def test_errata_have_an_order(chapter):
    homes = course().chapters_of("exercises", Mistake)
    for document in {m.document for m in all_mistakes().values() if homes[m.name] == chapter} - {
        ""
    }:
        order = {m.name: m.nth for m in all_mistakes().values() if m.document == document}
        assert sorted(order.values()) == [*range(1, len(order) + 1)], (
            f"number the errata of {document} from 1 on, as `nth`: {order}"
        )


# --- The page does the same -----------------------------------------------------------------

NAMES = [
    "",
    "Ada",
    " Ada ",
    "Ada  Lovelace",
    "سارا محمدی",
    "José",
    "Jose\u0301",
    "李雷",
    "😀 smile",
    "ß",
]
NAMES += [
    "\u00a0x\u2003y\ufeff",
    "\u212b",
    'o\'Brien, "Bob"',
    "\u1e9b\u0323",
    "\ud800 half",
    "=1+1",
]


def names(count):
    """Names of many scripts, with accents and odd spaces."""
    random = np.random.default_rng(1)
    letters = [
        *"abzÅéüñçßøłžαωжяابپچ李王あ한\u0301\u0308\u200d😀🤖",
        " ",
        "\u00a0",
        "\t",
        "-",
        "'",
        "7",
    ]
    made = {"".join(random.choice(letters, random.integers(1, 12))) for _ in range(2 * count)}
    return [*NAMES, *sorted(made)][:count]


def dealt_in_python(course, exercise, people):
    return [dealing.deal(course, exercise, name) for name in people]


DEAL = """(people) => people.map((name) =>
  courseware.dealVariant("2026 Herbst", "euler-1", name))"""


def test_the_engine_deals_the_same():
    """Without composed forms (NFC), which the engine of the build may not know."""
    people = [name for name in names(1000) if unicodedata.is_normalized("NFC", name)]
    assert len(people) > 500
    found = script.run(f"({DEAL})({json.dumps(people)})")
    assert found == dealt_in_python("2026 Herbst", "euler-1", people)


def test_a_release_deals_as_the_last_one_did():
    """Or who is half-way through the course gets other numbers."""
    dealt = dealt_in_python("robokin", "euler-1", ["", "Ada", "سارا محمدی", "李雷"])
    assert dealt == [11, 43, 44, 15]
    shown = EXERCISES["euler-1"].format_given(dealing.variants("euler-1")[43].numbers)
    assert list(shown.values()) == ["90°", "y", "−30°", "z", "z"]


def test_names_that_look_alike_are_the_same():
    assert dealing.fold_name("  Ada \u00a0 Lovelace\n") == "ada lovelace"
    assert dealing.fold_name("Jose\u0301") == dealing.fold_name("José")
    assert dealing.fold_name("  Ada\u200c \u00a0 ۰۴۷۱\n") == "ada 0471"
    assert dealing.fold_name("ADA ۰۴۷۱") == dealing.fold_name("ada 0471") == "ada 0471"
    assert dealing.fold_name("علي") == dealing.fold_name("علی")  # two letters, one name
    assert dealing.fold_name("A\u200cda\u200d") == "ada"


def test_the_hash_is_fnv1a():
    """The published test values of 32-bit FNV-1a."""
    assert dealing.fnv1a("") == 0x811C9DC5
    assert dealing.fnv1a("a") == 0xE40C292C
    assert dealing.fnv1a("foobar") == 0xBF9CF968


@each_exercise
def test_variants_are_dealt_evenly(exercise):
    """Numbered students: all variants, none twice as often as it should but by chance."""
    dealt = dealt_in_python("course", exercise.name, [f"{k}" for k in range(10_000, 16_400)])
    counts = np.bincount(dealt, minlength=dealing.VARIANTS)
    # 100 each on average, with a standard deviation of 10
    assert counts.min() > 50
    assert counts.max() < 200


def test_another_course_deals_other_variants():
    people = [f"{k}" for k in range(1000)]
    last, this = (dealt_in_python(year, "euler-1", people) for year in ("2025", "2026"))
    assert sum(a == b for a, b in zip(last, this, strict=True)) < 50  # 16 expected by chance


JUDGE = """(({ exercise, answers }) => answers.map(([k, text]) =>
  courseware.judgeAnswer(exercise, exercise.variants[k].candidates, text)))"""


def typed(rows, exercise):
    """Rows as a student would type them."""
    shaped = np.reshape(rows, (-1, *(exercise.shape or (len(exercise.unknowns),))))
    if exercise.accept != "all":
        shaped = shaped[0]
    return json.dumps(shaped.tolist()[0] if shaped.shape == (1,) else shaped.tolist())


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
    right = np.array(dealing.variants(name)[0].candidates[0].rows)
    off = 5 * max(ask.tolerance for ask in exercise.unknowns)
    [verdict] = judged(exercise, [(0, typed(right + off, exercise))])
    assert verdict.name == "near"
    assert f"give {decimals} decimals" in verdict.feedback


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
        ("planar-arm-2", "two mistakes in one term"),
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


def test_numbers_are_those_of_real_things():
    """A bicycle leans at most so far, a table is no bar, a truck has the wheels of one."""
    for variant in dealing.variants("bicycle-1"):
        n = variant.numbers
        sideways = n["v_front"] ** 2 * math.cos(n["phi"]) * math.sin(n["phi"]) / n["L"]
        assert sideways < 5
    for variant in dealing.variants("frames-6"):
        assert 0.5 < variant.numbers["height"] - variant.numbers["z_e"] < 1.1
    for variant in dealing.variants("bicycle-5"):
        assert variant.numbers["diameter"] >= 0.7


def test_a_unit_that_all_numbers_have_is_said_once():
    assert judging.format_prompt(EXERCISES["elbow-arm-3"]) == "3 numbers: θ_1, θ_2, θ_3 in rad"
    assert judging.format_prompt(EXERCISES["wheels-6"]).startswith(
        "2 numbers: β in rad, φ̇ in rad/s"
    )


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
    assert [judging.read_verdict(verdict) for verdict in found] == judged(exercise, answers)


MOST = 125_000  # bytes of a chapter's exercises; loaded only once a student's name is known


@pytest.mark.parametrize("topic", practice.all_topics())
def test_the_data_of_a_topic_are_light_and_not_in_clear(topic):
    text = rendering.render_script(topic)
    assert len(text) < MOST, (
        f"the exercises of {topic} have {len(text)} bytes, at most {MOST}: shorten solutions and "
        "texts, or ask for fewer numbers"
    )
    assert "right" not in text
    assert len(rendering.render_script(topic, solutions=False)) < len(text)


# --- In a notebook --------------------------------------------------------------------------


@pytest.fixture
def nobody(monkeypatch):
    """No answers yet, no name given."""
    monkeypatch.setattr(notebook, "_answers", {})
    monkeypatch.setattr(notebook, "_session", {"student": "", "course": ""})


def test_a_box_has_the_student_s_numbers(nobody):
    box = practice.exercise("differential-drive-1", student="Ada")
    number = dealing.deal(COURSE, "differential-drive-1", "Ada")
    assert box.variant is dealing.variants("differential-drive-1")[number]
    assert box.exercise.format_given(box.variant.numbers)["b"] in box.text
    assert repr(box.check(box.variant.candidates[0].rows[0][0])) == candidates.RIGHT
    practice.student(" Ada ")
    assert practice.exercise("differential-drive-1").variant is box.variant


def test_a_mistake_is_named(nobody):
    box = practice.exercise("differential-drive-1", student="Ada")
    b, v_L, v_R = (box.variant.numbers[name] for name in ("b", "v_L", "v_R"))
    verdict = box.check((v_R - v_L) / (b / 2))
    assert (verdict.result, verdict.name) == ("wrong", "M12")
    assert "half the wheel distance" in repr(verdict)
    assert box.check(np.degrees((v_R - v_L) / b)).result == "partly"
    assert box.check("0.5 m/s").result == "unread"
    assert box.check([1, 2]).result == "unread"
    assert box.check(np.array([(v_R - v_L) / b])).result == "right"


def test_answers_are_exported_as_grade_reads_them(nobody, tmp_path):
    with pytest.raises(CourseError, match="no answers yet"):
        practice.export(tmp_path / "answers.csv")
    box = practice.exercise("differential-drive-1", student="=Ada, 1")
    box.check("nonsense")
    box.check("-1/3")
    path = practice.export(tmp_path / "answers.csv")
    [row] = table(path)
    wanted = {"student": "=Ada, 1", "exercise": "differential-drive-1", "answer": "-1/3"}
    assert datetime.fromisoformat(row.pop("time")).tzinfo == UTC
    version = dealing.version()
    assert row == {"kind": "answers", "course": "robokin", "version": version, **wanted}
    with pytest.raises(CourseError, match="already there"):
        practice.export(path)


@pytest.mark.parametrize(
    "answer",
    [None, True, 1j, {}, {1.0}, [[1, 2], [3]], ["a"], b"1", 10**400, np.nan, np.ones(1000), []],
    ids=str,
)
def test_what_is_no_answer_is_unread(nobody, answer):
    verdict = practice.exercise("differential-drive-1", student="Ada").check(answer)
    assert verdict.result == "unread"
    assert verdict.feedback
    assert not practice.answers()


def test_a_further_try_takes_nothing_away(nobody):
    box = practice.exercise("differential-drive-1", student="Ada")
    right = typed(box.variant.candidates[0].rows, box.exercise)
    for tried in ("12345", right, "12345"):
        box.check(tried)
    assert [answer for *_, answer in practice.answers()] == [right]


def test_a_column_counts_as_a_list(nobody):
    box = practice.exercise("differential-drive-2", student=4711)
    assert box.check(np.reshape(box.variant.candidates[0].rows[0], (2, 1))).result == "right"
    with pytest.raises(CourseError, match=r"student must be text or a number, got \['Ada'\]"):
        practice.exercise("differential-drive-2", student=["Ada"])


def test_answers_of_nobody_are_not_exported(nobody, tmp_path):
    practice.exercise("differential-drive-1").check(1)
    with pytest.raises(CourseError, match="say who you are first"):
        practice.export(tmp_path / "answers.csv")


def test_an_exercise_is_named_after_its_folder(monkeypatch):
    monkeypatch.setattr(type(course()), "chapters_of", lambda *_: {"car-1": "bicycle"})
    with pytest.raises(CourseError, match=r"folder bicycle is named bicycle-1, .* got car-1"):
        all_exercises()


def test_unknown_names_are_refused():
    with pytest.raises(CourseError, match=r"no exercise 'drive-1'; there are .*drive-1"):
        practice.exercise("drive-1")
    with pytest.raises(CourseError, match=r"no mistake 'M99'; there are .*M12"):
        practice.mistake("M99")


@each_mistake
def test_a_mistake_is_shown_with_its_value(mistake):
    html = practice.mistake(mistake.name)._repr_mimebundle_()["text/html"]
    assert not re.search(r"\bnan\b", html)
    assert html.index("It gives") < html.index("<details>") < html.index("Right is")
    assert html.index(escape(mistake.line)) < html.index("It gives")


def test_a_matrix_is_given_row_by_row():
    html = practice.mistake("M19").answer
    assert html.count("<br>") == 6  # three rows, wrong and right
    assert "<br>" not in practice.mistake("M12").answer
