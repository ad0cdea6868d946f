"""The skeleton of a new chapter: `python -m courseware.new_chapter NAME`.

The files here are a small chapter that works, to be replaced piece by piece: one formula, function,
prediction, exercise and mistake, and figures. In them NAME is the chapter's name, SLUG the same
with hyphens, MISTAKE the next free number of a mistake, and `book` the course's package.
"""

from importlib.resources import files

from courseware.course import course
from courseware.errors import CourseError
from courseware.practice import all_mistakes


def write(name: str) -> str:
    """Write a chapter's folder, and return what to do next."""
    if not (name.isidentifier() and name.islower()):
        raise CourseError(f"{name!r} cannot name a module: use a-z, 0-9 and _, as in gear_train")
    folder = course().folder / name
    if any(path.name != "__pycache__" for path in folder.glob("*")):
        raise CourseError(f"{folder} exists: choose another name, or remove it")
    mistake = f"M{max((int(known.lstrip('M')) for known in all_mistakes()), default=0) + 1}"
    folder.mkdir(exist_ok=True)
    for template in files(__name__).iterdir():
        if template.name.endswith(".txt"):
            file = folder / template.name.removesuffix(".txt").replace("NAME", name)
            if file.name == "expected.py":
                file = course().folder.parent / "tests" / "expected" / f"{name}.py"
            text = template.read_text(encoding="utf-8").replace("NAME", name)
            text = text.replace("SLUG", name.replace("_", "-")).replace("MISTAKE", mistake)
            file.write_text(text.replace("book.", f"{course().package}."), encoding="utf-8")
    return (
        f"written: {folder}\n"
        f"Now add the line `- file: {name}/{name}` to _toc.yml, then: make notebooks T={name}, "
        f"make serve, make test T={name}"
    )
