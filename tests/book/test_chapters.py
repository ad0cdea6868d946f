"""The chapters' notebooks: one skeleton, code that a student could have typed, cells to try."""

import ast
import itertools
import re
import time

import nbformat
import pytest
from jupyter_client.manager import start_new_kernel
from stored_outputs import PLUMBING

import book  # noqa: F401 (opens the course)
from courseware.course import course
from courseware.practice import Exercise
from courseware.programs.program import all_programs

# in this order; between them come the steps, "1 …", "2 …"
BEFORE = ["Recall", "The exercise"]
AFTER = [
    *("As a function", "Where it fails", "Laboratory", "Your own figure", "Write it yourself"),
    *("Exercises", "Find the mistake", "Recap", "A glance further"),
]
OPTIONAL = {"Recall", "As a function", "Where it fails", "Find the mistake", "A glance further"}
FRAMEWORK = {"courseware", "book", "figures", "equations", "predictions", "practice", "show_source"}
CHECK = re.compile(r'^practice\.(\w+|program\(".*"\))\.check', re.M)  # that a student calls, too
LONGEST = 25  # visible lines of code in a section
LONGEST_FIGURE = 15  # lines of the function that draws it
PATIENCE = 60  # seconds at most for a cell to run
TAUGHT = course().taught
CHAPTERS = [chapter for chapter in TAUGHT if course().module(chapter, "exercises")]


class Section(list):
    """The cells of a notebook below a heading of the second level."""

    def __init__(self, title):
        super().__init__()
        self.title = title


def sections(chapter):
    """The sections of a chapter; the first is its opening, without a title."""
    found = [Section("")]
    for cell in nbformat.read(course().notebook(chapter), as_version=4).cells:
        if cell.cell_type == "markdown":
            found += [Section(title) for title in re.findall(r"^## (.*)", cell.source, re.M)]
        found[-1].append(cell)
    return found


def section(chapter, title):
    """The section of that title."""
    return next(each for each in sections(chapter) if each.title == title)


def tags(cell):
    return set(cell.metadata.get("tags", []))


def assert_tagged(cell, *wanted):
    missing = sorted({*wanted} - tags(cell))
    assert not missing, f"tag this cell {missing}, too: {cell.source}"


def code(cells):
    return [cell for cell in cells if cell.cell_type == "code"]


def visible(cells):
    """The code cells whose code is seen in JupyterLab."""
    return [cell for cell in code(cells) if not PLUMBING & tags(cell)]


def imports(chapter):
    """The first visible cell."""
    return visible(itertools.chain(*sections(chapter)))[0]


@pytest.mark.parametrize("chapter", CHAPTERS)
def test_sections_follow_the_skeleton(chapter):
    titles = [each.title for each in sections(chapter)][1:]
    steps = [title for title in titles if title not in BEFORE + AFTER]
    numbers = [title.partition(" ")[0] for title in steps]
    counted = [str(n) for n in range(1, len(steps) + 1)]
    assert numbers == counted, (
        f"number the steps, `## 1 …`, `## 2 …`, or name them as one of {BEFORE + AFTER}: {steps}"
    )
    left_out = OPTIONAL - set(titles)
    present = [title for title in (*BEFORE, *steps, *AFTER) if title not in left_out]
    assert titles == present, f"{chapter}.ipynb has the sections {titles}; it needs {present}"


@pytest.mark.parametrize("chapter", CHAPTERS)
def test_each_exercise_is_asked_in_its_own_chapter(chapter):
    source = "\n".join(cell.source for cell in code(itertools.chain(*sections(chapter))))
    homes = course().chapters_of("exercises", Exercise)
    declared = {name for name, home in homes.items() if home == chapter}
    missing = declared - set(re.findall(r'practice\.exercise\("([\w-]+)"', source))
    assert not missing, f"{chapter}.ipynb does not ask {missing}: `practice.exercise(…)`"


@pytest.mark.parametrize("chapter", TAUGHT)
def test_the_first_visible_cell_imports_and_nothing_else(chapter):
    for statement in ast.parse(imports(chapter).source).body:
        assert isinstance(statement, ast.Import | ast.ImportFrom), (
            f"move to a later cell of {chapter}.ipynb: {ast.unparse(statement)}"
        )


@pytest.mark.parametrize("chapter", TAUGHT)
def test_visible_code_is_the_students_own(chapter):
    for cell in visible(itertools.chain(*sections(chapter))):
        own = CHECK.sub("check", cell.source)
        used = names(ast.parse(own)) & FRAMEWORK
        assert not used, f"{used}: tag it `remove-input`, or write it without: {cell.source}"


def names(tree):
    """All names that code uses or imports, modules part by part."""
    found = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and not node.module.endswith(".functions"):
            found |= {node.module.partition(".")[0]}
        if isinstance(node, ast.Import):
            found |= {alias.name.partition(".")[0] for alias in node.names}
    return found


