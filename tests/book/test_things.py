"""The things of the course's figures: all can be drawn, and their outlines can be seen."""

import re
from itertools import product
from math import pi

import numpy as np
import pytest
import sympy as sp
from support import contrast, normals

from book import things
from book.things import space
from book.things.materials import GRADIENTS, GROUNDS, TONES
from courseware.equations.quantities import declarations
from courseware.errors import CourseError
from courseware.figures import VIEW, Figure, Slider
from courseware.figures.sprites import Outline, Sprite
from robokin.styles import KINDS

quantity, _ = declarations(__name__)

x = quantity("x", "m", -10, 10, "anything that moves")
pose = (x, 1 - x, 2 * x)
# every thing, whatever can move moving
MOVING = {
    "wheel": lambda **k: things.wheel(pose, 0.1, 0.03, "left2", x),
    "steered_wheel": lambda **k: things.steered_wheel(pose, x, "right2", x),
    "castor": lambda **k: things.castor(pose, x, roll=x, **k),
    "roller_wheel": lambda **k: things.roller_wheel(pose, 1, "left2", x, **k),
    "omni_wheel": lambda **k: things.omni_wheel(pose, "left2", x),
    "mecanum_wheel": lambda **k: things.mecanum_wheel(pose, "left2", x),
    "ball_wheel": lambda **k: things.ball_wheel(pose),
    "encoder_wheel": lambda **k: things.encoder_wheel(pose, x),
    "light_gate": lambda **k: things.light_gate(pose),
    "counter": lambda **k: things.counter(pose),
    "robot": lambda **k: things.robot(pose, (x, -x), **k),
    "pad": lambda **k: things.pad(pose),
    "pad_lights": lambda **k: things.pad_lights(pose),
    "vacuum": lambda **k: things.vacuum(pose, (x, x), **k),
    "dock": lambda **k: things.dock(pose),
    "omni_robot": lambda **k: things.omni_robot(pose, (x, x, x), beta=x, **k),
    "platform": lambda **k: things.platform(pose, (x, x, x), **k),
    "car": lambda **k: things.car(pose, (x, x), x, **k),
    "bus": lambda **k: things.bus(pose, (x, x), x, **k),
    "bicycle_wheel": lambda **k: things.bicycle_wheel(pose, x),
    "trolley": lambda **k: things.trolley(pose, (x, x, x, x), **k),
    "arm": lambda **k: things.arm(pose, (x, x, x, x), (0.4, 0.3, 0.2, 0.1), opening=x, **k),
    "ceiling_camera": lambda **k: things.ceiling_camera(pose, x),
    "camera_above": lambda **k: things.camera_above(pose, **k),
    "lamplight": lambda **k: things.lamplight(pose, 1),
    "parcel": lambda **k: things.parcel(pose, **k),
    "ball": lambda **k: things.ball(pose, **k),
    "bench": lambda **k: things.bench(-1, 1, 0, -0.2),
    "sheet": lambda **k: things.sheet(pose, 1, 1),
    "tracing_paper": lambda **k: things.tracing_paper(pose, (0, 1, 0, 1)),
    "ruler": lambda **k: things.ruler(pose, 1, 3),
    "kerb": lambda **k: things.kerb(pose, 10),
    "shelf": lambda **k: things.shelf(pose),
    "tiled_room": lambda **k: Sprite(pose, things.tiled_room((0, 1, 0, 1)), silhouette=""),
    "rod": lambda **k: things.rod(pose, 0.4),
    "walls": lambda **k: things.walls((0, 2, 0, 1)),
}
LOOKING = ("robot", "vacuum", "omni_robot", "platform", "car", "bus", "trolley", "arm", "parcel")


def draw(thing, start=0.3):
    """A picture with one thing, as SVG."""
    slider = Slider(x, -10, 10, start, 0.1)
    bar = things.wheel((x, 0, 0), 0.1, 0.1)  # what the slider moves in any case
    figure = Figure("thing", "A thing.", (-2, 2, -2, 2), (bar, thing), (slider,), ground="tiles")
    return figure.render_svg(400)


def test_none_is_left_out():
    assert set(MOVING) == set(things.__all__)


@pytest.mark.parametrize("name", MOVING)
def test_a_thing_is_drawn_wherever_it_moves(name):
    for start in (-7.7, 0, 3.1):
        svg = draw(MOVING[name](), start)
        assert not re.search("NaN|undefined|Infinity", svg)


