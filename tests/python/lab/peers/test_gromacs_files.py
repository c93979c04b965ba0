# SPDX-License-Identifier: MIT
"""GROMACS' files: what we write is what GROMACS' formats ask for, what we read is what is there."""

import struct

import numpy as np
import pytest
from pliant.lab.peers import gromacs_files as files
from pliant.lab.peers.gromacs_files import Setting

MASSES = np.array([12.0, 1.0, 16.0, 1.0])
LOG = """
     R E A L   C Y C L E   A N D   T I M E   A C C O U N T I N G

 Computing:          Num   Num      Call    Wall time         Giga-Cycles
                     Ranks Threads  Count      (s)         total sum    %
-----------------------------------------------------------------------------
 Force                  1    1        501       0.060          0.139  32.7
 Update                 1    1        501       0.047          0.108  25.5
 Constraints            1    1        401       1.066          0.152  35.8
 Rest                                           0.001          0.001   0.3
"""
FATAL = """
starting mdrun 'bars'

-------------------------------------------------------
Program:     gmx mdrun, version 2022.5
Source file: src/gromacs/mdlib/constr.cpp (line 240)
MPI rank:    0 (out of 1)

Fatal error:
Too many LINCS warnings (1000)
If you know what you are doing you can adjust the threshold
-------------------------------------------------------
"""


def sections(text):
    """Lines of a .top or .ndx file by the name of their section."""
    found = {}
    for line in text.splitlines():
        if line.startswith("["):
            found[line.strip("[ ]")] = rows = []
        else:
            rows.append(line.split())
    return found


def test_coordinates_stand_in_columns_within_the_box():
    positions = np.array([[-3.0, 0.0, 0.25], [1.0 / 3, 2.0, -7.0]])
    title, count, *lines, box = files.coordinates_text(positions, push=0.01).splitlines()
    assert title and count == "2"
    # Residue number, residue, atom, atom number in 5 each; then coordinates: 20 columns each.
    assert [line[:20] for line in lines] == ["    1BARS     A    1", "    1BARS     A    2"]
    read = np.array([[float(line[k : k + 20]) for k in (20, 40, 60)] for line in lines])
    assert read[1] - read[0] == pytest.approx(positions[1] - positions[0], abs=1e-14)
    edges = np.array(box.split(), float)
    assert np.all(read > 0.5) and np.all(read < edges - 0.5)


def test_topology_holds_masses_bars_and_tethers():
    bars = np.array([[0, 1], [0, 3]])
    top = sections(files.topology_text(MASSES, bars, np.array([0.109, 0.1])))
    assert [(float(row[7]), float(row[6])) for row in top["atoms"]] == [
        (12, 0),
        (1, 0),
        (16, 0),
        (1, 0),
    ]
    assert top["constraints"] == [["1", "2", "2", f"{0.109:.17g}"], ["1", "4", "2", f"{0.1:.17g}"]]
    springs = [[float(k) for k in row[2:]] for row in top["position_restraints"]]
    assert springs == [3 * [files.TETHER * mass] for mass in MASSES]


def test_groups_are_of_one_mass_each():
    groups = sections(files.groups_text(np.tile(MASSES, 10)))
    assert {name: sum(map(len, rows)) for name, rows in groups.items()} == {
        "System": 40,
        "M0": 20,
        "M1": 10,
        "M2": 10,
    }
    assert groups["M1"][0][:3] == ["1", "5", "9"]


def test_temperatures_push_all_masses_alike():
    push, boltzmann = 0.01, 8.31446261815324e-3
    heat = files.temperatures(MASSES, push)
    noise = 2 * boltzmann * heat / np.array([1.0, 12.0, 16.0])  # dt and tau are 1 ps
    # x is off by a variance v = noise / (1 - (1 - a)^2); a step adds noise and takes a x away.
    a = files.TETHER
    step = a**2 * noise / (1 - (1 - a) ** 2) + noise
    assert np.sqrt(step) == pytest.approx(np.full(3, push))


def test_parameters_tell_the_setting():
    text = files.parameters_text(Setting("lincs", 8, 3), MASSES, 0.01, 700, 70, 5)
    values = dict(line.split(" = ") for line in text.splitlines())
    assert (values["lincs-order"], values["lincs-iter"]) == ("8", "3")
    assert (values["nsteps"], values["nstxout"], values["ld-seed"]) == ("700", "70", "5")
    assert values["tc-grps"] == "M0 M1 M2" and len(values["ref-t"].split()) == 3
    text = files.parameters_text(Setting("shake", tolerance=1e-7), MASSES, 0.01, 9, 1, 1)
    assert "constraint-algorithm = shake\n" in text and "shake-tol = 1e-07\n" in text


def test_settings_have_a_name():
    assert str(Setting("lincs", 4, 1)) == "order 4, 1 iteration"
    assert str(Setting("lincs", 8, 2)) == "order 8, 2 iterations"
    assert str(Setting("shake", tolerance=1e-5)) == "tolerance 1e-05"


def test_the_log_tells_calls_and_seconds():
    assert files.constraint_seconds(LOG) == (401, 1.066)
    with pytest.raises(ValueError, match="no row of times for constraints"):
        files.constraint_seconds(LOG.replace("Constraints", "Comm. coord."))


def test_errors_are_reported_in_a_line():
    assert files.complaint(FATAL) == "Too many LINCS warnings (1000)"
    assert (
        files.complaint(FATAL.replace("1000)", "1000). More")) == "Too many LINCS warnings (1000)"
    )
    assert files.complaint("ERROR 1 [file a.mdp]:\n  Only full pbc\n\n" + FATAL) == "Only full pbc"
    assert files.complaint("starting mdrun 'bars'\n") == ""


def frame(step, positions, real):
    """A frame of a .trr file with box, positions and velocities, as GROMACS writes them."""
    count, kind = len(positions), f">f{real}"
    text = b"GMX_trn_file"
    sizes = [0, 0, 9 * real, 0, 0, 0, 0, 3 * count * real, 3 * count * real, 0]
    head = struct.pack(">3i", 1993, len(text) + 1, len(text)) + text
    head += struct.pack(">13i", *sizes, count, step, 0)
    head += np.array([0.5, 0.0], kind).tobytes()
    parts = [np.eye(3), positions, -positions]
    return head + b"".join(np.asarray(part, kind).tobytes() for part in parts)


@pytest.mark.parametrize("real", [4, 8])
def test_frames_are_read_in_the_precision_they_have(tmp_path, real):
    first = np.array([[0.1, 0.2, 0.3], [1.0, 2.0, 3.0]])
    (tmp_path / "a.trr").write_bytes(frame(0, first, real) + frame(50, first + 1, real))
    (a, there), (b, later) = files.read_frames(tmp_path / "a.trr")
    assert (a, b) == (0, 50)
    assert np.array_equal(there, first.astype(f"f{real}")) and there.dtype == np.float64
    assert np.array_equal(later, (first + 1).astype(f"f{real}"))


@pytest.mark.parametrize("cut", [5, 40, 120])
def test_a_torn_frame_is_refused(tmp_path, cut):
    whole = frame(0, np.ones((2, 3)), 8)
    (tmp_path / "a.trr").write_bytes(whole + whole[:cut])
    frames = files.read_frames(tmp_path / "a.trr")
    next(frames)
    with pytest.raises(ValueError, match="the file ends within a frame"):
        next(frames)


def test_another_file_is_refused(tmp_path):
    (tmp_path / "a.trr").write_bytes(b"ATOM      1  N   MET A   1")
    with pytest.raises(ValueError, match="instead of 1993"):
        list(files.read_frames(tmp_path / "a.trr"))
