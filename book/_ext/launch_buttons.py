"""A menu *Run* on the page of a chapter: links to places where its notebook runs, and its slides.

Two settings in `_config.yml` add places: the `url` of the public repository, and `site_hub`, the
address of a JupyterHub.
"""

import html
from urllib.parse import quote, urlencode, urlsplit

from jupyterlite import notebook_address


def list_places(app, page):
    """Return address and description of each place where the notebook of a page runs, by name."""
    theme, hub = app.config.html_theme_options, app.config.site_hub.rstrip("/")
    url, branch = theme.get("repository_url", ""), theme.get("repository_branch") or "main"
    repository = urlsplit(url.rstrip("/").removesuffix(".git"))
    name, notebook = repository.path.rpartition("/")[2], f"book/{page}.ipynb"
    found = {"In the browser": (notebook_address(page), "Nothing to install")}
    if url and hub:  # nbgitpuller fetches the newest notebooks and keeps a reader's edits
        # without targetPath the folder is called as the url ends, with its ".git"
        asked = {"repo": url, "branch": branch, "targetPath": name}
        query = urlencode(asked | {"urlpath": f"lab/tree/{name}/{notebook}"})
        words = "Your university's JupyterHub"
        found["JupyterHub"] = (f"{hub}/hub/user-redirect/git-pull?{query}", words)
    if repository.netloc == "github.com":
        path, place = repository.path.strip("/"), quote(f"lab/tree/{notebook}", safe="")
        binder = f"https://mybinder.org/v2/gh/{path}/{quote(branch, safe='')}?urlpath={place}"
        found["Binder"] = (binder, "Free, no account; starts in minutes")
    slides = f"{'../' * page.count('/')}slides/{page.partition('/')[0]}.html"
    found["Slides"] = (slides, "Figures, questions and formulas for a lecture")
    return found


def add_menu(app, page, template, context, doctree):
    """Add the menu to the page of a chapter."""
    if context.get("page_source_suffix") == ".ipynb":
        links = [
            {"type": "link", "text": name, "url": html.escape(url), "tooltip": tip}
            for name, (url, tip) in list_places(app, page).items()
        ]
        menu = {"type": "group", "tooltip": "Run this chapter", "icon": "fas fa-play"}
        context["header_buttons"].insert(0, menu | {"buttons": links, "label": "run-buttons"})


def setup(app):
    """Register the menu with Sphinx."""
    app.add_config_value("site_hub", "", "html", str)
    app.connect("html-page-context", add_menu, priority=502)  # after the theme's own buttons
    return {"parallel_read_safe": True, "parallel_write_safe": True}
