"""A live figure: its declaration, its compiled form, and how a notebook shows it."""

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from html import escape
from typing import Any, Literal

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike, NDArray

from courseware.course import course
from courseware.equations.equation import Where
from courseware.equations.javascript import run_javascript
from courseware.errors import CourseError
from courseware.figures.compiler import Compiler, serialize
from courseware.figures.computed_parts import Goal, Place, Readout
from courseware.figures.controls import Button, Choice, Control, Handle
from courseware.figures.solids import Solid
from courseware.figures.space import VIEW, view_sliders
from courseware.script import engine
from courseware.script.widget import Widget, create_widget

MIME = "application/vnd.courseware.figure+json"


@dataclass(frozen=True, eq=False)
class Figure:
    """A picture that answers to its controls, in a chapter's `figures.py`.

    A function of the chapter makes it, and `FIGURES` names it; a cell of its own, tagged
    `remove-input`, shows it.

    Expressions are taken from equations. A step figure has two things to move and three numbers at
    most, and about 20 lines; shapes that several figures draw are a function of the chapter.

    Args:
        name: its address on the page, letters and dashes.
        title: what it shows, for those who cannot see it.
        view: the window on the world, (x_low, x_high, y_low, y_high) in metres.
        shapes: in the order of painting.
        controls, readouts, handles, buttons: what is moved, read, dragged and pressed.
        sentence: about the present state, with `{name}` for controls, readouts and named steps; by
            default a list of all controls and readouts.
        where: named steps of the computation, in order, that all expressions but those of a
            Recurrence may use.
        seen_from: azimuth and elevation at first, of a picture with shapes of `VIEW`: the view's
            sliders are then its last controls, and dragging its ground turns it.
        grid: whether the flat ground shows x, y in m.
        ground: one of the course's grounds instead of the grid; tiles have a scale bar.
        goal: a Goal for the reader or several; none is reached at the start.
        follow: a point that the view moves along with, so that it stays inside.
        contain: places that the view fits round; then `view` is its form.
        size: "step" or "laboratory", or "" for a larger one. With all that is beside the
            picture, a step is at most 480 pixels high on a laptop and 560 on a phone, a laboratory
            800 on a laptop. Too high: make `view` flatter, or move and show less.
    """

    name: str
    title: str
    view: tuple[float, float, float, float]
    shapes: tuple[Any, ...]
    controls: tuple[Control, ...] = ()
    readouts: tuple[Readout, ...] = ()
    sentence: str = ""
    handles: tuple[Handle, ...] = ()
    buttons: tuple[Button, ...] = ()
    where: Where = ()
    seen_from: tuple[float, float] = (np.pi / 6, np.pi / 9)
    grid: bool = True
    ground: str = ""
    goal: Goal | tuple[Goal, ...] = ()
    follow: Place = ()
    contain: tuple[Place, ...] = ()
    size: Literal["step", "laboratory", ""] = "step"

    def __post_init__(self) -> None:
        if self.view_angles:
            own = (c for c in self.controls if getattr(c, "symbol", None) not in self.view_angles)
            controls = (*own, *view_sliders(*self.seen_from))
            object.__setattr__(self, "controls", controls)
        self._refuse_wrong_names()
        if not self.sentence:
            numbers = [(c.label or c.key, c.key) for c in self.controls]
            numbers += [(readout.label, readout.name) for readout in self.readouts]
            listed = ", ".join(f"{label}: {{{name}}}" for label, name in numbers)
            object.__setattr__(self, "sentence", listed)

    def _refuse_wrong_names(self) -> None:
        names = [*(c.key for c in self.controls), *(readout.name for readout in self.readouts)]
        if len(set(names)) < len(names):
            raise CourseError(f"the figure {self.name} has two controls or readouts of one name")
        names += [str(symbol) for symbol, _ in self.where]
        if unknown := set(re.findall(r"{(\w+)}", self.sentence)) - set(names):
            raise CourseError(
                f"the text `sentence` of {self.name} uses {', '.join(sorted(unknown))}, "
                f"but there are only {', '.join(names)}"
            )

    @property
    def goals(self) -> tuple[Goal, ...]:
        """Its goals, none, one or several."""
        return (self.goal,) if isinstance(self.goal, Goal) else self.goal

    @property
    def view_angles(self) -> tuple[sp.Symbol, ...]:
        """The angles that dragging the ground changes, of a picture in space."""
        deep = (isinstance(s, Solid) or getattr(s, "depth", None) is not None for s in self.shapes)
        return VIEW.angles if any(deep) else ()

    @property
    def control_symbols(self) -> list[sp.Symbol]:
        """The symbols that the controls set, in the order of the columns of `compute`."""
        return [symbol for control in self.controls for symbol in control.symbols]

    @cached_property
    def compiled(self) -> dict[str, Any]:
        """The compiled figure: data, and functions as `Code`."""
        chapter = course().find_chapter("figures", self)
        try:
            return Compiler(self, chapter).compile_figure()
        except CourseError as error:
            place = course().find_place(chapter, "figures", self.name)
            raise CourseError(f"{place}: in the figure {self.name}, {error}") from error

    @cached_property
    def code(self) -> str:
        """The compiled figure: a JavaScript object, data and functions, no renderer."""
        return serialize(self.compiled)

    @property
    def page_data(self) -> dict[str, Any]:
        """The compiled figure without its outlines, which are on a page once."""
        return self.compiled | {"drawings": None}

    def compute(self, points: ArrayLike) -> NDArray[np.float64]:
        """Compute all numbers at many settings (n, settings), in one call → (n, values)."""
        compute = "((figure) => (f, c) => courseware.compute(figure, c).values)"
        return run_javascript(f"{compute}({self.code})", points)

    def render_svg(self, width: int | None = None, **chosen: str) -> str:
        """Return the still picture (SVG) of the start, with the chosen option of some choices.

        Its width is in pixels; without one, as on a page.
        """
        places = {
            place: list(control.options).index(chosen[control.key])
            for place, control in enumerate(self.controls)
            if isinstance(control, Choice) and control.key in chosen
        }
        return str(
            engine.run(
                f"((figure) => courseware.renderPicture(figure, Object.assign("
                f"courseware.startState(figure), {places}), {width or 'undefined'}))"
                f"({self.code})"
            )
        )

    def render_contents(self) -> str:
        """Return the picture and its panel as HTML, as before the script takes them over."""
        return str(engine.run(f"courseware.renderFigure({serialize(self.page_data)})"))

    def render_html(self) -> str:
        """Return the element of a page, which the script moves."""
        size = self.size if self.controls else "still"
        start = f'<figure class="rk-figure" id="{self.name}" data-size="{size}"'
        return f'{start} aria-label="{escape(self.title)}">{self.render_contents()}</figure>\n'

    @cached_property
    def widget(self) -> Widget:
        """The widget in a notebook; its state is what its controls show."""
        return create_widget("figures", self.code, {})

    def _repr_mimebundle_(self, **_: Any) -> tuple[dict[str, Any], dict[str, Any]]:
        """Return the widget, the name by which a page finds the figure, and a still picture."""
        still = compact_svg(self.render_svg())
        others = {"text/plain": self.title, MIME: {"name": self.name}, "image/svg+xml": still}
        return self.widget.render_output(others)


