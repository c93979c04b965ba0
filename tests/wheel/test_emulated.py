# SPDX-License-Identifier: MIT
"""The commands of other systems give the same bits as that of this one: samples, conformers, runs
with several techniques, and texts. Each writes in a folder of its own, by the same names."""

import pytest
from emulated import EMULATED, ROOT
from h5md_contents import stored

MOLECULES = ROOT / "data/molecules"
RECORDED = {
    "sample of a peptide": "sample peptide_20.pdb --frames 12 --seed 3",
    "sample with the dilute sampler": "sample peptide_20.pdb --sampler dilute --frames 6 --seed 4",
    "conformers": "sample caffeine.sdf --frames 20",
    "run": "run peptide_20.pdb --steps 60 --every 10",
    "run by blocks": "run peptide_20.pdb --technique blocks --steps 40 --every 10",
    "run of a model": "run peptide_20.pdb --model protein --steps 40 --every 10",
    "run of walkers": "run peptide_20.pdb --walkers 4 --steps 20 --every 10",
}
PRINTED = {
    "contacts": "contacts peptide_20.pdb",
    "rigidity": "rigidity peptide_20.pdb",
    "dilution": "rigidity peptide_20.pdb --dilution",
    "order": "lab order caffeine.sdf",
    "info": "info peptide_20.pdb --json",
}


def written(command, folder, line):
    """What each file that the command writes holds."""
    folder.mkdir()
    for name in ("peptide_20.pdb", "caffeine.sdf"):
        (folder / name).write_bytes((MOLECULES / name).read_bytes())
    command.succeed(*line.split(), "-o", "out.h5md", cwd=folder)
    files = {path.name: stored(path) for path in sorted(folder.glob("*.h5md"))}
    assert files
    return files


@pytest.mark.parametrize("target", EMULATED)
@pytest.mark.parametrize("line", RECORDED.values(), ids=RECORDED.keys())
def test_every_dataset_has_the_same_bytes(command, native, tmp_path, target, line):
    theirs = written(command(target), tmp_path / "theirs", line)
    ours = written(native, tmp_path / "ours", line)
    assert theirs.keys() == ours.keys()
    for file, datasets in ours.items():
        assert len(datasets) > 20
        other = theirs[file]
        assert datasets.keys() == other.keys()
        assert [name for name in datasets if datasets[name] != other[name]] == []


@pytest.mark.parametrize("target", EMULATED)
@pytest.mark.parametrize("line", PRINTED.values(), ids=PRINTED.keys())
def test_the_same_is_printed(command, native, target, line):
    theirs = command(target).succeed(*line.split(), cwd=MOLECULES)
    assert theirs == native.succeed(*line.split(), cwd=MOLECULES)
    assert theirs
