# SPDX-License-Identifier: MIT
"""Frames in each format: sizes are those of the files, errors those of what is read back."""

import csv
import json
from pathlib import Path

import pytest
from pliant.lab.bench.command import main
from pliant.lab.bench.record_formats import H5MD, OTHERS, record_formats

PEPTIDE = Path(__file__).parents[4] / "data" / "molecules" / "peptide_20.pdb"

#: Largest error of a coordinate, Angstrom, and bytes of one.
EXPECTED = {
    "H5MD": (0.0, 8),
    "H5MD --compress": (0.0, 8),
    "H5MD --single": (4e-6, 4),
    "H5MD --precision 1e-3": (0.5e-3, 8),
    "H5MD --precision 1e-2": (0.5e-2, 8),
    "DCD": (4e-6, 4),
    "XTC": (0.5001e-2, 2),
}


@pytest.fixture(scope="module")
def found():
    return record_formats(PEPTIDE, frames=12, repeats=1)


def test_every_format_keeps_what_it_says(found):
    assert [row.format for row in found.rows] == [*H5MD, *OTHERS]
    rows = {row.format: row for row in found.rows}
    for name, (off, _) in EXPECTED.items():
        assert rows[name].off <= off, name
        assert rows[name].atoms == found.joints
        assert rows[name].write_microseconds > 0 and rows[name].read_microseconds > 0
    assert rows["H5MD --precision 1e-2"].off > rows["H5MD --precision 1e-3"].off > 1e-4
    assert rows["H5MD --save 'name CA'"].atoms == 20 and rows["H5MD --save 'name CA'"].off == 0


def test_sizes_are_those_of_the_coordinates(found):
    rows = {row.format: row for row in found.rows}
    assert rows["H5MD"].bytes_a_frame > 24 * found.joints
    assert 12 * found.joints < rows["DCD"].bytes_a_frame < 13 * found.joints + 200
    assert rows["XTC"].bytes_a_frame < 6 * found.joints


def test_the_command_prints_and_writes(tmp_path, capsys):
    path = tmp_path / "rows.csv"
    words = ["record", str(PEPTIDE), "--formats", "--repeats", "1", "--csv", str(path)]
    assert main(words) == 0
    assert "H5MD --precision 1e-3" in capsys.readouterr().out
    assert len(list(csv.DictReader(path.open()))) == len(H5MD) + len(OTHERS)
    assert main([*words[:-2], "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["frames"] == 200
