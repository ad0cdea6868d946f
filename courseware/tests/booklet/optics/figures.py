"""The live figures of the chapter: one scene, of which each shows some layers."""

from typing import Any

from sympy import Abs, pi, symbols

from booklet.optics import formulas
from booklet.optics.exercises import added, upside_down
from booklet.optics.formulas import d_i, d_o, f, h_i, h_o
from courseware.figures import (
    POINTER,
    Choice,
    Figure,
    Goal,
    Handle,
    Label,
    Length,
    Line,
    Outline,
    Point,
    Readout,
    Scene,
    Slider,
    Sprite,
    assign,
)

TALL = 0.05  # m, of the candle as it is drawn
SCREEN = 0.2  # m, behind the lens
NEAR = 0.5  # cm: how far from the screen still counts as sharp
LENS = Outline("M0 -.08Q.03 0 0 .08Q-.03 0 0 -.08z", "glass_lit", "edge", opacity=0.7)
WAX = Outline("M-.006 0h.012v.035h-.012z", "paper", "edge")
FLAME = Outline("M0 .035q.012 .005 0 .015q-.012 -.01 0 -.015z", "lamp", "edge")


def candle(x: Any, tall: Any, turn: Any = 0, look: str = "") -> Sprite:
    """Draw a candle on the axis, of any height; turned by π it hangs from the axis."""
    return Sprite((x, 0, turn), (WAX, FLAME), look=look, size=tall / TALL)


SCENE = Scene(
    layers={
        "lens": (
            Line("ghost", ((-0.42, 0), (0.34, 0))),
            Sprite((0, 0, 0), (LENS,)),
            Label("text", (0.02, 0.07), "lens"),
        ),
        "screen": (Line("path", ((SCREEN, -0.1), (SCREEN, 0.1))),),
        "rays": (
            Line("ghost", ((-d_o, h_o), (0, h_o), (d_i, h_i))),
            Line("ghost", ((-d_o, h_o), (d_i, h_i))),
        ),
        "candle": (candle(-d_o, h_o), candle(d_i, -h_i, pi, "ghost"), Point(d_i, (d_i, h_i))),
        "distances": (
            Length(d_o, (-d_o, -0.11), (0, -0.11)),
            Length(d_i, (0, -0.11), (d_i, -0.11)),
        ),
    },
    handles={"candle": (Handle("the candle", (-d_o, h_o), {d_o: -POINTER[0], h_o: POINTER[1]}),)},
    common={"view": (-0.42, 0.34, -0.14, 0.1), "grid": False},
)
IMAGE = assign(formulas.image_distance, formulas.image_height)
SLIDERS = (
    Slider(d_o, 0.15, 0.4, start=0.3, step=0.01),
    Slider(f, 0.06, 0.1, start=0.1, step=0.005),
    Slider(h_o, 0.02, 0.06, start=0.05, step=0.005),
)


def image_figure() -> Figure:
    """Draw a candle and its image."""
    return SCENE.figure(
        "optics-image",
        "A candle, a lens, and the image behind it, upside down",
        "lens rays candle distances",
        size="step",
        controls=SLIDERS[:2],
        where=[(h_o, TALL), *IMAGE],
        readouts=(Readout(d_i),),
        sentence="The image is {d_i} behind the lens.",
    )


def screen_figure() -> Figure:
    """Draw a candle and its image, which has to be put on a screen."""
    return SCENE.figure(
        "optics-screen",
        "A candle, a lens, and the image behind it, near a screen",
        "lens screen rays candle",
        "candle",
        size="laboratory",
        controls=SLIDERS,
        where=IMAGE,
        readouts=(Readout(d_i), Readout(h_i)),
        sentence="The image is {d_i} behind the lens and {h_i} tall.",
        goal=Goal(
            Abs(d_i - SCREEN) < NEAR / 100,
            f"Make the image sharp: within {NEAR} cm of the screen.",
        ),
    )


def mistakes_figure() -> Figure:
    """Draw the image, and where a mistake puts it."""
    nearer, larger = symbols("nearer larger")
    here = {d_o: 0.3, f: 0.1, h_o: TALL}
    right = formulas.image_distance.substitute(here)
    at = nearer * added.substitute(here) + larger * right
    tall = nearer * formulas.image_height.substitute({**here, d_i: at})
    tall += larger * upside_down.substitute({**here, d_i: right})
    return SCENE.figure(
        "optics-mistakes",
        "A candle, its image, and where a mistake puts the image",
        "lens",
        controls=(
            Choice.one_hot("mistake", (nearer, larger), (m.title for m in (added, upside_down))),
        ),
        shapes=(
            candle(-here[d_o], TALL),
            candle(right, TALL / 2, pi, "ghost"),
            candle(at, -tall, pi, "wrong"),
        ),
        readouts=(Readout("height", "height h_i", tall, "m"),),
        sentence="The mistake makes the image {height} tall.",
    )


FIGURES = (image_figure(), screen_figure(), mistakes_figure())
