"""For all tests: how hypothesis draws, what is tried twice, what nbval's run also compares."""

import os

import pytest
from hypothesis import settings

settings.register_profile("robokin", deadline=None, derandomize=True, print_blob=True)
settings.load_profile("robokin")
pytest.register_assert_rewrite("browser", "test_ninth_chapter")  # what tests import from others


def pytest_collection_modifyitems(items):
    """Two workers take file by file: first what has a tree and builds a site of its own, while the
    other builds the course's, then what needs that, and last the many that fill the gaps.

    On CI, a machine that others load, a test with a browser has a second try, and is named then:
    an unsteady test is a defect that is mended, but not by who changed something else.
    """
    items.sort(key=lambda item: turn(getattr(item, "fixturenames", ())))
    if os.environ.get("CI"):
        for item in items:
            if item.get_closest_marker("browser"):
                item.add_marker(pytest.mark.flaky(reruns=1))


def turn(fixtures):
    """Where a test with these fixtures comes: first, in the middle or last."""
    return 0 if "tree" in fixtures else 1 if "site" in fixtures else 2


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call(item):
    """After a cell of a notebook: the outputs as they are stored, pictures too, and the computed
    numbers of the prose that follows it."""
    result = yield
    if type(item).__name__ == "IPyNbCell":
        import stored  # here, because other tests do not need it

        told = [stored.different(item.cell, item.test_outputs)]
        for number, cell in stored.prose_after(item.parent.nb, item.cell):
            told.append(stale_prose(item, cell, f"{item.path.name}, cell {number}"))
        if any(told):
            item.raise_cell_error("\n".join(filter(None, told)))
    return result


def stale_prose(item, cell, where):
    """What is wrong with a cell's computed numbers; the kernel stands where its reader does."""
    import prose

    reply = item.parent.kernel.kc.execute(
        "",
        silent=True,
        user_expressions=prose.questions(cell, item.path.stem),
        reply=True,
        timeout=60,
    )
    try:
        fresh = prose.filled(cell, where, reply["content"]["user_expressions"])
    except prose.ProseError as error:
        return str(error)
    if fresh == cell.source:
        return ""
    pairs = zip(cell.source.splitlines(), fresh.splitlines(), strict=True)
    lines = [f"stored: {old}\nfresh:  {new}" for old, new in pairs if old != new]
    return "\n".join([f"{where}: numbers in the text are stale: run `make notebooks`", *lines])
