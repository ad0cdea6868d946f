"""Slides of each chapter, `slides/<chapter>.html`: its page without menus, cut by `slides.js`."""

import re
from pathlib import Path

from courseware.course import course

OTHERS = re.compile(r'<script[^>]* src="(?!\.\./_static/(documentation|pages/|courseware/))[^>]*>')
SCRIPTS = """</title>
<script defer src="../_static/reveal/reveal.js"></script>
<script defer src="../_static/slides.js"></script>"""  # first: they move what the others start
STYLES = """<link rel="stylesheet" href="../_static/reveal/reveal.css" />
<link rel="stylesheet" href="../_static/slides.css" />
</head>"""


def render_slides(page):
    """Return the slides of a page of the site."""
    head, _, body = page.partition("</head>")
    head = OTHERS.sub("<script>", head).replace("</title>", SCRIPTS, 1)
    article = body[body.index("<article") : body.index("</article>")]
    return f"{head}{STYLES}\n<body>\n{article}</article>\n</body>\n</html>\n"


def write_slides(app, error):
    """Write the slides of all chapters into the site."""
    if error or app.builder.name != "html":
        return
    folder = Path(app.outdir) / "slides"
    folder.mkdir(exist_ok=True)
    for name in course().taught:
        page = (folder.parent / name / f"{name}.html").read_text("utf-8")
        (folder / f"{name}.html").write_text(render_slides(page), "utf-8")


def setup(app):
    """Register with Sphinx."""
    app.connect("build-finished", write_slides)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
