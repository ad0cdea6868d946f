"""Write the book as an EPUB and two PDFs, from the built site (`make paper`).

What the site folds (answers, solutions, long code) lies open in one PDF and is left out of the
other. A reader of the EPUB can open folds, so they stay.
"""

import time
from dataclasses import dataclass

import chromium
import yaml

import book
from courseware.practice import rendering
from courseware.practice.bank import all_exercises, course_name
from paper import epub, pdf
from paper.pages import BUILD, ROOT


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
    solved = all_exercises() if site["course_solutions"] else ()
    return Book(
        title=settings["title"],
        author=settings["author"],
        claim=site["site_description"],
        rights=site["html_theme_options"]["extra_footer"],
        version=book.__version__,
        solutions={name: rendering.render_solution(name, course_name()) for name in solved},
    )


def main():
    what = described()
    with chromium.started() as browser:
        for make, name in (
            (epub.make, "robokin.epub"),
            (pdf.with_answers, "robokin.pdf"),
            (pdf.without_answers, "robokin-without-answers.pdf"),
        ):
            file, began = BUILD / name, time.monotonic()
            count = make(browser, what, file)
            megabytes, seconds = file.stat().st_size / 1e6, time.monotonic() - began
            print(f"_build/{name}: {count} pages, {megabytes:.1f} MB, {seconds:.0f} s", flush=True)


if __name__ == "__main__":
    main()
