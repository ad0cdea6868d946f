"""For teachers: give a class its numbers, collect and grade its answers, export to Moodle.

The commands: `python -m courseware.classroom --help`.

`answer_key` (everyone's numbers and right answers), `sheets` (a page to print for each student),
`collecting` (answers in files and folders), `grading`, `moodle` (the exercises as questions),
`assignments` (programs for a grader of code), `tables` (CSV). Students do not need it.
"""
