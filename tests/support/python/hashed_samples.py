# SPDX-License-Identifier: MIT
"""Samples, conformers and paths whose bits are looked at: every sampler, every option changed once.

What a sample with an option is, what its file says and what goes on with it are hashed, of the
package and of the command.
"""

import tempfile
from collections.abc import Iterator
from functools import partial
from pathlib import Path

from digest import Line, lines
from hashed_command import in_a_folder, written
from hashed_library import molecule, values

import pliant

PEPTIDES = ("cyclic_hexapeptide", "alanine_dipeptide")
SMALL = ("butane", "caffeine", "aspirin", "cyclohexane_chair", "glucose")
FRAMES = 4
OF_SAMPLE = tuple(
    "positions rmsf rmsf_error redrawn failed amplitude_asked amplitude_reason "
    "amplitude_reached max_residual max_limit max_overlap".split()
)
# Each option of a sample once, for scripts and for the command.
OPTIONS = {
    "first_frame": 97,
    "amplitude": 0.3,
    "seed": 2**64 - 1,
    "threads": 2,
    "contact_energy": 5.0,
    "amides": True,
}
OF_OUTPUT = ({}, {"precision": 0.01}, {"save": "name CA"})
OF_MODEL = (
    [], ["--model", "angles"], ["--free-torsions"], ["--keep-waters"], ["--all-hydrogens"],
    ["--hbond-cutoff", "-3"], ["--select", "not element H"], ["--precision", "0.01"],
)  # fmt: skip  # a table: a row a line
OF_PATH = ({}, {"atoms": "heavy"}, {"step": 0.1}, {"both": True}, {"backtrack": 2, "seed": 5})


def sample(name: str, **options) -> dict[str, object]:
    """A sample of a molecule, and the framework that its frames are of."""
    found = pliant.sample(pliant.read(molecule(name)), FRAMES, **options)
    framework = found.model.framework
    return {
        "sample": values(found, OF_SAMPLE),
        "framework": [framework.bars, framework.rest_lengths, framework.limits],
    }


def recorded(name: str, **options) -> dict[str, object]:
    """What files of a sample hold, as it ends and once it has gone on."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "out.h5md"
        pliant.sample(pliant.read(molecule(name)), FRAMES, output=path, **options)
        found = {f"{key} first": data for key, data in written(path.parent).items()}
        if "save" in options:  # part of the molecule alone does not go on
            return found
        added = pliant.continue_sample(path, 2 * FRAMES)
        return found | written(path.parent) | {"added": values(added, ("frames", "rmsf"))}


def path(**options) -> dict[str, object]:
    """A path to a frame of a sample."""
    start = pliant.read(molecule("peptide_20"))
    with tempfile.TemporaryDirectory() as folder:
        end, moved = Path(folder) / "end.pdb", pliant.sample(start, 1, seed=3)
        pliant.write_topology_pdb(end, moved.model.structure, positions=moved.positions[0])
        found = pliant.path(start, end, **options)
    notes = [note.replace(folder, "FOLDER") for note in found.notes]
    return {"positions": [*found.positions], "frames": repr(found.frames), "notes": notes}


def rows() -> Iterator[tuple[str, dict]]:
    """Each sampler as it is, and with each option."""
    for row in pliant.samplers():
        changed = {k: v for k, v in OPTIONS.items() if row.has_amplitude or k != "amplitude"}
        yield row.name, {}
        yield from ((row.name, {name: value}) for name, value in changed.items())


def library_lines() -> Iterator[Line]:
    """Those of the package."""
    for name in PEPTIDES + SMALL:
        yield from lines(f"sample auto {name}", partial(sample, name))
        for sampler, options in rows():
            title = f"{sampler} {name} {options}"
            yield from lines(f"sample {title}", partial(sample, name, sampler=sampler, **options))
    for name in (PEPTIDES[0], SMALL[0]):
        for sampler, options in rows():
            title = f"{sampler} {name} {options}"
            yield from lines(f"file {title}", partial(recorded, name, sampler=sampler, **options))
        for options in OF_OUTPUT:
            yield from lines(f"file {name} {options}", partial(recorded, name, **options))
    for options in OF_PATH:
        yield from lines(f"path {options}", partial(path, **options))


def command_jobs() -> Iterator[list[list[str]]]:
    """Each option of the command once; then the sample goes on."""
    output = ["-o", "out.h5md", "--quiet", "--frames", str(FRAMES)]
    go_on = ["sample", "--continue", "out.h5md", "--frames", str(2 * FRAMES), "--quiet"]
    words = [
        [
            word
            for name, value in options.items()
            for word in (f"--{name.replace('_', '-')}", *([] if value is True else [str(value)]))
        ]
        + ["--sampler", sampler]
        for sampler, options in rows()
        if "first_frame" not in options  # of jobs alone
    ]
    for file in ("cyclic_hexapeptide.pdb", "caffeine.sdf"):
        for more in [*OF_MODEL, *words]:
            yield [["sample", file, *output, *more], go_on]
    yield [["sample", "caffeine.sdf", "--sampler", "torsions", "--amplitude", "2"]]
    yield [["sample", "caffeine.sdf", "--sampler", "tortions"]]
    yield [["sample", "caffeine.sdf", "--temperature", "12"]]


def command_lines(command: Path) -> Iterator[Line]:
    """Those of the command."""
    for job in command_jobs():
        yield from lines(f"command {' '.join(job[0])}", partial(in_a_folder, command, job))
