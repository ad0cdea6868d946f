"""Write a chapter, the example's under a new name: `python -m courseware.new_chapter NAME`."""

import re
import sys
from pathlib import Path

from courseware.course import course
from courseware.practice import all_mistakes

EXAMPLE = Path(__file__).parent / "tests" / "booklet"
CHAPTER = "optics"  # a word that its texts never use


def write(name: str) -> None:
    """Write a chapter's files, and say what to do next."""
    if not (name.isidentifier() and name.islower()):
        sys.exit(f"{name!r} cannot name a module: use a-z, 0-9 and _, as in gear_train")
    folder = course().folder / name
    if any(path.name != "__pycache__" for path in folder.glob("*")):
        sys.exit(f"{folder} exists: choose another name, or remove it")
    last = max((int(known.lstrip("M")) for known in all_mistakes()), default=0)
    files = {path: folder / path.name for path in (EXAMPLE / CHAPTER).glob("*.[pi]*")}
    files[EXAMPLE / "expected.py"] = course().folder.parent / f"tests/expected/{CHAPTER}.py"
    for path, new in files.items():
        text = re.sub(r"\bM(\d)\b", lambda m: f"M{last + int(m[1])}", path.read_text("utf-8"))
        text = text.replace(f"{EXAMPLE.name}.{CHAPTER}", f"{course().package}.{name}")
        text = text.replace(f"{CHAPTER}-", f"{name.replace('_', '-')}-").replace(CHAPTER, name)
        new = new.with_name(new.name.replace(CHAPTER, name))
        new.parent.mkdir(parents=True, exist_ok=True)
        new.write_text(text, "utf-8")
    print(f"written: {folder}\nNow add the line `- file: {name}/{name}` to _toc.yml, then:")
    print(f"make notebooks T={name}, make serve, make test T={name}")


if __name__ == "__main__":
    write(sys.argv[1]) if len(sys.argv) == 2 else sys.exit(__doc__)
