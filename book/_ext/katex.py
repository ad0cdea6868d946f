"""Mathematics becomes HTML and MathML while the book is built; the page needs no script for it.

KaTeX runs in V8, which comes as the wheel `mini-racer`. TeX that KaTeX cannot read is a warning
with document and line, and warnings are errors in this book.
"""

import atexit
import functools
import html
import re
from pathlib import Path

from docutils import nodes
from py_mini_racer import MiniRacer
from sphinx.util import logging
from sphinx.util.math import get_node_equation_number

logger = logging.getLogger(__name__)

VENDOR = Path(__file__).parents[1] / "_vendor" / "katex"

RENDER = """
function render(tex, displayMode, macros, output) {
  const ours = ({command}) => command === "\\\\htmlData"; // keys of symbols, which the site writes
  const strict = (code) => code === "htmlExtension" ? "ignore" : "error";
  const options = {displayMode, macros, output, strict, trust: ours};
  try { return {html: katex.renderToString(tex, options)}; }
  catch (error) { return {error: error.rawMessage || error.message || String(error)}; }
}
"""

# KaTeX would number these environments itself; Sphinx does that, so the starred form is drawn
NUMBERED = re.compile(r"\\(begin|end)\{(equation|align|alignat|gather)\}")
PUNCTUATION = re.compile(r"[.,;:!?)\]”’]+")
PLAIN = re.compile(r"(?<=x-tex\")>.*?</annotation>", re.DOTALL)
ALIGNED = re.compile(r"\\begin\{aligned\}((?:(?!\\begin).)*)\\end\{aligned\}", re.DOTALL)
LINE_END = re.compile(r"\\\\\s*(?:\[\d+pt\])?")
BIG = r"\displaystyle "
HEIGHT = re.compile(r'katex-strut" style="height:([\d.]+)em')
ALONE, LINE, GAP = 1.3, 1.6, 0.7  # em: the least height of a line, of one among others; between
SHORT = 40  # characters of TeX: such a formula finds room on a line of a phone
SCOPES = re.compile(r"\\begin\{|\\end\{|\\[{}]|[{}]|\\\\")


def breaks_lines(tex):
    r"""Whether a `\\` stands outside every environment and brace."""
    depth = 0
    for token in SCOPES.findall(tex):
        if token == r"\\" and depth == 0:
            return True
        # \begin{x} opens its brace and itself; the brace of \end{x} closes the environment
        depth += {r"\begin{": 2, "{": 1, "}": -1}.get(token, 0)
    return False


def lines_aligned(tex):
    """The TeX of a display: several lines, or paragraphs, become one aligned environment."""
    parts = [part.strip() for part in re.split(r"\n\s*\n", tex) if part.strip()]
    if len(parts) == 1 and not breaks_lines(parts[0]):
        return parts[0]
    return r"\begin{aligned}" + r" \\ ".join(parts) + r"\end{aligned}"


def lines_of(tex):
    """The two sides of each line of an aligned formula, the sign = with the left one.

    None of them where a line holds another environment or is no equation.
    """
    found = ALIGNED.fullmatch(tex)
    lines = [line.split("&") for line in LINE_END.split(found[1])] if found else []
    if any(len(line) != 2 or not line[1].lstrip().startswith("=") for line in lines):
        return []
    return [(f"{left} =", right.lstrip()[1:]) for left, right in lines]


def tex_of(node):
    """The TeX of a formula, in which the site may have marked its symbols."""
    return node.get("marked", node.astext()).strip()


def display_tex(node):
    """The TeX that KaTeX draws for a display."""
    tex = tex_of(node)
    if r"\begin{matrix}" in tex and not node["number"]:  # SymPy's own; its fractions in full size
        tex = tex.replace(r"\frac", r"\dfrac")
    return NUMBERED.sub(r"\\\1{\2*}", tex) if node.get("nowrap") else lines_aligned(tex)


@functools.cache
def engine():
    """V8 with KaTeX in it, started once. One left open keeps Python from ending: closed at exit."""
    context = MiniRacer()
    atexit.register(context.close)
    context.eval((VENDOR / "katex.min.js").read_text("utf-8"))
    context.eval(RENDER)
    return context


