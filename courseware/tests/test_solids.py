"""Solids in space, quarter turns by buttons, and the matrix in the picture."""

import json
import re
from dataclasses import replace

import numpy as np
import pytest
import sympy as sp
from declared import FIGURES
from figure_numbers import pressed
from hypothesis import given
from hypothesis import strategies as st
from small_figures import painted, space_figure
from support import EPS, assert_close, normals

from book.euler.figures import PRESSES, compose, last_rotation
from book.things import meshes, space
from courseware.errors import CourseError
from courseware.figures import VIEW, Bracket, Readout
from courseware.script import engine as script
from robokin import euler

pytest_plugins = ["figure_page"]
in_browser = pytest.mark.browser

BODIES = {
    "box": meshes.box("body", (1, 2, 3), at=(1, 1, 1)),
    "cylinder": meshes.cylinder("body", (1, 0.5), (-1, 2), along="x"),
    "plate": meshes.plate("body", [(0, 0), (2, 0), (1, 1)], 0.1, along="y"),
    "die": space.die("body")[0],
    "ball": meshes.ball("body"),
    "ring": meshes.ring("body", 1.0, 1.5, 0.2, along="y"),
}
EYE = sp.eye(3)


@pytest.mark.parametrize("name", BODIES)
def test_faces_look_outward(name):
    """By the volume that lies behind them: of a ring turned inside out it would be negative."""
    part = BODIES[name]
    inside = np.mean(part.corners, axis=0)
    volume = sum(np.dot(middle - inside, up) for middle, up in normals(part)) / 6
    known = {"box": 6, "plate": 0.1}.get(name)
    assert volume > 0
    if known:
        assert volume == pytest.approx(known)
    if name != "ring":  # the others are convex: every face has the middle behind it
        assert all(np.dot(middle - inside, up) >= -1e-12 for middle, up in normals(part))


@pytest.mark.parametrize("name", BODIES)
def test_a_body_is_closed(name):
    """Every edge is run through once in each direction."""
    faces = BODIES[name].faces
    rounded = [tuple(np.round(c, 9)) for c in BODIES[name].corners]  # a ball's poles are one point
    edges = [
        (rounded[a], rounded[b])
        for face in faces
        for a, b in zip(face, (*face[1:], face[0]), strict=True)
        if rounded[a] != rounded[b]
    ]
    assert sorted(edges) == sorted((b, a) for a, b in edges)


def test_opposite_faces_of_a_die_add_up_to_seven():
    middles = {
        number: tuple(np.round(middle, 6))
        for number, (middle, _) in zip(space.FACE_NUMBERS, normals(BODIES["die"]), strict=False)
    }
    assert sorted(middles) == [1, 2, 3, 4, 5, 6]
    assert [middles[k] for k in (1, 2, 3)] == [(0.5, 0, 0), (0, 0.5, 0), (0, 0, 0.5)]
    assert all(np.allclose(middles[k], -np.array(middles[7 - k])) for k in (1, 2, 3))


# --- What is painted ------------------------------------------------------------------------


def drawn(figure, **shown):
    """The picture at a setting, in the units shown."""
    state = [shown.get(str(c.symbol), c.start) for c in figure.controls]
    return str(script.run(f"courseware.renderPicture({figure.code}, {json.dumps(state)})"))


def cubes(*places, **more):
    """Boxes of side 1 at places, each of a kind."""
    scene = [VIEW.solid([meshes.box(kind, (1, 1, 1))], EYE, at, **more) for kind, at in places]
    return space_figure(shapes=tuple(scene))


SIDES = [(30, 20, 3), (0, 0, 1), (90, 0, 1), (45, 0, 2), (-120, -40, 3), (10, 90, 1)]


@pytest.mark.parametrize(("azimuth", "elevation", "faces"), SIDES)
def test_faces_that_look_away_are_not_drawn(azimuth, elevation, faces):
    figure = cubes(("body", (0, 0, 0)))
    svg = drawn(figure, azimuth=azimuth, elevation=elevation)
    assert len(re.findall("color:color-mix", svg)) == faces


@pytest.mark.parametrize(("azimuth", "last"), [(0, "left"), (180, "right"), (170, "right")])
def test_the_nearer_body_is_painted_over_the_other(azimuth, last):
    figure = cubes(("left", (1, 0, 0)), ("right", (-1, 0, 0)))
    order = painted(figure, azimuth=azimuth, elevation=20)
    first = {"left": "right", "right": "left"}[last]
    assert set(order) == {"left", "right"}
    assert max(k for k, kind in enumerate(order) if kind == first) < order.index(last)


def shades(svg):
    """How much of its own colour each face keeps, + if lighter, in the order of painting."""
    found = re.findall(r"color:color-mix\(in srgb,var\(--rk-body,#\w+\) (\d+)%,#(\w)", svg)
    return [(100 - int(part)) * (1 if other == "f" else -1) for part, other in found]


