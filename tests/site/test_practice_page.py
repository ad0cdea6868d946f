"""The exercises on the built page: typed into, by keyboard, in a real browser."""

import csv
import io
import json
import re
from datetime import UTC, datetime, timedelta
from html import unescape
from pathlib import Path

import numpy as np
import pytest
from browser import FULL, TALL, draw_all, watched_page
from commands import TABLES
from declared import COURSE, EXERCISES, OF_EACH_KIND, table, typed
from playwright.sync_api import expect
from test_variants import DEAL, dealt_in_python, names

from book.differential_drive.exercises import half_wheel_distance
from courseware.classroom.__main__ import main
from courseware.practice import candidates, judging, variants
from courseware.units.formatting import render_symbols

pytest_plugins = ["browser"]
pytestmark = pytest.mark.browser

FIRST = "differential-drive-1"
NAMELESS = "Type your name first: it picks your numbers."
ONE_PASSED = f"1 of {len(EXERCISES)} checks on this page passed"


# nothing is kept, nobody has a name, and the numbers are there
FORGOTTEN = """() => {
  const name = document.getElementById("rk-student");
  localStorage.clear();
  history.replaceState(null, "");
  courseware.memory.data = {};
  name.value = "";
  name.dispatchEvent(new Event("change"));
  document.activeElement.blur();
  scrollTo(0, 0);
}"""


@pytest.fixture(scope="module")
def opened(chromium, server):
    """The practice page, which most tests share."""
    with watched_page(chromium, server) as (page, watch):
        page.goto(server + "practice.html")
        yield page, watch


@pytest.fixture
def page(opened):
    """The practice page of somebody without a name; it must stay quiet and at home."""
    page, watch = opened
    page.evaluate(FORGOTTEN)
    yield page
    faults = watch.errors + watch.strangers
    watch.errors.clear()
    watch.strangers.clear()
    assert not faults


def again(page):
    """Load the page anew, and wait for the numbers of those in sight."""
    page.reload()
    page.locator(".rk-exercise[data-variant]").first.wait_for()


def menu(page):
    """The menu of the answers, open."""
    page.evaluate("() => { document.querySelector('.rk-menu').open = true; }")
    return page.locator(".rk-menu")


def sign_in(page, name):
    """Type a name, leave the field, and wait for the numbers of that name."""
    page.fill("#rk-student", name)
    page.keyboard.press("Tab")
    come_to(page, FIRST, name)


def come_to(page, exercise, name):
    """Scroll to an exercise, and wait for somebody's numbers in it."""
    box(page, exercise).scroll_into_view_if_needed()
    number = variants.choose_variant(COURSE, exercise, name)
    page.locator(f"#{exercise}[data-variant='{number}']").wait_for()


def box(page, exercise):
    return page.locator(f"[data-exercise='{exercise}']")


SAID = """async (verdict) => {
  while (!verdict.textContent) await new Promise(requestAnimationFrame);
  return verdict.innerText;
}"""


def answer(page, exercise, text):
    """Type an answer, press Enter, and read what is said."""
    field = box(page, exercise).locator(".rk-row input")
    verdict = box(page, exercise).locator(".rk-verdict")
    verdict.evaluate("(element) => { element.textContent = ''; }")
    field.fill(text)
    field.press("Enter")
    return verdict.evaluate(SAID)


def printed(text):
    """A text as the page prints it: "p_x" has become a letter with an index."""
    return unescape(re.sub("<[^>]+>", "", render_symbols(text)))


def variant(exercise, name):
    return variants.find_variant(COURSE, exercise, name)


RIGHT = typed(variant(FIRST, "Ada").candidates[0].rows, EXERCISES[FIRST])  # Ada's answer


# what is said of several answers, one after the other
TOLD = """(box, texts) => texts.map((text) => {
  const field = box.querySelector(".rk-row input");
  field.value = text;
  field.form.requestSubmit();
  return box.querySelector(".rk-verdict").innerText;
})"""


@pytest.mark.parametrize("name", OF_EACH_KIND, ids=lambda name: f"{EXERCISES[name].topic}:{name}")
def test_every_candidate_of_each_kind_of_answer_is_named_on_the_page(page, name):
    exercise, possible = EXERCISES[name], variant(name, "Ada").candidates
    sign_in(page, "Ada")
    come_to(page, name, "Ada")
    texts = [typed(candidate.rows, exercise) for candidate in possible]
    said = box(page, name).evaluate(TOLD, texts)
    assert said == [printed(judging.judge(exercise, possible, text).feedback) for text in texts]


