"""Typed answers: what is asked for, and the scripts that read, judge and keep what is typed.

`tokenizing.js`, `nesting.js`, `calculating.js` and `parsing.js` read numbers, lists and units in
both conventions for decimals; `judging.js` compares them with the candidates of an exercise;
`storage.js` keeps them in the browser.
"""

from courseware.answers.unknowns import Unknown, angle, integer, matrix
from courseware.course import course
from courseware.script.parts import provide

provide(
    "courseware/answers/constants.js",  # two courses may be on one host
    lambda: {"STORE": " ".join(dict.fromkeys((course().name, course().salt)))},
)
