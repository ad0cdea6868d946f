"""Formulas become HTML and MathML when the book is built; pages need no script for them.

KaTeX runs in V8, from the wheel `mini-racer`. TeX that KaTeX cannot read is a warning with document
and line, and warnings are errors in this book.
"""

import atexit
import functools
import html
import re
from itertools import chain
from pathlib import Path

from docutils import nodes
from py_mini_racer import MiniRacer
from sphinx.util import logging
from sphinx.util.math import get_node_equation_number

logger = logging.getLogger(__name__)

VENDOR = Path(__file__).parents[1] / "_vendor" / "katex"

RENDER = """
function render(tex, displayMode, output) {
  const ours = ({command}) => command === "\\\\htmlData"; // keys of symbols, which the site writes
  const strict = (code) => code === "htmlExtension" ? "ignore" : "error";
  const options = {displayMode, output, strict, trust: ours};
  try { return {html: katex.renderToString(tex, options)}; }
  catch (error) { return {error: error.rawMessage || error.message || String(error)}; }
}
"""

# KaTeX would number these environments, as Sphinx does already: the starred form is rendered
NUMBERED = re.compile(r"\\(begin|end)\{(equation|align|alignat|gather)\}")
PUNCTUATION = re.compile(r"[.,;:!?)\]”’]+")
PLAIN = re.compile(r"(?<=x-tex\")>.*?</annotation>", re.DOTALL)
ALIGNED = re.compile(r"\\begin\{aligned\}((?:(?!\\begin).)*)\\end\{aligned\}", re.DOTALL)
LINE_END = re.compile(r"\\\\\s*(?:\[\d+pt\])?")
BIG = r"\displaystyle "
SHORT = 40  # characters of TeX that fit on a line of a phone
SCOPES = re.compile(r"\\begin\{|\\end\{|\\[{}]|[{}]|\\\\")


def has_line_break(tex):
    r"""Return whether a `\\` is outside every environment and brace."""
    depth = 0
    for token in SCOPES.findall(tex):
        if token == r"\\" and depth == 0:
            return True
        # \begin{x} opens its brace and itself; the brace of \end{x} closes the environment
        depth += {r"\begin{": 2, "{": 1, "}": -1}.get(token, 0)
    return False


def align_lines(tex):
    """Put the lines or paragraphs of TeX into one aligned environment."""
    parts = [part.strip() for part in re.split(r"\n\s*\n", tex) if part.strip()]
    if len(parts) == 1 and not has_line_break(parts[0]):
        return parts[0]
    return r"\begin{aligned}" + r" \\ ".join(parts) + r"\end{aligned}"


def split_lines(tex):
    """Return both sides of each line of an aligned formula, the sign = with the left one.

    The list is empty if a line holds another environment or is no equation.
    """
    found = ALIGNED.fullmatch(tex)
    lines = [line.split("&") for line in LINE_END.split(found[1])] if found else []
    if any(len(line) != 2 or not line[1].lstrip().startswith("=") for line in lines):
        return []
    return [(f"{left} =", right.lstrip()[1:]) for left, right in lines]


def get_tex(node):
    """Return the TeX of a formula, with marked symbols if the site has marked them."""
    return node.get("marked", node.astext()).strip()


def get_display_tex(node):
    """Return the TeX of a display for KaTeX."""
    tex = get_tex(node)
    if r"\begin{matrix}" in tex and not node["number"]:  # SymPy's own; its fractions in full size
        tex = tex.replace(r"\frac", r"\dfrac")
    return NUMBERED.sub(r"\\\1{\2*}", tex) if node.get("nowrap") else align_lines(tex)


@functools.cache
def start_katex():
    """Return V8 with KaTeX, started once and closed at exit: open, it keeps Python from ending."""
    context = MiniRacer()
    atexit.register(context.close)
    context.eval((VENDOR / "katex.min.js").read_text("utf-8"))
    context.eval(RENDER)
    return context