def test_the_browser_deals_as_python_does(page):
    """A thousand names: accents, composed and not, Persian, emoji, spaces of all kinds."""
    people = names(1000)
    found = page.evaluate(DEAL, people)
    assert found == dealt_in_python("2026 Herbst", "euler-1", people)


def test_the_text_has_the_student_s_numbers(page):
    for name in ("Ada", "سارا محمدی", "  José "):
        sign_in(page, name)
        for number in EXERCISES[FIRST].format_given(variant(FIRST, name).numbers).values():
            text = box(page, FIRST).inner_text().replace("\u00a0", " ")
            assert number in text


def test_what_cannot_be_read_counts_for_nothing(page):
    assert "one number" in answer(page, FIRST, "[1, 2]")
    assert "unit" in answer(page, FIRST, "0.5 cm/s")
    assert answer(page, FIRST, "")
    assert page.inner_text(".rk-progress").startswith("0 of ")


def test_progress_is_kept_and_cleared(page):
    """And a further try takes nothing away."""
    sign_in(page, "Ada")
    assert answer(page, FIRST, RIGHT) == candidates.RIGHT
    assert page.inner_text(".rk-progress").startswith("1 of ")
    assert answer(page, FIRST, "1.2345") == judging.format_feedback("wrong")
    assert page.inner_text(".rk-progress").startswith("1 of ")
    again(page)
    assert page.input_value("#rk-student") == "Ada"
    assert box(page, FIRST).locator(".rk-row input").input_value() == RIGHT
    assert page.inner_text(".rk-progress").startswith("1 of ")
    sign_in(page, "Bob")
    assert page.inner_text(".rk-progress").startswith("0 of ")
    assert box(page, FIRST).locator(".rk-row input").input_value() == ""
    sign_in(page, "Ada")
    clear = menu(page).locator(".rk-clear")
    clear.click()
    assert clear.inner_text() == "Press again to clear all answers of Ada"
    assert page.inner_text(".rk-progress").startswith("1 of ")
    clear.click()
    assert page.inner_text(".rk-progress").startswith("0 of ")
    assert page.evaluate("() => document.cookie") == ""


OUTSIDE = """() => {
  const first = document.querySelector(".rk-exercise"), desk = "#rk-student";
  const parts = [first.querySelector(".rk-text"), first.querySelector(".rk-row input")];
  return [...document.querySelectorAll(desk), ...parts].filter((each) => !each.checkVisibility()
    || each.getBoundingClientRect().bottom > innerHeight).map((each) => each.outerHTML);
}"""


def test_practice_opens_with_an_exercise(server, chromium):
    """Name and the first exercise with its box on the first screen."""
    with watched_page(chromium, server, reduced_motion="reduce") as (page, _):
        page.goto(server + "practice.html")
        page.locator(".rk-live").first.wait_for()
        for width, height in ((1280, 800), (390, 844)):
            page.set_viewport_size({"width": width, "height": height})
            assert page.evaluate(OUTSIDE) == []


def test_with_a_name_the_numbers_come_chapter_by_chapter(server, chromium):
    """Never another name's numbers without a word."""
    with watched_page(chromium, server) as (page, watch):
        page.goto(server + "practice.html")
        sign_in_first = page.locator(".rk-exercise").first.get_attribute("id")
        page.fill("#rk-student", "Ada")
        page.keyboard.press("Tab")
        page.locator(f"#{sign_in_first}[data-variant]").wait_for()
        last = page.locator(".rk-exercise").last
        assert "rk-stale" in last.get_attribute("class")
        page.emulate_media(media="print")
        assert last.locator(".rk-text p").first.is_hidden()
        page.emulate_media(media="screen")
        last.scroll_into_view_if_needed()
        page.locator(f"#{last.get_attribute('id')}[data-variant]").wait_for()
        assert "rk-stale" not in last.get_attribute("class")
        assert not watch.errors + watch.strangers


