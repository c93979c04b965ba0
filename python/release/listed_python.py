# SPDX-License-Identifier: MIT
"""The Python interface as lines: names without an underscore, with their parameters.

They are read from the committed reference, which a test compares with the package. Types are not
part of the promise, for they only get wider: parameters, their order and their defaults are.
"""

from __future__ import annotations

import ast
import re

from project import Project

REFERENCE = "tests/python/pliant.pyi.ref"
PACKAGES = "python/pliant/[a-z]*/__init__.py"  # their __all__ is what they promise
NAMES = re.compile(r"^Names: (.*)$", re.MULTILINE)
VALUE = re.compile(r"(\w+)(: .*| = .*)?$")


def lines(project: Project) -> list[str]:
    """One line for each name, function, method, property and enumerator."""
    text = project.text(REFERENCE)
    names = NAMES.search(text)
    public = names[1].split() if names else []
    found, owner = [f"{name}" for name in public], ""
    for line in text.splitlines():
        if line.startswith("class "):
            owner = line[6:].partition("(")[0]
        elif line.startswith("    ") and owner in public:
            found.append(f"{owner}.{_member(line.strip())}")
        elif line.startswith("def ") and line[4:].partition("(")[0] in public:
            found.append(_call(line))
    return sorted({line for line in found if "__repr__" not in line} | _below_the_top(project))


def _below_the_top(project: Project) -> set[str]:
    """Such as pliant.analysis.Rmsf: what a package within the package has in its __all__."""
    found: set[str] = set()
    for path in sorted(project.root.glob(PACKAGES)):
        for node in ast.parse(path.read_text(encoding="utf-8")).body:
            if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "__all__":
                found |= {f"pliant.{path.parent.name}.{n}" for n in ast.literal_eval(node.value)}
    return found


def _member(line: str) -> str:
    if line.startswith("def "):
        return _call(line)
    if " may be assigned " in line:
        return line.partition(" may ")[0] + " may be assigned"
    match = VALUE.match(line)
    return match[1] + (match[2] if (match[2] or "").startswith(" = ") else "") if match else line


def _call(line: str) -> str:
    """A definition without its types."""
    node = ast.parse(line + ": ...").body[0]
    assert isinstance(node, ast.FunctionDef)
    every = [*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs]
    for argument in [*every, *filter(None, (node.args.vararg, node.args.kwarg))]:
        argument.annotation = None
    return f"{node.name}({ast.unparse(node.args)})"


def _parameters(call: str) -> tuple[list[tuple[str, str]], dict[str, str], bool]:
    """(by position, by name alone, whether any more are taken), each with its default."""
    head, _, words = call.partition("(")
    del head
    node = ast.parse(f"def f({words}: ...").body[0]
    assert isinstance(node, ast.FunctionDef)
    args = node.args
    positional = [*args.posonlyargs, *args.args]
    defaults = ["" for _ in positional[len(args.defaults) :]] + [
        ast.unparse(one) for one in args.defaults
    ]
    places = [(one.arg, text) for one, text in zip(positional, defaults, strict=True)]
    pairs = zip(args.kwonlyargs, args.kw_defaults, strict=True)
    named = {one.arg: ast.unparse(text) if text else "" for one, text in pairs}
    return places, named, bool(args.vararg or args.kwarg)


def serves(new: str, old: str) -> bool:
    """Whether every call that the old line allows means the same by the new one."""
    if new == old:
        return True
    if "(" not in old or "(" not in new or new.partition("(")[0] != old.partition("(")[0]:
        return False
    old_places, old_named, old_any = _parameters(old)
    places, named, takes_any = _parameters(new)
    if places[: len(old_places)] != old_places or (old_any and not takes_any):
        return False
    more = dict(places[len(old_places) :]) | named
    kept = all(more.get(name) == default for name, default in old_named.items())
    return kept and all(text for name, text in more.items() if name not in old_named)
