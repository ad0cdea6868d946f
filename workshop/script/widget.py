"""A live figure in JupyterLab, Notebook and VS Code."""

from typing import Any

import anywidget
import traitlets

from workshop.script.runtime import runtime, stylesheet


class FigureWidget(anywidget.AnyWidget):
    """The runtime with one compiled figure as a front-end module; `values` are its settings."""

    _esm = traitlets.Unicode().tag(sync=True)
    _css = traitlets.Unicode().tag(sync=True)
    values = traitlets.Dict().tag(sync=True)


def widget(code: str, values: dict[str, Any]) -> FigureWidget:
    """The widget of a compiled figure, set to `values`."""
    module = (
        f"{runtime()}\nconst figure = {code};\n"
        "export default { render: (view) => robokin.inNotebook(figure, view) };\n"
    )
    return FigureWidget(_esm=module, _css=stylesheet(), values=values)
