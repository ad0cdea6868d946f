"""The built site and a real browser, for every test that looks at pages.

A test module asks for the fixtures with `pytest_plugins = ["browser"]` (once, in conftest.py or in
the module): `site` (folder), `server` (address) and `chromium` (Playwright's browser).
"""

import functools
import gzip
import os
import subprocess
import sys
import threading
import time
from collections import defaultdict
from contextlib import contextmanager
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from urllib.parse import urlsplit

import pytest
import yaml
from chromium import launch
from playwright.sync_api import expect

from courseware.course import list_documents

ROOT = Path(__file__).resolve().parents[1]
SITE = ROOT / "_build" / "html"
WAIT = 1200  # seconds for another worker's build; it fails before, if it does

expect.set_options(timeout=30_000)  # ms, as all other waits; on a busy machine 5 s are too few

# --- the site -------------------------------------------------------------------------------


def make_book():
    """Return the command that brings the site up to date with this Python."""
    return ["make", "book", f"BIN={Path(sys.executable).parent}", "READY="]


def build_site():
    """Bring `_build/html` up to date; return the build's output if it fails."""
    run = subprocess.run(make_book(), cwd=ROOT, capture_output=True, text=True)
    return "" if run.returncode == 0 else run.stdout + run.stderr


def once(folder, name, work):
    """Return the text of `work()`, done by the first worker; the others wait for it."""
    begun, done = folder / f"{name}.begun", folder / f"{name}.done"
    try:
        begun.touch(exist_ok=False)
    except FileExistsError:
        return wait_for(done)
    result = work()
    unfinished = done.with_suffix(".part")
    unfinished.write_text(result, "utf-8")
    unfinished.replace(done)
    return result


def wait_for(file):
    """Return the text of a file that another worker is about to write."""
    end = time.monotonic() + WAIT
    while not file.exists():
        assert time.monotonic() < end, f"no {file.name} after {WAIT} s"
        time.sleep(0.1)
    return file.read_text("utf-8")


def shared_folder(tmp_path_factory):
    """Return a folder that all workers share."""
    base = tmp_path_factory.getbasetemp()
    return base.parent if os.environ.get("PYTEST_XDIST_WORKER") else base


def listed():
    """Return the documents of the table of contents, the first page first."""
    return list(list_documents(yaml.safe_load((ROOT / "_toc.yml").read_text("utf-8"))))


def pages(site):
    """Return every page of the site, as names relative to it; redirects are not pages."""
    names = sorted(file.relative_to(site).as_posix() for file in site.rglob("*.html"))
    return [
        name for name in names if not name.startswith(("_static/", "_sources/", "lite/", "slides/"))
    ]


@pytest.fixture(scope="session")
def site(tmp_path_factory):
    """Return the folder of the built site, brought up to date once per run of the tests."""
    shared = shared_folder(tmp_path_factory)
    if complaint := once(shared, "site", build_site):
        error = RuntimeError(f"the book does not build:\n{complaint}")
        error.tell_once = lambda test: once(shared, "told", lambda: test)  # see conftest.py
        raise error
    return SITE


# --- the server -----------------------------------------------------------------------------


class Quiet(SimpleHTTPRequestHandler):
    """A handler that serves files and logs nothing."""

    def log_message(self, format, *args):
        """Nothing."""


class Server(ThreadingHTTPServer):
    """A server whose browser may hang up at any time."""

    daemon_threads = True

    def handle_error(self, request, client_address):
        """A connection that the browser closed is no error."""
        if not isinstance(sys.exception(), ConnectionError):
            super().handle_error(request, client_address)


@contextmanager
def serving(folder, handler=Quiet):
    """Serve a folder; yield its address."""
    handler = functools.partial(handler, directory=str(folder))
    with Server(("127.0.0.1", 0), handler) as running:
        thread = threading.Thread(target=running.serve_forever)
        thread.start()
        try:
            yield f"http://127.0.0.1:{running.server_port}/"
        finally:
            running.shutdown()
            thread.join()


@pytest.fixture(scope="session")
def server(site):
    """Serve the site; yield its address, with a slash at the end."""
    with serving(site) as address:
        yield address


# --- the browser ----------------------------------------------------------------------------


@pytest.fixture(scope="session")
def chromium():
    """Start Playwright's browser: Chromium from the path, else Playwright's own."""
    with launch() as browser:
        yield browser


def settled(page, address):
    """Open a page, and wait for its scripts and the fonts in sight."""
    page.goto(address)
    page.evaluate("() => document.fonts.ready")