@pytest.mark.parametrize("chapter", TAUGHT)
def test_a_section_has_few_visible_lines(chapter):
    for each in sections(chapter):
        if each.title == "Write it yourself":
            continue  # a cell at a time, with its text between
        lines = sum(len(cell.source.splitlines()) for cell in visible(each))
        assert lines <= LONGEST, (
            f"{lines} lines of visible code in *{each.title}*, at most {LONGEST}: shorten them, or "
            "tag cells `hide-input`"
        )


# --- cells to try: Your own figure, Write it yourself ---------------------------------------------


class Kernel:
    """A kernel as JupyterLab has one: it runs cells, and moves their sliders."""

    def __init__(self):
        self.manager, self.client = start_new_kernel()

    def stop(self):
        self.client.stop_channels()
        self.manager.shutdown_kernel(now=True)

    def run(self, source):
        """The messages that a cell sends while it runs."""
        return self._until_idle(self.client.execute(source))

    def move(self, slider, value):
        """The messages that come when a slider is moved."""
        data = {"method": "update", "state": {"value": value}, "buffer_paths": []}
        content = {"comm_id": slider, "data": data}
        message = self.client.session.msg("comm_msg", content)
        self.client.shell_channel.send(message)
        return self._until_idle(message["header"]["msg_id"])

    def _until_idle(self, asked):
        end, found = time.monotonic() + PATIENCE, []
        while True:
            message = self.client.get_iopub_msg(timeout=max(0, end - time.monotonic()))
            if message["parent_header"].get("msg_id") != asked:
                continue
            found.append((message["msg_type"], message["content"]))
            if found[-1] == ("status", {"execution_state": "idle"}):
                return found


@pytest.fixture(scope="module")
def running():
    """One kernel for all chapters; to start one takes longer than most cells."""
    running = Kernel()
    yield running
    running.stop()


@pytest.fixture
def kernel(running):
    """The kernel, without the names of the test before."""
    assert not errors(running.run("%reset -f"))
    return running


def errors(messages):
    return [content["evalue"] for kind, content in messages if kind == "error"]


def pictures(messages):
    """The pictures that are shown, also inside a widget."""
    shown = [content["data"] for kind, content in messages if kind == "display_data"]
    for kind, content in messages:
        if kind == "comm_msg":
            outputs = content["data"].get("state", {}).get("outputs", ())
            shown += [output.get("data", {}) for output in outputs]
    return [data["image/png"] for data in shown if "image/png" in data]


def sliders(messages):
    """The sliders that appear: their names, values and ends."""
    for kind, content in messages:
        state = content.get("data", {}).get("state", {}) if kind == "comm_open" else {}
        if state.get("_model_name") in ("IntSliderModel", "FloatSliderModel"):
            yield content["comm_id"], state


@pytest.mark.parametrize("chapter", CHAPTERS)
def test_own_figure_moves_in_a_kernel(chapter, kernel):
    assert not errors(kernel.run(imports(chapter).source))
    *drawing, interactive = visible(section(chapter, "Your own figure"))
    assert_tagged(interactive, "interact", "skip-execution", "nbval-skip")
    (function,) = (
        part
        for cell in drawing
        for part in ast.parse(cell.source).body
        if isinstance(part, ast.FunctionDef)
    )
    lines = function.end_lineno - function.lineno + 1
    assert lines <= LONGEST_FIGURE, (
        f"`{function.name}` has {lines} lines, at most {LONGEST_FIGURE}: draw less"
    )
    still = [kernel.run(cell.source) for cell in drawing]
    assert not any(map(errors, still))
    assert any(map(pictures, still)), "its picture is on the page"
    started = kernel.run(interactive.source)
    assert not errors(started)
    slider, state = next(sliders(started))
    low, high = state["min"], state["max"]
    middle = type(low)((low + high) / 2)  # the ends may look alike
    shown = {state["value"]: pictures(started)}
    for value in {low, middle} - set(shown):
        moved = kernel.move(slider, value)
        assert not errors(moved)
        shown[value] = pictures(moved)
        assert shown[value], f"nothing is drawn at {state['description']} = {value}"
    assert shown[low] != shown[middle], f"the picture is the same at {low} and at {middle}"


@pytest.mark.parametrize("chapter", CHAPTERS)
def test_programs_wait_to_be_filled_in(chapter):
    """For each: what is asked, its starter, and the check, which the page has as a button."""
    programs = [p for p in all_programs().values() if p.topic == chapter]
    cells = code(section(chapter, "Write it yourself"))
    assert programs
    assert len(cells) == 3 * len(programs)
    for p, asked, starter, check in zip(
        programs, cells[::3], cells[1::3], cells[2::3], strict=True
    ):
        call, function = f'programs.show("{p.name}")', p.definition.name
        assert (asked.source, starter.source) == (call, p.starter.rstrip("\n"))
        assert check.source == f"{call}.check({function})"
        assert_tagged(asked, "remove-input")
        assert_tagged(starter, "skip-execution", "nbval-skip", f"program-{p.name}")
        assert_tagged(check, "skip-execution", "nbval-skip", "raises-exception", "remove-cell")
