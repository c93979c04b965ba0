# SPDX-License-Identifier: MIT
"""Files are written in one way, which leaves none that is cut off: `pliant.base.new_file` in
Python, `OutputFile` in C++."""

import re

import pytest
from sources import CPP, files, numbered_lines, place, refuse

PYTHON_WAY = "python/pliant/base/new_file.py"
CPP_WAYS = ("src/pliant/text/output_file.cpp", "src/pliant/base/system/")

WRITES_IN_PYTHON = re.compile(
    r"\bopen\([^)]*[\"'](?:[wxa]b?t?\+?|r\+b?|ab\+)[\"']|\.write_(?:text|bytes)\(|"
    r"\b(?:savefig|print_png|imsave)\((?!file\b)|\bto_csv\(|\bSDWriter\(|\bMDAnalysis\.Writer\(|"
    r"h5py\.File\((?!new\b|good\b|file\b)[^)]*[\"'][wax]|\bnp\.save\w*\((?!file\b)|\.tofile\(|\bto_zarr\(|"
    r"\bos\.(?:replace|link|rename)\(|\bshutil\.(?:copy\w*|move)\(|\.rename\("
)
WRITES_IN_CPP = re.compile(
    r"\bofstream\b|\bstd::fstream\b|\bfopen\(|\bfreopen\(|\bfs::(?:rename|copy\w*)\(|"
    r"\b(?:replace_name|take_name)\("
)

#: what else writes, and why: (file, what stands on the line)
EXCEPTIONS = {
    ("jobs/conformers/journal.py", "os.replace("): "a journal: records are committed one by one",
    ("shards/commits.py", ".rename("): "a log of commits",
    ("shards/folder_lock.py", "open("): "a lock, which holds nothing",
    ("trajectory/shards/manifest.py", "open("): "a log: a line that is cut off does not count",
    ("shards/plan_made.py", "open("): "waits for the disk, as shards do",
    ("shards/scratch.py", "copyfile("): "a shard that was checked, from another disk",
    ("shards/scratch.py", "os.rename("): "the same",
    ("shards/scratch.py", ".rename("): "the same",
    ("shards/scratch.py", "open("): "a lock, which holds nothing",
    ("adapters/convert/zarr_store.py", ".rename("): "a folder of files, complete first",
    ("adapters/convert/zarr_store.py", "to_zarr("): "the same",
    ("adapters/convert/formats.py", "MDAnalysis.Writer("): "to the path of a NewFile",
    ("lab/bench/reading.py", "MDAnalysis.Writer("): "in a folder that goes again",
    ("trajectory/recover/recover.py", "copyfile("): "a copy that goes again",
    ("trajectory/recover/superblock.py", "open("): "that copy",
    ("lab/experiment/folders.py", ".rename("): "a folder of files, complete first",
    ("lab/bench/step_memory.py", "open("): "an order to the kernel",
    ("checks/openmm/worker.py", "np.save("): "a process that may crash: its file is checked",
    ("checks/openmm/worker.py", "open("): "the same",
    ("checks/openmm/child.py", ".write_text("): "an empty file",
    ("checks/openmm/child.py", "open("): "what another program says",
}


def is_excepted(name: str, line: str) -> bool:
    return any(name == f"python/pliant/{file}" and what in line for file, what in EXCEPTIONS)


def test_python_writes_files_in_one_way():
    refuse(
        [
            f"{place(path, number)}: {found[0]}: pliant.base.new_file writes files"
            for path in files(".py", folders=("python/pliant",))
            if not place(path).startswith((PYTHON_WAY, "python/pliant/tests/"))
            for number, line in numbered_lines(path)
            if (found := WRITES_IN_PYTHON.search(line)) and not is_excepted(place(path), line)
        ]
    )


def test_cpp_writes_files_in_one_way():
    refuse(
        [
            f"{place(path, number)}: {found[0]}: OutputFile writes files"
            for path in files(*CPP, folders=("src", "apps", "python"))
            if not place(path).startswith(CPP_WAYS)
            for number, line in numbered_lines(path)
            if (found := WRITES_IN_CPP.search(line))
        ]
    )


@pytest.mark.parametrize(
    "line",
    [
        'with open(path, "w", encoding="utf-8") as file:',
        'with Path(file).open("x") as stream:',
        "path.write_text(text)",
        "(folder / name).write_bytes(data)",
        "figure.savefig(path, dpi=dpi)",
        "canvas.print_png(path)",
        "writer = Chem.SDWriter(path)",
        'with h5py.File(path, "w") as file:',
        "np.save(path, rows)",
        "os.replace(partial, target)",
    ],
)
def test_other_ways_are_seen(line):
    assert WRITES_IN_PYTHON.search(line)


@pytest.mark.parametrize(
    "line", ['open(path, encoding="utf-8")', 'open(path, "rb")', "write_text(path, text)"]
)
def test_reading_is_free(line):
    assert not WRITES_IN_PYTHON.search(line)