DRAW_ALL = """() => {
  document.head.insertAdjacentHTML(
    "beforeend", "<style>* { content-visibility: visible !important; }</style>");
  return document.body.offsetHeight && document.fonts.ready.then(() => true);
}"""


def draw_all(page):
    """Draw also the parts far from the window, with their fonts: a page is then as it stays."""
    page.evaluate(DRAW_ALL)


def pull(page, start, end, steps=3):
    """By the mouse, from a place to another."""
    page.mouse.move(*start)
    page.mouse.down()
    page.mouse.move(*end, steps=steps)
    page.mouse.up()


# opens the folds around an element and in it, but not a figure's own; predictions as answered
UNFOLD = """(element) => {
  const folds = [...element.querySelectorAll("details, .rk-prediction")];
  for (let at = element; at; at = at.parentElement) folds.push(at);
  for (const fold of folds) {
    if (fold.matches("details:not(.rk-figure *)")) fold.open = true;
    if (fold.matches(".rk-prediction")) fold.classList.add("rk-answered");
  }
  element.querySelectorAll(".rk-veiled .rk-skip").forEach((button) => button.click());
}"""

# waits until the script has taken a figure over, as it does when that comes near, and drawn it
COME_ALIVE = """async (figure) => {
  const svg = figure.querySelector(".rk-picture svg");
  svg.scrollIntoView({ block: "center", behavior: "instant" });
  const fits = () => svg.clientWidth >= 240 && svg.clientWidth === svg.parentElement.clientWidth
    && Math.abs(svg.viewBox.baseVal.width - svg.clientWidth) < 1; // drawn anew, not only shrunk
  const end = performance.now() + 30_000;
  while (!figure.courseware || !fits()) {
    if (performance.now() > end) throw new Error(`${figure.id} does not come alive`);
    await new Promise(requestAnimationFrame);
  }
  figure.courseware.settled();
}"""

# in `shifts`, how far what a page shows has jumped since this ran
SHIFTS = """
window.shifts = [];
new PerformanceObserver((list) => {
  for (const { value } of list.getEntries()) shifts.push(value);
}).observe({ type: "layout-shift" });
"""

TALL = "document.documentElement.scrollHeight"
# a script for a page whose browser keeps nothing more
FULL = "Storage.prototype.setItem = (key) => { if (key.startsWith('robokin')) throw new Error(); }"

# --- what a page does -----------------------------------------------------------------------


class Watch:
    """A record of a page's errors and requests."""

    def __init__(self, page, home):
        self.home = home
        self.errors, self.strangers = [], []
        self.kinds = {}
        page.on("console", self.on_console)
        page.on("pageerror", lambda error: self.errors.append(str(error)))
        page.on("request", self.on_request)
        page.on("requestfailed", self.on_failure)
        page.on("response", self.on_response)

    def on_console(self, message):
        """Keep errors and warnings."""
        if message.type in ("error", "warning"):
            self.errors.append(f"{message.type}: {message.text}")

    def on_request(self, request):
        """Keep the kind of a request, and its address if it leaves the site."""
        self.kinds[request.url] = request.resource_type
        if not request.url.startswith((self.home, "data:", "blob:")):
            self.strangers.append(request.url)

    def on_failure(self, request):
        """Keep a request that failed; what was under way when the page was left is no fault."""
        if request.failure != "net::ERR_ABORTED":
            self.errors.append(f"{request.failure}: {request.url}")

    def on_response(self, response):
        """Keep an answer that is no success."""
        if response.status >= 400:
            self.errors.append(f"{response.status}: {response.url}")

    def weight(self, site):
        """Return bytes by kind of resource, each compressed as by a server; pictures apart."""
        weights = defaultdict(int)
        for url, kind in self.kinds.items():
            if url.startswith(self.home):
                weights[kind] += compressed(site / urlsplit(url[len(self.home) :]).path)
        return dict(weights)


def compressed(file):
    """Return the bytes of a file as sent: compressed, unless that makes it larger."""
    if file.is_dir():
        file = file / "index.html"
    data = file.read_bytes()
    return min(len(data), len(gzip.compress(data, 6)))


@contextmanager
def watched_page(browser, home, width=1280, scheme="light", **options):
    """Open a fresh page (first visit); yield it and its `Watch`."""
    size = {"width": width, "height": 900 if width > 600 else 844}
    context = browser.new_context(viewport=size, color_scheme=scheme, **options)
    try:
        page = context.new_page()
        yield page, Watch(page, home)
    finally:
        context.close()
