"""Repairs of the pinned theme and its helpers, each for one defect; see the README."""

from docutils import nodes


def name_site(app, config):
    """Have previews of links give the name and the address of the other settings."""
    config.ogp_site_name, config.ogp_site_url = config.html_title, config.html_baseurl


def repair_names(app, pagename, templatename, context, doctree):
    """Repair names and roles for screen readers, as axe asks."""
    if "body" in context:  # of a bibliography (docutils) and of a folded cell (myst-nb)
        body = context["body"].replace('role="doc-biblioentry"', 'role="listitem"')
        context["body"] = body.replace('<summary aria-label="Toggle hidden content">', "<summary>")


def visit_image(writer, node):
    """Write an image that loads when it is near; its size keeps its place until then."""
    node["loading"] = "lazy"
    type(writer).visit_image(writer, node)
    if "width" in node and "height" in node:
        size = (f'{name}="{node[name].removesuffix("px")}"' for name in ("width", "height"))
        writer.body[-1] = writer.body[-1].replace("<img ", f"<img {' '.join(size)} ", 1)


def setup(app):
    """Register the repairs with Sphinx."""
    app.add_css_file("site.css", priority=900)
    # first: it removes what other scripts had made in a page that was saved
    app.add_js_file("site.js", priority=200, loading_method="defer")
    app.add_node(nodes.image, override=True, html=(visit_image, None))
    app.connect("config-inited", name_site)
    app.connect("html-page-context", repair_names, priority=900)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