@functools.cache
def render(tex, display, output="htmlAndMathml"):
    """Return `{"html": …}` or `{"error": …}` of a formula."""
    return start_katex().call("render", tex, display, output)


def locate(node):
    """Return document and line of a formula; in a notebook, cell and line."""
    while node.parent is not None and node.line is None:
        node = node.parent
    source, line = node.source or "", node.line
    if source.endswith(".ipynb") and line and line >= 10_000:  # how myst-nb counts
        return source, f"cell {line // 10_000}, line {line % 10_000}"
    return (f"{source}:{line}" if line else source), ""


def render_html(writer, node, tex, display, plain=None):
    """Return the HTML of a formula, or its TeX with a warning. plain: the text to copy."""
    output = "html" if node.get("seen_only") else "htmlAndMathml"  # read aloud elsewhere
    result = render(tex, display, output)
    if "html" in result:
        copied = html.escape(plain or node.astext().strip(), quote=False)
        return PLAIN.sub(lambda _: f">{copied}</annotation>", result["html"])
    location, cell = locate(node)
    where = f" ({cell})" if cell else ""
    logger.warning("TeX: %s in %s%s", result["error"], tex, where, location=location, type="katex")
    return f"<code>{html.escape(tex)}</code>"


def render_display(writer, node):
    """Return the HTML of a display.

    Each side of each line is a cell of its own, so that a long one can be broken.
    """
    lines = split_lines(get_display_tex(node))
    plain = split_lines(align_lines(node.astext().strip()))
    if not lines or len(lines) != len(plain):
        return render_html(writer, node, get_display_tex(node), True)
    sides = zip(chain(*lines), chain(*plain), strict=True)
    cells = (render_html(writer, node, BIG + side, False, copied) for side, copied in sides)
    return f'<div class="math-lines"><div>{"</div><div>".join(cells)}</div></div>'


def visit_inline(writer, node):
    """Write an inline formula with the punctuation behind it; a short one is not broken."""
    if "after" in node:
        writer.body.append('<span class="kept">')
    kept = " kept" if len(node.astext()) <= SHORT else ""
    writer.body.append(
        writer.starttag(node, "span", "", CLASS=f"math{kept} notranslate nohighlight")
    )
    writer.body.append(render_html(writer, node, get_tex(node), False) + "</span>")
    if "after" in node:
        writer.body.append(f"{html.escape(node['after'])}</span>")
    raise nodes.SkipNode


def keep_punctuation(app, doctree, docname):
    """Move the punctuation behind a short formula into it, so that no line starts with it."""
    for node in list(doctree.findall(nodes.math)):
        following = node.next_node(descend=False, siblings=True)
        found = PUNCTUATION.match(following) if isinstance(following, nodes.Text) else None
        if found and len(node.astext()) <= SHORT:
            node["after"] = found[0]
            following.parent.replace(following, nodes.Text(following[found.end() :]))


def visit_display(writer, node):
    """Write a display: the formula in a box that scrolls, its number beside it."""
    writer.body.append(writer.starttag(node, "div", CLASS="math notranslate nohighlight"))
    writer.body.append(f'<div class="math-scroll">{render_display(writer, node)}</div>')
    if node["number"]:
        writer.body.append(f'<span class="eqno">({get_node_equation_number(writer, node)})')
        writer.add_permalink_ref(node, "Link to this equation")
        writer.body.append("</span>")
    writer.body.append("</div>\n")
    raise nodes.SkipNode


def setup(app):
    """Register the renderer `katex`."""
    app.add_html_math_renderer("katex", (visit_inline, None), (visit_display, None))
    app.add_js_file("katex/copy-tex.min.js", loading_method="defer")
    app.add_css_file("katex/katex.min.css", priority=300)
    app.connect("doctree-resolved", keep_punctuation)
    return {"parallel_read_safe": True, "parallel_write_safe": False}
