"""Predictions on a built page, in a real browser: those of the ninth chapter, one of each kind."""

import pytest
from browser import FULL, serving, watched_page
from test_ninth_chapter import site, tree  # noqa: F401 (fixtures)

pytest_plugins = ["browser"]
pytestmark = pytest.mark.browser

FIGURE = "document.getElementById('beacon-guess').workshop"


@pytest.fixture(scope="module")
def home(site):  # noqa: F811 (the fixture)
    with serving(site) as address:
        yield address + "beacon/beacon.html"


@pytest.fixture
def page(chromium, home):
    """The chapter on a first visit; it must stay quiet and at home."""
    with watched_page(chromium, home.rpartition("beacon/")[0]) as (page, watch):
        page.goto(home)
        page.locator("#beacon-place .rk-skip").wait_for()
        yield page
        assert not watch.errors + watch.strangers


def fold(page, name):
    return page.locator(f"#{name} > .rk-opens")


def said(page, name):
    return page.locator(f"#{name} > .rk-said")


def come_alive(page):
    """Go to the figure, which starts when it is near, and wait until it runs."""
    page.locator("#beacon-guess").scroll_into_view_if_needed()
    page.wait_for_function(f"() => {FIGURE}")


def place_ghost(page, **places):
    """Put the figure's ghost somewhere."""
    come_alive(page)
    page.evaluate(
        f"(places) => {FIGURE}.set({FIGURE}.figure.controls.map((c, i) =>"
        f" places[c.key] ?? {FIGURE}.state[i]))",
        places,
    )


def state(page):
    """What the figure's sliders show, by name."""
    come_alive(page)
    return page.evaluate(
        f"() => Object.fromEntries({FIGURE}.figure.controls.map((c, i) =>"
        f" [c.key, {FIGURE}.state[i]]))"
    )


def test_nothing_is_open_before_a_guess(page):
    for name in ("beacon-turns", "beacon-far", "beacon-place"):
        assert not fold(page, name).is_visible()
    assert page.get_by_text("So a turn of the robot is").is_hidden()  # a Markdown cell with the tag
    assert page.get_by_text("array([0.5").is_hidden()  # a code cell with the tag


def test_a_button_opens_what_belongs_to_it(page):
    page.get_by_role("button", name="to its left").focus()
    page.keyboard.press("Enter")
    assert fold(page, "beacon-turns").is_visible()
    assert page.get_by_text("So a turn of the robot is").is_visible()
    words = said(page, "beacon-turns").inner_text()
    assert words.startswith("You said: to its left. Right: to its right.")
    assert "as the beacon sees it" in words  # what this guess assumes
    assert said(page, "beacon-turns").get_attribute("role") == "status"
    assert page.evaluate("() => document.activeElement.textContent") == "to its left"
    pressed = page.locator("#beacon-turns [aria-pressed='true']")
    assert pressed.inner_text() == "to its left"
    assert not fold(page, "beacon-far").is_visible()


@pytest.mark.parametrize(
    ("typed", "words"),
    [
        ("5", "✓ You said: 5 m."),
        ("10/2", "✓ You said: 5 m."),
        ("5.1", "✓ You said: 5.1 m. Right: 5 m."),  # near enough
        ("7", "You said: 7 m. Right: 5 m.\n\nIt goes along the walls."),
        ("9", "You said: 9 m. Right: 5 m."),
    ],
)
def test_a_number_is_read_as_answers_are(page, typed, words):
    page.fill("#beacon-far input", typed)
    page.press("#beacon-far input", "Enter")
    fold(page, "beacon-far").wait_for()
    assert said(page, "beacon-far").inner_text() == words


def test_what_cannot_be_read_opens_nothing(page):
    for typed, words in (("", "Nothing is typed yet"), ("[1, 2]", "Type one number")):
        page.fill("#beacon-far input", typed)
        page.press("#beacon-far input", "Enter")
        assert words in said(page, "beacon-far").inner_text()
        assert not fold(page, "beacon-far").is_visible()


def test_only_the_ghost_can_be_moved_until_it_is_placed(page):
    figure = page.locator("#beacon-guess")
    labels = (
        "() => [...document.querySelectorAll('#beacon-guess .rk-control')]"
        ".filter((c) => c.checkVisibility()).map((c) => c.querySelector('.rk-name').textContent)"
    )
    page.wait_for_function("() => document.querySelector('#beacon-guess.rk-asked')")
    assert page.evaluate(labels) == ["x", "y"]
    assert figure.locator(".rk-readouts").is_hidden()
    grip = figure.locator("circle[aria-label^='your guess']")
    grip.hover()
    box = grip.bounding_box()
    page.mouse.down()
    page.mouse.move(box["x"] + box["width"] / 2 - 40, box["y"], steps=3)
    page.mouse.up()
    put = state(page)
    assert put["guess_x"] < 0.3  # where it was
    page.get_by_role("button", name="Here", exact=True).click()
    fold(page, "beacon-place").wait_for()
    then = state(page)
    assert {key: then[key] for key in ("guess_x", "guess_y")} == {
        key: put[key] for key in ("guess_x", "guess_y")
    }
    assert (then["b_x"], then["b_y"], round(then["theta"])) == (0, 0.5, 30)  # shown beside it
    assert page.evaluate(labels) == ["beacon bx", "beacon by", "heading"]
    assert figure.locator(".rk-readouts").is_visible()


