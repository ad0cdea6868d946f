"""Copies of the notebooks for Colab, which lacks the packages of the course.

    python tools/colab_copies.py       into _build/hosted, from the site that `make book` has built

A first cell in each copy installs the course on Colab and does nothing elsewhere. Its wheels are in
the same folder. `.github/workflows/hosted.yml` makes it the branch `hosted`.
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


def make_first_cell(address, wheels):
    """Return the source of the first cell. address: of the folder with the wheels."""
    extras = {"robokin": "[draw]"}
    requirements = (
        f'"{(name := wheel.partition("-")[0]).replace("_", "-")}{extras.get(name, "")}'
        f' @ {address}/{wheel}"'
        for wheel in wheels
    )
    return CELL.format(wheels=" ".join(requirements))


def copy_all(address, folder):
    """Write all notebooks and the wheels into a new folder."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    wheels = sorted(BUILT.glob("*.whl"))
    for wheel in wheels:
        shutil.copy(wheel, folder)
    first = make_first_cell(address, [wheel.name for wheel in wheels])
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
