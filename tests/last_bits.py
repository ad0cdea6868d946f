"""Move the last bits of what NumPy and robokin compute, as another processor may.

IEEE 754 fixes `+ - * /` and the square root of floats. It does not fix sines and powers, nor the
order of a sum: there a result may differ in its last bits with the processor, the version of NumPy
and the system. `move(1)` moves each such result, and what goes into a sum, by one or two units in
the last place; `move(-1)` moves them all the other way, so that a value at a border crosses it in
one of the two. Zeros of sums get either sign.

A number of at most 26 significant bits (0, 1, 0.5) is exact, and stays.
"""

import ast
import builtins
import functools
import importlib
import math
import operator
import pkgutil
from collections.abc import Callable
from typing import Any

import numpy as np
from IPython import get_ipython

import robokin

ELEMENTARY = (
    "sin cos tan arcsin arccos arctan arctan2 hypot sinh cosh tanh exp expm1 log log10 log1p log2 "
    "sinc angle asin acos atan atan2 dist"
)
SUMS = (
    "dot vdot inner vecdot matmul matvec vecmat einsum tensordot sum mean average std var cumsum "
    "trapezoid interp polyfit polyval"
)


def move(direction: int) -> None:
    """Wrap the functions, and in the cells of this kernel the operator `@`."""
    bits = LastBits(direction)
    for module in (np, math):
        bits.wrap(module, ELEMENTARY.split(), sums=False)
    bits.wrap(np, SUMS.split(), sums=True)
    bits.wrap(np.linalg, np.linalg.__all__, sums=True)
    for module in pkgutil.iter_modules(robokin.__path__):
        if not module.name.startswith("_"):
            module = importlib.import_module(f"robokin.{module.name}")
            own = [name for name, each in vars(module).items() if is_own(module, each)]
            bits.wrap(module, own, sums=False)
    builtins._matmul = bits.moving(operator.matmul, sums=True)  # type: ignore[attr-defined]
    if shell := get_ipython():
        shell.ast_transformers.append(MatrixProducts())


def is_own(module: Any, value: Any) -> bool:
    return callable(value) and not isinstance(value, type) and value.__module__ == module.__name__


class MatrixProducts(ast.NodeTransformer):
    """Call `_matmul` in place of `@`."""

    def visit_BinOp(self, node: ast.BinOp) -> ast.AST:
        self.generic_visit(node)
        if not isinstance(node.op, ast.MatMult):
            return node
        name = ast.Name("_matmul", ast.Load())
        return ast.fix_missing_locations(
            ast.copy_location(ast.Call(name, [node.left, node.right], []), node)
        )


class LastBits:
    def __init__(self, direction: int) -> None:
        self.direction = direction
        self.random = np.random.default_rng(1)

    def wrap(self, module: Any, names: list[str], sums: bool) -> None:
        for name in names:
            if callable(getattr(module, name, None)):
                setattr(module, name, self.moving(getattr(module, name), sums))

    def moving(self, function: Callable[..., Any], sums: bool) -> Callable[..., Any]:
        @functools.wraps(function)
        def moved(*args: Any, **options: Any) -> Any:
            if sums:
                args = tuple(self.moved(arg) for arg in args)
            result = self.moved(function(*args, **options), zeros=sums)
            if options.get("out") is not None:
                options["out"][...] = result
            return result

        return moved

    def moved(self, value: Any, zeros: bool = False) -> Any:
        """A value with its floats moved. zeros: give zeros either sign."""
        if isinstance(value, tuple):
            parts = [self.moved(part, zeros) for part in value]
            return type(value)(*parts) if hasattr(value, "_fields") else tuple(parts)
        if isinstance(value, np.ndarray) and value.dtype == complex:
            return self.moved(value.real, zeros) + 1j * self.moved(value.imag, zeros)
        if not isinstance(value, float | np.ndarray) or np.asarray(value).dtype != float:
            return value
        numbers = np.asarray(value)
        steps = self.direction * self.random.choice([-2, -1, 1, 2], numbers.shape)
        mantissa, _ = np.frexp(numbers)
        scaled = np.ldexp(mantissa, 26)
        exact = ~np.isfinite(numbers) | (scaled == np.trunc(scaled))
        result = np.where(exact, numbers, numbers * (1 + steps * 2.0**-52))
        if zeros:
            result = np.where(numbers == 0, np.copysign(0.0, steps), result)
        return result if isinstance(value, np.ndarray) else type(value)(result)
