"""Write the book as PDF and EPUB, from the built site (`make paper`).

    python -m paper               what is folded lies open in the PDF
    python -m paper --folds gone  it is left out: answers, solutions, long code

A reader of the EPUB can open folds, so they stay.
"""

import argparse
import time
from dataclasses import dataclass

import chromium
import yaml

import book
from paper import epub, pdf
from paper.pages import BUILD, ROOT
from workshop.practice import page
from workshop.practice.bank import default_salt, exercises


@dataclass(frozen=True)
class Book:
    """What stands on the first page, and the worked solutions: HTML, by the exercise's name."""

    title: str
    author: str
    claim: str
    rights: str
    version: str
    solutions: dict


def described():
    """The book as its settings say."""
    settings = yaml.safe_load((ROOT / "_config.yml").read_text("utf-8"))
    site = settings["sphinx"]["config"]
    solved = exercises() if site["course_solutions"] else ()
    return Book(
        title=settings["title"],
        author=settings["author"],
        claim=site["site_description"],
        rights=site["html_theme_options"]["extra_footer"],
        version=book.__version__,
        solutions={name: page.solution(name, default_salt()) for name in solved},
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--folds", choices=["open", "gone"], default="open")
    folds = parser.parse_args().folds
    what = described()
    with chromium.started() as browser:
        for make, file in ((epub.make, epub.TARGET), (pdf.make, pdf.TARGET)):
            began = time.monotonic()
            count = make(browser, what, folds)
            megabytes, seconds = file.stat().st_size / 1e6, time.monotonic() - began
            name = file.relative_to(BUILD.parent)
            print(f"{name}: {count} pages, {megabytes:.1f} MB, {seconds:.0f} s", flush=True)


if __name__ == "__main__":
    main()
