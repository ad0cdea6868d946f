"""Write the book as two PDFs, and the poster, from the built site (`make paper`).

Folded parts of the site (answers, solutions, long code) are open in one and left out of the other.
"""

import time
from html import escape

import chromium
import yaml

import book  # noqa: F401 - opens the course
from courseware.course import course
from courseware.practice import variants
from courseware.practice.bank import all_exercises
from courseware.script import engine
from paper import pdf
from paper.pages import BUILD, ROOT


def main():
    settings = yaml.safe_load((ROOT / "_config.yml").read_text("utf-8"))
    site = settings["sphinx"]["config"]
    rights = site["html_theme_options"]["extra_footer"]
    front = {"title": escape(settings["title"]), "rights": rights}
    solved = all_exercises() if site["course_solutions"] else {}
    solutions = {name: render_solution(exercise) for name, exercise in solved.items()}
    with chromium.launch() as browser:
        for name, shown, folds_open in (
            ("robokin.pdf", solutions, True),
            ("robokin-without-answers.pdf", {}, False),
        ):
            file, began = BUILD / name, time.monotonic()
            count = pdf.write(browser, front, file, shown, folds_open)
            megabytes, seconds = file.stat().st_size / 1e6, time.monotonic() - began
            print(f"_build/{name}: {count} pages, {megabytes:.1f} MB, {seconds:.0f} s", flush=True)
        for size in ("A4", "A2"):
            pdf.print_poster(browser, BUILD / f"robokin-poster-{size}.pdf", size)


def render_solution(exercise):
    """Render a worked solution in the numbers that a page has for somebody without a name."""
    numbers = variants.find_variant(course().salt, exercise.name).numbers
    return engine.call(
        "courseware.renderParagraphs", exercise.fill(exercise.solution.text, numbers)
    )


if __name__ == "__main__":
    main()