def test_the_light_comes_from_above_and_stays_in_the_room():
    """The top is the lightest face from wherever it is seen, and turning the view changes none."""
    figure = cubes(("body", (0, 0, 0)))
    seen = {a: shades(drawn(figure, azimuth=a, elevation=30)) for a in (20, 40, 110, 130)}
    assert sorted(seen[20]) == sorted(seen[40])
    assert sorted(seen[20]) != sorted(seen[110])
    tops = {max(found) for found in seen.values()}
    assert len(tops) == 1
    assert all(found.count(max(found)) == 1 for found in seen.values())


def test_a_pose_turns_and_moves_a_body():
    """A box turned by a quarter about z looks like one with its sides exchanged."""
    R = sp.Matrix([[0, -1, 0], [1, 0, 0], [0, 0, 1]])
    turned = space_figure(shapes=(VIEW.solid([meshes.box("body", (1, 2, 3))], R, (0, 1, 0)),))
    exchanged = space_figure(
        shapes=(VIEW.solid([meshes.box("body", (2, 1, 3), at=(0, 1, 0))], EYE),)
    )
    outlines = [set(map(frozenset, map(str.split, re.findall('d="M([^"]+)z"', drawn(f)))))
                for f in (turned, exchanged)]  # fmt: skip
    assert outlines[0] == outlines[1]


def test_a_shadow_falls_straight_down_and_lies_under_all():
    figure = cubes(("body", (0, 0, 0)), floor=-1.0)
    shadow = "opacity:var(--rk-soft"
    seen = drawn(figure, elevation=30)
    assert 0 < seen.index(shadow) < seen.rindex(shadow) < seen.index("--rk-body")
    from_above = drawn(figure, azimuth=0, elevation=90)
    outline, top = (re.search(f'{name}([^"z]+)', from_above)[1] for name in (' d="M', ' points="'))
    corners = re.findall(r"\S+ \S+", top)
    assert sorted(re.findall(r"\S+ \S+", outline)) == sorted(corners[:-1])  # ends where it began
    assert shadow not in drawn(figure, elevation=-30)  # through the floor one sees no shadow


def test_the_shadow_of_a_ring_has_a_hole():
    """Two loops that run opposite ways: a ring's inner rim lets the light through."""
    ring = VIEW.solid([meshes.ring("body", 0.6, 0.8, 0.1, "z")], EYE, floor=-1.0)
    loops = re.search(' d="M([^"]+)z"', drawn(space_figure(shapes=(ring,)), elevation=90))[1]
    areas = []
    for loop in loops.split("zM"):
        x, y = np.array(loop.split(), dtype=float).reshape(-1, 2).T
        areas.append(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))
    assert len(areas) == 2
    assert areas[0] * areas[1] < 0


def test_a_ghost_is_clear():
    ghost = drawn(cubes(("ghost", (0, 0, 0)), opacity=0.2))
    assert "fill-opacity:0.2" in ghost
    assert "color-mix" not in ghost


def test_what_is_printed_on_a_face_goes_with_it():
    figure = space_figure(shapes=(VIEW.solid(space.die("body"), EYE),))
    counts = {drawn(figure, azimuth=a, elevation=e).count("<circle")
              for a, e in ((0, 0), (90, 0), (0, 90), (180, 0), (-90, 0), (0, -90))}  # fmt: skip
    assert counts == {1, 2, 3, 4, 5, 6}


@pytest.mark.parametrize(
    "part", [{"kind": "gold"}, {"edge": "gold"}, {"dots": {0: [(0, 0, 0.1, "gold")]}}]
)
def test_an_unknown_material_of_a_part_is_refused(part):
    body = replace(meshes.box("body", (1, 1, 1)), **part)
    with pytest.raises(CourseError, match="no material 'gold'; there are"):
        _ = space_figure(shapes=(VIEW.solid([body], EYE),)).code


def test_shades_are_plain_colours_in_a_notebook():
    assert "color-mix" not in FIGURES["die"]._repr_mimebundle_()[0]["image/svg+xml"]


# --- Quarter turns --------------------------------------------------------------------------

presses = st.lists(st.sampled_from([s + x for s in ("", "-") for x in "xyzXYZ"]), max_size=6)


def turning(**parts):
    """A body's rotation, entry by entry, after presses."""
    now = compose(last_rotation(PRESSES.part))
    names = [f"r{k}" for k in range(9)]
    right = {
        "controls": (PRESSES,),
        "readouts": tuple(Readout(n, n, x, "") for n, x in zip(names, now, strict=True)),
        "shapes": (Bracket(now, (0, 0), "now"),),
        "sentence": "{turns}",
    }
    return space_figure(**{**right, **parts})


FIGURE = turning()


def rotation(text, made=1.0):
    """The rotation that the figure computes."""
    return FIGURE.compute([pressed(text, made)])[0, :9].reshape(3, 3)


@given(presses, st.floats(0, 1))
def test_own_axes_multiply_on_the_right_and_the_rooms_on_the_left(pressed_ones, made):
    R = np.eye(3)
    for place, press in enumerate(pressed_ones):
        part = made if place == len(pressed_ones) - 1 else 1
        angle = np.pi / 2 * part * (-1 if press[0] == "-" else 1)
        turn = euler.to_matrix(press[-1], [angle])
        R = R @ turn if press[-1].isupper() else turn @ R
    # six products of quarter turns, each off by a rounding of cos(90°)
    assert_close(rotation("".join(pressed_ones), made), R, atol=12 * EPS)


