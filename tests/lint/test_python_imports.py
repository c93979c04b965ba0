# SPDX-License-Identifier: MIT
"""Modules of the Python package import each other one way only."""

import ast
import re
from collections.abc import Iterator
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

from sources import ROOT, files, numbered_lines, place, refuse

PACKAGE = ROOT / "python"


def name_of(path: Path) -> str:
    """As it is imported."""
    parts = path.relative_to(PACKAGE).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def named_modules(node: ast.AST) -> Iterator[list[str]]:
    """What an import may mean, the likeliest first: `from a import b` is a.b, or b of a."""
    if isinstance(node, ast.Import):
        yield from ([alias.name] for alias in node.names)
    elif isinstance(node, ast.ImportFrom):
        yield from ([f"{node.module}.{alias.name}", str(node.module)] for alias in node.names)


def imports(tree: ast.AST, known: set[str]) -> set[str]:
    """Modules of ours, wherever it imports them: in functions and for type checkers, too."""
    found = set()
    for node in ast.walk(tree):
        for names in named_modules(node):
            found.update([name for name in names if name in known][:1])
    return found


def import_graph() -> dict[str, set[str]]:
    """Each module of ours, and which others it imports; the extension stands below all."""
    trees = {
        name_of(path): ast.parse(path.read_text(encoding="utf-8"))
        for path in files(".py", folders=("python/pliant",))
    }
    known = {*trees, "pliant._core"}
    return {name: imports(tree, known) - {name} for name, tree in trees.items()}


def circle(graph: dict[str, set[str]]) -> str:
    """A circle as text; empty if there is none."""
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        return " imports ".join(reversed(error.args[1]))
    return ""


def test_imports_make_no_circle():
    assert circle(import_graph()) == ""


LABORATORY = "pliant.lab"


def is_of(package: str, name: str) -> bool:
    return name == package or name.startswith(package + ".")


def needs_of_the_laboratory(graph: dict[str, set[str]]) -> list[str]:
    """What imports the laboratory from outside it."""
    return [
        f"{name} imports {other}"
        for name, others in graph.items()
        for other in sorted(others)
        if is_of(LABORATORY, other) and not is_of(LABORATORY, name)
    ]


def test_the_product_does_not_stand_on_its_laboratory():
    assert needs_of_the_laboratory(import_graph()) == []


def test_a_need_of_the_laboratory_would_be_found():
    graph = {"pliant.check": {"pliant.lab"}, "pliant.lab.bench": {"pliant.lab.peers"}}
    assert needs_of_the_laboratory(graph) == ["pliant.check imports pliant.lab"]


def test_the_product_does_not_name_its_laboratory():
    refuse(
        [
            f"{place(path, number)}: names {LABORATORY}"
            for path in files(".py", folders=("python/pliant",))
            if not is_of(LABORATORY, name_of(path))
            for number, line in numbered_lines(path)
            if re.search(re.escape(LABORATORY) + r"\b", line)
        ]
    )


def test_a_circle_would_be_found():
    texts = {
        "p": "from p.a import one",
        "p.a": "def f():\n    from p import b",
        "p.b": "if TYPE_CHECKING:\n    import p",
    }
    graph = {name: imports(ast.parse(text), set(texts)) for name, text in texts.items()}
    assert graph == {"p": {"p.a"}, "p.a": {"p.b"}, "p.b": {"p"}}
    assert circle(graph) in {
        "p imports p.a imports p.b imports p",
        "p.a imports p.b imports p imports p.a",
        "p.b imports p imports p.a imports p.b",
    }
