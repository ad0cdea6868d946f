"""Import the questions into a real Moodle and answer them there.

    python tools/moodle_server.py FOLDER [EXERCISE …]

FOLDER holds Moodle's own code. Moodle is installed into a PostgreSQL of its own. It imports the
questions and gets answers through its question engine, each by the question's own button and when
an attempt is finished: right ones, mistakes, a wrong unit. Every sixteenth variant also gets other
units and texts that are not read, and all of it in German and Persian, too. Of these languages
Moodle has only the signs and the direction: language packs are not part of its code. Pictures of
three questions go to _build/screenshots.

It needs postgresql and PHP with the extensions for Moodle (on Debian: php-cli php-pgsql php-intl
php-xml php-mbstring php-curl php-zip php-gd php-soap). Everything else is removed afterwards.
"""

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from html import unescape
from pathlib import Path
from urllib.parse import urlencode

from playwright.sync_api import sync_playwright

from classroom import moodle
from classroom.answer_key import choose_exercises
from classroom.moodle_answers import choose_row
from courseware.practice import candidates, dealing
from courseware.practice.formatting import render_symbols

PORT = 5432  # the name of a socket in a folder of its own: nothing listens on the network
SITE = "127.0.0.1:8764"
LANGUAGES = {  # name, decimal sign, sign between thousands, direction
    "de": ("Deutsch", ",", ".", "ltr"),
    "fa": ("فارسی", ".", ",", "rtl"),
}
LANGUAGE = """<?php
$string['thislanguage'] = '{}';
$string['decsep'] = '{}';
$string['thousandssep'] = '{}';
$string['thisdirection'] = '{}';
"""
ALWAYS = ("right", "mistake", "unknown unit")
PICTURES = ("elbow-arm-1", "euler-2", "euler-5")
OUT = Path("_build/screenshots")
CONFIG = """<?php
$CFG = new stdClass();
$CFG->dbtype = 'pgsql';
$CFG->dblibrary = 'native';
$CFG->dbhost = 'localhost';
$CFG->dbname = $CFG->dbuser = 'moodle';
$CFG->dbpass = '';
$CFG->prefix = 'm_';
$CFG->dboptions = ['dbport' => {port}, 'dbsocket' => '{socket}'];
$CFG->wwwroot = 'http://{site}';
$CFG->dataroot = '{data}';
require_once(__DIR__ . '/lib/setup.php');
"""


def run(*command, **options):
    streams = {"text": True, "stdout": subprocess.PIPE, "stderr": subprocess.STDOUT}
    done = subprocess.run(list(map(str, command)), **streams, **options)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))} failed:\n{done.stdout[-3000:]}")
    return done.stdout


def main(folder, only):
    """Install, import, answer, and print the table."""
    config = folder / "config.php"
    if config.exists() or not (folder / "question").is_dir():
        sys.exit(f"{folder} must hold Moodle's code, and no config.php")
    tools = Path(run("pg_config", "--bindir").strip())
    with tempfile.TemporaryDirectory(prefix="moodle-") as place:
        place = Path(place)
        database, data = place / "database", place / "data"
        database.mkdir()
        for language, signs in LANGUAGES.items():
            (data / "lang" / language).mkdir(parents=True)
            (data / "lang" / language / "langconfig.php").write_text(LANGUAGE.format(*signs))
        other = []
        if os.geteuid() == 0:  # PostgreSQL does not run as root
            other = ["runuser", "-u", "nobody", "--"]
            run("chown", "-R", "nobody", place)
        run(*other, tools / "initdb", "-D", database, "-A", "trust", "-U", "moodle", "-E", "UTF8")
        socket = f"-k {place} -p {PORT} -c listen_addresses='' -c fsync=off"
        start = (tools / "pg_ctl", "-D", database, "-w", "-l", place / "log")
        run(*other, *start, "-o", socket, "start", cwd=place)
        try:
            run(tools / "createdb", "-h", place, "-p", PORT, "-U", "moodle", "moodle")
            config.write_text(CONFIG.format(port=PORT, socket=place, data=data, site=SITE))
            log = place / "php.log"
            php = ("php", "-d", "max_input_vars=5000", "-d", "memory_limit=4G")
            php += ("-d", "display_errors=0", "-d", "log_errors=1", "-d", f"error_log={log}")
            install = ("--agree-license", "--adminpass=Pass-w0rd", "--fullname=t", "--shortname=t")
            run(*php, folder / "admin/cli/install_database.php", *install)
            quiz, answers = place / "quiz.xml", place / "answers.json"
            moodle.write(quiz, only)
            asked = [*list_questions(only)]
            answers.write_text(json.dumps(asked))
            here = Path(__file__).with_suffix(".php")
            output = run(*php, here, folder, quiz, answers)
            warnings = log.read_text().count("PHP Warning")
            take_pictures((*php, "-S", SITE, "-t", folder, here), asked)
        finally:
            config.unlink(missing_ok=True)
            run(*other, *start, "-m", "fast", "stop", cwd=place)
    found = next(line for line in output.splitlines() if line.startswith('{"imported'))
    print(f"warnings of PHP: {warnings}")
    print_table(json.loads(found))


