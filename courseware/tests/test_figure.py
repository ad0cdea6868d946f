"""What a figure leaves in a notebook, and how it is found."""

import json
from functools import cache
from xml.etree import ElementTree

import nbformat
import pytest
from declared import FIGURES, each
from small_figures import painted, small_figure, space_figure
from support import ROOT

from courseware.errors import CourseError
from courseware.figures import Figure
from courseware.figures.figure import MIME, find_figure

SIZE = 30_000  # bytes for one figure, nearly all the still picture
# three rings in space, with a face for each 15 degrees
SIZES = {"rings-alone": 38_000, "gimbal-rings": 44_000, "robots": 46_000}
# a solid arm on its turntable, or two, with the covers of its joints
SIZES |= dict.fromkeys(("grip", "arm-exercise", "turn-round", "on-the-axis"), 66_000)
# a room and its arm twice, or with tracing paper on it
SIZES |= dict.fromkeys(("two-views", "chain-exercise", "room-plan", "letters-frames"), 38_000)
SIZES["camera-above"] = 46_000
SIZES |= dict.fromkeys(("arm-laboratory", "dh-frames", "wrong-reach"), 66_000)


@cache
def kept_figures():
    """The stored outputs that hold a figure, by the figure's name."""
    found = {}
    for path in sorted((ROOT / "book").glob("*/*.ipynb")):
        notebook = nbformat.read(path, as_version=4)
        assert "widgets" not in notebook.metadata
        for cell in notebook.cells:
            for output in cell.get("outputs", []):
                if MIME in output.get("data", {}):
                    found[output.data[MIME]["name"]] = output.data
    return found


@each("figure", "figures", Figure, only=lambda figure: figure.name != "hero")
def test_a_notebook_keeps_the_name_and_the_still_picture(figure):
    """What is compiled is made when the page is: the figure that the chapter declares."""
    data = kept_figures()[figure.name]
    new, _ = figure._repr_mimebundle_()
    assert data == {key: new[key] for key in (MIME, "text/plain", "image/svg+xml")}, (
        "the stored figure is old: run `make notebooks`"
    )
    assert data[MIME] == {"name": figure.name}
    assert len(json.dumps(data)) < SIZES.get(figure.name, SIZE)
    assert "var(" not in data["image/svg+xml"]  # it is used without the page's style
    ElementTree.fromstring(data["image/svg+xml"])  # and as a file


def test_a_figure_that_no_chapter_declares_is_refused():
    assert find_figure("wheel-speeds") is FIGURES["wheel-speeds"]
    with pytest.raises(CourseError, match=r"no figure 'small'; there are .* chapters' figures\.py"):
        find_figure("small")


def test_a_widget_carries_its_figure_and_its_part():
    figure = next(iter(FIGURES.values()))
    module = figure.widget.get_state()["_esm"]
    assert module.startswith("export default")
    assert figure.code in module


def test_no_grid_where_none_is_wanted():
    assert "grid" in painted(small_figure())
    assert "grid" not in painted(small_figure(grid=False))
    assert "grid" not in painted(space_figure())
    assert "x, y in m" not in space_figure().render_svg()
