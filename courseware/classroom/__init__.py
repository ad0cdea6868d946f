"""For teachers: give a class its numbers, collect and grade its answers, export to Moodle.

The commands: `python -m courseware.classroom --help`.

`answer_key` (everyone's numbers and right answers), `sheets` (a page to print for each student),
`collecting` (answers in files and folders), `grading`, `class_page` (a look at the class), `moodle`
(the exercises as questions), `tables` (CSV, as spreadsheets write it). Students do not need it.
"""