@functools.cache
def rendered(tex, display, macros=(), output="htmlAndMathml"):
    """`{"html": …}` or `{"error": …}` for one formula; `macros` are pairs (name, TeX)."""
    return engine().call("render", tex, display, dict(macros), output)


def place(node):
    """Document and line of a formula, for the message; a notebook's line as cell and line."""
    while node.parent is not None and node.line is None:
        node = node.parent
    source, line = node.source or "", node.line
    if source.endswith(".ipynb") and line and line >= 10_000:  # how myst-nb counts
        return source, f"cell {line // 10_000}, line {line % 10_000}"
    return (f"{source}:{line}" if line else source), ""


def to_html(writer, node, tex, display, plain=None):
    """The formula as HTML, or its TeX and a warning. plain: what who copies it gets."""
    macros = tuple(sorted(writer.builder.config.katex_macros.items()))
    output = "html" if node.get("seen_only") else "htmlAndMathml"  # what is said stands elsewhere
    result = rendered(tex, display, macros, output)
    if "html" in result:
        copied = html.escape(plain or node.astext().strip(), quote=False)
        return PLAIN.sub(lambda _: f">{copied}</annotation>", result["html"])
    location, cell = place(node)
    where = f" ({cell})" if cell else ""
    logger.warning("TeX: %s in %s%s", result["error"], tex, where, location=location, type="katex")
    return f"<code>{html.escape(tex)}</code>"


def display_html(writer, node):
    """A display, and its height in em: a page is laid out before what lies far below is drawn.

    Lines below each other are cells of their own: a long one can be broken.
    """
    lines = lines_of(display_tex(node))
    plain = lines_of(lines_aligned(node.astext().strip()))
    if not lines or len(lines) != len(plain):
        formula = to_html(writer, node, display_tex(node), True)
        return formula, height(formula)
    rows = [
        "".join(
            f"<div>{to_html(writer, node, BIG + side, False, copied)}</div>"
            for side, copied in zip(line, same, strict=True)
        )
        for line, same in zip(lines, plain, strict=True)
    ]
    high = sum(max(LINE, height(row)) for row in rows) + GAP * (len(rows) - 1)
    return f'<div class="math-lines">{"".join(rows)}</div>', high


def height(formula):
    """Of a formula in one line, in em."""
    return max(ALONE, *map(float, HEIGHT.findall(formula)))


def visit_inline(writer, node):
    """Write an inline formula, with the punctuation behind it; a short one stays on one line."""
    if "after" in node:
        writer.body.append('<span class="kept">')
    kept = " kept" if len(node.astext()) <= SHORT else ""
    writer.body.append(
        writer.starttag(node, "span", "", CLASS=f"math{kept} notranslate nohighlight")
    )
    writer.body.append(to_html(writer, node, tex_of(node), False) + "</span>")
    if "after" in node:
        writer.body.append(f"{html.escape(node['after'])}</span>")
    raise nodes.SkipNode


def keep_punctuation(app, doctree, docname):
    """Take the punctuation behind a short formula to the formula: it must not start a line."""
    for node in list(doctree.findall(nodes.math)):
        following = node.next_node(descend=False, siblings=True)
        found = PUNCTUATION.match(following) if isinstance(following, nodes.Text) else None
        if found and len(node.astext()) <= SHORT:
            node["after"] = found[0]
            following.parent.replace(following, nodes.Text(following[found.end() :]))


def visit_display(writer, node):
    """Write a display: the formula in a box that scrolls, its number beside the box."""
    formula, high = display_html(writer, node)
    writer.body.append(writer.starttag(node, "div", CLASS="math notranslate nohighlight"))
    writer.body.append(f'<div class="math-scroll" style="--high:{high:.3g}">{formula}</div>')
    if node["number"]:
        writer.body.append(f'<span class="eqno">({get_node_equation_number(writer, node)})')
        writer.add_permalink_ref(node, "Link to this equation")
        writer.body.append("</span>")
    writer.body.append("</div>\n")
    raise nodes.SkipNode


def setup(app):
    """Register the renderer `katex`."""
    app.add_html_math_renderer("katex", (visit_inline, None), (visit_display, None))
    app.add_config_value("katex_macros", {}, "html", dict)
    app.add_css_file("katex/katex.min.css", priority=300)
    app.connect("doctree-resolved", keep_punctuation)
    return {"parallel_read_safe": True, "parallel_write_safe": False}
