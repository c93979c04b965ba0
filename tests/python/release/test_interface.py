# SPDX-License-Identifier: MIT
"""What the last release promised is there: Python, C++, command line and files.

Each list of python/release/interface is compared with what there is now. A line may be served by
one that allows every use of it; nothing else may take its place within a major version.
"""

import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]
sys.path.insert(0, str(ROOT / "python" / "release"))

import interface  # noqa: E402
import listed_cpp  # noqa: E402
import listed_python  # noqa: E402
from project import Project  # noqa: E402

PROJECT = Project(ROOT)
FEWEST = {"python": 250, "cpp": 200, "commands": 100, "files": 150}
MOST = 900  # lines of all lists: what is promised cannot be taken back


@pytest.mark.parametrize("part", interface.PARTS)
def test_what_was_promised_is_there(part):
    now = interface.PARTS[part].lines(PROJECT)
    assert len(now) >= FEWEST[part]
    assert interface.problems(PROJECT, part, now) == []


@pytest.mark.parametrize("part", interface.PARTS)
def test_lists_are_whole(part):
    for version in interface.versions(PROJECT):
        assert len(interface.listed(PROJECT, version, part)) >= FEWEST[part]


def test_lists_are_short():
    last = interface.versions(PROJECT)[-1]
    assert sum(len(interface.listed(PROJECT, last, part)) for part in interface.PARTS) <= MOST


@pytest.mark.parametrize("part", interface.PARTS)
def test_a_line_that_is_gone_is_found(part):
    last = interface.versions(PROJECT)[-1]
    lines = interface.listed(PROJECT, last, part)
    gone = lines[len(lines) // 2]
    found = interface.problems(PROJECT, part, [line for line in lines if line != gone])
    assert found == [f"{part}: {gone}: was in {last}"]


@pytest.mark.parametrize(
    ("new", "old", "serves"),
    [
        ("run(file, *, seed=0)", "run(file, *, seed=0)", True),
        ("run(file, *, seed=0, steps=3)", "run(file, *, seed=0)", True),
        ("run(file, steps=3, *, seed=0)", "run(file, *, seed=0)", True),
        ("run(file, seed=0)", "run(file, *, seed=0)", True),  # by name and by place
        ("run(file, *, seed=0, steps)", "run(file, *, seed=0)", False),  # one must be given
        ("run(file)", "run(file, *, seed=0)", False),
        ("run(file, *, seed=1)", "run(file, *, seed=0)", False),  # means something else
        ("run(name, *, seed=0)", "run(file, *, seed=0)", False),
        ("run(steps, file)", "run(file, steps)", False),
        ("run(file, *, seed=0)", "run(file, seed=0)", False),  # by place no more
        ("go(file)", "run(file)", False),
        ("State.seed", "State.seed", True),
        ("State.time", "State.seed", False),
    ],
)
def test_calls_in_python_that_serve_an_old_one(new, old, serves):
    assert listed_python.serves(new, old) is serves


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


def project_with(tmp_path, version):
    """A project of this version, of whose Python list two lines were in 1.4.0."""
    (tmp_path / "CMakeLists.txt").write_text(f"project(pliant VERSION {version} LANGUAGES CXX)\n")
    folder = tmp_path / interface.LISTS / "1.4.0"
    folder.mkdir(parents=True)
    (folder / "python.txt").write_text("f(a)\ng(a)\n")
    return Project(tmp_path)


def test_nothing_goes_within_a_major_version(tmp_path):
    project = project_with(tmp_path, "1.5.0")
    assert interface.problems(project, "python", ["f(a)"]) == ["python: g(a): was in 1.4.0"]
    (tmp_path / "CMakeLists.txt").write_text("project(pliant VERSION 2.0.0 LANGUAGES CXX)\n")
    assert interface.problems(project, "python", ["f(a)"]) == []


def test_the_last_list_is_that_of_the_highest_version(tmp_path):
    project = project_with(tmp_path, "1.10.0")
    (tmp_path / interface.LISTS / "1.10.0").mkdir()
    assert interface.versions(project) == ["1.4.0", "1.10.0"]


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
