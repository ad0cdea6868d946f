"""The programs that students of the chapter write."""

from booklet.optics.exercises import added, upside_down
from booklet.optics.formulas import d_i, d_o, f, h_o
from booklet.optics.functions import focal_length, image_distance, image_height
from courseware.answers import Unknown
from courseware.figures import Line, Point
from courseware.programs.program import Program


def draw_distance(right, answer, d_o, f):
    """Draw object and lens, and the right place of the image beside the answer."""
    return (
        Line("ghost", ((-d_o, 0), (right, 0))),
        Point("path", (-d_o, 0)),
        Point("target", (right, 0)),
        Point("error", (answer, 0)),
    )


def draw_height(right, answer, d_o, d_i, h_o):
    """Draw the object, the right image, and the answer."""
    return (
        Line("path", ((-d_o, 0), (-d_o, h_o))),
        Line("ghost", ((-d_o, h_o), (d_i, right))),
        Line("target", ((d_i, 0), (d_i, right))),
        Line("error", ((d_i, 0), (d_i, answer))),
    )


def draw_focus(right, answer, d_o, d_i):
    """Draw object and image, and the right focus beside the answer."""
    return (
        Line("ghost", ((-d_o, 0), (d_i, 0))),
        Point("target", (right, 0)),
        Point("error", (answer, 0)),
    )


PROGRAMS = (
    Program(
        "optics-p1",
        title="Where the image is",
        text="Write the distance of the image from the lens. The object is beyond the focus.",
        starter='''\
def my_image_distance(d_o, f):
    """Return how far behind the lens the image is [m]."""
    ...
''',
        symbols=(d_o, f),
        answer=(Unknown("d_i", "m"),),
        right=image_distance,
        picture=draw_distance,
        extent=0,
        specials={"at twice the focal length": {d_o: 0.2, f: 0.1}},
        wrong={added: lambda d_o, f: added.formula.evaluate(d_o=d_o, f=f)},
        hints=("What is 1/d_i, if 1/f is the sum of 1/d_o and 1/d_i?",),
        solution="""\
def my_image_distance(d_o, f):
    return f * d_o / (d_o - f)
""",
    ),
    Program(
        "optics-p2",
        title="How tall the image is",
        text="Write the height of the image, negative if it is upside down.",
        starter='''\
def my_image_height(d_o, d_i, h_o):
    """Return the height of the image [m]."""
    ...
''',
        symbols=(d_o, d_i, h_o),
        answer=(Unknown("h_i", "m"),),
        right=image_height,
        picture=draw_height,
        extent=0,
        wrong={
            upside_down: lambda d_o, d_i, h_o: upside_down.formula.evaluate(
                d_o=d_o, d_i=d_i, h_o=h_o
            )
        },
        hints=("Which ray goes straight on?",),
        solution="""\
def my_image_height(d_o, d_i, h_o):
    return -h_o * d_i / d_o
""",
    ),
    Program(
        "optics-p3",
        title="Mend the focal length",
        text="This function shall return the focal length from both distances. Mend it.",
        starter='''\
def my_focal_length(d_o, d_i):
    """Return the focal length [m]."""
    return (d_o + d_i) / (d_o * d_i)
''',
        symbols=(d_o, d_i),
        answer=(Unknown("f", "m"),),
        right=focal_length,
        picture=draw_focus,
        extent=0,
        likely_slips={"with the last reciprocal forgotten": lambda d_o, d_i: 1 / d_o + 1 / d_i},
        hints=("Which unit has the result?",),
        solution="""\
def my_focal_length(d_o, d_i):
    return d_o * d_i / (d_o + d_i)
""",
    ),
)