def test_whole_turns_are_whole_numbers():
    assert set(np.ravel(pressed("XyZ-x-Y-z", 1.0)[:9])) <= {-1, 0, 1}
    assert pressed("", 1.0)[9:] == [0, 0, 0, 1, 1, 0]
    assert pressed("X-y", 0.5)[9:] == [0, -1, 0, 0, 0.5, 2]


def test_a_matrix_stands_in_the_picture_with_its_columns_in_colour():
    svg = str(script.run(f"courseware.renderPicture({FIGURE.code}, [['Z', 1]])"))
    found = re.findall(r'style="fill:var\(--rk-(\w)_axis[^"]*font:600 13px[^"]*">([^<]+)<', svg)
    assert found == [(axis, n) for row in (["0", "−1", "0"], ["1", "0", "0"], ["0", "0", "1"])
                     for axis, n in zip("xyz", row, strict=True)]  # fmt: skip
    assert "now" in svg


# --- On the page ----------------------------------------------------------------------------

DIE = FIGURES["die"]


@in_browser
def test_buttons_turn_the_die_and_the_goal_is_reached(alone):
    with alone(DIE) as live:
        goals = live.root.locator(".rk-goal")
        live.press(DIE.controls[0], "Z", "X", "Y", "-Y", "X")
        assert live.state()[0] == ["ZXY-YX", 1]
        assert live.readouts() == {"count": "5"}
        assert [goal.locator("output").text_content() for goal in goals.all()] == ["reached", ""]
        live.root.locator(".rk-reset").click()
        assert live.state()[0] == ["", 1]
        live.press(DIE.controls[0], "z", "X", "X")
        live.state()  # drawn to the end
        assert goals.nth(1).locator("output").text_content() == "reached"


@in_browser
def test_a_turn_slides_in_from_its_own_side(alone):
    """From the right about own axes, from the left about the room's; then it stands beside."""
    own = {"before": lambda page: page.clock.install(time=0), "reduced_motion": "no-preference"}
    with alone(DIE, **own) as live:
        live.page.clock.pause_at(60_000)
        ways = {}
        for one in ("Z", "z"):
            live.root.locator(f"[data-press='{one}']").click()
            ways[one] = []
            for _ in range(3):
                live.page.clock.run_for(150)
                live.state()
                ways[one].append(live.root.evaluate(PLACE))
            live.page.clock.run_for(600)
        assert ways["Z"] == sorted(ways["Z"], reverse=True)
        assert ways["z"] == sorted(ways["z"])
        assert ways["Z"][0] > ways["Z"][-1] > ways["z"][-1] > ways["z"][0]


PLACE = """(figure) => Math.min(...[...figure.querySelectorAll("svg text")]
  .filter((text) => text.getAttribute("style").includes("--rk-icr"))
  .map((text) => Number(text.getAttribute("x"))))"""


@in_browser
@pytest.mark.parametrize("meanwhile", ["the view is dragged", "a slider of the view", "reset"])
def test_a_turn_comes_to_its_end_whatever_else_moves(alone, meanwhile):
    own = {"before": lambda page: page.clock.install(time=0), "reduced_motion": "no-preference"}
    with alone(DIE, **own) as live:
        live.page.clock.pause_at(60_000)
        before = live.state()
        live.root.locator("[data-press='Z']").click()
        live.page.clock.run_for(200)
        assert 0 < live.state()[0][1] < 1
        if meanwhile == "reset":
            live.root.locator(".rk-reset").click()
        elif meanwhile == "a slider of the view":
            live.root.locator(".rk-view summary").press("Enter")
            live.press(DIE.controls[-1], "ArrowRight")
        else:
            box = live.picture.bounding_box()
            live.page.mouse.move(box["x"] + 60, box["y"] + 60)
            live.page.mouse.down()
            live.page.clock.run_for(200)
            live.page.mouse.move(box["x"] + 120, box["y"] + 60, steps=3)
            live.page.mouse.up()
        live.page.clock.run_for(1000)
        turned, *view = live.state()
        assert turned == (["", 1] if meanwhile == "reset" else ["Z", 1])
        assert (view == before[1:]) == (meanwhile == "reset")


@in_browser
def test_with_reduced_motion_a_turn_is_there_at_once(alone):
    with alone(DIE, reduced_motion="reduce") as live:
        live.root.locator("[data-press='X']").click()
        assert live.state()[0] == ["X", 1]


@in_browser
def test_the_view_is_turned_by_keys_once_its_fold_is_open(alone):
    with alone(DIE) as live:
        before = live.state()
        assert not live.input(DIE.controls[-1]).is_visible()
        live.root.locator(".rk-view summary").press("Enter")
        assert live.input(DIE.controls[-1]).is_visible()
        live.press(DIE.controls[-1], "ArrowRight")
        assert live.state()[-1] == before[-1] + 1
