# SPDX-License-Identifier: MIT
"""The Python interface as lines: what is promised, with parameters.

They are read from the committed reference, which a test compares with the package. Types are not
part of the promise, for they only get wider: parameters, their order and their defaults are.
"""

from __future__ import annotations

import ast
import re

from project import Project

REFERENCE = "tests/python/pliant.pyi.ref"
NAMES = re.compile(r"^Names: (.*)$", re.MULTILINE)
VALUE = re.compile(r"(\w+)(: .*| = .*)?$")
#: what printing and pickling call
NOT_CALLED = re.compile(r"__(repr|str|getstate|setstate)__")


def lines(project: Project) -> list[str]:
    """One line for each name, function, method, property and enumerator."""
    text = project.text(REFERENCE)
    found, owner, bases = set(NAMES.findall(text)[0].split()), "", []
    for line in text.splitlines():
        if line.startswith("class "):
            owner, _, names = line[6:].rstrip(")").partition("(")
            bases = names.split(", ")
        elif line.startswith("    ") and not NOT_CALLED.search(line):
            member = _member(line.strip())
            if not any(f"{base}.{member}" in found for base in bases):  # as it is promised there
                found.add(f"{owner}.{member}")
        elif line.startswith("def "):
            found = (found | {_call(line)}) - {line[4:].partition("(")[0]}
    return sorted(found)


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
