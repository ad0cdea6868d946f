"""Chromium without a window, for the tests and for the book on paper."""

import shutil
from contextlib import contextmanager

from playwright.sync_api import Error, sync_playwright

ARGUMENTS = [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]
MISSING = "no Chromium: install the package `chromium`, or run `playwright install chromium`"


def find_path():
    """Return the path of Chromium or Chrome, or None; the headless shell is twice as fast."""
    names = ("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome", "chrome")
    return next(filter(None, map(shutil.which, names)), None)


@contextmanager
def launch():
    """Launch Chromium from the path, or else Playwright's own, and close it at the end."""
    with sync_playwright() as playwright:
        try:
            browser = playwright.chromium.launch(executable_path=find_path(), args=ARGUMENTS)
        except Error as error:
            raise SystemExit(f"{MISSING}\n{error}") from error
        yield browser
        browser.close()