@pytest.mark.parametrize(("name", "look"), [*product(LOOKING, ("ghost", "wrong"))])
def test_a_thing_is_a_belief_or_a_mistake(name, look):
    """With a line all round that is its own, so that it is seen on whatever it lies."""
    kind = {"ghost": "ghost", "wrong": "error"}[look]
    assert f"stroke:var(--rk-{kind}" in draw(MOVING[name](look=look))


# ---- contrast


def tones_of(material):
    return [stop[1] for stop in GRADIENTS[material].stops] if material in GRADIENTS else [material]


ON = {tone for ground in GROUNDS.values() for tone in tones_of(ground.fill)}


def edges(thing):
    """The materials round a thing and round what stands out of it."""
    widest = [part.edge for part in thing.parts if isinstance(part, Outline) and not part.width]
    inner = [part for part in thing.parts if isinstance(part, Sprite)]
    return {*filter(None, widest), *(edge for part in inner for edge in edges(part))}


@pytest.mark.parametrize("page", [0, 1], ids=["light", "dark"])
def test_outlines_stand_out_from_every_ground(page):
    around = set().union(*(edges(MOVING[name]()) for name in MOVING))
    around |= {name for name in TONES if name.endswith("edge")} | {"rim"}
    meanings = {name: (look.light, look.dark) for name, look in KINDS.items()}
    for name in (around & TONES.keys()) | {"ghost", "error", "target"}:
        tone = TONES.get(name) or meanings[name]
        for ground in ON:
            assert contrast(tone[page], TONES[ground][page]) >= 3, (name, ground)  # WCAG 1.4.11


# ---- what moves


def points(path):
    """The points of a path of straight pieces."""
    return [tuple(map(float, pair.split())) for pair in re.findall(r"[ML]([^MLz]+)", path)]


def test_treads_run_ahead_as_a_wheel_rolls():
    """By one pitch the picture is the same again; by less, the mark on top is ahead."""

    def marks(roll):
        svg = draw(things.wheel((0, 1, 0), 1, 0.3, "", roll))
        *_, treads = re.findall(r'd="((?:M[^"ML]+L[^"ML]+){8,})"', svg)
        return sorted(float(m) for m in re.findall(r"M(\S+)", treads))

    pitch = 2 * pi * 0.5 / 18
    assert marks(0) == pytest.approx(marks(pitch), abs=1e-3)  # five digits are written
    top = min(marks(0.4 * pitch), key=abs)
    assert top == pytest.approx(0.92 * 0.4 * pitch, rel=0.01)  # treads lie a little inside


def test_the_pen_ends_where_the_last_link_does():
    """So the tip that is drawn is the point that a chapter computes."""
    arm = things.arm((0, 0, 0), (0, 0), (0.4, 0.3), tool="pen", base="")
    link, reach = arm, 0.0
    while inner := [part for part in link.parts if isinstance(part, Sprite)]:
        link = inner[0]
        reach += link.at[0]
    tip = max(px for px, _ in points(link.parts[-1].path))
    assert reach + tip == pytest.approx(0.7, abs=1e-5)


def test_an_arm_has_a_length_for_each_angle():
    with pytest.raises(CourseError, match=r"length for each angle, got \(0,\) and \(0.4, 0.3\)"):
        things.arm((0, 0, 0), (0,), (0.4, 0.3))


# ---- in space

MESHES = {
    "link": space.link(0.4, 0.06, 0.04),
    "pale": space.link(0.2, 0.04, 0.03, pale=True),
    "gripper": space.gripper(0.2),
    "column": space.column(0.2),
    "camera": space.camera(),
    "parcel": space.parcel(),
    "ball": space.ball(),
    "stand": space.stand(0.2),
    "aeroplane": space.aeroplane(),
    "slab": space.slab(0, 1),
}


@pytest.mark.parametrize("name", MESHES)
def test_faces_look_outwards(name):
    """Else they would be left out when they look at the reader."""
    for mesh in MESHES[name]:
        inside = np.mean(mesh.corners, axis=0)
        assert all(np.dot(middle - inside, up) >= 0 for middle, up in normals(mesh))
        assert {mesh.kind, mesh.edge} <= TONES.keys()


def test_a_body_of_a_material_is_drawn():
    bodies = [VIEW.solid(meshes, x * sp.eye(3)) for meshes in MESHES.values()]
    figure = Figure("space", "All.", (-1, 1, -1, 1), tuple(bodies), (Slider(x, -10, 10, 1, 0.1),))
    svg = figure.render_svg(400)
    assert "NaN" not in svg
    assert "color-mix(in srgb,var(--m-accent," in svg
