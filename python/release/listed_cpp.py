# SPDX-License-Identifier: MIT
"""The C++ interface as lines: what the headers of pliant.hpp declare in namespace pliant."""

from __future__ import annotations

import re
import sys

from project import ROOT, Project

sys.path.insert(0, str(ROOT / "docs" / "tools"))

import headers

PRIVATE = re.compile(r"\bnamespace detail\b")
#: copied, moved, compared, destroyed, counted by the compiler: the affair of a type itself
OF_ITSELF = re.compile(
    r"^~|^friend |^static_assert|^using [\w:]+::\w+$|\(\) = default$|"
    r"\b(\w+)\((\1|const \1)? ?&{1,2}\)|^\w+& operator=\("
)
CALL = re.compile(r"\w\(|operator")
TYPE = re.compile(r"(?:template ?<.*?> ?)?(?:class|struct|enum class|enum) (?:\[\[\w+\]\] )?(\w+)")


def lines(project: Project) -> list[str]:
    """One line for each declaration, and for each public member of a type."""
    found: list[str] = []
    for folder, name in headers.INCLUDED.findall(project.text("src/pliant/pliant.hpp")):
        found.append(f'#include "pliant/{folder}/{name}"')
        text = project.text(f"src/pliant/{folder}/{name}").splitlines()
        start = next(k for k, line in enumerate(text) if line.startswith("#"))
        if text[start] == "#pragma once":
            for _, declared in headers.entities(text[start + 1 :]):
                found += _lines_of(declared)
    return sorted(set(found))


def _lines_of(declared: list[str]) -> list[str]:
    """A declaration as one line; a type as one with its data, and one line for each function."""
    code = [re.sub(r"\s*///?.*", "", line) for line in declared]
    text = " ".join(" ".join(code).split())
    match = TYPE.match(text)
    if not match or "{" not in text:
        return [text.rstrip("; ") + ";"] if text else []
    head, _, body = text.partition("{")
    members = [one for one in _members(body, head) if not OF_ITSELF.search(one)]
    calls = [one for one in members if CALL.search(_without_arguments(one).partition("=")[0])]
    data = "; ".join(one for one in members if one not in calls)
    return [f"{head.strip()} {{{data}}};", *(f"{match[1]}::{one}" for one in calls)]


def _without_arguments(text: str) -> str:
    """A declaration without the arguments of its templates."""
    shorter = re.sub(r"<[^<>]*>", "", text)
    return text if shorter == text else _without_arguments(shorter)


def _members(body: str, head: str) -> list[str]:
    """What stands directly between the braces, without bodies of functions."""
    separators, depth, one, found = ",;" if "enum" in head else ";", 0, "", []
    for letter in body.replace("public:", ""):
        if depth == 0 and letter in "{":
            one = one.rstrip()
        depth += (letter in "{(") - (letter in "})")
        if depth < 0:
            break
        ended = (depth == 0 and letter in separators) or (letter == "}" and depth == 0)
        if ended and not (letter == "}" and not _is_function(one)):
            found.append(_declared(one + letter))
            one = ""
        else:
            one += letter
    found.append(_declared(one))
    return [text for text in found if text]


def _is_function(text: str) -> bool:
    return bool(re.search(r"\)[^(]*(\{|:)", text)) and "=" not in text.partition("(")[0]


def _declared(text: str) -> str:
    """A member without its body, or without what only its place in a list needs."""
    text = " ".join(text.split()).strip(" ;,")
    if _is_function(text):
        text = re.sub(r"\)(\s*(?:const|noexcept|override)*)\s*[:{].*", r")\1", text)
    return text.strip()


def broken(before: Project, now: Project) -> list[str]:
    """The declarations of the old headers that nothing in the new ones serves."""
    there = lines(now)
    return [
        f"{old}: is gone" for old in lines(before) if not any(serves(new, old) for new in there)
    ]


def serves(new: str, old: str) -> bool:
    """Whether what compiled with the old declaration compiles with the new one."""
    if new == old:
        return True
    if old.endswith("};") and new.partition(" {")[0] == old.partition(" {")[0]:
        return _has_all_in_order(_data(new), _data(old), is_enum=old.startswith("enum"))
    end = re.search(r"\)( const)?( noexcept)?;?$", old)
    if not end or not new.endswith(end[0]):
        return False
    head, more = old[: end.start()], new.removesuffix(end[0])
    added = more.removeprefix(head)
    return more.startswith(head) and added.startswith(", ") and _all_have_defaults(added[2:])


def _data(line: str) -> list[str]:
    """The members of a type that are no functions."""
    return line.partition(" {")[2].removesuffix("};").split("; ")


def _has_all_in_order(new: list[str], old: list[str], is_enum: bool) -> bool:
    """Whether more members came alone: anywhere in a struct, at the end of an enumeration."""
    return new[: len(old)] == old if is_enum else [one for one in new if one in old] == old


def _all_have_defaults(parameters: str) -> bool:
    return all("=" in one for one in re.split(r",(?![^<({]*[>)}])", parameters))
