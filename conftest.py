"""nbval runs each notebook once; from the same run comes what nbval itself does not compare."""

import pytest


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call(item):
    """After a cell of a notebook: the outputs as they are stored, pictures too, and the computed
    numbers of the prose that follows it."""
    result = yield
    if type(item).__name__ == "IPyNbCell":
        from tools import notebooks  # here, because other tests do not need what it imports

        told = [notebooks.different(item.cell, item.test_outputs)]
        for number, cell in notebooks.prose_after(item.parent.nb, item.cell):
            told.append(stale_prose(item, cell, f"{item.path.name}, cell {number}"))
        if any(told):
            item.raise_cell_error("\n".join(filter(None, told)))
    return result


def stale_prose(item, cell, where):
    """What is wrong with a cell's computed numbers; the kernel stands where its reader does."""
    from tools import prose

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
