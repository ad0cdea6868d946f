"""Copies of the notebooks for Colab, which has no environment of the course.

    python tools/colab_copies.py       into _build/hosted, from the site that `make book` has built

Each copy is the notebook with one cell before all others, which installs the course there and does
nothing elsewhere. Beside them stand the wheels that it installs. The folder is the branch `hosted`
of the repository: `.github/workflows/hosted.yml` puts it there.
"""

import shutil
import sys
from pathlib import Path

import nbformat
import yaml

ROOT = Path(__file__).parents[1]
BUILT = ROOT / "_build" / "html" / "_sources"
HOSTED = ROOT / "_build" / "hosted"
CELL = """\
# On Colab this installs the course; elsewhere it does nothing.
import sys

if "google.colab" in sys.modules:
    %pip install --quiet {wheels}"""


def installing(address, wheels):
    """The first cell. address: where the wheels are to be had."""
    extras = {"robokin": "[draw]"}
    asked = (
        f'"{(name := wheel.partition("-")[0]).replace("_", "-")}{extras.get(name, "")}'
        f' @ {address}/{wheel}"'
        for wheel in wheels
    )
    return CELL.format(wheels=" ".join(asked))


def copy_all(address, folder):
    """All notebooks and the wheels, in a folder that is made anew."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    wheels = sorted(BUILT.glob("*.whl"))
    for wheel in wheels:
        shutil.copy(wheel, folder)
    first = installing(address, [wheel.name for wheel in wheels])
    for file in sorted(BUILT.glob("*/*.ipynb")):
        notebook = nbformat.read(file, as_version=4)
        cell = nbformat.v4.new_code_cell(first, id="install")
        notebook.cells.insert(0, cell)
        nbformat.write(notebook, folder / file.name)


def main():
    settings = yaml.safe_load((ROOT / "_config.yml").read_text("utf-8"))
    url = settings["repository"]["url"].removesuffix(".git").rstrip("/")
    if not url:
        print("no copies: the repository's url in _config.yml is empty")
        return 0
    copy_all(f"{url}/raw/hosted", HOSTED)
    print(f"the copies are in {HOSTED}: put them on the branch `hosted`")
    return 0


if __name__ == "__main__":
    sys.exit(main())
