"""What a course is made with: formulas, live figures and exercises, declared in Python.

`equations` (how a formula is declared, printed and checked), `figures` (how a figure is declared,
compiled and drawn), `practice` (how an exercise is dealt and judged), `predictions` (what a
reader is asked before it is told), `symbols` (one symbol in formula, sentence and picture), `run`
(cells that run in the page), `script` (what runs in the browser), `site` (how all of these get onto
a page), `course` (where they are found).
"""

__version__ = "0.1.0"
