"""For all tests: how hypothesis draws, what is tried twice, what nbval's run also compares."""

import os
import re

import pytest
from hypothesis import settings

settings.register_profile("robokin", deadline=None, derandomize=True, print_blob=True)
settings.load_profile("robokin")
# what tests import from others
pytest.register_assert_rewrite("browser", "figure_numbers", "figure_page", "test_new_chapter")


@pytest.hookimpl(wrapper=True)
def pytest_sessionstart(session):
    """Stop at a wrong declaration, once: nearly every test would fail for it.

    Workers, which are started first, look for their tests meanwhile.
    """
    yield
    config = session.config
    alone = r"benchmarks|tests/robokin|.*\.ipynb$"  # need no course, or say what is wrong
    if hasattr(config, "workerinput") or all(re.match(alone, each) for each in config.args):
        return
    import book  # noqa: F401 (opens the course)
    from courseware.course import CourseError, course
    from courseware.figures import Figure

    try:
        for part in ("checks", "exercises", "predictions", "programs"):
            course().modules(part)
        for figure in course().find_all("figures", Figure).values():
            _ = figure.compiled
    except CourseError as error:
        raise pytest.UsageError(str(error)) from None


@pytest.hookimpl(wrapper=True)
def pytest_runtest_setup(item):
    """A site that does not build is one failure; what else needs it is skipped."""
    try:
        return (yield)
    except Exception as error:
        if hasattr(error, "tell_once") and error.tell_once(item.nodeid) != item.nodeid:
            pytest.skip("the site does not build")
        raise


@pytest.hookimpl(trylast=True)  # of the tests that are left to run
def pytest_collection_modifyitems(items):
    """Two workers take file by file: one file that builds the site, meanwhile the notebooks, which
    do not need it, then what does, and last the many short ones that fill the gaps.

    On CI, a machine that others load, a test with a browser has a second try, and is named then:
    an unsteady test is a defect that is mended, but not by who changed something else.
    """
    builds = next((item.path for item in items if needs_site(item)), None)
    items.sort(key=lambda item: turn(item, builds))
    if os.environ.get("CI"):
        for item in items:
            if item.get_closest_marker("browser"):
                item.add_marker(pytest.mark.flaky(reruns=1))


def needs_site(item):
    """Whether a test needs the built site."""
    return "site" in getattr(item, "fixturenames", ())


def turn(item, builds):
    """When a test comes; builds: the file that comes first."""
    if item.path == builds:
        return 0
    return 1 if item.path.suffix == ".ipynb" else 2 if needs_site(item) else 3


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call(item):
    """After a cell of a notebook: the outputs as they are stored, pictures too, and the computed
    numbers of the prose that follows it."""
    result = yield
    if type(item).__name__ == "IPyNbCell":
        import stored_outputs  # here, because other tests do not need it

        told = [stored_outputs.describe_difference(item.cell, item.test_outputs)]
        for number, cell in stored_outputs.prose_after(item.parent.nb, item.cell):
            told.append(stale_prose(item, cell, f"{item.path.name}, cell {number}"))
        if any(told):
            item.raise_cell_error("\n".join(filter(None, told)))
    return result


def stale_prose(item, cell, where):
    """What is wrong with a cell's computed numbers; the kernel stands where its reader does."""
    import prose_numbers

    reply = item.parent.kernel.kc.execute(
        "",
        silent=True,
        user_expressions=prose_numbers.kernel_expressions(cell, item.path.stem),
        reply=True,
        timeout=60,
    )
    try:
        fresh = prose_numbers.fill_numbers(cell, where, reply["content"]["user_expressions"])
    except prose_numbers.ProseError as error:
        return str(error)
    if fresh == cell.source:
        return ""
    pairs = zip(cell.source.splitlines(), fresh.splitlines(), strict=True)
    lines = [f"stored: {old}\nfresh:  {new}" for old, new in pairs if old != new]
    return "\n".join([f"{where}: numbers in the text are stale: run `make notebooks`", *lines])
