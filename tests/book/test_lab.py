"""The notebook in a real JupyterLab: run as a whole, a figure moved, an exercise answered."""

import json
import os
import signal
import subprocess
import sys
import time
from contextlib import contextmanager

import pytest
from browser import pull, watched_page
from declared import COURSE, EXERCISES
from support import ROOT

from courseware.practice.notebook import Box

pytest_plugins = ["browser"]
pytestmark = [pytest.mark.browser, pytest.mark.slow]  # test_widget.py is its quick part

NOTEBOOK = "differential_drive/differential_drive.ipynb"
PATIENCE = 90  # seconds at most for the server to start, and for all cells to run
SCREENSHOTS = ROOT / "_build" / "screenshots"

# at the end of the notebook: one more figure, so that Python can be asked about it
FIGURE = "mine = figures.drive_figure()\nmine"
ASK = "mine.widget.state.get('shown')"

# before it an exercise, so that Python can be asked what was answered
EXERCISE = 'box = practice.exercise("differential-drive-1", student="Ada")\nbox'
ANSWERS = "from courseware.practice import notebook\nlist(notebook._answers.values())"

# every cell is on the page, also those that are scrolled away; nothing is asked of the network
SETTINGS = {
    "notebook-extension/tracker": {"windowingMode": "none"},
    "apputils-extension/notification": {"fetchNews": "false", "checkForUpdates": False},
    "extensionmanager-extension/plugin": {"enabled": False},
}


def copied(folder):
    """The notebook without its outputs, and the cells of this test at its end."""
    notebook = json.loads((ROOT / "book" / NOTEBOOK).read_text("utf-8"))
    for place, source in enumerate((EXERCISE, ANSWERS, FIGURE, ASK)):
        cell = {"cell_type": "code", "id": f"mine-{place}", "metadata": {}, "source": source}
        notebook["cells"].append(cell)
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code":  # nothing stored can pass for something that has run
            cell.update(outputs=[], execution_count=None)
    (folder / NOTEBOOK).parent.mkdir(parents=True)
    (folder / NOTEBOOK).write_text(json.dumps(notebook), "utf-8")


def surroundings(home):
    """An environment in which JupyterLab touches nothing but `home`, with our settings."""
    for name, settings in SETTINGS.items():
        file = home / "lab" / "@jupyterlab" / f"{name}.jupyterlab-settings"
        file.parent.mkdir(parents=True)
        file.write_text(json.dumps(settings), "utf-8")
    places = ["JUPYTER_CONFIG_DIR", "JUPYTER_DATA_DIR", "JUPYTER_RUNTIME_DIR", "IPYTHONDIR"]
    own = {place: str(home / place.lower()) for place in places}
    own |= {"JUPYTERLAB_SETTINGS_DIR": str(home / "lab")}
    own |= {"JUPYTERLAB_WORKSPACES_DIR": str(home / "workspaces")}
    return {**os.environ, **own}


@contextmanager
def lab(folder, home):
    """The address of a JupyterLab over a folder; it is stopped in any case, kernels too."""
    environment = surroundings(home)
    options = ["--no-browser", "--port=0", "--ip=127.0.0.1", "--IdentityProvider.token="]
    options += ["--allow-root", f"--ServerApp.root_dir={folder}"]
    with (home / "log").open("w") as log:
        server = subprocess.Popen(
            [sys.executable, "-m", "jupyterlab", *options],
            env=environment,
            stdout=log,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )
        try:
            yield address(server, home)
        finally:
            stop(server)


def address(server, home):
    """Where the server answers, as soon as it says so."""
    end = time.monotonic() + PATIENCE
    while not (told := list((home / "jupyter_runtime_dir").glob("jpserver-*.json"))):
        running = server.poll() is None and time.monotonic() < end
        assert running, f"JupyterLab does not start:\n{(home / 'log').read_text('utf-8')}"
        time.sleep(0.1)
    return json.loads(told[0].read_text("utf-8"))["url"]


def stop(server):
    """Unknown it to end, with its kernels; after a while, make it."""
    server.terminate()
    try:
        server.wait(timeout=15)
    except subprocess.TimeoutExpired:
        os.killpg(server.pid, signal.SIGKILL)
        server.wait()


