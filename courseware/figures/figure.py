"""A live figure: its declaration, its compiled form, and how a notebook shows it."""

import re
from dataclasses import dataclass
from functools import cached_property
from html import escape
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike, NDArray

from courseware.course import course
from courseware.equations.equation import Where
from courseware.errors import CourseError
from courseware.figures.compiling import Compiler, Control, serialize, settings, xy
from courseware.figures.declaration import Choice, Goal, Handle, Place, Readout, Recurrence
from courseware.figures.javascript import run_function
from courseware.figures.solids import Solid
from courseware.figures.space import VIEW, view_sliders
from courseware.script import engine
from courseware.script.widget import Widget, widget

SIZES = ("step", "laboratory", "")
MIME = "application/vnd.courseware.figure+json"


@dataclass(frozen=True, eq=False)
class Figure:
    """A picture that answers to its controls, in a chapter's `figures.py`.

    A function of the chapter makes it, and `FIGURES` names it; a cell of its own, tagged
    `remove-input`, shows it. A test tries it at a thousand settings against the tables in the
    chapter's `expected.py`, by its name:

    - `READOUTS`: a function from its settings, an array each in the order of its controls, to what
      the library says that its readouts are, one a column
    - `SPECIALS`: settings that are always tried too, a list that may be empty
    - `WORDS`, a list: (figure, slider → what it shows, readout, the word that stands there)
    - `TITLES`, of a choice "mistake" beside sliders: title → function from all settings to whether
      what it says is true, or None if it says nothing of the picture

    Expressions are taken from equations. A step figure has two things to move and three numbers at
    most, and about 20 lines; what several figures draw is a function of the chapter.

    Args:
        name: its address on the page, letters and dashes.
        title: what it shows, for those who cannot see it.
        view: the window on the world, (x_low, x_high, y_low, y_high) in metres.
        scene: shapes, as painted.
        controls, readouts, handles: what is moved, told and dragged.
        sentence: a sentence about the present state, with `{name}` for controls, readouts and named
            steps; without one, all controls and readouts are told.
        where: named steps of the computation, in order, that all expressions but those of a
            Recurrence may use.
        seen_from: azimuth and elevation at first, of a picture with shapes of `VIEW`: the view's
            sliders are then its last controls, and dragging its ground turns it.
        grid: whether the flat ground shows x, y in m.
        goal: what the reader shall reach, a Goal or several; none is reached at the start.
        follow: a point that the view moves along with, so that it stays inside.
        size: "step" or "laboratory", or "" for a larger one. With all that stands beside the
            picture, a step is at most 420 pixels high on a laptop and 560 on a phone, a laboratory
            800 on a laptop. Too high: make `view` flatter, or move and tell less.
    """

    name: str
    title: str
    view: tuple[float, float, float, float]
    scene: tuple[Any, ...]
    controls: tuple[Control, ...] = ()
    readouts: tuple[Readout, ...] = ()
    sentence: str = ""
    handles: tuple[Handle, ...] = ()
    where: Where = ()
    seen_from: tuple[float, float] = (np.pi / 6, np.pi / 9)
    grid: bool = True
    goal: Goal | tuple[Goal, ...] = ()
    follow: Place = ()
    size: str = "step"

    def __post_init__(self) -> None:
        if self.view_angles:
            own = (c for c in self.controls if getattr(c, "symbol", None) not in self.view_angles)
            controls = (*own, *view_sliders(*self.seen_from))
            object.__setattr__(self, "controls", controls)
        names = [
            *(control.key for control in self.controls),
            *(readout.name for readout in self.readouts),
        ]
        if len(set(names)) < len(names):
            raise CourseError(f"the figure {self.name} has two controls or readouts of one name")
        if self.size not in SIZES:
            raise CourseError(
                f"the size of {self.name} is {self.size!r}; there are {', '.join(map(repr, SIZES))}"
            )
        if any(isinstance(step, Recurrence) for step in self.where):
            raise CourseError(
                f"`where` of {self.name} has a Recurrence: give it to a Trail of the scene, which "
                "draws its states; the figure finds it there"
            )
        names += [str(symbol) for symbol, _ in self.where]
        unknown = set(re.findall(r"{(\w+)}", self.sentence)) - set(names)
        if unknown:
            raise CourseError(
                f"the text `sentence` of {self.name} uses {', '.join(sorted(unknown))}, "
                f"but there are only {', '.join(names)}"
            )

    @property
    def view_angles(self) -> tuple[sp.Symbol, ...]:
        """Of a picture in space, the angles that dragging its ground changes."""
        deep = (isinstance(s, Solid) or getattr(s, "depth", None) is not None for s in self.scene)
        return VIEW.angles if any(deep) else ()

    @property
    def settings(self) -> list[sp.Symbol]:
        """The symbols that the controls set, in the order of the columns of `compute`."""
        return settings(self.controls)

    @cached_property
    def _compiled(self) -> tuple[str, list[Any]]:
        try:
            return self._compile()
        except CourseError as error:
            raise CourseError(f"in the figure {self.name}, {error}") from error

    def _compile(self) -> tuple[str, list[Any]]:
        chapter = course().chapters_of("figures", Figure).get(self.name, "")
        compiler = Compiler(self.controls, self.scene, self.where, chapter)
        parts: dict[str, Any] = {
            "name": self.name,
            "title": self.title,
            "view": list(self.view),
            "sentence": self.sentence or self._default_sentence(),
            "controls": [compiler.control(control) for control in self.controls],
            "readouts": [compiler.readout(readout) for readout in self.readouts],
            "scene": [compiler.shape(shape) for shape in self.scene],
            "handles": [compiler.handle(handle) for handle in self.handles],
            "steps": compiler.known_steps(),
            "recurrences": [compiler.recurrence(loop) for loop in compiler.recurrences],
        }
        if self.view_angles:
            parts["viewAngles"] = compiler.sliders(
                self.view_angles, f"dragging the ground of {self.name}"
            )
        if self.view_angles or not self.grid:
            parts["grid"] = False
        goals = (self.goal,) if isinstance(self.goal, Goal) else self.goal
        parts["goals"] = [compiler.goal(goal) for goal in goals]
        if self.follow:
            parts["follow"] = compiler.numbers(*xy(self.follow))
        parts["size"] = self.size
        parts["where"] = compiler.steps()
        parts["compute"] = compiler.code()
        script = serialize(parts)
        self._refuse_idle_controls(script)
        return script, compiler.expressions

    def _refuse_idle_controls(self, script: str) -> None:
        used = {int(place) for place in re.findall(r"\bc\[(\d+)\]", script)}
        for control in self.controls:
            if used.isdisjoint(map(self.settings.index, control.symbols)):
                raise CourseError(
                    f"the control {control.key} moves nothing: use it in the scene, or take it out"
                )

    @property
    def code(self) -> str:
        """The compiled figure: a JavaScript object, data and functions, no renderer."""
        return self._compiled[0]

    @property
    def expressions(self) -> list[Any]:
        """What the figure computes, in order: the readouts, then all coordinates of the scene."""
        return self._compiled[1]

    def compute(self, points: ArrayLike) -> NDArray[np.float64]:
        """All numbers of the figure at many settings (n, settings), in one call → (n, values)."""
        compute = "((figure) => (f, c) => courseware.compute(figure, c).values)"
        return run_function(f"{compute}({self.code})", points)

    def render_svg(self, width: int | None = None, **chosen: str) -> str:
        """Return the still picture (SVG) of the start, but with some choices made otherwise.

        Args:
            width: in pixels, else as on a page.
            chosen: the option of a choice, by its name.
        """
        places = {
            place: list(control.options).index(chosen[control.name])
            for place, control in enumerate(self.controls)
            if isinstance(control, Choice) and control.name in chosen
        }
        return str(
            engine.run(
                f"((figure) => courseware.renderPicture(figure, Object.assign("
                f"courseware.startState(figure), {places}), {width or 'undefined'}))"
                f"({self.code})"
            )
        )

    def render_contents(self) -> str:
        """What stands on a page before, and is moved after, the script takes over."""
        return str(engine.run(f"courseware.renderFigure({self.code})"))

    def render_html(self) -> str:
        """The HTML of the figure, which the script brings to life."""
        start = f'<figure class="rk-figure" id="{self.name}" data-size="{self.size}"'
        return f'{start} aria-label="{escape(self.title)}">{self.render_contents()}</figure>\n'

    @cached_property
    def widget(self) -> Widget:
        """What a notebook shows; its state are the settings in SI units, by name."""
        return widget("figures", self.code, {c.key: c.start for c in self.controls})

    def _default_sentence(self) -> str:
        """All controls and readouts, for those who cannot see them."""
        named = [(c.label or c.key, c.key) for c in self.controls]
        named += [(readout.label, readout.name) for readout in self.readouts]
        return ", ".join(f"{label}: {{{name}}}" for label, name in named)

    def _repr_mimebundle_(self, **_: Any) -> tuple[dict[str, Any], dict[str, Any]]:
        """The widget; its name, by which a page finds it; for all others a still picture."""
        others = {"text/plain": self.title, MIME: {"name": self.name}}
        if engine.available():
            others["image/svg+xml"] = compact_svg(self.render_svg())
        return self.widget.output(others)


