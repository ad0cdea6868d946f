"""Widgets for notebooks: in JupyterLab, Notebook and VS Code."""

from typing import Any

import anywidget
import traitlets

from courseware.script import parts

# Or an arrow in a figure moves to the next cell, and x cuts one
KEEP_KEYS = 'view.el.addEventListener("keydown", (event) => event.stopPropagation());'


class Widget(anywidget.AnyWidget):
    """A part's content in a notebook, and its state as JSON."""

    _esm = traitlets.Unicode().tag(sync=True)
    _css = traitlets.Unicode().tag(sync=True)
    state = traitlets.Dict().tag(sync=True)

    def render_output(self, others: dict[str, Any]) -> tuple[dict[str, Any], dict[str, Any]]:
        """Return an output by MIME type, with others in it, and its metadata."""
        data, metadata = self._repr_mimebundle_() or ({}, {})
        return {**data, **others}, metadata


def create_widget(part: str, content: str, state: dict[str, Any]) -> Widget:
    """Return the widget of a part. content: what it shows, a JavaScript expression."""
    show = f"{parts.bundle_widget(part)}({content}, view)"
    return Widget(
        _esm=f"export default {{ render: (view) => {{ {KEEP_KEYS} return {show}; }} }};",
        _css=parts.join_styles(part),
        _anywidget_id=f"courseware-{part}",  # one style sheet for all widgets of the part
        state=state,
    )