def test_in_a_frame_that_forbids_files_and_dialogs_that_is_said(server, chromium):
    frame = '<iframe sandbox="allow-scripts allow-same-origin" width="1000" height="900" src="{}">'
    with watched_page(chromium, server) as (page, _):
        page.goto(server + "search.html")
        page.set_content(frame.format(server + "practice.html"))
        inner = page.frame_locator("iframe")
        inner.locator("#rk-student").fill("Ada")
        first = inner.locator(".rk-exercise").first
        first.locator(".rk-row input").fill("1")
        first.locator(".rk-row input").press("Enter")
        inner.locator(".rk-menu summary").click()
        inner.locator(".rk-export").click()
        inner.get_by_text("the frame that shows this page forbids it").wait_for()
        for _ in range(2):
            inner.locator(".rk-clear").click()
        expect(first.locator(".rk-row input")).to_have_value("")


def test_the_entries_of_a_matrix_fit_at_four_hundred_percent(server, chromium):
    over = """() => [...document.querySelectorAll(".rk-grid")].filter((grid) => {
      grid.open = true;
      return grid.scrollWidth > grid.clientWidth
        || grid.querySelector("table").getBoundingClientRect().right
          > grid.closest(".rk-exercise").getBoundingClientRect().right;
    }).length"""
    with watched_page(chromium, server, 320) as (page, _):
        page.goto(server + "practice.html")
        assert page.locator(".rk-grid").count() > 0
        assert page.evaluate(over) == 0


def test_a_browser_is_asked_not_to_tidy_up_once_there_are_answers(server, chromium):
    with watched_page(chromium, server) as (page, _):
        page.add_init_script(
            "globalThis.asked = 0; navigator.storage.persist = async () => { asked += 1; }"
        )
        page.goto(server + "practice.html")
        page.locator(".rk-live").first.wait_for()
        assert page.evaluate("() => asked") == 0
        answer(page, FIRST, "1")
        assert page.evaluate("() => asked") > 0


def test_who_gives_no_name_is_told(page):
    right = typed(variant(FIRST, "").candidates[0].rows, EXERCISES[FIRST])
    assert answer(page, FIRST, right) == candidates.RIGHT
    assert page.inner_text(".rk-progress").endswith("passed. " + NAMELESS)
    sign_in(page, "Ada")
    assert NAMELESS not in page.inner_text(".rk-progress")


def test_what_is_typed_while_the_numbers_load_stays(chromium, server):
    """On a slow line a student types faster than the numbers come."""
    held, numbers = [], "**/_static/practice/differential_drive.js*"
    with watched_page(chromium, server) as (page, watch):
        page.goto(server + "practice.html")
        page.route(numbers, lambda route: held.append(route))
        page.fill("#rk-student", "Ada")
        with page.expect_request(numbers):
            page.keyboard.press("Tab")
            box(page, FIRST).scroll_into_view_if_needed()
        field = box(page, FIRST).locator(".rk-row input")
        field.fill(RIGHT)
        field.press("Enter")
        held[0].continue_()
        box(page, FIRST).get_by_text(candidates.RIGHT, exact=True).wait_for()
        assert field.input_value() == RIGHT
        assert not watch.errors + watch.strangers


def test_answers_are_saved_as_grade_reads_them(page, tmp_path):
    sign_in(page, '=Ada, "B"')
    answer(page, FIRST, "-1/3")
    with page.expect_download() as download:
        menu(page).locator(".rk-export").click()
    path = tmp_path / download.value.suggested_filename
    assert path.name == "answers--Ada-B-.csv"
    download.value.save_as(path)
    assert page.inner_text(".rk-progress") == "Saved 1 answer as answers--Ada-B-.csv."
    [row] = table(path)
    time = datetime.fromisoformat(row.pop("time"))
    assert abs(datetime.now(UTC) - time) < timedelta(hours=1)  # now, and in no other zone
    assert row == {
        **{"kind": "answers", "course": "robokin", "version": variants.version()},
        **{"student": '=Ada, "B"', "exercise": FIRST, "answer": "-1/3"},
        **{"tries": "1", "help": ""},
    }
    first = next(csv.reader(io.StringIO(path.read_text("utf-8-sig").splitlines()[1])))
    assert first[4].startswith("'=")  # for a spreadsheet it is no formula


def saved(page, folder):
    """The answers of the file that the page saves, by exercise."""
    with page.expect_download() as download:
        menu(page).locator(".rk-export").click()
    download.value.save_as(folder / "saved.csv")
    return {row["exercise"]: row["answer"] for row in table(folder / "saved.csv")}


