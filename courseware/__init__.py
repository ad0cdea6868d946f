"""A framework for courses: formulas, live figures and exercises, declared in Python.

`equations` declares and prints formulas; `figures` declares, compiles and draws figures;
`practice` deals and judges exercises, `programs` functions that students write; `predictions` asks
a reader before the text explains; `symbols` marks a symbol in formulas, text and figures; `run`
runs cells in the page; `script` bundles the JavaScript; `site` puts all of these onto pages;
`course` finds them.
"""

__version__ = "0.1.0"
