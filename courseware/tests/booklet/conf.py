"""Sphinx builds the example with the framework's extension, and without those of `book/_ext`."""

import booklet  # noqa: F401  (opens the course)

project = "Example"
extensions = ["myst_nb", "sphinx_external_toc", "courseware.site"]
nb_execution_mode = "off"  # notebooks are run before, as those of any course
nb_ipywidgets_js = {}
