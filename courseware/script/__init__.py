"""The code for the browser: one script and one style sheet, put together from parts.

A part (`parts.Part`) brings ES modules, and registers; this package knows none of them. What they
import is joined to one script (`modules.join_modules`), in which every name is declared once. It
runs on a page (`parts.bundle_pages`), in a notebook's widgets (`widget.Widget`), and without either
(`engine.run`): there it draws the still pictures and judges the answers that Python is given.
"""
