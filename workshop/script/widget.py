"""What a notebook shows, in JupyterLab, Notebook and VS Code: a part's content, and its state."""

from importlib.resources import files
from typing import Any

import anywidget
import ipywidgets
import traitlets

from workshop.script import runtime


class Runtime(ipywidgets.Widget):  # type: ignore[misc]
    """The script and the style of a part, sent once for all its widgets."""

    name = traitlets.Unicode().tag(sync=True)
    script = traitlets.Unicode().tag(sync=True)
    rules = traitlets.Unicode().tag(sync=True)


class Widget(anywidget.AnyWidget):
    """A figure or an exercise. content: a JavaScript expression; state: what changes, as JSON."""

    _esm = files("workshop.script").joinpath("widget.js").read_text(encoding="utf-8")
    runtime = traitlets.Unicode().tag(sync=True)  # the id of its model
    content = traitlets.Unicode().tag(sync=True)
    state = traitlets.Dict().tag(sync=True)

    def output(self, others: dict[str, Any]) -> tuple[dict[str, Any], dict[str, Any]]:
        """What an output holds of it and of others, by MIME type; and what Colab must know."""
        data, metadata = self._repr_mimebundle_() or ({}, {})
        return {**data, **others}, metadata


_sent: dict[str, Runtime] = {}  # by the name of the part


def widget(part: str, content: str, state: dict[str, Any]) -> Widget:
    """The widget of a part's content."""
    if part not in _sent or _sent[part].comm is None:  # none yet, or closed
        _sent[part] = Runtime(name=part, script=runtime.code(part), rules=runtime.rules(part))
    return Widget(runtime=_sent[part].model_id, content=content, state=state)
