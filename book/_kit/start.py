"""Start the notebooks: `python start.py`. The first time it sets up the folder .venv beside it.

What follows the name goes to JupyterLab: `python start.py --no-browser`.
"""

import os
import subprocess
import sys
import venv
from pathlib import Path

HERE = Path(__file__).resolve().parent
ENVIRONMENT = HERE / ".venv"
PYTHON = ENVIRONMENT / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
PACKAGES = HERE / "packages"  # what the network would give, if somebody put it there
READY = ENVIRONMENT / "ready"
MADE_BY = f"{sys.base_prefix} {sys.version_info[0]}.{sys.version_info[1]}"  # set up by this Python
# what other projects have set would change what is installed here, and what runs
OTHERS = ("PIP_PREFIX", "PIP_REQUIRE_HASHES", "PIP_TARGET", "PIP_USER", "MPLBACKEND")
OTHERS += ("PYTHONHOME", "PYTHONOPTIMIZE", "PYTHONPATH", "PYTHONWARNINGS")


def set_up():
    """An environment with the packages of the list, each as its hash says, and the course."""
    print("Setting up, once: loading 110 MB, which become 600 MB on the disk.", flush=True)
    venv.create(ENVIRONMENT, clear=True, with_pip=True, symlinks=os.name != "nt")
    pip = [str(PYTHON), "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    source = ["--no-index", "--find-links", str(PACKAGES)] if PACKAGES.is_dir() else []
    wheels = sorted(map(str, HERE.glob("wheels/*.whl")))
    listed = str(HERE / "requirements-light.txt")
    subprocess.run([*pip, *source, "--require-hashes", "-r", listed], check=True)
    subprocess.run([*pip, "--no-index", "--no-deps", *wheels], check=True)
    READY.write_text(MADE_BY, "utf-8")


def main():
    if sys.version_info < (3, 11):  # noqa: UP036 - a reader's Python may be any
        sys.exit(f"Python 3.11 or newer is needed, this is {sys.version.split()[0]}: python.org")
    if os.pathsep in str(HERE):
        sys.exit(f"No environment can be made in a folder with {os.pathsep!r} in its path: {HERE}")
    for name in OTHERS:
        os.environ.pop(name, None)
    if not READY.exists() or READY.read_text("utf-8") != MADE_BY:
        try:
            set_up()
        except subprocess.CalledProcessError as error:
            sys.exit(f"The set-up failed, see above. Mend that and start again. ({error})")
    command = [str(PYTHON), "-m", "jupyterlab", *sys.argv[1:]]
    lab = subprocess.Popen(command, cwd=HERE / "notebooks")
    while True:
        try:
            return lab.wait()
        except KeyboardInterrupt:  # it has got that, too, and asks whether to stop
            pass


if __name__ == "__main__":
    sys.exit(main())
