"""Programs that students write, judged by the simplest input on which they are wrong.

`declaration` declares one in a chapter's `programs.py`; `storing` draws its inputs and computes
what is right and what known mistakes give; `notebook` shows it. `judge` runs a student's function
on these numbers: it needs NumPy alone, in a notebook, on the page and beside a grader.
"""
