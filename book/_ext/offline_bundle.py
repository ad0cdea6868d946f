"""Two zips in the site: the notebooks with all that they need, and the site itself.

`robokin-kit.zip` holds `book/_kit`, the notebooks numbered as the chapters, the wheels and the list
of packages. `robokin-site.zip` is for a disk or a stick: every page but what needs a server,
and the book as PDF and EPUB if `make paper` has made them, because the first page links them.
The same book gives the same bytes.
"""

from pathlib import Path
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from courseware.site.assets import wheel_name

KIT = Path(__file__).parents[1] / "_kit"
# JupyterLite and Python in the page need a server; names with a dot are the build's own
LEFT_OUT = ("lite/", "_static/python/", "robokin-site.zip", ".")


def write_zip(target, files):
    """A zip of the files, by their names in it, in a folder of its own name."""
    target.unlink(missing_ok=True)
    with ZipFile(target, "w") as archive:
        for name in sorted(files):
            entry = ZipInfo(f"{target.stem}/{name}")  # its date is always the same
            entry.compress_type, entry.external_attr = ZIP_DEFLATED, 0o644 << 16
            archive.writestr(entry, files[name].read_bytes())


def notebooks(env):
    """The notebooks of the book, numbered as on the pages; 00 is what has no number."""
    found = {}
    for page in env.found_docs:
        file = Path(env.doc2path(page))
        if file.suffix == ".ipynb":
            (number, *_) = env.toc_secnumbers.get(page, {}).get("", (0,))
            found[f"notebooks/{number:02}-{file.name}"] = file
    return found


def kit_files(app):
    """What stands in the kit."""
    beside = Path(app.outdir) / "_sources"
    wheels = map(wheel_name, app.config.course_wheels)
    lock = Path(app.config.course_lock).name
    return {
        **{file.name: file for file in KIT.glob("*.*")},
        **{f"wheels/{name}": beside / name for name in wheels},
        **notebooks(app.env),
        lock: beside / lock,
    }


def site_files(folder):
    """All of the site that works without a server."""
    names = ((file.relative_to(folder).as_posix(), file) for file in folder.rglob("*"))
    kept = ((name, f) for name, f in names if name == ".nojekyll" or not name.startswith(LEFT_OUT))
    return {name: file for name, file in kept if file.is_file()}


def write(app, error):
    """The kit first: the site holds it."""
    if error or app.builder.name != "html":
        return
    folder = Path(app.outdir)
    write_zip(folder / "robokin-kit.zip", kit_files(app))
    write_zip(folder / "robokin-site.zip", site_files(folder))


def setup(app):
    """Called by Sphinx; after all that writes into the site."""
    app.connect("build-finished", write, priority=999)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
