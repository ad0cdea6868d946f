"""Predictions on a built page, in a real browser: three of one chapter, one of each kind."""

from contextlib import contextmanager

import pytest
from browser import DRAW_ALL, FULL, watched_page
from playwright.sync_api import expect

pytest_plugins = ["browser"]
pytestmark = pytest.mark.browser

HOME = "differential_drive/differential_drive.html"
BUTTONS, NUMBER, GHOST = "ever-straighter", "how-fast", "where-after"
# a card is in the figure that waits, and then at its own place
GHOSTS = {GHOST: "guess", "where-still": "still"}
CARDS = {name: f":is(#{figure}, #{name}) .rk-card" for name, figure in GHOSTS.items()}
FIGURE = "document.getElementById('guess').courseware"
INSIDE = "happens in real programs"  # in what the buttons open
THERE = (-0.069, 0.126)  # where P is after 2 s


@contextmanager
def visited(chromium, server):
    """The chapter on a first visit; it must stay quiet and at home."""
    with watched_page(chromium, server) as (page, watch):
        page.goto(server + HOME)
        card(page, GHOST).locator("form").wait_for()
        yield page
        assert not watch.errors + watch.strangers


@pytest.fixture(scope="module")
def opened(chromium, server):
    """The chapter, which most tests share."""
    with visited(chromium, server) as page:
        yield page


def card(page, name):
    return page.locator(CARDS.get(name, f"#{name} .rk-card"))


def place_wrongly(page, **places):
    """Place the ghost somewhere, and return what is said of it; the question stays open."""
    place_ghost(page, **places)
    card(page, GHOST).get_by_role("button", name="Here").click()
    assert not fold(page, GHOST).is_visible()
    return said(page, GHOST).inner_text()


def give_up(page, name=GHOST):
    """Press what shows the answer; a ghost is placed three times before, where it is."""
    for _ in range(3 if name == GHOST else 0):
        card(page, GHOST).get_by_role("button", name="Here").click()
    card(page, name).locator(".rk-skip").focus()
    page.keyboard.press("Enter")


# as on a first visit, but for figures that are alive
FORGOTTEN = """() => {
  document.querySelector(".rk-skip").click();
  document.querySelector(".rk-forget button").click();
  history.replaceState(null, "", location.pathname);
  localStorage.clear();
}"""


@pytest.fixture
def page(opened):
    """The chapter, with no guess made."""
    opened.emulate_media(media="screen")
    opened.mouse.move(0, 0)
    opened.evaluate(FORGOTTEN)
    return opened


def fold(page, name):
    return page.locator(f"#{name} > .rk-opens")


def said(page, name):
    return card(page, name).locator(".rk-said")


def come_alive(page):
    """Go to the figure, which starts when it is near, and wait until it runs."""
    page.locator("#guess").scroll_into_view_if_needed()
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


def test_nothing_is_open_before_a_guess(chromium, server):
    with visited(chromium, server) as page:
        for name in (BUTTONS, NUMBER, GHOST):
            assert not fold(page, name).is_visible()
        assert page.get_by_text(INSIDE).is_hidden()  # a Markdown cell with the tag
        assert page.get_by_text("omega 1e-12: off by").is_hidden()  # a code cell with the tag


def test_a_button_opens_what_belongs_to_it(page):
    page.get_by_role("button", name="it stays right").focus()
    page.keyboard.press("Enter")
    assert fold(page, BUTTONS).is_visible()
    assert page.get_by_text(INSIDE).is_visible()
    words = said(page, BUTTONS).inner_text()
    assert words.startswith("You said: it stays right. The answer: it gets worse.")
    assert "a computer keeps 16 digits" in words  # what this guess assumes
    assert said(page, BUTTONS).get_attribute("role") == "status"
    assert page.evaluate("() => document.activeElement.textContent") == "it stays right"
    pressed = page.locator(f"#{BUTTONS} [aria-pressed='true']")
    assert pressed.inner_text() == "it stays right"
    assert not fold(page, NUMBER).is_visible()


TYPED = {
    "15/2": "✓ You said: 7.5 cm/s.",
    "7.6": "✓ You said: 7.6 cm/s. The answer: 7.5 cm/s.",  # near enough
    "5": "You said: 5 cm/s. The answer: 7.5 cm/s.\n\n"
    "That is the difference: the robot turns by it.",
    "9": "You said: 9 cm/s. The answer: 7.5 cm/s.",
}


TOLD = """(box, texts) => texts.map((text) => {
  const field = box.querySelector("input");
  field.value = text;
  field.form.requestSubmit();
  const said = box.querySelector(".rk-opens").open && box.querySelector(".rk-said").innerText;
  document.querySelector(".rk-forget button").click();
  return said;
})"""


