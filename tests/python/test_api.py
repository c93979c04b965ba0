# SPDX-License-Identifier: MIT
"""The Python API under version control: names, signatures and docstrings.

``python tests/python/test_api.py`` writes the reference anew; its difference shows what changed.
"""

import ast
import difflib
import inspect
import re
from pathlib import Path

import pytest

import pliant

REFERENCE = Path(__file__).with_name("pliant.pyi.ref")
STUB = Path(pliant._core.__file__).with_name("_core.pyi")
TITLE = "# The Python API of Pliant; written by tests/python/test_api.py\n"
MOST_NAMES = 65  # each is a promise until the next major version
#: what is private, and what printing and pickling call
NOT_CALLED = re.compile(r"_[a-z]|__(repr|str|getstate|setstate)__")
SECTION = re.compile(r"\n(\w+)\n-+\n")


def stub_nodes():
    return [
        node
        for node in ast.parse(STUB.read_text()).body
        if isinstance(node, ast.ClassDef | ast.FunctionDef)
    ]


def signature(node):
    returns = f" -> {ast.unparse(node.returns)}" if node.returns else ""
    return f"def {node.name}({ast.unparse(node.args)}){returns}: ..."


def is_decorated(node, name):
    return any(ast.unparse(decorator).split(".")[-1] == name for decorator in node.decorator_list)


def member_line(node):
    """A property, a method or an enumerator on one line; empty for what is none of them."""
    if isinstance(node, ast.Assign):
        return ast.unparse(node)
    if not isinstance(node, ast.FunctionDef) or NOT_CALLED.match(node.name):
        return ""
    if is_decorated(node, "setter"):
        value = [*node.args.posonlyargs, *node.args.args][-1]
        return f"# {node.name} may be assigned {ast.unparse(value.annotation)}"
    if is_decorated(node, "property") or is_decorated(node, "cached_property"):
        return f"{node.name}: {ast.unparse(node.returns)}"
    return signature(node)


def lines_of(node):
    if isinstance(node, ast.FunctionDef):
        return [signature(node)]
    members = [line for member in node.body if (line := member_line(member))] or ["..."]
    head = f"class {node.name}({', '.join(map(ast.unparse, node.bases))}):"
    return ["", head, *(f"    {line}" for line in members)]


def python_functions():
    found = [getattr(pliant, name) for name in pliant.__all__]
    return [one for one in found if inspect.isfunction(one)]


def python_classes():
    """The nodes of classes written in Python, and of what they have from others."""
    found = [getattr(pliant, name) for name in pliant.__all__]
    written = {
        base: None
        for one in found
        if inspect.isclass(one)
        for base in reversed(one.__mro__)
        if base.__module__.startswith("pliant") and not hasattr(pliant._core, base.__name__)
    }
    return [node_of(one) for one in written]


def node_of(written):
    """Of a class: some say that they are of pliant itself, so it is looked for."""
    head = re.compile(rf"^class {written.__name__}\b", re.MULTILINE)
    for path in sorted(Path(pliant.__file__).parent.rglob("*.py")):
        text = path.read_text()
        if head.search(text):
            named = [node for node in ast.parse(text).body if isinstance(node, ast.ClassDef)]
            return next(node for node in named if node.name == written.__name__)
    raise AssertionError(written)


def promised_stubs(classes):
    """The nodes of what is compiled: promised, or the base of such a class."""
    bases = {ast.unparse(base).split(".")[-1] for node in classes for base in node.bases}
    return [node for node in stub_nodes() if node.name in {*pliant.__all__, *bases}]


def reference_text():
    functions = [ast.parse(inspect.getsource(function)).body[0] for function in python_functions()]
    classes = python_classes()
    names = ["# Names: " + " ".join(pliant.__all__), ""]
    nodes = [*functions, *classes, *promised_stubs(classes)]
    return "\n".join([TITLE, *names, *(line for node in nodes for line in lines_of(node)), ""])


def test_the_api_is_the_committed_one():
    expected = REFERENCE.read_text()
    found = reference_text()
    difference = difflib.unified_diff(
        expected.splitlines(), found.splitlines(), "committed", "found", lineterm=""
    )
    assert found == expected, "\n" + "\n".join(difference)


def test_everything_public_is_there():
    assert len(pliant.__all__) <= MOST_NAMES
    for name in pliant.__all__:
        assert getattr(pliant, name) is not None
    assert (Path(pliant.__file__).with_name("py.typed")).exists()


def test_pytest_takes_no_class_of_ours_for_tests():
    named = [name for name in vars(pliant._core) if name.startswith("Test")]
    assert "TestSet" in named
    assert all(getattr(pliant, name).__test__ is False for name in named)


def parameters_made_with(node):
    """Those of a class' constructor."""
    made = [m for m in node.body if isinstance(m, ast.FunctionDef) and m.name == "__init__"]
    return parameters_of(made[0])[1:] if made else []


def documented_members(node):
    for member in node.body:
        if not isinstance(member, ast.FunctionDef) or member.name.startswith("_"):
            continue
        if not is_decorated(member, "setter"):
            doc = ast.get_docstring(member) or ""
            is_bound = not is_decorated(member, "staticmethod")
            yield f"{node.name}.{member.name}", doc, parameters_of(member)[is_bound:]


def documented():
    """Name, documentation and names of parameters of what is public."""
    for function in python_functions():
        yield function.__name__, function.__doc__, list(inspect.signature(function).parameters)
    for node in [*python_classes(), *stub_nodes()]:
        doc = ast.get_docstring(node) or ""
        if isinstance(node, ast.ClassDef):
            yield node.name, doc, parameters_made_with(node)
            yield from documented_members(node)
        else:
            yield node.name, doc, parameters_of(node)


def parameters_of(node):
    return [a.arg for a in [*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs]]


DOCUMENTED = list(documented())


@pytest.mark.parametrize(
    ("name", "doc", "parameters"), DOCUMENTED, ids=[row[0] for row in DOCUMENTED]
)
def test_docstrings_say_what_and_name_every_parameter(name, doc, parameters):
    assert doc
    sections = SECTION.split("\n" + inspect.cleandoc(doc))
    if "Parameters" not in sections:
        return
    text = sections[sections.index("Parameters") + 1]
    lines = [line.lstrip("*") for line in text.splitlines()]  # **options
    heads = [line.split(" : ")[0] for line in lines if re.match(r"\w", line)]
    assert [head for line in heads for head in line.split(", ")] == parameters


def test_what_takes_an_array_names_its_shape():
    for name, doc, parameters in DOCUMENTED:
        if "positions" in parameters and not name.startswith("Frame"):
            assert re.search(r"\((N|B|M), [23]\)|as the function|``resolve``", doc), name


if __name__ == "__main__":
    REFERENCE.write_text(reference_text())
