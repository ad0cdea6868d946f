"""The page for addresses that lead nowhere, as servers show it: at any depth, under any path."""

import pytest
from browser import Quiet, serving, settled, watched_page

pytest_plugins = ["browser"]
pytestmark = pytest.mark.browser


COLOUR = """() => getComputedStyle(document.documentElement)
  .getPropertyValue("--pst-color-primary")"""


class Hosted(Quiet):
    """A handler that shows the page of the site that it serves below /someone/course/."""

    def send_error(self, code, *args):
        page = (self.site / "404.html").read_bytes()
        self.send_response(404)
        self.send_header("Content-Type", "text/html; charset=utf-8")
        self.end_headers()
        if self.command != "HEAD":
            self.wfile.write(page)


@pytest.fixture(scope="module")
def hosted(site, tmp_path_factory):
    """Serve the site below a path; yield its address."""
    folder = tmp_path_factory.mktemp("host")
    (folder / "someone").mkdir()
    (folder / "someone" / "course").symlink_to(site)
    handler = type("Handler", (Hosted,), {"site": site})
    with serving(folder, handler) as address:
        yield f"{address}someone/course/"


@pytest.mark.parametrize("place", ["gone.html", "euler/gone.html", "a/b/c/"])
def test_a_page_that_is_not_there_looks_like_the_site_and_finds_what_is(place, hosted, chromium):
    with watched_page(chromium, hosted) as (page, watch):
        settled(page, hosted + place)
        assert page.locator("h1").inner_text() == "There is no such page"
        assert page.evaluate(COLOUR).strip() == "#14609f"
        links = page.locator("a[href]").evaluate_all("(all) => all.map(({ href }) => href)")
        links = {link.partition("#")[0] for link in links if link.partition("#")[0] != page.url}
        assert len(links) > 15
        for link in links:
            assert page.request.get(link).ok, link
        page.locator(".bd-search-container input").first.fill("turning radius")
        result = page.locator(".site-results li a").first
        result.wait_for()
        assert page.request.get(result.evaluate("({ href }) => href")).ok
        page.locator("a[href$='#main-content']").evaluate("(skip) => skip.click()")
        assert page.url.startswith(hosted + place)
        assert not [error for error in watch.errors if "404" not in error]
        home = hosted.removesuffix("someone/course/")
        assert not [url for url in watch.strangers if not url.startswith(home)]