def inline_colors(svg: str) -> str:
    """A picture for where there is no page and no style, with colours of its own."""
    svg = re.sub(r"var\(--[\w-]+,([^)]+)\)", r"\1", svg)
    return re.sub(r"color-mix\(in srgb,#(\w+) (\d+)%,#(\w)\w+\)", _mix, svg)


def compact_svg(svg: str) -> str:
    """The same with lines in whole pixels, so that notebooks stay small."""
    whole = re.compile(r"-?\d+\.\d+")
    return re.sub(
        r'(?<= d=")[^"]+',
        lambda line: whole.sub(lambda n: f"{float(n[0]):.0f}", line[0]),
        inline_colors(svg),
    )


def _mix(found: re.Match[str]) -> str:
    """A shade of a face as one colour."""
    part, other = int(found[2]) / 100, 17 * int(found[3], 16)
    channels = (int(found[1][k : k + 2], 16) for k in (0, 2, 4))
    return "#" + "".join(f"{round(part * c + (1 - part) * other):02x}" for c in channels)


def figures() -> dict[str, Figure]:
    """Every figure of the course, by name, in the course's order."""
    return course().find_all("figures", Figure)


def find_figure(name: str) -> Figure:
    """The figure of that name: a page shows what a chapter declares, a cell holds only its name."""
    return course().find("figures", Figure, name)