def test_what_was_not_checked_is_saved_too(page, tmp_path):
    """Also after the page was loaded again; it takes no pass away, and training is not saved."""
    sign_in(page, "Ada")
    assert answer(page, FIRST, RIGHT) == candidates.RIGHT
    box(page, FIRST).locator(".rk-row input").fill("12345")
    box(page, "differential-drive-2").locator(".rk-row input").fill("1, 2")
    box(page, "euler-2").get_by_role("button", name="Another one").click()
    box(page, "euler-2").locator(".rk-row input").fill("7")
    wanted = {FIRST: RIGHT, "differential-drive-2": "1, 2"}
    assert saved(page, tmp_path) == wanted
    again(page)
    assert page.inner_text(".rk-progress").startswith("1 of ")
    assert saved(page, tmp_path) == wanted


def test_nobody_saves_no_answers(page):
    answer(page, FIRST, "1")
    menu(page).locator(".rk-export").click()
    assert page.inner_text(".rk-progress") == NAMELESS
    assert page.evaluate("() => document.activeElement.id") == "rk-student"
    sign_in(page, "Ada")
    menu(page).locator(".rk-export").click()
    assert "nothing was saved" in page.inner_text(".rk-progress")


def test_another_one_is_for_training(page):
    sign_in(page, "Ada")
    before = box(page, FIRST).locator(".rk-text").inner_text()
    box(page, FIRST).get_by_role("button", name="Another one").click()
    assert box(page, FIRST).locator(".rk-text").inner_text() != before
    number = variants.choose_variant(COURSE, FIRST, "Ada") + 1
    other = variants.all_variants(FIRST)[number % variants.VARIANTS]
    right = typed(other.candidates[0].rows, EXERCISES[FIRST])
    assert answer(page, FIRST, right) == candidates.RIGHT
    assert page.inner_text(".rk-progress").startswith("0 of ")
    box(page, FIRST).get_by_role("button", name="Back to my numbers").click()
    assert box(page, FIRST).locator(".rk-text").inner_text() == before


def ladder(page, exercise):
    """What is open of the ladder of an exercise."""
    return box(page, exercise).locator(".rk-ladder").inner_text()


def test_a_ladder_from_where_to_look_to_the_answer(page, site):
    """The steps open after a try, one by one; the reason after two; what was opened is kept."""
    name = "differential-drive-4"
    sign_in(page, "Ada")
    mine, help = variant(name, "Ada"), box(page, name).locator(".rk-help")
    assert not ladder(page, name)
    help.click()
    assert "formulas of φ̇L, φ̇R" in ladder(page, name)
    link = box(page, name).locator(".rk-ladder").get_by_role("link", name="φ̇L, φ̇R")
    chapter, place = link.get_attribute("href").split("#")
    assert chapter == "./differential_drive/differential_drive.html"
    assert (site / chapter).read_text("utf-8").count(f' id="{place}"') == 1
    help.click()
    assert "Check an answer first" in ladder(page, name)
    wrong = next(c for c in mine.candidates if c.name == "M12")
    assert "half the wheel distance" in answer(page, name, typed(wrong.rows, EXERCISES[name]))
    assert "circles around the left one" not in ladder(page, name)
    answer(page, name, typed(wrong.rows, EXERCISES[name]))
    assert "circles around the left one" in ladder(page, name)  # why it is wrong
    link = box(page, name).get_by_role("link", name="See it in the chapter.")
    assert link.get_attribute("href") == "./differential_drive/differential_drive.html#M12"
    assert help.inner_text() == "Show the first step"
    help.click()
    right = EXERCISES[name].format_answer(mine.numbers)
    assert "radius times angular velocity" in ladder(page, name)
    assert f"{mine.candidates[0].rows[0][0]:.3f}" not in ladder(page, name)
    again(page)
    assert "radius times angular velocity" in ladder(page, name)
    assert answer(page, name, right.replace("rad/s", "")) == candidates.RIGHT
    assert "circles around the left one" not in ladder(page, name)  # it is no mistake any more
    assert box(page, name).locator(".rk-passed").inner_text() == "passed with help: 1 of 2 steps"
    assert help.inner_text() == "Show the answer"
    help.click()
    assert f"{mine.candidates[0].rows[0][0]:.3f}" in ladder(page, name)
    assert help.is_hidden()
    sign_in(page, "Bob")
    sign_in(page, "Ada")
    assert box(page, name).locator(".rk-passed").inner_text() == "passed with help: 1 of 2 steps"


