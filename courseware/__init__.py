"""A framework for courses: formulas, live figures and exercises, declared in Python.

`equations` declares and prints formulas; `figures` declares, compiles and draws figures; `answers`
reads and judges what is typed; `practice` gives every student numbers and names mistakes;
`programs` are functions that students write, and `judge` judges them; `predictions` asks a reader
before the text explains; `symbols` marks a symbol in formulas, text and figures; `run` runs cells
in the page; `units` prints numbers; `script` bundles the JavaScript; `course` finds declarations;
`site` puts all of these onto pages; `classroom` is for teachers.
"""

__version__ = "0.1.0"
