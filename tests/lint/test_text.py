# SPDX-License-Identifier: MIT
"""Licence line, words, names and lengths."""

import ast
import re
import statistics
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from sources import CPP, FOLDERS, ROOT, files, numbered_lines, place, refuse

LONGEST_FILE = 400  # lines; from 300 on a file is reported
LONG_FILE = 300
LONGEST_FUNCTION = 50
MEDIAN_FUNCTION = 10

SPDX = re.compile(r"(//|#) SPDX-License-Identifier: MIT$")

# Built here from halves, so that this file passes its own rule.
REFUSED_ANYWHERE = {
    "/wo" + "rk/": "a path of one machine",
    "/ro" + "ot/": "a path of one machine",
    "/ho" + "me/": "a path of one machine",
    "TO" + "DO": "do it, or leave it out",
    "FIX" + "ME": "do it, or leave it out",
    "un" + "pkg": "nothing is loaded from the network",
    "jsde" + "livr": "nothing is loaded from the network",
}

# What the library may not use, and why.
REFUSED_IN_LIBRARY = {
    r"std::(cout|cerr|clog)\b|\b(f|v|vf)?printf\(|\bputs\(": "the library speaks through Log",
    r"\bexit\(|\babort\(|\bassert\(": "errors are exceptions",
    r"\busing namespace (?!std::\w+_literals)": "name what is used",
    r"\bstd::\w+_distribution\b|\bs?rand\(|\brandom_device\b": "random numbers: base/random.hpp",
    r"\bstd::sto[dfil]\w*\(|\b(strto|ato)[dfil]\w*\(|\bsetlocale\(": "numbers: base/number.hpp",
    r"\bnew \w|\bdelete \w|\bmalloc\(|\bfree\(": "memory has an owner: a container or unique_ptr",
}

# Files that may own memory by hand, and why.
RAW_MEMORY = {"committed_driver.cpp": "HDF5 hands a driver's memory through C callbacks"}

WORDS_NOT_IN_FILE_NAMES = re.compile(r"manager|helper|util|misc|common|impl(?!y)|stuff|[a-z]{4}\d$")


class Function(NamedTuple):
    """A function's definition."""

    path: Path
    line: int
    name: str
    length: int


def source_files() -> Iterator[Path]:
    """Everything that we write as code."""
    yield from files(*CPP, ".py", ".cmake")
    yield from (path for path in files(".txt") if path.name == "CMakeLists.txt")
    yield from (ROOT / name for name in ("CMakeLists.txt", "pyproject.toml", "dev", ".ci/run"))


# A line that opens a function's body in formatted C++: a parenthesis was closed before the brace.
OPENING = re.compile(
    r"^( *)(?!.*\b(if|for|while|switch|do|else|catch|namespace|return)\b)"
    r".*\).*\{$|^( *): .*\{$"
)


def cpp_functions(path: Path) -> Iterator[Function]:
    """Definitions that take more than one line; known by the indentation that the format gives.

    One that is nothing but `return {` and rows is a table, and may be as long as it needs.
    """
    opened = None
    for number, line in numbered_lines(path):
        indent = len(line) - len(line.lstrip())
        if opened is None:
            if OPENING.match(line) and indent <= 6:
                opened = (number, line.strip(), indent)
        elif line == "  return {" and number == opened[0] + 1:
            opened = None
        elif line.startswith("}") or (line.strip() == "}" and indent < 4 and indent <= opened[2]):
            start, name, _ = opened
            yield Function(path, start, name, number - start + 1)
            opened = None


