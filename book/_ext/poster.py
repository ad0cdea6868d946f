"""The chapters on a poster, `poster.svg`, which needs no other file: a picture, a sentence each."""

from dataclasses import replace
from html import escape
from pathlib import Path
from textwrap import wrap

from courseware.course import course
from courseware.figures.figure import find_figure, inline_colors
from courseware.site.home_page import ASPECT, widen

WIDE, TALL = 1000, 1414  # of the sheet, as all A formats
PICTURE = 425  # so wide that its letters are 8 points high on A4
TOP, ROW, LINE, LETTERS = 104, 322, 18, 62
RECAPS = {  # the picture of each recap, with its letters put back, and the picture in words
    "arm-recap": ({}, "The elbow is where two circles cross: one about the shoulder, one about the "
    "ball. Three sides give three angles."),
    "rotation-recap": ({"first_column": "arrow 3", "second_column": "arrow 1"},
    "The columns of a rotation matrix are the turned axes. Every rotation is one turn about one "
    "axis."),
    "letters-frames": ({"name_1": "T_db", "name_2": "T_bc", "name_3": "T_ce"},
    "A transform moves no point, it names it anew. In a chain neighbouring letters are the same."),
    "letters": ({"name_1": "R", "name_2": "ωb", "name_3": "c"}, "The tips of the arrows lie on a "
    "line: its height in the middle is v, its slope ω. Where it meets the axle’s line is the ICR."),
    "car-summary": ({}, "The axles of a car that does not slide meet in one point, the ICR. The "
    "bend of its way is tan φ / L."),
    "wheel-summary": ({}, "A turn about Q slides a wheel by ω times Q’s distance from its axle "
    "line, and rolls it by ω times that from its push line."),
    "odometry-letters": ({"name_1": "ℓ", "name_2": "εℓ/b", "name_3": "ε/b"}, "A slip ε is a door: "
    "the rest of the way swings about the other wheel by ε/b, and its end moves by εℓ/b."),
    "weight-letters": ({"name_1": "ICR", "name_2": "½ det J"}, "A joint’s rate is a weight on the "
    "joint. The hand turns about their balance point; det J is twice the triangle."),
}  # fmt: skip
SHEET = f"""<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDE} {TALL}" \
font-family="sans-serif" font-size="14" fill="#1f2933"><title>{{title}}</title>
<rect width="{WIDE}" height="{TALL}" fill="#fff"/>
<text x="50" y="66" font-size="40" font-weight="700">{{title}}</text>
<text x="50" y="90">{{address}}</text>
{{chapters}}
<text x="{WIDE - 50}" y="{TALL - 16}" font-size="10" text-anchor="end">CC BY 4.0</text>
</svg>
"""


def render_chapter(place, name, chosen, sentence):
    """Return a chapter's picture, title and sentence in their place on the sheet."""
    figure = find_figure(name)
    picture = replace(figure, view=widen(figure.view)).render_svg(PICTURE, **chosen)
    picture = inline_colors(picture).replace("system-ui,", "")
    chapter = course().find_chapter("figures", figure)
    title = f"{course().taught.index(chapter)} {escape(course().title(chapter))}"
    left, top = 50 + place % 2 * (PICTURE + 50), TOP + place // 2 * ROW
    below = PICTURE / ASPECT + 22
    lines = enumerate(wrap(escape(sentence), LETTERS), 1)
    words = "".join(f'<text y="{below + LINE * k:g}">{line}</text>' for k, line in lines)
    head = f'<text y="{below:g}" font-size="18" font-weight="700">{title}</text>'
    return f'<g transform="translate({left} {top})">{picture}{head}{words}</g>'


def write_poster(app, error):
    """Write the poster into the site."""
    if not error and app.builder.name == "html":
        recaps = enumerate(RECAPS.items())
        chapters = "\n".join(render_chapter(k, name, *recap) for k, (name, recap) in recaps)
        title = f"{escape(app.config.html_title)}: robot kinematics in pictures"
        sheet = SHEET.format(title=title, address=app.config.html_baseurl, chapters=chapters)
        (Path(app.outdir) / "poster.svg").write_text(sheet, "utf-8")


def setup(app):
    """Register with Sphinx."""
    app.connect("build-finished", write_poster)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
