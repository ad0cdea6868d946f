"""The library's own tests by the Python of a browser, whose integers have 32 bits.

It runs in Node, which has Chromium's engine.
"""

import json
import os
import subprocess
import sys
from importlib.metadata import version
from pathlib import Path

import pyodide
import pytest
from support import ROOT

NEEDED = ("pytest", "pluggy", "iniconfig", "packaging", "pygments", "hypothesis")
NEEDED += ("sortedcontainers", "sympy", "mpmath")
HERE = Path(__file__).parent
OTHERS = ("test_api.py", "test_draw.py", Path(__file__).name)  # need the repository, Matplotlib
TESTS = [file for file in sorted(HERE.glob("test_*.py")) if file.name not in OTHERS]


@pytest.mark.install
def test_the_library_passes_its_tests_in_the_python_of_a_browser(tmp_path):
    """The wheel that is under test; an oracle that is not to be had is named in what it prints."""
    if missing := pyodide.missing(("numpy",)):
        pytest.skip(f"needs {missing[0]}, which only the public address of Pyodide has")
    pip = [sys.executable, "-m", "pip", "install", "--quiet", "--no-deps"]
    pip += ["--target", str(tmp_path)]
    pip += ["--only-binary", ":all:", "--python-version", "3.14", "--platform", "any"]
    pip += ["--platform", "pyemscripten_2026_0_wasm32"]
    subprocess.run([*pip, *(f"{name}=={version(name)}" for name in NEEDED)], check=True)
    oracles = [] if pyodide.missing(("scipy",)) else ["scipy"]
    absent = ["courseware.script.widget", "py_mini_racer", *({"scipy"} - set(oracles))]
    library = os.environ.get("ROBOKIN_UNDER_TEST", str(ROOT))
    paths = [library, str(ROOT), str(ROOT / "tests"), str(HERE), str(tmp_path)]
    settings = {
        "python": str(pyodide.had()),
        "lock": pyodide.with_hashes((pyodide.had() / pyodide.LOCK).read_text("utf-8"), here=True),
        "packages": ["numpy", *oracles],
        "folders": [str(ROOT), str(tmp_path)],
        "program": str(HERE / "in_pyodide.py"),
        "asked": [str(ROOT), paths, absent, [str(file) for file in TESTS]],
    }
    command = ["node", str(ROOT / "tests" / "pyodide.mjs")]
    run = subprocess.run(command, input=json.dumps(settings), capture_output=True, text=True)
    print(run.stdout[-500:])
    assert run.returncode == 0, run.stdout + run.stderr
