# SPDX-License-Identifier: MIT
"""Modules of the Python package import each other one way only."""

import ast
from collections.abc import Iterator
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

from sources import ROOT, files

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


def test_what_people_call_needs_no_bench_nor_experiment():
    wrong = [
        f"{name} imports {other}"
        for name, others in import_graph().items()
        for other in others
        if not name.startswith("pliant.lab.")
        and other.startswith(("pliant.lab.bench", "pliant.lab.experiment"))
    ]
    assert wrong == []


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