def test_what_was_read_is_always_shown(page):
    answer(page, FIRST, "ω = ۲/۱۹۱ rad/s")
    assert box(page, FIRST).locator(".rk-read").inner_text() == "Read as 2.191 rad/s."


def test_numbers_that_do_not_come_are_told_and_asked_for_again(chromium, server):
    """Nothing is judged by numbers that are not shown."""
    numbers = "**/_static/practice/differential_drive.js*"
    with watched_page(chromium, server) as (page, _):
        page.route(numbers, lambda route: route.abort())
        page.goto(server + "practice.html")
        page.fill("#rk-student", "Ada")
        page.keyboard.press("Tab")
        first = box(page, FIRST)
        first.scroll_into_view_if_needed()
        first.get_by_text("could not be loaded").wait_for()
        field = first.locator(".rk-row input")
        field.fill(RIGHT)
        field.press("Enter")
        first.get_by_text("could not be loaded").wait_for()
        assert "wheels" not in first.locator(".rk-text").inner_text()
        assert not first.locator(".rk-verdict").inner_text()
        page.unroute(numbers)
        first.get_by_role("button", name="Try again").click()
        come_to(page, FIRST, "Ada")
        assert field.input_value() == RIGHT
        assert answer(page, FIRST, RIGHT) == candidates.RIGHT


def test_the_bar_says_who_and_how_far(page):
    sign_in(page, "ADA")
    box(page, FIRST).scroll_into_view_if_needed()
    bar = page.locator(".rk-bar")
    bar.wait_for()
    assert bar.locator("button").inner_text() == "ADA"
    assert f"0 of {len(EXERCISES)} in the course" in bar.inner_text()
    assert answer(page, FIRST, RIGHT) == candidates.RIGHT  # the same student
    assert f"1 of {len(EXERCISES)} in the course" in bar.inner_text()
    sign_in(page, " ada")
    assert page.inner_text(".rk-progress").startswith("1 of ")


def test_the_bar_comes_and_the_end_of_a_chapter_stays(chromium, server):
    with watched_page(chromium, server) as (page, watch):
        page.goto(f"{server}bicycle/bicycle.html")
        bar = page.locator(".rk-bar")
        expect(bar).to_have_attribute("inert", "")
        expect(bar).to_be_hidden()
        draw_all(page)
        high = page.evaluate(TALL)
        expect(bar).to_be_hidden()
        box(page, "bicycle-4").scroll_into_view_if_needed()
        expect(bar).to_be_visible()
        assert page.evaluate(TALL) == high
        assert not watch.errors + watch.strangers


def test_answers_are_taken_along(page, chromium, server, tmp_path):
    """By the file: on another computer they are checked again."""
    sign_in(page, "Ada")
    answer(page, FIRST, RIGHT)
    answer(page, "euler-1", "1, 2, 3")
    saved(page, tmp_path)
    with watched_page(chromium, server) as (other, _):
        other.goto(server + "practice.html")
        other.set_input_files("[type=file]", tmp_path / "saved.csv")
        other.get_by_text(ONE_PASSED).wait_for()
        assert other.input_value("#rk-student") == "Ada"
        assert box(other, FIRST).locator(".rk-row input").input_value() == RIGHT
        box(other, "euler-1").get_by_text("Not yet").wait_for()


def test_two_courses_on_one_host_share_no_answers(page, chromium, server):
    """Their names tell them apart, for answers and for the numbers that are dealt."""
    sign_in(page, "Ada")
    answer(page, FIRST, RIGHT)
    assert page.inner_text(".rk-progress").startswith("1 of ")
    other = page.context.new_page()

    def rename(route):
        text = route.fetch().text()
        route.fulfill(
            body=text.replace(f'"{COURSE}"', '"another-course"'), content_type="text/html"
        )

    other.route("**/practice.html", rename)
    other.goto(server + "practice.html")
    other.fill("#rk-student", "Ada")
    other.keyboard.press("Tab")
    box(other, FIRST).scroll_into_view_if_needed()
    number = variants.choose_variant("another-course", FIRST, "Ada")
    assert number != variants.choose_variant(COURSE, FIRST, "Ada")
    other.locator(f"#{FIRST}[data-variant='{number}']").wait_for()
    assert other.inner_text(".rk-progress").startswith("0 of ")
    assert box(other, FIRST).locator(".rk-row input").input_value() == ""
    other.close()


