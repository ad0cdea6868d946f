"""For all tests: how hypothesis draws, what is tried twice, what nbval's run also compares."""

import os

import pytest
from hypothesis import settings

settings.register_profile("robokin", deadline=None, derandomize=True, print_blob=True)
settings.load_profile("robokin")
pytest.register_assert_rewrite("browser", "test_ninth_chapter")  # what tests import from others


@pytest.hookimpl(tryfirst=True)  # before the workers of xdist look at the groups
def pytest_collection_modifyitems(items):
    """The order of the tests, and which stay together in one worker.

    A file's tests do, with what they share, as a notebook's cells with their kernel; those with a
    browser go one by one to the next free worker. Two workers build two sites at once: what has a
    tree of its own comes first, then what needs the course's site, and last what fills every gap.

    On CI, a machine that others load, a test with a browser has a second try, and is named then:
    an unsteady test is a defect that is mended, but not by who changed something else.
    """
    items.sort(key=turn)
    for item in items:
        if not item.get_closest_marker("browser"):
            item.add_marker(pytest.mark.xdist_group(item.path.name))
        elif os.environ.get("CI"):
            item.add_marker(pytest.mark.flaky(reruns=1))


def turn(item):
    """When a test comes: first with its own tree, then with the site; last with a browser."""
    fixtures = getattr(item, "fixturenames", ())
    if item.get_closest_marker("browser"):
        return 3
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
