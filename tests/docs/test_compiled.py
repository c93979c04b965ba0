# SPDX-License-Identifier: MIT
"""C++, CMake and cluster files of the pages: parts of files that tests compile, or tried here."""

import re
import shutil
import subprocess

import pytest
import transcripts

INCLUDED = re.compile(r'^--8<-- "(tests/[\w/.]+)(?::\d+)*"\n$')
SOURCES = transcripts.ROOT / "src"
TABLE = "constexpr OrderingEntry table[] = {\n"


def all_of(kind):
    """Blocks of a kind that stand on a page as they are, each with its place."""
    return [
        pytest.param(block, id=f"{page.stem}-{block.line}")
        for page in transcripts.pages()
        for block in transcripts.blocks(page.read_text())
        if block.kind == kind and not INCLUDED.match(block.code)
    ]


def test_parts_of_files_are_of_files_that_tests_compile():
    found = [
        path
        for page in transcripts.pages()
        for block in transcripts.blocks(page.read_text())
        if block.kind in ("cpp", "cmake")
        for path in INCLUDED.findall(block.code)
    ]
    assert len(found) >= 4
    for path in found:
        file = transcripts.ROOT / path
        assert file.name in file.with_name("CMakeLists.txt").read_text() or path.endswith(".txt")


def program_of(code):
    """A translation unit of a block."""
    if "{.name" in code:
        return unit_of_row(*code.split("\n    {.name"))
    lines = code.splitlines(keepends=True)
    heads = [line for line in lines if line.startswith("#")]
    return "".join([*heads, "void shown() {\n", *lines[len(heads) :], "}\n"])


def unit_of_row(function, row):
    """The table of orderings as the page says to change it: a function, and a row of the table."""
    before, table, rows = (SOURCES / "pliant/order/ordering.cpp").read_text().partition(TABLE)
    assert table
    heads = "#include <algorithm>\n#include <functional>\n"
    return f"{heads}{before}{function}\n{table}    {{.name{row}{rows}"


@pytest.mark.long
@pytest.mark.skipif(shutil.which("c++") is None, reason="no C++ compiler is installed")
@pytest.mark.parametrize("block", all_of("cpp"))
def test_cpp_compiles(block, tmp_path):
    source = tmp_path / "shown.cpp"
    source.write_text(program_of(block.code))
    command = ["c++", "-std=c++20", "-fsyntax-only", "-ffp-contract=off", f"-I{SOURCES}", source]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def test_every_cmake_block_is_part_of_a_file():
    assert all_of("cmake") == []


@pytest.mark.parametrize("block", all_of("yaml"))
def test_cluster_files_are_read(block, tmp_path):
    pytest.importorskip("dask_jobqueue", reason="dask-jobqueue is not installed")
    from pliant.shards.queue_jobs import Queue

    path = tmp_path / "cluster.yaml"
    path.write_text(block.code)
    Queue(str(path))