def test_a_number_is_read_as_answers_are(page):
    page.evaluate(DRAW_ALL)  # what is not drawn has no text
    found = page.locator(f"#{NUMBER}").evaluate(TOLD, list(TYPED))
    assert dict(zip(TYPED, found, strict=True)) == TYPED


def test_what_cannot_be_read_opens_nothing(page):
    for typed, words in (("", "Nothing is typed yet"), ("[1, 2]", "Type one number")):
        page.fill(f"#{NUMBER} input", typed)
        page.press(f"#{NUMBER} input", "Enter")
        assert words in said(page, NUMBER).inner_text()
        assert not fold(page, NUMBER).is_visible()
    page.fill(f"#{NUMBER} input", "5")
    page.press(f"#{NUMBER} input", "Enter")
    assert fold(page, NUMBER).is_visible()


# where the picture is below the top of its figure, and how large
PICTURE = """(figure) => {
  const { top } = figure.getBoundingClientRect();
  const box = figure.querySelector("svg").getBoundingClientRect();
  return [box.top - top, box.width, box.height];
}"""


def test_only_the_ghost_can_be_moved_until_it_is_placed(page):
    figure = page.locator("#guess")
    come_alive(page)
    labels = (
        "() => [...document.querySelectorAll('#guess .rk-control')]"
        ".filter((c) => !c.inert).map((c) => c.querySelector('.rk-name').textContent)"
    )
    page.wait_for_function("() => document.querySelector('#guess [inert]')")
    assert page.evaluate(labels) == ["x", "y"]
    assert figure.locator(".rk-reset").is_hidden()
    grip = figure.locator("circle[aria-label^='your guess']")
    grip.hover()
    box = grip.bounding_box()
    page.mouse.down()
    page.mouse.move(box["x"] + box["width"] / 2 - 40, box["y"], steps=3)
    page.mouse.up()
    put, stands = state(page), figure.evaluate(PICTURE)
    assert put["guess_x"] < 0.1  # where it was
    give_up(page)
    fold(page, GHOST).wait_for()
    then = state(page)
    assert figure.evaluate(PICTURE) == stands
    assert (then["guess_x"], then["guess_y"]) == (put["guess_x"], put["guess_y"])
    assert then["t"] == 2  # shown beside it
    assert page.evaluate(labels) == ["time"]


def test_a_guess_may_be_tried_and_one_that_is_near_goes_to_the_right_place(page):
    """The pin of step 2: the time may be moved meanwhile."""
    figure, live = page.locator("#still"), "document.getElementById('still').courseware"
    figure.scroll_into_view_if_needed()
    page.wait_for_function(f"() => {live}")
    time = figure.locator(".rk-clock input")
    time.press("End")
    assert page.evaluate(f"() => {live}.state[2]") == float(time.get_attribute("max"))
    page.evaluate(f"() => {live}.set([-0.14, 0.005, 0])")  # as near as is enough
    card(page, "where-still").get_by_role("button", name="Here").click()
    fold(page, "where-still").wait_for()
    assert said(page, "where-still").inner_text().startswith("✓")
    assert page.evaluate(f"() => {live}.state.slice(0, 2)") == pytest.approx([-0.15, 0])


def test_a_figure_goes_on_from_its_answer_and_a_reset_leaves_what_that_has_drawn(chromium, server):
    with watched_page(chromium, server) as (page, _):
        page.goto(f"{server}elbow_arm/elbow_arm.html#four-countries")
        figure = page.locator("#four-countries")
        figure.locator(".rk-skip").click()
        state = "document.getElementById('four-countries').courseware?.state"
        page.wait_for_function(f"() => {state}?.[2] === 1")
        figure.locator("[type=range]").first.press("ArrowRight")
        assert page.evaluate(state) == [17, 90, 1]  # the answer is 16.3° and 90°
        figure.locator(".rk-reset").click()
        assert page.evaluate(state)[2] == 1


def test_nothing_is_judged_before_it_is_moved(page):
    come_alive(page)
    for _ in range(4):
        card(page, GHOST).locator("form button", has_text="Here").click()
        assert said(page, GHOST).inner_text() == "Move your guess first."
    assert card(page, GHOST).locator(".rk-skip").is_visible()


def test_a_wrong_place_is_answered_with_its_way_and_tried_again(page):
    x, y = THERE
    assert place_wrongly(page, guess_x=x + 0.12, guess_y=y) == "Too far to the right."
    straight = place_wrongly(page, guess_x=0, guess_y=0.15)
    assert straight.endswith("That is straight on, as if it did not turn.")
    far = "10 cm too far to the left, 5 cm too far down."  # the third time with sizes
    assert place_wrongly(page, guess_x=x - 0.1, guess_y=y - 0.05) == far
    assert page.evaluate("() => localStorage.getItem('robokin guesses')") in (None, "{}")


