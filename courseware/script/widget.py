"""What a notebook shows, in JupyterLab, Notebook and VS Code: a part's content, and its state."""

from typing import Any

import anywidget
import traitlets

from courseware.script import parts


class Widget(anywidget.AnyWidget):
    """A figure or an exercise. state: what changes, as JSON."""

    _esm = traitlets.Unicode().tag(sync=True)
    _css = traitlets.Unicode().tag(sync=True)
    state = traitlets.Dict().tag(sync=True)

    def output(self, others: dict[str, Any]) -> tuple[dict[str, Any], dict[str, Any]]:
        """What an output holds of it and of others, by MIME type; and what Colab must know."""
        data, metadata = self._repr_mimebundle_() or ({}, {})
        return {**data, **others}, metadata


def widget(part: str, content: str, state: dict[str, Any]) -> Widget:
    """Return the widget of a part. content: what it shows, a JavaScript expression."""
    render = f"render: (view) => {parts.widget_script(part)}({content}, view)"
    return Widget(
        _esm=f"export default {{ {render} }};",
        _css=parts.style_sheet(part),
        _anywidget_id=f"courseware-{part}",  # one style sheet for all widgets of the part
        state=state,
    )