def run_all(page):
    """Every cell from top to bottom, by the menu; none fails, and empty functions are judged."""
    page.locator(".jp-StatusBar-TextItem", has_text="| Idle").wait_for()  # the kernel is there
    page.get_by_role("menuitem", name="Run", exact=True).click()
    page.get_by_role("menuitem", name="Run All Cells", exact=True).click()
    page.wait_for_function(
        """() => [...document.querySelectorAll(".jp-CodeCell .jp-InputArea-prompt")].every(
            (prompt) => /\\[\\d+\\]/.test(prompt.textContent))"""
    )
    assert not page.locator('[data-mime-type="application/vnd.jupyter.stderr"]').all_text_contents()
    judged = page.locator(".rk-judged.rk-wrong").all_text_contents()
    assert ["It returns nothing" in words for words in judged] == [True, True, False]  # one to mend


def slide(page):
    """The first slider of *Your own figure*, by the keyboard, until its picture is another."""
    cell = page.locator(".jp-CodeCell", has_text="interact(draw_drive")
    before = cell.locator("img").get_attribute("src")
    cell.locator(".noUi-handle").first.press("ArrowRight")
    page.wait_for_function(
        "([cell, before]) => ![before, undefined].includes(cell.querySelector('img')?.src)",
        arg=[cell.element_handle(), before],
    )


def run_again(cell):
    """One cell, by the keyboard; its output."""
    before = cell.locator(".jp-InputPrompt").text_content()
    cell.locator(".cm-content").click()
    cell.page.keyboard.press("Control+Enter")
    cell.page.wait_for_function(
        "([prompt, before]) => prompt.textContent !== before && /\\d/.test(prompt.textContent)",
        arg=[cell.locator(".jp-InputPrompt").element_handle(), before],
    )
    return cell.locator(".jp-OutputArea").text_content()


def shows(figure, name, text):
    """Wait until a readout of the figure has a text."""
    row = figure.locator("dl > div").filter(has_text=name)
    row.locator("dd", has_text=text).wait_for()


def test_figures_and_exercises_in_the_notebook(tmp_path, chromium):
    copied(tmp_path / "notebooks")
    home = tmp_path / "home"
    home.mkdir()
    with (
        lab(tmp_path / "notebooks", home) as server,
        watched_page(chromium, server) as (page, _),
    ):
        page.set_default_timeout(1000 * PATIENCE)
        page.goto(f"{server}lab/tree/{NOTEBOOK}")
        run_all(page)
        slide(page)
        cells = page.locator(".jp-CodeCell")
        shown, asked = cells.nth(-2), cells.nth(-1)
        figure = shown.locator(".rk-figure.rk-live")
        shows(figure, "speed v", "0.075 m/s")
        drag(page, figure.locator(".rk-handles circle").first)
        shows(figure, "speed v", "0.110 m/s")
        assert "[0.12, 0.1, " in run_again(asked)
        run_again(shown)
        shows(figure, "speed v", "0.075 m/s")
        SCREENSHOTS.mkdir(parents=True, exist_ok=True)
        box, answers = cells.nth(-4).locator(".rk-exercise.rk-live"), cells.nth(-3)
        field, verdict = box.get_by_label("Answer, one number"), box.locator(".rk-verdict")
        field.fill("nonsense")
        field.press("Enter")
        verdict.filter(has_text="cannot be read").wait_for()
        assert "nonsense" in run_again(answers)  # nothing typed is lost
        right = Box(EXERCISES["differential-drive-1"], "Ada", COURSE).variant.candidates[0].rows[0]
        field.fill(f"{right[0]:.4f}")
        field.press("Enter")
        verdict.filter(has_text="This check passed.").wait_for()
        told = run_again(answers)
        assert "Ada" in told
        assert f"{right[0]:.4f}" in told
        assert "nonsense" not in told
        box.scroll_into_view_if_needed()
        page.screenshot(path=SCREENSHOTS / "lab-exercise.png")
        figure.scroll_into_view_if_needed()
        page.screenshot(path=SCREENSHOTS / "lab.png")


def drag(page, handle):
    """The tip of the left wheel's arrow, pulled forward beyond its greatest speed."""
    handle.scroll_into_view_if_needed()
    box = handle.bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    pull(page, (x, y), (x, y - 200), steps=5)