def test_after_three_tries_it_is_warmer_or_colder(page):
    skip, (x, y) = card(page, GHOST).locator(".rk-skip"), THERE
    for words in (*["Too far to the right."] * 2, "10 cm too far to the right."):
        assert place_wrongly(page, guess_x=x + 0.1, guess_y=y) == words
    assert place_wrongly(page, guess_x=x, guess_y=y + 0.05) == "Warmer: 5 cm too far up."
    assert place_wrongly(page, guess_x=x, guess_y=y + 0.07) == "Colder: 7 cm too far up."
    skip.click()
    assert fold(page, GHOST).is_visible()
    assert said(page, GHOST).inner_text().startswith("You said: x −0.069 m, y 0.196 m.")


def test_it_is_shown_without_a_guess_too(page):
    place_ghost(page, guess_x=-0.2)
    for name in (BUTTONS, NUMBER, GHOST):
        give_up(page, name)
        assert fold(page, name).is_visible()
        assert card(page, name).locator(".rk-skip").is_hidden()
        assert said(page, name).inner_text().startswith(("Shown: ", "You said: "))
        assert page.evaluate("document.activeElement.className") == "rk-said"
    page.get_by_role("button", name="Forget my guesses").click()
    assert not any(fold(page, name).is_visible() for name in (BUTTONS, NUMBER, GHOST))


def test_a_guess_that_is_typed_and_not_given_stays(page):
    page.locator(f"#{NUMBER} .rk-guess input").press_sequentially("7.")
    page.reload()
    expect(page.locator(f"#{NUMBER} .rk-guess input")).to_have_value("7.")


def test_guesses_are_kept_until_they_are_forgotten(page):
    page.get_by_role("button", name="it gets better").click()
    place_ghost(page, guess_x=-0.2, guess_y=0.1)
    give_up(page)
    fold(page, GHOST).wait_for()
    kept = page.evaluate("() => JSON.parse(localStorage.getItem('robokin guesses'))")
    assert kept == {BUTTONS: 0, GHOST: [-0.2, 0.1]}  # as in earlier releases: who comes back has it
    page.reload()
    fold(page, GHOST).wait_for()
    said(page, BUTTONS).scroll_into_view_if_needed()
    page.wait_for_function("(said) => said.innerText", arg=said(page, BUTTONS).element_handle())
    assert said(page, BUTTONS).inner_text() == (
        "You said: it gets better. The answer: it gets worse.\n\n"
        "The path gets simpler, but not the computation."
    )
    come_alive(page)
    page.wait_for_function(f"() => {FIGURE}.state.includes(-0.2)")
    page.get_by_role("button", name="Forget my guesses").click()
    assert not fold(page, BUTTONS).is_visible()
    assert not fold(page, GHOST).is_visible()
    page.reload()
    card(page, GHOST).locator("form").wait_for()
    assert not fold(page, BUTTONS).is_visible()
    assert page.evaluate("() => document.cookie") == ""


def test_a_browser_that_keeps_nothing_is_told_of(chromium, server):
    with watched_page(chromium, server) as (page, watch):
        page.add_init_script(FULL)
        page.goto(server + HOME)
        page.get_by_role("button", name="it gets better").click()
        assert "keeps nothing" in page.locator(".rk-forget").inner_text()
        assert fold(page, BUTTONS).is_visible()
        assert not watch.errors


def test_without_a_script_it_is_a_question_with_a_fold(chromium, server):
    with watched_page(chromium, server, java_script_enabled=False) as (page, _):
        page.goto(server + HOME)
        box = page.locator(f"#{BUTTONS}")
        assert box.get_by_role("button").count() == 0
        box.scroll_into_view_if_needed()
        expect(box.locator(".rk-plain")).to_contain_text("it gets worse", use_inner_text=True)
        assert page.get_by_text(INSIDE).is_hidden()
        box.locator("summary").first.click()
        assert page.get_by_text(INSIDE).is_visible()
        assert "a computer keeps 16 digits" in box.inner_text()


def test_a_link_into_a_fold_opens_it(page):
    inside = fold(page, BUTTONS).locator("[id^='equation']")
    page.goto(f"{page.url}#{inside.first.get_attribute('id')}")
    fold(page, BUTTONS).wait_for()


def test_in_print_the_fold_stands_where_the_buttons_were(page):
    page.emulate_media(media="print")
    assert page.locator(f"#{BUTTONS} button").first.is_hidden()
    assert page.locator(f"#{BUTTONS} .rk-plain").is_visible()
    assert fold(page, BUTTONS).is_visible()
