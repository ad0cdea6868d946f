"""Where a chapter can be run: a menu *Run* in the bar of its page.

Each place is a link. What an address is needed for is absent without it: `repository_url` in
`_config.yml` says where the course's files are public, `site_hub` the address of a JupyterHub.
"""

import html
import re
from urllib.parse import quote, urlencode

from lite import address

GITHUB = re.compile(r"https://github\.com/([\w.-]+)/([\w.-]+?)(?:\.git)?/?")
COPIES = "hosted"  # the branch with the notebooks that install the course: tools/hosted.py


def places(app, page):
    """Name → (address, what it says) of each place where the notebook of a page can be run."""
    theme, hub = app.config.html_theme_options, app.config.site_hub
    url, branch = theme.get("repository_url", ""), theme.get("repository_branch") or "main"
    return {**in_browser(page), **on_hub(url, branch, hub, page), **on_github(url, branch, page)}


def in_browser(page):
    """JupyterLite, which stands beside the book."""
    return {"In the browser": ("../" * page.count("/") + address(page), "Nothing to install")}


def on_github(url, branch, page):
    """Places that take a notebook from GitHub. Colab and Kaggle have no environment of the
    course: there a copy is opened, with a first cell that installs it."""
    found = GITHUB.fullmatch(url)
    if not found:
        return {}
    owner, name = found.groups()
    notebook = quote(f"lab/tree/book/{page}.ipynb", safe="")
    copy = f"{owner}/{name}/blob/{COPIES}/{page.rpartition('/')[2]}.ipynb"
    binder = f"https://mybinder.org/v2/gh/{owner}/{name}/{quote(branch, safe='')}"
    return {
        "Binder": (f"{binder}?urlpath={notebook}", "Free, no account; starts in minutes"),
        "Colab": (f"https://colab.research.google.com/github/{copy}", "With a Google account"),
        "Kaggle": (
            f"https://kaggle.com/kernels/welcome?src=https://github.com/{copy}",
            "With a Kaggle account; switch Internet on there",
        ),
        "Codespaces": (
            f"https://codespaces.new/{owner}/{name}/tree/{branch}?quickstart=1",
            "An editor with a GitHub account",
        ),
    }


def on_hub(url, branch, hub, page):
    """A JupyterHub with nbgitpuller: it fetches the newest notebooks and keeps a reader's edits."""
    if not url or not hub:
        return {}
    name = url.rstrip("/").removesuffix(".git").rpartition("/")[2]
    asked = {"repo": url, "branch": branch, "urlpath": f"lab/tree/{name}/book/{page}.ipynb"}
    address = f"{hub.rstrip('/')}/hub/user-redirect/git-pull?{urlencode(asked)}"
    return {"JupyterHub": (address, "Your university's JupyterHub")}


def add_menu(app, page, template, context, doctree):
    """The menu of a chapter, if there is a place to run it."""
    found = places(app, page) if context.get("page_source_suffix") == ".ipynb" else {}
    if not found:
        return
    links = [
        {"type": "link", "text": name, "url": html.escape(url), "tooltip": says}
        for name, (url, says) in found.items()
    ]
    menu = {"type": "group", "tooltip": "Run this chapter", "icon": "fas fa-play"}
    context["header_buttons"].insert(0, menu | {"buttons": links, "label": "run-buttons"})


def setup(app):
    """Called by Sphinx."""
    app.add_config_value("site_hub", "", "html", str)
    app.connect("html-page-context", add_menu, priority=502)  # after the theme's own buttons
    return {"parallel_read_safe": True, "parallel_write_safe": True}
