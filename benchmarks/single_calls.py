"""One call of every public function on one item, as a figure or a control loop makes it.

The arguments are those of the table in tests/arguments.py, its lists of numbers as arrays.
"""

import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

sys.path.append(str(Path(__file__).parents[1] / "tests"))

import numpy as np
from arguments import DATA, PARAMETERS, TABLE, bind, public_functions

LEFT_OUT = set(public_functions()) - {label.split()[0] for label in TABLE}
if LEFT_OUT:
    sys.exit(f"tests/arguments.py has no arguments for {', '.join(sorted(LEFT_OUT))}")


def call(label: str) -> Callable[[], Any]:
    row = TABLE[label]
    lists = [key for key in row.having(*DATA, *PARAMETERS) if isinstance(row.good[key], list)]
    function, positional, named = bind(label, **{key: np.array(row.good[key]) for key in lists})
    return partial(function, *positional, **named)


CALLS = {label: call(label) for label in TABLE}