@dataclass(frozen=True)
class Scene:
    """The scene of a chapter, of which each figure shows some layers::

        ROBOT = Scene(
            layers={"ghost": (robot(START, look="ghost"),), "robot": (robot(now),)},
            handles={"robot": (Handle("the robot", now),)},
            common={"view": (-1, 1, -1, 1), "ground": "tiles", "where": VELOCITY},
        )
        ROBOT.figure("park", "A robot", "ghost robot", controls=(…))

    Args:
        layers: their shapes by name, in the order of painting.
        handles: what is dragged, by name.
        common: parts of all its figures; a figure may give others.
    """

    layers: Mapping[str, tuple[Any, ...]]
    handles: Mapping[str, tuple[Handle, ...]]
    common: Mapping[str, Any]

    def figure(self, name: str, title: str, layers: str, drag: str = "", **parts: Any) -> Figure:
        """Return the figure of some layers and handles, named in one text; `shapes` lies on top."""
        in_order = sorted(layers.split(), key=list(self.layers).index)
        shown = [part for layer in in_order for part in self.layers[layer]]
        handles = tuple(handle for each in drag.split() for handle in self.handles[each])
        scene = (*shown, *parts.pop("shapes", ()))
        return Figure(name, title, **{"handles": handles, **self.common, **parts, "shapes": scene})


def render_outlines(figures: Iterable[Figure]) -> str:
    """Return what a page with these figures needs once: the outlines of all their sprites."""
    drawings: dict[str, Any] = {}
    for figure in figures:
        drawings |= figure.compiled["drawings"]
    return str(engine.call("courseware.renderOutlines", drawings))


def inline_colors(svg: str) -> str:
    """Replace a page's colours in a picture by their values, for where there is no style."""
    svg = re.sub(r"var\(--[\w-]+,([^)]+)\)", r"\1", svg)
    return re.sub(r"color-mix\(in srgb,#(\w+) (\d+)%,#(\w)\w+\)", _mix, svg)


def compact_svg(svg: str) -> str:
    """Inline a picture's colours, and round its lines to pixels, so that notebooks stay small."""
    in_metres, end, in_pixels = inline_colors(svg).rpartition("</defs>")
    rounded = re.sub(
        r'(?:(?<= d=")|(?<= points="))[^"]+',
        lambda line: re.sub(r"-?\d+\.\d+", lambda n: f"{float(n[0]):.0f}", line[0]),
        in_pixels,
    )
    return in_metres + end + rounded


def _mix(found: re.Match[str]) -> str:
    """Return a face's shade as one colour."""
    part, other = int(found[2]) / 100, 17 * int(found[3], 16)
    channels = (int(found[1][k : k + 2], 16) for k in (0, 2, 4))
    return "#" + "".join(f"{round(part * c + (1 - part) * other):02x}" for c in channels)


def find_figure(name: str) -> Figure:
    """Return the figure that a chapter declares under a name; a cell holds only the name."""
    return course().find("figures", Figure, name)
