"""What a chapter that shows, asks and then says keeps to: sizes, goals, screens, words."""

import re

import nbformat
import pytest
from browser import pull, watched_page
from declared import FIGURES, each
from figure_numbers import expected, point
from figure_page import MADE, SHOW

from courseware.course import course
from courseware.figures import Choice, Clock, Figure, QuarterTurns
from courseware.figures.figure import MIME
from courseware.units import figure_unit

pytest_plugins = ["figure_page"]
GOALS = expected("GOALS")
in_browser = pytest.mark.browser


def opens_with_a_figure(chapter):
    """Whether there is something to move before the first section."""
    cells = nbformat.read(course().notebook(chapter), as_version=4).cells
    sections = (k for k, cell in enumerate(cells) if re.search("^## ", cell.source, re.MULTILINE))
    opening = cells[: next(sections)]
    return any(MIME in output.get("data", {}) for c in opening for output in c.get("outputs", []))


# the chapters that are told so
IN_STEPS = [
    c for c in filter(opens_with_a_figure, course().taught) if course().module(c, "exercises")
]

# --- Sizes ----------------------------------------------------------------------------------


# by name: an arm has three joints, a body three angles
MOVED = {"grip": 3, "base-views": 3, "yaw-pitch-roll": 3, "letters": 3, "draw-line": 3}
MOVED |= dict.fromkeys(("dh-frames", "tip-to-tail", "balance", "pose-columns", "letters-frames"), 3)
MOVED["odometry-letters"] = 3
TOLD = {"one-axis": 4}


@each("figure", "figures", Figure, only=lambda figure: figure.size == "step")
def test_a_step_has_two_things_to_move_and_three_numbers(figure):
    view = [c for c in figure.controls if getattr(c, "symbol", None) in figure.view_angles]
    moved = [
        c
        for c in figure.controls
        if not isinstance(c, Clock) and c not in view and getattr(c, "shown", True) is not False
    ]
    instead = "take some away, or make its size another than step"
    most = MOVED.get(figure.name, 2)
    assert len(moved) <= most, f"{figure.name} has {len(moved)} controls, at most {most}: {instead}"
    told = len(figure.readouts)
    most = TOLD.get(figure.name, 3)
    assert told <= most, f"{figure.name} has {told} readouts, at most {most}: {instead}"


# --- Goals ----------------------------------------------------------------------------------


def reached(live):
    """Which goals are marked as reached; drawn to the end first."""
    live.state()
    return live.root.locator(".rk-goal").evaluate_all(
        "(all) => all.map((goal) => goal.classList.contains('rk-done'))"
    )


def drag(live, place, wished):
    """A handle, by the mouse, to where it is at a state."""
    before = live.state()
    live.put(wished)
    there = live.centre(place)
    live.put(before)
    pull(live.page, live.centre(place), there, steps=8)


@in_browser
def test_the_robot_is_parked_by_two_drags(alone):
    with alone(FIGURES["park"], width=390) as live:
        goal = live.root.locator(".rk-goal output")
        assert reached(live) == [False]
        assert goal.text_content() == ""
        drag(live, 0, [0.06, 0.05, 0])
        assert reached(live) == [False]
        drag(live, 1, [0.06, 0.12, 0])
        assert reached(live) == [True]
        assert goal.text_content() == "reached"
        assert goal.evaluate("(e) => e.matches('output')")  # which is read aloud when it changes
        live.put([0.0, 0.0, 0])
        assert reached(live) == [True]  # once is enough …
        live.root.locator(".rk-reset").click()
        assert reached(live) == [False]  # … until a reset


@in_browser
def test_the_tasks_of_the_laboratory_are_done_by_keys(alone):
    """On the steps of the sliders, as they are for those who use no mouse."""
    figure = FIGURES["wheel-speeds"]
    left, right, time = figure.controls
    with alone(figure) as live:
        assert reached(live) == [False] * 3
        live.press(left, *["ArrowLeft"] * 10)  # from 0.05 to 0
        assert reached(live) == [True, False, False]
        live.press(left, *["ArrowRight"] * 4)
        live.press(right, *["ArrowLeft"] * 8)  # 0.02 and 0.06
        assert reached(live) == [True, True, False]
        live.press(left, *["ArrowRight"] * 16)
        live.press(right, *["ArrowLeft"] * 2)  # 0.1 and 0.05: the bay is where that is after 5 s
        live.press(time, *["ArrowRight"] * 60)
        assert reached(live) == [True] * 3


