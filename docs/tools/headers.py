# SPDX-License-Identifier: MIT
"""The C++ interface as pages: what the public headers say, folder by folder."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

SOURCES = Path(__file__).resolve().parents[2] / "src"
CONTENTS = SOURCES / "pliant" / "pliant.hpp"

INCLUDED = re.compile(r'#include "pliant/(\w+)/([\w/]+\.hpp)"')
GROUP = re.compile(r"// ([\w, ]+): (.*)")
NAMED = re.compile(
    r"\b(?:class|struct|enum class|enum|using|concept)\s+(\w+)|(\w+)\(|(\w+)\s*(?:=|\{|;)"
)
KEPT_OUT = re.compile(r"(class|struct) \w+;|friend |using namespace ")


def pages() -> Iterator[tuple[str, str]]:
    """Names and texts: a page for each folder, and one that leads to them."""
    folders: dict[str, list[str]] = {}
    for folder, name in INCLUDED.findall(CONTENTS.read_text()):
        folders.setdefault(folder, []).append(f"{folder}/{name}")
    yield "api/cpp/index.md", _index(folders)
    for folder, names in folders.items():
        parts = [f"# C++: {folder}", *(_header(name) for name in names)]
        yield f"api/cpp/{folder}.md", "\n\n".join(parts) + "\n"


def _index(folders: dict[str, list[str]]) -> str:
    rows = [
        f"| [`{folder}`]({folder}.md) | " + ", ".join(f"`{Path(n).name}`" for n in names) + " |"
        for folder, names in folders.items()
    ]
    table = "\n".join(["| folder | headers |", "|---|---|", *rows])
    return f"""# C++ interface

`#include "pliant/pliant.hpp"` brings everything on these pages; each header can also be included
alone. All names are in namespace `pliant`. Lengths are in Å, times in ps, masses in u, forces in
kJ/(mol Å). N is a number of joints, B of bars, L of limits. The [C++ guide](../../cpp.md) shows how
to use it; [how it is built](../../inside/structure.md) says what each folder is for.

{table}
"""


def _header(name: str) -> str:
    lines = (SOURCES / "pliant" / name).read_text().splitlines()
    start = next(i for i, line in enumerate(lines) if line.startswith("#"))
    about = " ".join(line[3:] for line in lines[1:start] if line.startswith("// "))
    rows = lines[start] != "#pragma once"  # of a table that others include: nothing is declared
    shown = [] if rows else [_entity(*one) for one in entities(lines[start + 1 :])]
    return "\n\n".join(
        [f"## {Path(name).name} {{#{_anchor(name)}}}", f"`pliant/{name}`: {about}", *shown]
    )


def _anchor(name: str) -> str:
    return name.removesuffix(".hpp").replace("/", "-")


def entities(lines: list[str]) -> Iterator[tuple[list[str], list[str]]]:
    """Comment and declaration of what stands directly in the namespace."""
    comment: list[str] = []
    at = 0
    while at < len(lines):
        line = lines[at]
        if line.startswith("///"):
            comment.append(line[3:].removeprefix(" "))
        elif not line or line.startswith(("#", "//", "namespace", "}")):
            comment = comment if line else []
        else:
            end = _end(lines, at)
            if not KEPT_OUT.match(line):
                yield comment, _public(lines[at : end + 1])
            comment, at = [], end
        at += 1


def _end(lines: list[str], at: int) -> int:
    """The last line of the declaration that begins at `at`."""
    depth, opened = 0, False
    for number in range(at, len(lines)):
        code = re.sub(r"//.*|'[{}]'|\"[^\"]*\"", "", lines[number])
        depth += sum(map(code.count, "{(")) - sum(map(code.count, "})"))
        opened = opened or "{" in code
        done = code.rstrip().endswith((";", "}")) or (opened and not code.strip())
        if depth == 0 and done:
            return number
    return len(lines) - 1


def _public(lines: list[str]) -> list[str]:
    """A declaration without its private part and without bodies of functions."""
    if re.match(r"(template.*>\s*)?(class|struct|enum)\b", lines[0]) or lines[0].startswith(
        "template"
    ):
        kept, hidden = [], False
        for line in lines:
            hidden = not line.startswith(" public:") and (hidden or line.startswith(" private:"))
            if not hidden or line.startswith("}"):
                kept.append(line)
        return kept
    text = "\n".join(lines)
    is_function = re.match(r"[^={]*\)\s*(const\s*)?(noexcept\s*)?\{", text, re.DOTALL)
    return [is_function[0].rstrip("{ \n") + ";"] if is_function else lines


def _entity(comment: list[str], lines: list[str]) -> str:
    code = "\n".join(lines)
    while code.endswith("\n\n};"):
        code = code.replace("\n\n};", "\n};")
    code = code.replace("\n\n};", "\n};")
    about = "\n".join(_escaped(line) for line in comment)
    found = NAMED.search(re.sub(r"template\s*<[^>]*>|\[\[\w+\]\]", "", code))
    name = next((one for one in found.groups() if one), "") if found else ""
    return f"### `{name}`\n\n{about}\n\n```cpp\n{code}\n```" if name else f"```cpp\n{code}\n```"


def _escaped(text: str) -> str:
    """Comments are plain text: nothing in them is Markdown but code between backquotes."""
    parts = re.split(r"(`[^`]*`)", text)
    return "".join(part if part.startswith("`") else _plain(part) for part in parts)


def _plain(text: str) -> str:
    marked = re.sub(r"([*_\[\]$])", r"\\\1", text)
    return marked.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
