"""Formulas, each declared once: printed in chapters, compared with code, drawn from."""

from courseware.equations.declared_checks import Array, Check
from courseware.equations.equation import Equation, Where, as_written, find_equation, substitute
from courseware.equations.notebook import show
from courseware.equations.quantities import declarations, find_kind
