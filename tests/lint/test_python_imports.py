# SPDX-License-Identifier: MIT
"""Rooms and modules of the Python package import each other one way only."""

import ast
import re
from collections.abc import Iterator
from functools import cache
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest
from sources import ROOT, files, refuse

PACKAGE = ROOT / "python"
Modules = dict[str, ast.Module]  # by name


def name_of(path: Path) -> str:
    """As it is imported."""
    parts = path.relative_to(PACKAGE).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


@cache
def modules() -> Modules:
    """Those of the package."""
    return {
        name_of(path): ast.parse(path.read_text(encoding="utf-8"))
        for path in files(".py", folders=("python/pliant",))
    }


def named_modules(node: ast.AST) -> Iterator[list[str]]:
    """What an import may mean, the likeliest first: `from a import b` is a.b, or b of a."""
    if isinstance(node, ast.Import):
        yield from ([alias.name] for alias in node.names)
    elif isinstance(node, ast.ImportFrom):
        yield from ([f"{node.module}.{alias.name}", str(node.module)] for alias in node.names)


def named_in_text(node: ast.AST) -> Iterator[list[str]]:
    """A module whose name is written as text is looked up when it is used."""
    yield from named_modules(node)
    if isinstance(node, ast.Constant) and str(node.value).startswith("pliant."):
        yield [node.value]


def graph(of: Modules, named=named_modules) -> dict[str, set[str]]:
    """Each module, and which others it imports: in functions and for type checkers, too; the
    extension stands below all."""
    known = {*of, "pliant._core"}
    return {
        name: {
            one
            for node in ast.walk(tree)
            for names in named(node)
            for one in [name for name in names if name in known][:1]
        }
        - {name}
        for name, tree in of.items()
    }


def circle(needs: dict[str, set[str]]) -> str:
    """A circle as text; empty if there is none."""
    try:
        TopologicalSorter(needs).prepare()
    except CycleError as error:
        return " imports ".join(reversed(error.args[1]))
    return ""


def test_imports_make_no_circle():
    assert circle(graph(modules())) == ""


def test_a_circle_would_be_found():
    texts = {
        "p": "from p.a import one",
        "p.a": "def f():\n    from p import b",
        "p.b": "if TYPE_CHECKING:\n    import p",
    }
    needs = graph({name: ast.parse(text) for name, text in texts.items()})
    assert needs == {"p": {"p.a"}, "p.a": {"p.b"}, "p.b": {"p"}}
    assert circle(needs) in {
        "p imports p.a imports p.b imports p",
        "p.a imports p.b imports p imports p.a",
        "p.b imports p imports p.a imports p.b",
    }


ROW = re.compile(r"^\| `(\w+)` \| [^|]+ \| ([a-z, ]*)\|$", re.MULTILINE)
DOOR = "the door"  # pliant itself, and what lies beside the rooms
#: what goes against the table, and why
EXCEPTIONS = {
    "adapters imports pliant.checks.force_field.export": "convert --to",
    "trajectory imports pliant.adapters": "what has frames gives them to other packages",
    "trajectory imports pliant.adapters.convert.write": "HasFrames.save",
    "trajectory imports pliant.play.view": "HasFrames.view",
    "trajectory imports pliant.play.widget": "the type of what it returns",
    "trajectory imports pliant.report.suite": "HasFrames.analyse",
}


@cache
def rooms() -> dict[str, set[str]]:
    """Which others each room may import, by the table of CONTRIBUTING.md, the lowest first."""
    rows = ROW.findall((ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8"))
    return {name: set(text.replace(",", " ").split()) for name, text in rows}


@cache
def rights() -> dict[str, set[str]]:
    """The same with the extension, which stands below, and the door, which brings all together."""
    table = {name: {name, "_core", *others} for name, others in rooms().items()}
    every = {DOOR, "_core", *table}
    return table | {"lab": every, DOOR: every - {"lab"}}


def room_of(name: str) -> str:
    """`pliant.report.study` is of `report`."""
    part = name.removeprefix("pliant.").partition(".")[0]
    return part if part in rooms() or part == "_core" else DOOR


def against_the_table(of: Modules) -> set[str]:
    """One text for each import of a module by a room that may not."""
    return {
        f"{room_of(name)} imports {other}"
        for name, others in graph(of, named_in_text).items()
        for other in others
        if room_of(other) not in rights()[room_of(name)]
    }


def test_the_table_has_every_room_and_goes_one_way():
    folders = {path.parent.name for path in (PACKAGE / "pliant").glob("*/__init__.py")}
    assert {*rooms(), "tests"} == folders
    above: set[str] = set()
    for name, others in rooms().items():
        assert others <= above or (name, others) == ("lab", {"all"}), name
        above.add(name)


def test_rooms_import_as_the_table_says():
    found = against_the_table(modules())
    refuse(sorted(found - set(EXCEPTIONS)))
    assert set(EXCEPTIONS) - found == set(), "an exception that is none any more"


@pytest.mark.parametrize(
    ("name", "text", "found"),
    [
        ("pliant.base.a", "from pliant._core import Error", set()),
        ("pliant.report.a", "from pliant.measure import b", set()),
        ("pliant.measure.b", "import pliant.report.a", {"measure imports pliant.report.a"}),
        ("pliant.base.a", 'later("pliant.report.a")', {"base imports pliant.report.a"}),
        ("pliant.report.b", "import pliant", {"report imports pliant"}),
        ("pliant.lab.a", "import pliant", set()),
        ("pliant", "from pliant.lab import a", {"the door imports pliant.lab.a"}),
    ],
)
def test_an_import_against_the_table_would_be_found(name, text, found):
    there = ("pliant", "pliant.report.a", "pliant.measure.b", "pliant.lab.a")
    empty = {one: ast.parse("") for one in there}
    assert against_the_table(empty | {name: ast.parse(text)}) == found


MOST_IN_FUNCTIONS = 36


def imports_in_functions(tree: ast.AST) -> int:
    """How many there are; those of a function in a function count once."""
    return len(
        {
            node
            for function in ast.walk(tree)
            if isinstance(function, ast.FunctionDef | ast.AsyncFunctionDef)
            for node in ast.walk(function)
            if isinstance(node, ast.Import | ast.ImportFrom)
        }
    )


def test_few_imports_hide_in_functions():
    """One that is not needed for a package that may be missing belongs at the top."""
    assert sum(map(imports_in_functions, modules().values())) <= MOST_IN_FUNCTIONS
    assert imports_in_functions(ast.parse("import a\ndef f():\n  def g():\n    import b")) == 1
