"""Python for the browser where its public address cannot be reached: that host alone is answered.

Its own files come from the npm package of the same version, pure wheels from the package index. One
that is compiled for browsers (NumPy, Matplotlib, SciPy) is to be had only if somebody puts it into
`BY_HAND`, with its name in `book/_vendor/pyodide/pyodide-lock.json`; another version will do, if
Pyodide built it for the same `pyemscripten_…`. The list of packages is given the hashes of all
these. `missing()` names the rest: what needs it is not run, and that is said.
"""

import hashlib
import json
import re
import subprocess
import sys
import tarfile
from contextlib import suppress
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from urllib.error import URLError
from urllib.request import urlopen

from packaging.utils import canonicalize_name
from support import ROOT

LOCK = "pyodide-lock.json"
# imported by chapters and by JupyterLite's kernel
PACKAGES = (
    *("numpy", "pyyaml", "sympy", "matplotlib"),
    *("ipython", "jedi", "micropip", "typing-extensions"),
)

VERSION = "314.0.6"
PLACE = f"https://cdn.jsdelivr.net/pyodide/v{VERSION}/full/"
CACHE = ROOT / "_build" / f"pyodide-{VERSION}"
BY_HAND = CACHE.with_name("wheels")  # each with the name that the list of packages gives it
KINDS = {".mjs": "text/javascript", ".wasm": "application/wasm", ".json": "application/json"}


@cache
def reached():
    """Whether the public address answers here."""
    try:
        with urlopen(PLACE + LOCK, timeout=10):
            return True
    except (URLError, TimeoutError):
        return False


def with_dependencies(packages, names):
    """The names of packages and of all their dependencies."""
    found, wanted = set(), list(names)
    while wanted:
        name = canonicalize_name(wanted.pop())
        if name not in found:
            found.add(name)
            wanted += packages[name]["depends"]
    return sorted(found)


@cache
def packages(names=PACKAGES):
    """The entries of what is wanted and of what that needs."""
    lock = json.loads((ROOT / "book/_vendor/pyodide" / LOCK).read_text("utf-8"))
    return {name: lock["packages"][name] for name in with_dependencies(lock["packages"], names)}


def pure():
    """Those that are Python alone."""
    return {n: p for n, p in packages().items() if p["file_name"].endswith("-none-any.whl")}


def missing(names=PACKAGES):
    """Those that are not to be had, here."""
    return [] if reached() else [n for n, p in packages(names).items() if not wheel(p["file_name"])]


@cache
def had():
    """The folder with the files that are to be had, filled once."""
    if not CACHE.exists():
        CACHE.parent.mkdir(exist_ok=True)
        with TemporaryDirectory(dir=CACHE.parent) as name:
            fill(Path(name))
            with suppress(OSError):  # another worker was faster
                (Path(name) / "package").rename(CACHE)
    return CACHE


def fill(folder):
    """Put the files into its folder `package`."""
    pack = ["npm", "pack", "--silent", f"pyodide@{VERSION}"]
    subprocess.run(pack, cwd=folder, check=True, capture_output=True)
    with tarfile.open(folder / f"pyodide-{VERSION}.tgz") as archive:
        archive.extractall(folder, filter="data")
    pins = [f"{name}=={package['version']}" for name, package in pure().items()]
    pip = [sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "--platform", "any"]
    pip += ["--only-binary", ":all:", "--python-version", "3.14"]
    subprocess.run([*pip, "--dest", str(folder / "package"), *pins], check=True)


def wheel(file_name):
    """The file of a package: an index may write its name otherwise."""
    files = (*had().glob("*.whl"), *BY_HAND.glob("*.whl"))
    return next((f for f in files if plain(f.name) == plain(file_name)), None)


def plain(name):
    return re.sub(r"[-_.]+", "-", name.replace("py2.py3", "py3")).lower()


def with_hashes(text, here=False):
    """A list of packages with the hashes of what is to be had; here: and with where it lies."""
    lock = json.loads(text)
    for entry in lock["packages"].values():
        file = wheel(Path(entry["file_name"]).name)
        if file:
            entry["sha256"] = hashlib.sha256(file.read_bytes()).hexdigest()
            entry["file_name"] = str(file) if here else entry["file_name"]
    return json.dumps(lock)


def answer(context):
    """Let a browser's context reach Python; says how."""
    if reached():
        print(f"Python in the browser comes from {PLACE}: everything is run")
        return
    print(f"{PLACE} is not reached: not to be had are {', '.join(missing())}")
    context.route(f"{PLACE}**", lambda route: fulfil(route, Path(route.request.url)))
    context.route(f"**/lite/packages/{LOCK}", hashed)


def fulfil(route, address):
    """One file, or a refusal."""
    file = had() / address.name
    if address.suffix == ".whl":
        file = wheel(address.name)
    if file is None or not file.exists():
        route.abort()
        return
    kind = KINDS.get(address.suffix, "application/octet-stream")
    headers = {"content-type": kind, "access-control-allow-origin": "*"}
    text = with_hashes(file.read_text("utf-8")) if file.name == LOCK else ""
    route.fulfill(body=text or file.read_bytes(), headers=headers)


def hashed(route):
    """The course's own list of packages."""
    reply = route.fetch()
    route.fulfill(response=reply, body=with_hashes(reply.text()))
