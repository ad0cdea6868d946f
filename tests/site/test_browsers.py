"""Firefox and WebKitGTK over every page, with one drag a figure.

Debian and Ubuntu have them in the packages `firefox-esr` and `webkit2gtk-driver`. Firefox is driven
by Marionette, its own protocol, and so needs no driver; WebKitGTK by WebDriver, and on a machine
without a screen with `xvfb-run make test-slow`.
"""

import json
import socket
import subprocess
import time
import urllib.error
import urllib.request

import pytest
from browser import DRAW_ALL, UNFOLD, listed
from declared import FIGURES
from support import find_command

from courseware.figures import Choice

pytest_plugins = ["browser"]
pytestmark = pytest.mark.slow

WAIT = 60  # seconds for what takes one or two


def free_port():
    """A port that nobody uses now."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        return free.getsockname()[1]


def until(asked):
    """Wait until it is so."""
    end = time.monotonic() + WAIT
    while not (found := asked()):
        assert time.monotonic() < end, f"not within {WAIT} s"
        time.sleep(0.1)
    return found


class Browser:
    """A browser with one window. call: does one of WebDriver's commands."""

    process: subprocess.Popen

    def run(self, function, *arguments):
        """What a JavaScript function gives on the page."""
        script = f"return ({function})(...arguments);"
        return self.call("ExecuteScript", {"script": script, "args": arguments})

    def drag(self, x, y, right, down):
        """By mouse."""
        places = [(x, y), (x + right / 2, y + down / 2), (x + right, y + down)]
        moves = [
            {"type": "pointerMove", "duration": 20, "x": round(x), "y": round(y)} for x, y in places
        ]
        down, up = ({"type": f"pointer{way}", "button": 0} for way in ("Down", "Up"))
        mouse = {"type": "pointer", "id": "mouse", "actions": [moves[0], down, *moves[1:], up]}
        self.call("PerformActions", {"actions": [mouse]})

    def close(self):
        self.process.terminate()
        self.process.wait(WAIT)


class Firefox(Browser):
    """By Marionette: messages of JSON behind their lengths."""

    names = ("firefox-esr", "firefox")
    package = "firefox-esr"

    def __init__(self, command, folder):
        port = free_port()
        settings = {"marionette.port": port, "ui.prefersReducedMotion": 1}
        lines = (f"user_pref({json.dumps(k)}, {json.dumps(v)});\n" for k, v in settings.items())
        (folder / "user.js").write_text("".join(lines))
        options = ["-marionette", "-headless", "-no-remote", "-profile", str(folder)]
        self.process = subprocess.Popen([command, *options], stderr=subprocess.DEVNULL)
        self.line = until(lambda: self.reached(port))
        self.answer()  # it greets
        self.call("NewSession", {})

    def reached(self, port):
        try:
            with socket.create_connection(("127.0.0.1", port), timeout=WAIT) as opened:
                return opened.makefile("rwb")  # it keeps the connection
        except ConnectionError:
            return None

    def close(self):
        self.line.close()
        super().close()

    def answer(self):
        size = b""
        while (sign := self.line.read(1)) != b":":
            size += sign
        return json.loads(self.line.read(int(size)))

    def call(self, name, body):
        data = json.dumps([0, 1, f"WebDriver:{name}", body]).encode()
        self.line.write(b"%d:%s" % (len(data), data))
        self.line.flush()
        _, _, error, found = self.answer()
        assert not error, error
        return found.get("value")


PLACES = {"Navigate": "/url", "ExecuteScript": "/execute/sync", "PerformActions": "/actions"}


class WebKit(Browser):
    """By WebDriver: a request for each command."""

    names = ("WebKitWebDriver",)
    package = "webkit2gtk-driver"

    def __init__(self, command, folder):
        port = free_port()
        self.process = subprocess.Popen([command, f"--port={port}"])
        self.home = f"http://127.0.0.1:{port}"
        until(self.ready)
        session = self.send("/session", {"capabilities": {}})
        self.home += f"/session/{session['sessionId']}"

    def ready(self):
        try:
            return self.send("/status")["ready"]
        except urllib.error.URLError:
            return False

    def send(self, place, body=None, method=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.home + place, data, method=method)
        try:
            with urllib.request.urlopen(request, timeout=WAIT) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise AssertionError(json.load(error)["value"]["message"]) from error

    def call(self, name, body):
        return self.send(PLACES[name], body)

    def close(self):
        self.send("", method="DELETE")
        super().close()


@pytest.fixture(scope="module", params=[Firefox, WebKit])
def browser(request, tmp_path_factory):
    command = find_command(request.param.package, *request.param.names)
    opened = request.param(command, tmp_path_factory.mktemp("profile"))
    yield opened
    opened.close()


WEIGHT = """() =>
  getComputedStyle(document.querySelector("main h1:not(.onlyprint *)")).fontWeight"""
SHOWN = """(name) => {
  const figure = document.getElementById(name);
  figure.scrollIntoView({block: "center", behavior: "instant"});
  return Boolean(figure.courseware) && document.fonts.status === "loaded";
}"""
STATE = "(name) => JSON.stringify(document.getElementById(name).courseware.state)"
# the middle of a handle, a slider's thumb, a button or a ground that can be taken; and where to
GRIP = """(name) => {
  const root = document.getElementById(name), inside = (all) => root.querySelectorAll(all);
  const grips = inside(".rk-handles circle, input[type=range], [data-press]");
  for (const grip of [...grips, ...inside(".rk-picture svg")]) {
    grip.scrollIntoView({block: "center", behavior: "instant"});
    const { left, top, width, height } = grip.getBoundingClientRect();
    const share = grip.type === "range" ? (grip.value - grip.min) / (grip.max - grip.min) : 0.5;
    const x = left + 14 + share * (width - 28), y = top + height / 2;
    const way = grip.type === "button" ? [0, 0] : [share > 0.5 ? -40 : 40, 25];
    if (grip.contains(document.elementFromPoint(x, y))) return [x, y, ...way];
  }
  return null;
}"""


@pytest.mark.parametrize("name", listed())
def test_a_page_and_its_figures(name, browser, server):
    browser.call("Navigate", {"url": f"{server}{name}.html"})
    assert browser.run(WEIGHT) == "700"  # the style has come
    browser.run(DRAW_ALL)  # then nothing moves any more
    ids = browser.run("() => [...document.querySelectorAll('.rk-figure')].map(({id}) => id)")
    for figure in ids:
        browser.run(f"(name) => ({UNFOLD})(document.getElementById(name))", figure)
        until(lambda: browser.run(SHOWN, figure))  # noqa: B023 (asked at once)
        if not all(isinstance(control, Choice) for control in FIGURES[figure].controls):
            before, grip = browser.run(STATE, figure), browser.run(GRIP, figure)
            assert grip, f"nothing of {figure} can be taken"
            browser.drag(*grip)
            until(lambda: browser.run(STATE, figure) != before)  # noqa: B023
