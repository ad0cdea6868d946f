"""Import the questions into a real Moodle and answer them there.

    python tools/moodle_server.py FOLDER [EXERCISE …]

FOLDER holds Moodle's own code. Moodle is installed into a PostgreSQL of its own. It imports the
questions and gets answers through its question engine: right ones, mistakes, with units. It needs
postgresql and PHP with the extensions for Moodle (on Debian: php-cli php-pgsql php-intl php-xml
php-mbstring php-curl php-zip php-gd php-soap). Everything is removed afterwards.
"""

import json
import os
import re
import subprocess
import sys
import tempfile
from collections import Counter
from html import unescape
from pathlib import Path

from classroom import moodle
from classroom.answer_key import choose_exercises
from courseware.practice import candidates, dealing
from courseware.practice.formatting import render_symbols

PORT = 5432  # the name of a socket in a folder of its own: nothing listens on the network
CONFIG = """<?php
$CFG = new stdClass();
$CFG->dbtype = 'pgsql';
$CFG->dblibrary = 'native';
$CFG->dbhost = 'localhost';
$CFG->dbname = $CFG->dbuser = 'moodle';
$CFG->dbpass = '';
$CFG->prefix = 'm_';
$CFG->dboptions = ['dbport' => {port}, 'dbsocket' => '{socket}'];
$CFG->wwwroot = 'http://localhost';
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
        data.mkdir()
        database.mkdir()
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
            config.write_text(CONFIG.format(port=PORT, socket=place, data=data))
            php = ("php", "-d", "max_input_vars=5000", "-d", "memory_limit=2G")
            install = ("--agree-license", "--adminpass=Pass-w0rd", "--fullname=t", "--shortname=t")
            run(*php, folder / "admin/cli/install_database.php", *install)
            quiz, answers = place / "quiz.xml", place / "answers.json"
            moodle.write(quiz, only)
            answers.write_text(json.dumps([*list_questions(only)]))
            here = Path(__file__).with_suffix(".php")
            output = run(*php, here, folder, quiz, answers)
        finally:
            config.unlink(missing_ok=True)
            run(*other, *start, "-m", "fast", "stop", cwd=place)
    print_table(
        json.loads(next(line for line in output.splitlines() if line.startswith('{"imported')))
    )


def list_questions(only):
    """Yield each question with its answers and the expected feedback."""
    for exercise in choose_exercises(only).values():
        for number, variant in enumerate(dealing.variants(exercise.name)):
            tries = [*list_answers(exercise, variant)]
            name = f"{exercise.name} {number:02}: {exercise.title}"
            yield {"exercise": exercise.name, "name": name, "tries": tries}


def list_answers(exercise, variant):
    """Yield the right answer, those of mistakes, and the right one with its units."""
    known = {"right", *(mistake.name for mistake in exercise.wrong)}
    for candidate in (c for c in variant.candidates if c.name in known):
        given = [f"{x:.6f}" for x in candidate.rows[0]]
        if exercise.accept != "one":
            given = [exercise.format_rows(candidate.rows)]
        says = render_symbols(candidates.outcomes(exercise)[candidate.name].feedback)
        says = unescape(re.sub("<[^>]+>", "", says))
        if exercise.accept != "any" or candidate in first_candidates(variant):
            yield {"what": candidate.name, "given": given, "says": says}
    if exercise.accept == "one" and len(exercise.unknowns) == 1:
        right = variant.candidates[0].rows[0][0]
        for unit, factor in moodle.unit_factors(exercise.unknowns[0]).items():
            given = [f"{right * factor:.6f} {unit}"]
            yield {"what": f"right in {unit}", "given": given, "says": candidates.RIGHT}


def first_candidates(variant):
    """Return the first answer of each name, which is among the choices."""
    return {c.name: c for c in reversed(variant.candidates)}.values()


def print_table(results):
    """Print counts: questions, right answers with full marks, mistakes without, named ones."""
    right, wrong = Counter(), Counter()
    for row in results["found"]:
        if row["what"] == "tries":
            right[f"{row['mark']} tries when interactive"] += 1
        elif row["what"].startswith("right"):
            kind = re.sub(" in .*", " with a unit", row["what"])
            right[f"{kind}: mark {row['mark']:.2f}"] += 1
        else:
            wrong["full marks" if row["mark"] > 0.999 else "no full marks"] += 1
            wrong["named" if row["told"] else "not named"] += 1
            if not row["told"]:
                wrong[f"  not named: {row['exercise']} {row['what']}"] += 1
    print(f"imported: {results['imported']}, {results['questions']:,} questions")
    for counts in (right, wrong):
        for what, count in sorted(counts.items()):
            print(f"{count:8,}  {what}")


if __name__ == "__main__":
    main(Path(sys.argv[1]).resolve(), sys.argv[2:])
