# SPDX-License-Identifier: MIT
"""What the command prints and writes, byte by byte: files of runs, orderings, graphs, forces."""

import subprocess
import sys
import tempfile
from collections.abc import Iterator
from functools import partial
from pathlib import Path

from digest import Line, lines
from hashed_library import MOLECULES, ROOT, molecule

import pliant

sys.path.append(str(ROOT / "tests/cli"))
import test_same_bits

CAFFEINE = "caffeine.sdf"
RUN = ["run", CAFFEINE, "-o", "out.h5md", "--quiet"]
TOGETHER = ["--walkers", "11", "--perturb", "displacement", "--steps", "20", "--topology", "none"]
STEPS = ["--steps", "30"]
# Each row is one after the other in one folder; what the last prints, and all files, are hashed.
JOBS = [
    [[*RUN, *STEPS, "--record-forces", "forces.txt", "--seed", "3"]],
    [[*RUN, *STEPS, "--precision", "1e-3", "--every", "7", "--damping", "0.2"]],
    [[*RUN, *STEPS, "--pin", "name C1", "--mass-weighted"]],
    [[*RUN, *STEPS, "--perturb", "force_all", "--technique", "units", "--bars", "angles"]],
    [[*RUN, *TOGETHER, "--threads", "1"]],
    [[*RUN, *TOGETHER, "--threads", "2", "--technique", "newton"]],
    [
        ["lab", "forcegen", CAFFEINE, "--steps", "20", "--force", "200", "-o", "forces.txt"],
        [*RUN, "--forces", "forces.txt", "--technique", "dfs_reverse"],
    ],
    [
        ["lab", "order", CAFFEINE, "--ordering", "bfs_random", "--seed", "4", "-o", "ordering.txt"],
        [*RUN, *STEPS, "--ordering", "ordering.txt"],
    ],
    [
        ["lab", "structgen", "2-cycle-path", "--seed", "7", "-o", "graph.xml"],
        ["run", "graph.xml", "-o", "out.h5md", *STEPS, "--quiet", "--technique", "bfs_adapt"],
    ],
    [["lab", "structgen", "--test-set", "set", "--graphs", "2", "--forces", "5", "--seed", "2"]],
    [["lab", "techniques", "--json"]],
    [["run", CAFFEINE, "--technique", "none"]],
]


def command_lines(command: Path) -> Iterator[Line]:
    """All lines of a command."""
    yield from same_bits_lines(command)
    for job in JOBS + small_jobs():
        yield from lines(f"command {' '.join(job[-1])}", partial(in_a_folder, command, job))


def same_bits_lines(command: Path) -> Iterator[Line]:
    """Every dataset of the files that tests/cli/test_same_bits.py compares."""
    for name in test_same_bits.MOLECULES:
        for settings in test_same_bits.SETTINGS:
            with tempfile.TemporaryDirectory() as folder:
                call = partial(test_same_bits.run, command, Path(folder), molecule(name), settings)
                yield from lines(f"same_bits {name} {' '.join(settings)}", call)


def small_jobs() -> list[list[list[str]]]:
    """What reads and prints: each molecule, each technique's ordering, each class of graphs."""
    files = sorted(path.name for path in MOLECULES.iterdir())
    names = [row.name for row in pliant.techniques()]
    kinds = [row.name for row in pliant.graph_classes()]
    return [
        *([["info", file, "--json", "--bars", b]] for file in files for b in ("bonds", "angles")),
        *([["lab", "order", CAFFEINE, "--ordering", name, "--seed", "9"]] for name in names),
        *([["lab", "structgen", kind, "--seed", "5"]] for kind in kinds),
    ]


def in_a_folder(command: Path, job: list[list[str]]) -> dict[str, object]:
    """What commands, run one after the other in a folder of their own, print and write."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for arguments in job:
            words, how = (
                [command, *with_inputs(arguments, folder)],
                {"capture_output": True, "timeout": 120},
            )
            ended = subprocess.run(words, cwd=folder, check=False, **how)
        spoken = [out.replace(name.encode(), b"FOLDER") for out in (ended.stdout, ended.stderr)]
        return {"printed": [ended.returncode, *spoken]} | written(folder)


def with_inputs(arguments: list[str], folder: Path) -> list[str]:
    """The same arguments; molecules that they name are linked to from the folder."""
    for word in arguments:
        if (MOLECULES / word).is_file() and not (folder / word).exists():
            (folder / word).symlink_to(MOLECULES / word)
    return arguments


def written(folder: Path) -> dict[str, object]:
    """Every file by name; of an H5MD file its datasets, as the version is among its attributes."""
    found: dict[str, object] = {}
    for path in sorted(folder.rglob("*")):
        name = path.relative_to(folder).as_posix()
        if path.suffix == ".h5md":
            found |= {f"{name}/{key}": data for key, data in test_same_bits.datasets(path).items()}
        elif path.is_file() and not path.is_symlink():
            found[name] = path.read_bytes()
    return found
