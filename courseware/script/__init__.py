"""What runs in the browser: one script and one style sheet, put together from parts.

A part (`runtime.Part`) brings its files, and registers; this package knows none of them. The same
script runs on a page (`runtime.script`), in a notebook's widgets (`widget.Widget`), and without
either (`engine.run`): it draws the still pictures and judges the answers that Python is given.
"""
