# SPDX-License-Identifier: MIT
"""The wheel of another processor in Python of that processor, under qemu: what is written in
Python has the same bytes as from the wheel of this machine, and the tests in the wheel pass."""

import shutil

import pytest
from emulated import ROOT, RUNNERS, THIS, python_of, stored, targets

PEPTIDE = (ROOT / "data/molecules/peptide_20.pdb").read_bytes()
FOREIGN = [name for name, row in targets().items() if row.tried == "qemu"]
PATH = "import sys; from pliant.jobs.path.command import main; sys.exit(main())"


@pytest.fixture(params=FOREIGN)
def theirs(request):
    if not shutil.which(RUNNERS["qemu"][0]):
        pytest.skip(f"{RUNNERS['qemu'][0]} is not installed")
    return python_of(request.param) or pytest.skip(
        f"build/portable has no Python of {request.param}: ./dev wheel --all gets it"
    )


@pytest.fixture
def ends(native, tmp_path):
    """A folder with the two ends of a path."""
    (tmp_path / "start.pdb").write_bytes(PEPTIDE)
    words = ["--frames", 1, "--seed", 5, "-o", "end.pdb"]
    native.succeed("sample", "start.pdb", *words, cwd=tmp_path)
    return tmp_path


@pytest.mark.parametrize("options", [[], ["--atoms", "heavy", "--both"]], ids=["CA", "heavy"])
def test_paths_have_the_same_bytes(theirs, ends, options):
    found = []
    for python, output in ((theirs, "theirs.h5md"), (python_of(THIS), "ours.h5md")):
        words = ["start.pdb", "end.pdb", *options, "-o", output]
        done = python.run("-c", PATH, *words, cwd=ends)
        assert done.returncode in (0, 3), done.stderr  # 3: the end is not reached
        found.append(stored(ends / output))
    other, datasets = found
    assert len(datasets) > 20
    assert datasets.keys() == other.keys()
    assert [name for name in datasets if datasets[name] != other[name]] == []


def test_the_tests_of_the_wheel_pass(theirs, tmp_path):
    printed = theirs.succeed("-m", "pytest", "--quiet", "--pyargs", "pliant", cwd=tmp_path)
    assert " passed" in printed.decode()