KEPT = "() => JSON.parse(localStorage.getItem('robokin answers robokin')).ada"


def test_a_file_that_is_loaded_twice_changes_nothing(page, tmp_path):
    """No try is added, no help forgotten, and no answer becomes newer than it is."""
    sign_in(page, "Ada")
    box(page, FIRST).locator(".rk-help").click()
    for text in ("0.3", "0.4"):
        answer(page, FIRST, text)
    before = page.evaluate(KEPT)
    assert (before[FIRST]["tries"], before[FIRST]["help"]) == (2, 1)
    saved(page, tmp_path)
    for _ in range(2):
        page.set_input_files("[type=file]", tmp_path / "saved.csv")
        page.wait_for_function("() => !document.querySelector('[type=file]').value")
        assert page.evaluate(KEPT) == before


def test_answers_are_loaded_from_what_platforms_make_of_them(page):
    """As the command `grade` reads them: see `test_tables.py`."""
    for name, content in TABLES.items():
        page.evaluate("() => localStorage.clear()")
        file = {"name": "t.csv", "mimeType": "text/csv", "buffer": content}
        page.set_input_files("[type=file]", file)
        page.wait_for_function("() => !document.querySelector('[type=file]').value")
        assert page.input_value("#rk-student") == "Ada; Ω", name
        field = box(page, FIRST).locator(".rk-row input")
        expect(field, name).to_have_value("[1; 2], ½")


def test_of_a_file_the_newer_answers_count_and_the_right_ones(page, tmp_path):
    """Who worked at two computers loses no pass, and not what was typed last."""
    sign_in(page, "Ada")
    given = {FIRST: (2001, RIGHT), "euler-1": (2001, "5; 6; 7"), "bicycle-1": (2999, "2")}
    for name in given:
        answer(page, name, "1" if len(EXERCISES[name].unknowns) == 1 else "[1, 2, 3]")
    here = page.evaluate(KEPT)
    head = "kind,course,version,time,student,exercise,answer"
    rows = [f"answers,robokin,,{y}-01-01T00:00:00.000Z,Ada,{n},{a}" for n, (y, a) in given.items()]
    (tmp_path / "other.csv").write_text("\n".join([head, *rows]))
    page.set_input_files("[type=file]", tmp_path / "other.csv")
    page.get_by_text(ONE_PASSED).wait_for()
    field = {name: box(page, name).locator(".rk-row input") for name in given}
    expect(field[FIRST]).to_have_value(RIGHT)
    expect(field["euler-1"]).to_have_value("[1, 2, 3]")  # an older wrong one
    expect(field["bicycle-1"]).to_have_value("2")
    kept = page.evaluate(KEPT)
    assert kept["euler-1"] == here["euler-1"]
    assert kept["bicycle-1"]["time"].startswith("2999")


def test_what_is_typed_and_not_checked_stays(page):
    """The field is still in use when the page is loaded again."""
    sign_in(page, "Ada")
    field = box(page, FIRST).locator(".rk-row input")
    field.press_sequentially("0.12")
    again(page)
    expect(field).to_have_value("0.12")


def test_two_tabs_show_one_name_and_its_answers(page):
    """What is typed goes to the name that is seen."""
    sign_in(page, "s0741")
    other = page.context.new_page()
    other.goto(page.url)
    expect(other.locator("#rk-student")).to_have_value("s0741")
    sign_in(other, "s0471")
    expect(page.locator("#rk-student")).to_have_value("s0471")
    answer(page, FIRST, "5")
    field = box(other, FIRST).locator(".rk-row input")
    expect(field).to_have_value("5")
    expect(box(other, FIRST).locator(".rk-verdict")).to_contain_text("Not yet")
    field.fill("56")
    expect(box(page, FIRST).locator(".rk-row input")).to_have_value("56")
    answers = page.evaluate("() => JSON.parse(localStorage.getItem('robokin answers robokin'))")
    assert [*answers] == ["s0471"]
    other.close()


