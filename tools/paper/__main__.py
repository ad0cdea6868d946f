"""Write the book as an EPUB and two PDFs, from the built site (`make paper`).

Folded parts of the site (answers, solutions, long code) are open in one PDF and left out of the
other. In the EPUB they stay folded.
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
    """Texts of the first page, and the worked solutions as HTML, by the exercise's name."""

    title: str
    author: str
    claim: str
    rights: str
    version: str
    solutions: dict


def read_settings():
    """Return the book with the texts of its settings."""
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
    settings = read_settings()
    with chromium.launch() as browser:
        for write, name in (
            (epub.write, "robokin.epub"),
            (pdf.write_with_answers, "robokin.pdf"),
            (pdf.write_without_answers, "robokin-without-answers.pdf"),
        ):
            file, began = BUILD / name, time.monotonic()
            count = write(browser, settings, file)
            megabytes, seconds = file.stat().st_size / 1e6, time.monotonic() - began
            print(f"_build/{name}: {count} pages, {megabytes:.1f} MB, {seconds:.0f} s", flush=True)


if __name__ == "__main__":
    main()
