"""One call of every public function on one item, as a figure or a control loop makes it.

The arguments are those of the table in tests/arguments.py.
"""

import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

sys.path.append(str(Path(__file__).parents[1] / "tests"))

from arguments import TABLE, bind, public_functions

LEFT_OUT = set(public_functions()) - {label.split()[0] for label in TABLE}
if LEFT_OUT:
    sys.exit(f"tests/arguments.py has no arguments for {', '.join(sorted(LEFT_OUT))}")


def call(label: str) -> Callable[[], Any]:
    function, positional, named = bind(label)
    return partial(function, *positional, **named)


CALLS = {label: call(label) for label in TABLE}