def test_by_back_a_page_shows_the_name_that_was_corrected_elsewhere(page):
    """A browser may show the page as it was left: then it is told by `pageshow`."""
    sign_in(page, "s0741")
    page.evaluate("() => localStorage.setItem('robokin student', 's0471')")  # tells no other page
    page.evaluate("() => dispatchEvent(new PageTransitionEvent('pageshow', { persisted: true }))")
    expect(page.locator("#rk-student")).to_have_value("s0471")
    answer(page, FIRST, "5")
    answers = page.evaluate("() => JSON.parse(localStorage.getItem('robokin answers robokin'))")
    assert [*answers] == ["s0471"]


def test_work_before_the_name_is_not_lost(page):
    """Its numbers were nobody's; it is said where it is, and it comes back."""
    answer(page, FIRST, "2")
    sign_in(page, "Ada")
    assert "1 answered before you typed a name" in page.inner_text(".rk-progress")
    field = box(page, FIRST).locator(".rk-row input")
    expect(field).to_have_value("")
    sign_in(page, "")
    expect(field).to_have_value("2")
    assert "before you typed" not in page.inner_text(".rk-progress")


def test_a_full_browser_is_told_of(chromium, server):
    with watched_page(chromium, server) as (page, watch):
        page.add_init_script(FULL)
        page.goto(server + "practice.html")
        sign_in(page, "Ada")
        assert answer(page, FIRST, RIGHT) == candidates.RIGHT
        assert ONE_PASSED in page.inner_text(".rk-progress")
        for place in (".rk-progress", ".rk-bar"):
            assert "keeps nothing more" in page.inner_text(place)
        assert not watch.errors


def test_answers_do_not_stand_in_clear(page):
    html = page.content()
    mine = variant(FIRST, "")
    right = f"{mine.candidates[0].rows[0][0]:.3f}"
    assert right not in html.replace("\u2212", "-")
    assert json.dumps("M12") not in html


def test_keyboard_and_screen_reader(page):
    first = box(page, FIRST)
    field = first.get_by_label("Answer, one number: ω in rad/s")
    field.focus()
    described = field.get_attribute("aria-describedby").split()
    assert "wheels" in page.inner_text(f"#{described[0]}")
    assert page.get_attribute(f"#{described[1]}", "role") == "status"
    order = ["Check", "Another one", "Where should I look?"]
    for name in order:
        page.keyboard.press("Tab")
        assert page.evaluate("() => document.activeElement.textContent") == name


def test_without_a_script_it_is_said_where_the_answer_box_would_be(chromium, server):
    with watched_page(chromium, server, java_script_enabled=False) as (page, _):
        page.goto(server + "practice.html")
        assert page.get_by_text("answers cannot be checked").is_visible()
        assert box(page, FIRST).locator(".rk-text").is_visible()
        assert box(page, FIRST).locator(".rk-row input").is_hidden()


def write_sheet(*exercises):
    """The address of Ada's sheet."""
    Path("roster.csv").write_text("student\nAda\n")
    assert main(["key", "roster.csv", "--secret", "secret.txt", "--only", *exercises]) == 0
    assert main(["sheet", "key.csv"]) == 0
    [sheet] = Path("sheets").resolve().iterdir()
    return sheet.as_uri()


def test_a_teacher_s_sheet_keeps_and_saves_what_is_typed(chromium, tmp_path, monkeypatch):
    """From disk, and at once; it judges nothing, and `grade` reads what it saves."""
    monkeypatch.chdir(tmp_path)
    sheet = write_sheet(FIRST)
    (tmp_path / "answers").mkdir()
    with watched_page(chromium, tmp_path.as_uri()) as (page, watch):
        page.goto(sheet)
        page.get_by_label("Answer, one number").fill("1/3")
        page.reload()
        expect(page.get_by_label("Answer, one number")).to_have_value("1/3")
        expect(page.get_by_text("Here this sheet can be read and printed")).to_be_hidden()
        with page.expect_download() as download:
            page.get_by_role("button", name="Save my answers").click()
        expect(page.get_by_role("status")).to_have_text("Saved 1 answer as answers-Ada.csv.")
        download.value.save_as(tmp_path / "answers" / download.value.suggested_filename)
        assert not watch.errors + watch.strangers
    assert main(["grade", "answers", "--key", "key.csv"]) == 0
    [graded] = table("grades.csv")
    assert (graded["student"], graded["answer"]) == ("Ada", "1/3")
    assert graded["result"] != "missing"


