# SPDX-License-Identifier: MIT
"""What the last tagged version promised is there: Python, C++, command line and files."""

import warnings

import interface
import listed_cpp
import listed_python
import pytest
from pliant.base.deprecated import warn_deprecated
from project import Project
from small_project import commit, in_git

import pliant

#: what each part has at least, so that a comparison of nothing is found
FEWEST = {"python": 50, "cpp": 200, "commands": 100, "files": 150}
HEADER = "// SPDX\n// What it is.\n#pragma once\n\nnamespace pliant {\n\nvoid f(int a);\n\n}\n"

FILES = {
    "tests/python/pliant.pyi.ref": (
        "class State():\n    seed: int\n\ndef run(file, *, seed: int=0): ...\n"
    ),
    "src/pliant/pliant.hpp": '#include "pliant/base/log.hpp"\n',
    "src/pliant/base/log.hpp": HEADER,
    "tests/cli/help/pliant-run.help.txt": "  --seed N   a number\n",
    "tests/cli/help/pliant-run-all.help.txt": "  --seed N   a number\n",
    "tests/cli/help/pliant-lab-bench.help.txt": "  --rows N   a number\n",
    "tests/python/trajectory/promised_files.ref": "h5md: particles/mass\n",
}


def write(project, files):
    for name, text in files.items():
        path = project.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    commit(project.root)


@pytest.fixture
def tagged(small):
    """A project whose version 1.2.3 is tagged."""
    write(small, FILES)
    in_git(small.root, "tag", "v1.2.3")
    return small


def test_what_was_promised_is_there():
    assert interface.problems(Project()) == []


@pytest.mark.parametrize("part", interface.PARTS)
def test_each_part_of_these_files_is_found(part, tmp_path):
    """All that they promise is missing in a project without files."""
    if not Project().files():
        pytest.skip("this is no clone: git lists no files")
    found = interface.PARTS[part](Project(), Project(tmp_path))
    assert len(found) >= FEWEST[part]


@pytest.mark.parametrize(
    ("name", "old", "new", "said"),
    [
        ("tests/python/pliant.pyi.ref", "seed: int\n", "time: int\n", "python: State.seed: "),
        ("tests/python/pliant.pyi.ref", "=0", "=1", "python: run(seed): Parameter default was "),
        ("src/pliant/base/log.hpp", "int a", "int a, int b", "cpp: void f(int a);: is gone"),
        ("tests/cli/help/pliant-run.help.txt", "--seed", "--sed", "commands: pliant run --seed: "),
        (
            "tests/python/trajectory/promised_files.ref",
            "mass",
            "m",
            "files: h5md: particles/mass: is ",
        ),
    ],
)
def test_what_is_gone_is_found(tagged, name, old, new, said):
    assert interface.problems(tagged) == []
    write(tagged, {name: FILES[name].replace(old, new)})
    (found,) = interface.problems(tagged)
    assert found.startswith(said)
    assert found.endswith(" (since v1.2.3)")


def test_the_laboratory_and_more_of_anything_break_nothing(tagged):
    write(
        tagged,
        {
            "tests/cli/help/pliant-lab-bench.help.txt": "",
            "tests/python/pliant.pyi.ref": FILES["tests/python/pliant.pyi.ref"].replace(
                "seed: int=0", "seed: str=0, steps: int=1"
            ),
            "src/pliant/base/log.hpp": HEADER.replace("int a", "int a, int b = 0"),
        },
    )
    assert interface.problems(tagged) == []


def test_nothing_goes_within_a_major_version(tagged):
    write(tagged, dict.fromkeys(FILES, "\n"))
    assert len(interface.problems(tagged)) == 6
    write(tagged, {"CMakeLists.txt": "project(pliant VERSION 2.0.0 LANGUAGES CXX)\n"})
    assert interface.problems(tagged) == []


def test_the_last_tag_is_that_of_the_highest_version(tagged):
    assert interface.last_tag(tagged) == "v1.2.3"
    in_git(tagged.root, "tag", "v1.10.0")
    in_git(tagged.root, "tag", "v1.9.0")
    assert interface.last_tag(tagged) == "v1.10.0"


def test_overloads_are_told_apart():
    text = "def f(a): ...\ndef f(b): ...\nclass A():\n    def f(self): ...\n"
    assert listed_python.numbered(text) == text.replace("def f(b)", "def f_2(b)")


@pytest.mark.parametrize(
    ("new", "old", "serves"),
    [
        ("void f(int a);", "void f(int a);", True),
        ("void f(int a, int b = 0);", "void f(int a);", True),
        ("void f(int a, std::array<int, 3> b = {});", "void f(int a);", True),
        ("void f(int a, int b);", "void f(int a);", False),
        ("void f(int a, int b = 0, int c);", "void f(int a);", False),
        ("int f(int a);", "void f(int a);", False),
        ("struct X {int a = 0; int b};", "struct X {int a = 0};", True),
        ("struct X {int b; int a = 0};", "struct X {int a = 0};", True),
        ("struct X {int a = 1};", "struct X {int a = 0};", False),
        ("struct X {int b; int a};", "struct X {int a; int b};", False),
        ("enum class X {a; b};", "enum class X {a};", True),
        ("enum class X {b; a};", "enum class X {a};", False),
        ("X::int f(int a, int b = 0) const", "X::int f(int a) const", True),
        ("X::int f(int a, int b = 0)", "X::int f(int a) const", False),
    ],
)
def test_declarations_in_cpp_that_serve_an_old_one(new, old, serves):
    assert listed_cpp.serves(new, old) is serves


def test_data_of_a_type_is_one_line_and_each_function_another():
    declared = [
        "struct Box {",
        "  double side = 1;  ///< its length",
        "  Vec3 middle() const { return side * x; }",
        "  explicit Box(double s) : side(s) {}",
        "  Box(const Box&) = delete;",
        "  Box& operator=(Box&&) noexcept;",
        "  ~Box();",
        "  std::function<void(int)> seen = {};",
        "};",
    ]
    assert listed_cpp._lines_of(declared) == [
        "struct Box {double side = 1; std::function<void(int)> seen ={}};",
        "Box::Vec3 middle() const",
        "Box::explicit Box(double s)",
    ]


def old_name():
    warn_deprecated("old_name", "1.1", "new_name")
    return 3


def test_what_is_deprecated_names_what_to_use_at_the_line_that_calls_it():
    with pytest.warns(pliant.PliantDeprecationWarning) as caught:
        assert old_name() == 3
    (one,) = caught
    assert str(one.message) == "old_name is deprecated since 1.1: use new_name"
    assert one.filename == __file__


def test_what_is_deprecated_can_be_made_an_error():
    with warnings.catch_warnings():
        warnings.simplefilter("error", pliant.PliantDeprecationWarning)
        with pytest.raises(pliant.PliantDeprecationWarning):
            old_name()