def test_a_ghost_in_the_right_place_is_right(page):
    place_ghost(page, guess_x=0.02, guess_y=0.5)
    page.get_by_role("button", name="Here", exact=True).click()
    fold(page, "beacon-place").wait_for()
    assert said(page, "beacon-place").inner_text().startswith("✓")


@pytest.mark.parametrize("which", ["turns", "far", "place"])
def test_it_is_shown_without_a_guess_too(page, which):
    name = f"beacon-{which}"
    for _ in range(2):  # shown, forgotten, shown again
        skip = page.locator(f"#{name} .rk-skip")
        skip.focus()
        page.keyboard.press("Enter")
        assert fold(page, name).is_visible()
        assert skip.is_hidden()
        assert said(page, name).inner_text().startswith("Shown: ")
        assert page.evaluate("document.activeElement.className") == "rk-said"
        page.reload()
        fold(page, name).wait_for()
        page.get_by_role("button", name="Forget my guesses").click()
        assert not fold(page, name).is_visible()


def test_a_ghost_that_is_shown_stands_where_it_belongs(page):
    page.locator("#beacon-place .rk-skip").click()
    put = state(page)
    assert (put["guess_x"], put["guess_y"]) == pytest.approx((0, 0.5), abs=0.05)


def test_guesses_are_kept_until_they_are_forgotten(page):
    page.get_by_role("button", name="not at all").click()
    place_ghost(page, guess_x=-0.4, guess_y=0.1)
    page.get_by_role("button", name="Here", exact=True).click()
    fold(page, "beacon-place").wait_for()
    page.reload()
    fold(page, "beacon-place").wait_for()
    assert said(page, "beacon-turns").inner_text() == "You said: not at all. Right: to its right."
    come_alive(page)
    page.wait_for_function(f"() => {FIGURE}.state.includes(-0.4)")
    page.get_by_role("button", name="Forget my guesses").click()
    assert not fold(page, "beacon-turns").is_visible()
    assert not fold(page, "beacon-place").is_visible()
    page.reload()
    page.locator("#beacon-place .rk-skip").wait_for()
    assert not fold(page, "beacon-turns").is_visible()
    assert page.evaluate("() => document.cookie") == ""


def test_a_browser_that_keeps_nothing_is_told_of(chromium, home):
    with watched_page(chromium, home) as (page, watch):
        page.add_init_script(FULL)
        page.goto(home)
        page.get_by_role("button", name="not at all").click()
        assert "keeps nothing" in page.locator(".rk-forget").inner_text()
        assert fold(page, "beacon-turns").is_visible()
        assert not watch.errors


def test_broken_memory_does_no_harm(chromium, home):
    with watched_page(chromium, home) as (page, watch):
        page.add_init_script("localStorage.setItem('robokin guesses', '{broken')")
        page.goto(home)
        page.get_by_role("button", name="not at all").click()
        assert fold(page, "beacon-turns").is_visible()
        assert not watch.errors


def test_without_a_script_it_is_a_question_with_a_fold(chromium, home):
    with watched_page(chromium, home, java_script_enabled=False) as (page, _):
        page.goto(home)
        box = page.locator("#beacon-turns")
        assert box.get_by_role("button").count() == 0
        assert "to its right" in box.locator(".rk-plain").inner_text()
        assert page.get_by_text("So a turn of the robot is").is_hidden()
        box.locator("summary").first.click()
        assert page.get_by_text("So a turn of the robot is").is_visible()
        assert "as the beacon sees it" in box.inner_text()


def test_a_link_into_a_fold_opens_it(page):
    inside = fold(page, "beacon-turns").locator("[id^='equation']")
    page.goto(f"{page.url}#{inside.first.get_attribute('id')}")
    fold(page, "beacon-turns").wait_for()


def test_in_print_the_fold_stands_where_the_buttons_were(page):
    page.emulate_media(media="print")
    assert page.locator("#beacon-turns button").first.is_hidden()
    assert page.locator("#beacon-turns .rk-plain").is_visible()
    assert fold(page, "beacon-turns").is_visible()