def test_two_tabs_of_a_sheet_lose_no_answer(chromium, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    sheet = write_sheet(FIRST, "euler-1")
    with watched_page(chromium, tmp_path.as_uri()) as (page, watch):
        page.goto(sheet)
        other = page.context.new_page()
        other.goto(sheet)
        page.fill(f"[name={FIRST}]", "1/3")
        expect(other.locator(f"[name={FIRST}]")).to_have_value("1/3")
        other.fill("[name=euler-1]", "[1, 2, 3]")
        expect(page.locator("[name=euler-1]")).to_have_value("[1, 2, 3]")
        page.reload()
        expect(page.locator(f"[name={FIRST}]")).to_have_value("1/3")
        expect(page.locator("[name=euler-1]")).to_have_value("[1, 2, 3]")
        assert not watch.errors + watch.strangers


def test_a_sheet_without_scripts_asks_for_a_browser(chromium, tmp_path, monkeypatch):
    """As previews of files show it: nothing looks as if it could be typed or saved."""
    monkeypatch.chdir(tmp_path)
    sheet = write_sheet(FIRST)
    with watched_page(chromium, tmp_path.as_uri(), java_script_enabled=False) as (page, _):
        page.goto(sheet)
        assert page.get_by_text("Here this sheet can be read and printed").is_visible()
        assert page.locator("input:visible, button:visible").count() == 0


def test_a_matrix_can_be_typed_entry_by_entry(page):
    sign_in(page, "Ada")
    come_to(page, "euler-2", "Ada")
    right = variant("euler-2", "Ada").candidates[0].rows[0]
    grid = box(page, "euler-2").locator(".rk-grid")
    grid.locator("summary").click()
    for k, entry in enumerate(right):
        grid.get_by_label(f"row {k // 3 + 1}, column {k % 3 + 1}").fill(f"{entry:.4f}")
    grid.get_by_label("row 3, column 3").press("Enter")
    box(page, "euler-2").get_by_text(candidates.RIGHT, exact=True).wait_for()
    again(page)
    first = grid.get_by_label("row 1, column 1")
    assert float(first.input_value()) == pytest.approx(right[0], abs=1e-4)


def test_a_matrix_with_decimal_commas_fills_its_entries(page):
    """It can be read as twice as many numbers, too."""
    sign_in(page, "Ada")
    right = np.reshape(variant("euler-2", "Ada").candidates[0].rows[0], (3, 3))
    lines = ("; ".join(f"{x:.4f}".replace(".", ",") for x in line) for line in right)
    assert answer(page, "euler-2", f"[[{']; ['.join(lines)}]]") == candidates.RIGHT
    again(page)
    entries = (
        box(page, "euler-2").locator("td input").evaluate_all("all => all.map((e) => +e.value)")
    )
    assert entries == pytest.approx([*right.flat], abs=1e-4)


@pytest.mark.parametrize(("from_disk", "scheme"), [(False, "light"), (True, "dark")])
def test_who_makes_a_mistake_twice_sees_what_it_does(chromium, server, site, from_disk, scheme):
    """In the colours of the page; it is not loaded before."""
    home = site.as_uri() + "/" if from_disk else server
    with watched_page(chromium, home, scheme=scheme) as (page, watch):
        page.goto(f"{home}differential_drive/differential_drive.html")
        sign_in(page, "Ada")
        wrong = next(c for c in variant(FIRST, "Ada").candidates if c.name == "M12")
        assert "half the wheel distance" in answer(page, FIRST, typed(wrong.rows, EXERCISES[FIRST]))
        pictures = box(page, FIRST).locator(".rk-ladder img")
        expect(pictures).to_have_count(0)
        assert not [url for url in watch.kinds if "M12.svg" in url]
        answer(page, FIRST, typed(wrong.rows, EXERCISES[FIRST]))
        still = box(page, FIRST).get_by_role("img", name=half_wheel_distance.picture)
        expect(still).to_have_attribute("src", re.compile(rf"/M12\.svg\?\w+#{scheme}$"))
        still.scroll_into_view_if_needed()
        page.wait_for_function("(image) => image.naturalWidth > 300", arg=still.element_handle())
        assert not watch.errors + watch.strangers
