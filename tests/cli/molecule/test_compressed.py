# SPDX-License-Identifier: MIT
"""Compressed inputs: the same molecule, and no more memory than the caller allows."""

from __future__ import annotations

import bz2
import gzip
import lzma
import resource
import subprocess

import pytest

import pliant

WATER = b"3\nwater\nO 0 0 0\nH 0.96 0 0\nH -0.24 0.93 0\n"
COMPRESS = {"gz": gzip.compress, "bz2": bz2.compress, "xz": lzma.compress}
#: Address space (bytes) in which a bomb must be refused.
LITTLE = 200 << 20


def pliant_in_little_memory(command, *arguments):
    return subprocess.run(
        [command, *map(str, arguments)],
        capture_output=True,
        text=True,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (LITTLE, LITTLE)),
    )


def bomb(suffix, megabytes):
    """Many members of 10 MB each: no compressor needs to see so much text."""
    return COMPRESS[suffix](b" " * 10_000_000) * (megabytes // 10)


@pytest.mark.parametrize("suffix", COMPRESS)
def test_what_is_compressed_is_the_same_molecule(command, tmp_path, suffix):
    path = tmp_path / f"water.xyz.{suffix}"
    path.write_bytes(COMPRESS[suffix](WATER))
    structure = pliant.read(path)
    assert structure.symbols.tolist() == ["O", "H", "H"]
    done = subprocess.run(
        [command, "run", path, "--steps", "2"], cwd=tmp_path, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "water.h5md").exists()


LIMITS = [
    ("bomb.pdb.gz", lambda: bomb("gz", 260), 250, "gzip: expands to more than"),
    ("bomb.pdb.bz2", lambda: bomb("bz2", 260), 250, "bzip2: expands to more than"),
    ("bomb.pdb.xz", lambda: bomb("xz", 260), 250, "xz: expands to more than"),
    ("bomb.xyz.gz", lambda: bomb("gz", 2010), None, "gzip: expands to more than"),
    ("graph.xml", lambda: bytes(1_000_001), 1, "is larger than"),
]


@pytest.mark.parametrize(
    ("name", "content", "most", "said"),
    [pytest.param(*row, id=row[0], marks=[] if row[2] else pytest.mark.long) for row in LIMITS],
)
def test_what_is_too_large_ends_with_one_line_and_in_little_memory(
    command, tmp_path, name, content, most, said
):
    path = tmp_path / name
    path.write_bytes(content())
    done = pliant_in_little_memory(command, "run", path, *(["--max-input", most] if most else []))
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == (
        f"pliant: error: {path}: {said} {most or 2000} MB, the most that is read; "
        "--max-input allows more\n"
    )
    assert [left.name for left in tmp_path.iterdir()] == [name]


def test_python_has_the_limit_too(tmp_path):
    path = tmp_path / "water.xyz.bz2"
    text = WATER.replace(b"water", b"water " * 1000)
    path.write_bytes(bz2.compress(text))
    assert len(pliant.read(path, max_input=len(text))) == 3
    with pytest.raises(pliant.InputError) as caught:
        pliant.read(path, max_input=len(text) - 1)
    assert str(caught.value) == (
        f"{path}: bzip2: expands to more than {len(text) - 1} bytes, the most that is read"
    )
    for wrong in (0, 2**32 + 1):
        with pytest.raises(pliant.OptionError, match=r"^max_input: expected 1 to 4294967296 bytes"):
            pliant.read(path, max_input=wrong)