def python_functions(path: Path) -> Iterator[Function]:
    """Definitions of a Python file; a docstring is not counted."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            documented = ast.get_docstring(node) is not None
            first = node.body[1] if documented and len(node.body) > 1 else node.body[0]
            yield Function(path, node.lineno, node.name, node.end_lineno - first.lineno + 2)


def functions() -> list[Function]:
    """Every function of the project."""
    cpp = [found for path in files(*CPP) for found in cpp_functions(path)]
    return cpp + [found for path in files(".py") for found in python_functions(path)]


def test_sources_begin_with_the_licence():
    def has_licence(path: Path) -> bool:
        lines = path.read_text(encoding="utf-8").splitlines()[:2]
        first = lines[1:] if lines and lines[0].startswith("#!") else lines[:1]
        return bool(first) and SPDX.match(first[0]) is not None

    refuse(
        [f"{place(path)}: no SPDX line first" for path in source_files() if not has_licence(path)]
    )


def test_headers_say_what_they_are():
    def begins_with_comment(path: Path) -> bool:
        lines = path.read_text(encoding="utf-8").splitlines()
        return len(lines) > 1 and lines[1].startswith("// ")

    headers = files(".hpp", folders=("src", "apps"))
    refuse(
        [
            f"{place(path)}:2: no sentence on what this header is"
            for path in headers
            if not begins_with_comment(path)
        ]
    )


def test_no_word_that_does_not_belong():
    texts = [*source_files(), *files(".md", folders=(*FOLDERS, "data")), *ROOT.glob("*.md")]
    refuse(
        [
            f"{place(path, number)}: {word!r}: {reason}"
            for path in texts
            for number, line in numbered_lines(path)
            for word, reason in REFUSED_ANYWHERE.items()
            if word in line
        ]
    )


# What a reader of headers need not guess: of what, and by whom.
DIALECT = re.compile(r"\b[Tt]old\b|^(Of|That of) ")
COMMENT = re.compile(r"(?:^|\s)///?<? ?(.*)$")


def test_headers_are_written_in_sentences():
    """A comment that begins with "Of" has lost its noun; nobody is "told" anything."""
    headers = files(".hpp", folders=("src", "apps", "python"))
    refuse(
        [
            f"{place(path, number)}: write a whole sentence: {line.strip()}"
            for path in headers
            for number, line in numbered_lines(path)
            if (comment := COMMENT.search(line))
            if DIALECT.search(comment[1])
        ]
    )


def broken_rules(path: Path) -> Iterator[str]:
    """One text for each line of a library file that breaks a rule."""
    rules = {
        pattern: why
        for pattern, why in REFUSED_IN_LIBRARY.items()
        if not (path.name in RAW_MEMORY and why.startswith("memory"))
    }
    for number, line in numbered_lines(path):
        code = line.split("//")[0]
        for pattern, why in rules.items():
            if re.search(pattern, code):
                yield f"{place(path, number)}: {why}: {line.strip()}"


def test_library_keeps_its_rules():
    refuse([text for path in files(*CPP, folders=("src",)) for text in broken_rules(path)])


def test_file_names_name_things():
    named = files(*CPP, ".py", ".cmake")
    refuse(
        [
            f"{place(path)}: a name that says nothing"
            for path in named
            if WORDS_NOT_IN_FILE_NAMES.search(path.stem)
        ]
    )


def test_files_are_short(record_property):
    lengths = {path: sum(1 for _ in numbered_lines(path)) for path in files(*CPP, ".py")}
    long = [f"{place(path)}: {n} lines" for path, n in lengths.items() if n >= LONG_FILE]
    record_property("long files", ", ".join(long))
    refuse(
        [
            f"{place(path)}: {n} lines, at most {LONGEST_FILE}"
            for path, n in lengths.items()
            if n >= LONGEST_FILE
        ]
    )


def test_functions_are_short(record_property):
    found = functions()
    median = statistics.median(function.length for function in found)
    record_property("median function", median)
    assert median <= MEDIAN_FUNCTION
    refuse(
        [
            f"{place(f.path, f.line)}: {f.length} lines, at most {LONGEST_FUNCTION}: {f.name}"
            for f in found
            if f.length > LONGEST_FUNCTION
        ]
    )


def test_tests_that_run_side_by_side_share_no_file():
    """A name in the folder of all temporary files is taken by two tests at once."""
    shared = re.compile(r"\bTempDir\(\)|\btemp_directory_path\(\)")
    refuse(
        [
            f"{place(path, number)}: files of a test: support/temp_directory.hpp: {line.strip()}"
            for path in files(*CPP, folders=("tests",))
            if path.name != "temp_directory.hpp"
            for number, line in numbered_lines(path)
            if shared.search(line)
        ]
    )