@in_browser
def test_a_goal_is_reached_by_taps(alone):
    """On the buttons beside sliders, by somebody with a finger."""
    figure = FIGURES["euler-sequence"]
    sequence, *angles = figure.controls
    with alone(figure, width=390) as live:
        live.choose(sequence, "ZXZ")
        for slider, times in zip(angles, (4, 3, -8), strict=False):
            assert not any(reached(live))
            beside = live.input(slider).locator("xpath=ancestor::div[1]")
            button = beside.locator(".rk-step").nth(int(times > 0))
            for _ in range(abs(times)):
                button.click()
        assert any(reached(live))


@in_browser
def test_a_goal_is_not_reached_by_passing_over_it(alone):
    """Over the wish that can be had, on to one that cannot; with the handle and with the slider."""
    figure = FIGURES["sideways"]
    with alone(figure) as live:
        drag(live, 0, [0.08, -0.1])
        assert live.state() == pytest.approx([0.08, -0.1], abs=2e-3)  # to a pixel
        assert reached(live) == [False]
        slider = live.input(figure.controls[1])
        slider.evaluate(SHOW)
        box = slider.bounding_box()
        height, ends = box["y"] + box["height"] / 2, (0.2, 0.5, 0.8)
        mouse, (start, middle, end) = live.page.mouse, (box["x"] + box["width"] * x for x in ends)
        mouse.move(start, height)
        mouse.down()
        mouse.move(middle, height, steps=4)
        assert live.state()[1] == pytest.approx(0, abs=0.005)
        assert reached(live) == [False]  # the hand is still on it …
        mouse.move(end, height)
        mouse.up()
        assert reached(live) == [False]
        pull(live.page, (end, height), (middle, height), steps=1)
        assert reached(live) == [True]  # … and here it has let go


@in_browser
def test_what_is_dragged_leaves_a_track(alone):
    pieces = "(all) => all.map((path) => path.getAttribute('d').split('L').length - 1)"
    with alone(FIGURES["four-countries"]) as live:
        paths = live.picture.locator("path")
        before = sum(paths.evaluate_all(pieces))
        drag(live, 2, [40, -20, 0])
        live.state()
        assert sum(paths.evaluate_all(pieces)) >= before + 4  # of eight moves of the mouse


@each("figure", "figures", Figure)
def test_a_goal_is_not_reached_at_the_start(figure):
    places = [goal["at"] for goal in figure.compiled["goals"]]
    start = figure.compute([point(figure, {})])[0, places]
    assert not start.any(), f"{figure.name}: start its controls elsewhere, or set another goal"


@in_browser
def test_the_view_follows_the_robot(alone):
    """Straight on at the highest speed for 12 s: 1.8 m, and still in the picture."""
    with alone(FIGURES["wheel-speeds"]) as live:
        live.put([0.15, 0.15, 12.0])
        box = live.picture.bounding_box()
        robot = live.picture.locator("use").last
        seen = robot.bounding_box()
        assert box["y"] < seen["y"] < box["y"] + box["height"]


# --- The page -------------------------------------------------------------------------------

OUTSIDE, INSIDE = 1600, 1500  # words outside and inside folds
FOLD = re.compile("<details>.*?</details>", re.DOTALL)


def told(chapter):
    """Return a chapter's words outside and inside folds, without exercises and mistakes."""
    outside, inside = [], []
    for cell in nbformat.read(course().notebook(chapter), as_version=4).cells:
        if cell.cell_type != "markdown":
            continue
        if any(tag.startswith("after-") for tag in cell.metadata.get("tags", [])):
            inside.append(cell.source)
        else:
            inside += FOLD.findall(cell.source)
            outside.append(FOLD.sub("", cell.source))
    inside += [p.explanation for p in course().module(chapter, "predictions").PREDICTIONS]
    return " ".join(outside).split(), " ".join(inside).split()


