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


def path():
    """Chromium or Chrome on this machine, or None; without its windows it is twice as fast."""
    names = ("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome", "chrome")
    return next(filter(None, map(shutil.which, names)), None)


@contextmanager
def started():
    """Playwright's browser: Chromium from the path, else Playwright's own."""
    with sync_playwright() as playwright:
        try:
            browser = playwright.chromium.launch(executable_path=path(), args=ARGUMENTS)
        except Error as error:
            raise SystemExit(f"{MISSING}\n{error}") from error
        yield browser
        browser.close()
