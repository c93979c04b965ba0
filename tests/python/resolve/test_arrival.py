# SPDX-License-Identifier: MIT
"""`auto` arrives on real files wherever another technique does, and no step costs much more."""

from pathlib import Path

import numpy as np
import pytest
from arrival import BARS, MOST_OVER_MEDIAN, PUSHES, Run, failures
from real_files import real_files, structure_of

import pliant

FILES = real_files()
#: With large rings, loops that no torsions close at once, disulphides, waters, no hydrogens.
SHORT = ("5a7u.pdb", "1dx5I.pdb.gz", "1i8nA.pdb.gz", "crown_18_6.cif", "cyclic_hexapeptide.pdb")
#: A run of the long test is cut off after so many seconds of the processor.
MOST_SECONDS = 20.0
pytestmark = pytest.mark.filterwarnings("ignore::pliant.PliantWarning")


def check(path: Path, bars: str, push: str, steps: int, seconds: float) -> None:
    """Fails with what does not hold."""
    structure = structure_of(path)
    if structure is None:
        pytest.skip("no structure with bonds, or a large one")
    try:
        structure.framework(bars=bars)
    except pliant.InputError as error:
        pytest.skip(str(error))
    found, _ = failures(structure, bars, push, seconds, steps)
    assert found == []


@pytest.mark.parametrize("push", ["force_all", "displacement 0.5"])
@pytest.mark.parametrize("bars", BARS)
@pytest.mark.parametrize("name", SHORT)
def test_auto_arrives_on_some_files(name: str, bars: str, push: str) -> None:
    paths = [path for path in FILES if path.name == name]
    if not paths:
        pytest.skip("MDAnalysisTests is not installed")
    check(paths[0], bars, push, 60, np.inf)


@pytest.mark.long
@pytest.mark.parametrize("push", PUSHES)
@pytest.mark.parametrize("bars", BARS)
@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_auto_arrives_on_every_file(path: Path, bars: str, push: str) -> None:
    check(path, bars, push, 100, MOST_SECONDS)


def test_dear_steps_are_reported() -> None:
    assert Run(10, looked=[10] * 9 + [600]).over_median == 60.0 > MOST_OVER_MEDIAN
    assert Run(100, looked=[2] * 9 + [600]).over_median == 6.0
    assert Run(10).over_median == 0.0
