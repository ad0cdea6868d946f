"""What the first page offers: two zips for use without a network, the book and a poster on paper.

`robokin-kit.zip` holds `book/_kit`, the notebooks numbered as the chapters, the wheels and the list
of packages. `robokin-site.zip` holds every page that needs no server. The PDFs are in both the
site and its zip if `make paper` has written them; the first page links them with `{only} paper`.
Equal books give equal bytes.
"""

from pathlib import Path
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from courseware.run.page import wheel_name

KIT = Path(__file__).parents[1] / "_kit"
PAPER = (
    "robokin.pdf",
    "robokin-without-answers.pdf",
    "robokin-poster-A4.pdf",
    "robokin-poster-A2.pdf",
)
# JupyterLite needs a server; names with a dot belong to the build
LEFT_OUT = ("lite/", "robokin-site.zip", ".")


def offer_paper(app, config):
    """Take the PDFs into the site, and have the first page link them."""
    files = [Path(app.outdir).parent / name for name in PAPER]
    if all(map(Path.is_file, files)):
        app.tags.add("paper")
        config.html_extra_path = list(map(str, files))


def write_zip(target, files):
    """Write a zip of files, by their names in it, in a folder of its own name."""
    with ZipFile(target, "w") as archive:
        for name in sorted(files):
            entry = ZipInfo(f"{target.stem}/{name}")  # its date is always the same
            entry.compress_type, entry.external_attr = ZIP_DEFLATED, 0o644 << 16
            archive.writestr(entry, files[name].read_bytes())


def number_notebooks(env):
    """Return the notebooks by names with the numbers of their pages, 00 for one without."""
    found = {}
    for page in env.found_docs:
        file = Path(env.doc2path(page))
        if file.suffix == ".ipynb":
            (number, *_) = env.toc_secnumbers.get(page, {}).get("", (0,))
            found[f"notebooks/{number:02}-{file.name}"] = file
    return found


def list_kit(app):
    """Return the files of the kit by their names in it."""
    beside = Path(app.outdir) / "_sources"
    wheels = map(wheel_name, app.config.course_wheels)
    lock = Path(app.config.course_lock).name
    return {
        **{file.name: file for file in KIT.glob("*.*")},
        **{f"wheels/{name}": beside / name for name in wheels},
        **number_notebooks(app.env),
        lock: beside / lock,
    }


def list_site(folder):
    """Return the files of the site that need no server, by their names."""
    names = ((file.relative_to(folder).as_posix(), file) for file in folder.rglob("*"))
    kept = ((name, f) for name, f in names if name == ".nojekyll" or not name.startswith(LEFT_OUT))
    return {name: file for name, file in kept if file.is_file()}


def write_zips(app, error):
    """Write both, the kit first: the site holds it."""
    if error or app.builder.name != "html":
        return
    folder = Path(app.outdir)
    write_zip(folder / "robokin-kit.zip", list_kit(app))
    write_zip(folder / "robokin-site.zip", list_site(folder))


def setup(app):
    """Register with Sphinx, after everything that writes into the site."""
    app.connect("config-inited", offer_paper)
    app.connect("build-finished", write_zips, priority=999)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