@pytest.mark.parametrize("chapter", IN_STEPS)
def test_a_chapter_has_few_words(chapter):
    outside, inside = map(len, told(chapter))
    print(f"{chapter}: {outside} words, {inside} in folds")
    assert outside <= OUTSIDE, f"{outside} words of prose, at most {OUTSIDE}: shorten or fold some"
    assert inside <= INSIDE, f"{inside} words in folds, at most {INSIDE}: shorten some"


def figures_of(chapter):
    """Return the figures of a chapter's notebook, in order."""
    cells = nbformat.read(course().notebook(chapter), as_version=4).cells
    outputs = [output.get("data", {}) for c in cells for output in c.get("outputs", [])]
    return [FIGURES[data[MIME]["name"]] for data in outputs if MIME in data]


@pytest.mark.parametrize("chapter", IN_STEPS)
def test_a_chapter_has_enough_to_do(chapter):
    figures = figures_of(chapter)
    live = [figure for figure in figures if figure.controls]
    goals = [goal for figure in live for goal in figure.goals]
    asked = course().module(chapter, "predictions").PREDICTIONS
    assert len(live) >= 13
    assert 8 <= len(asked) <= 10
    assert len(goals) >= 5
    source = course().notebook(chapter).read_text("utf-8")
    assert "A place to stop" in source
    assert "## Recall" in source


@in_browser
@pytest.mark.parametrize("chapter", IN_STEPS)
def test_the_first_screen_holds_the_puzzle_and_its_keys(chapter, chromium, server):
    opening = figures_of(chapter)[0]
    with watched_page(chromium, server) as (page, _):
        page.goto(f"{server}{chapter}/{chapter}.html")
        root = page.locator(f"#{opening.name}")
        keys = root.locator(  # without the view's, which are folded
            ":is(.rk-goal, .rk-control input, .rk-control select, .rk-turning button)"
            ":not(.rk-view *)"
        )
        for width, height in ((1280, 800), (390, 844)):
            page.set_viewport_size({"width": width, "height": height})
            boxes = [key.bounding_box() for key in keys.all() if key.is_visible()]
            assert max(box["y"] + box["height"] for box in boxes) <= height


@in_browser
@pytest.mark.parametrize("chapter", IN_STEPS)
def test_the_opening_is_won_by_at_most_six_acts_of_the_hand_and_by_keys(chapter, alone):
    figure = figures_of(chapter)[0]
    for by_keys in (False, True):
        with alone(figure) as live:
            acts = 0
            for k, (wished, _) in enumerate(GOALS[figure.name]):
                acts += 0 if reached(live)[k] else win(live, wished[0], by_keys)
            assert all(reached(live))
            assert by_keys or acts <= 6


def win(live, wished, by_keys):
    """Bring controls to a setting on their steps → how many acts of the hand it took."""
    acts, sliders = 0, {}
    for control in live.figure.controls:
        if control.key not in wished:
            continue
        if isinstance(control, QuarterTurns):
            for letter in re.findall("-?.", wished[control.key]):
                button = live.root.locator(f"[data-press='{letter}']")
                button.press("Enter") if by_keys else button.click()
                live.page.wait_for_function(MADE, arg=live.figure.name)
                acts += 1
            continue
        if isinstance(control, Choice):
            live.choose(control, wished[control.key])
            acts += 1
            continue
        place = live.figure.controls.index(control)
        if control.shown is False and len(live.figure.buttons) == 1:  # its button counts
            while live.point()[place] < wished[control.key]:
                button = live.root.locator(".rk-buttons button")
                button.press("Enter") if by_keys else button.click()
            acts += 1
            continue
        now = figure_unit(control.symbol.unit).factor * live.state()[place]
        steps = round((wished[control.key] - now) / control.step)
        if by_keys or not any(control.symbol in handle.sets for handle in live.figure.handles):
            live.press(control, *["ArrowRight" if steps > 0 else "ArrowLeft"] * abs(steps))
            acts += 1
            continue
        sliders[control.symbol] = (
            place,
            figure_unit(control.symbol.unit).from_si(wished[control.key]),
        )
    for k, handle in enumerate(live.figure.handles):
        there = live.state()
        for place, value in (sliders[symbol] for symbol in handle.sets if symbol in sliders):
            there[place] = value
        if there != pytest.approx(live.state()):
            drag(live, k, there)
            acts += 1
    return acts