def list_questions(only):
    """Yield each question with its languages, answers and the expected feedback."""
    for exercise in choose_exercises(only).values():
        for number, variant in enumerate(dealing.variants(exercise.name)):
            is_sample, tries = number % 16 == 0, list_answers(exercise, variant)
            yield {
                "name": f"{exercise.name} {number:02}: {exercise.title}",
                "languages": ["en", *LANGUAGES] if is_sample else ["en"],
                "tries": [each for each in tries if is_sample or each["what"] in ALWAYS],
            }


def list_answers(exercise, variant):
    """Yield what is typed: the right answer, those of mistakes, and what gets no marks."""
    right = choose_row(exercise, variant)[1]
    single = len(exercise.unknowns) == 1
    unit = f" {exercise.unknowns[0].unit}" if single else ""

    def attempt(what, numbers, says="", behind=unit):
        texts = [x if isinstance(x, str) else f"{x:.9f}" for x in numbers]
        says = unescape(re.sub("<[^>]+>", "", render_symbols(says)))
        return {"what": what, "given": [text + behind for text in texts], "says": says}

    yield attempt("right", right, moodle.NUMBER_RIGHT if single else candidates.RIGHT)
    for candidate in variant.candidates:
        if candidate.name in {mistake.name for mistake in exercise.wrong}:
            feedback = candidates.outcomes(exercise)[candidate.name].feedback
            yield attempt("mistake", candidate.rows[0], feedback)
    if single:
        for word, size in moodle.unit_sizes(exercise.unknowns[0]).items():
            yield attempt("another unit", [right[0] * size], behind=f" {word}")
            if size != 1:
                yield attempt("wrong unit", right, behind=f" {word}")
        yield attempt("no unit", right, behind="")
    yield attempt("unknown unit" if single else "unit in a field", right, behind=" banana")
    persian = str.maketrans("0123456789.", "۰۱۲۳۴۵۶۷۸۹٫")
    yield attempt("Persian digits", [f"{x:.4f}".translate(persian) for x in right])
    yield attempt("copied minus", [f"{-x:.4f}".replace("-", "−") for x in right])
    yield attempt("brackets", [f"({x:.4f})" for x in right])


def take_pictures(server, asked):
    """Show three questions, wide and on a phone, from left to right and from right to left."""
    shown = [each for each in asked if each["name"].startswith(tuple(f"{n} 00" for n in PICTURES))]
    server = subprocess.Popen(list(map(str, server)), stderr=subprocess.DEVNULL)
    try:
        with sync_playwright() as playwright:
            program = shutil.which("chromium-headless-shell") or shutil.which("chromium")
            browser = playwright.chromium.launch(executable_path=program)
            for width in (1280, 390):
                page = browser.new_page(viewport={"width": width, "height": 900})
                for question in shown:
                    for language in question["languages"]:
                        show(page, question, language, f"{language}-{width}")
    finally:
        server.kill()


def show(page, question, language, name):
    """Answer a question with its first mistake, on a page of Moodle, and take its picture."""
    wrong = next(each for each in question["tries"] if each["what"] == "mistake")
    query = {"name": question["name"], "lang": language, "given[]": wrong["given"]}
    page.goto(f"http://{SITE}/shown?{urlencode(query, doseq=True)}", timeout=100_000)
    stem = question["name"].split()[0]
    page.locator(".que").screenshot(path=OUT / f"moodle-{stem}-{name}.png")


def print_table(results):
    """Print what came of each kind of answer, by language and by how it was handed in."""
    marks, named = Counter(), Counter()
    for row in results["found"]:
        mark = {0: "no marks", 1: "full marks"}.get(row["mark"], "a part")
        marks[row["what"], row["language"], row["behaviour"], mark] += 1
        if row["told"] is not None:
            named[row["what"], row["language"], row["told"]] += 1
        if row["what"] == "mistake" and row["told"] is False:
            print(f"not named: {row['name']} {row['given']} {row['language']}")
    print(f"Moodle {results['release']}: {results['questions']:,} questions")
    for key, count in sorted(marks.items()):
        print(f"{count:8,}  {', '.join(key)}")
    for (what, language, told), count in sorted(named.items()):
        print(f"{count:8,}  {what}, {language}, {'named' if told else 'not named'}")


if __name__ == "__main__":
    main(Path(sys.argv[1]).resolve(), sys.argv[2:])
