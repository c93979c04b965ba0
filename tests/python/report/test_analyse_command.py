# SPDX-License-Identifier: MIT
"""pliant analyse: files, figures and tables it writes, and what it says when it cannot."""

import csv
import json
import shutil
import subprocess
from pathlib import Path

import h5py
import numpy as np
import pytest
from pliant.base.console import plain
from pliant.report.command import main
from pliant.report.sections.series import Rmsd

import pliant

without_figures = pytest.mark.usefixtures("no_drawing")


@pytest.fixture
def run(tmp_path, peptide, wander, write_run):
    trajectory = wander(peptide, peptide.rotatable, 24, degrees=12.0)
    trajectory[9, 4] += [0.0, 0.0, 0.01]
    flags = np.arange(24) != 9
    return write_run(tmp_path / "run.h5md", peptide, trajectory, converged=flags)


@pytest.fixture
def analysed(tmp_path, run, capsys):
    """Runs the command; returns exit code, standard output and error."""

    def call(*arguments):
        code = main([str(run), "-o", str(tmp_path / "out"), "--dpi", "50", *map(str, arguments)])
        text = capsys.readouterr()
        return code, text.out, text.err

    return call


def read_csv(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


FIGURES = set(
    "residuals sweeps rmsd radius_of_gyration flexibility correlations motions torsions "
    "ramachandran pca".split()
)
TABLES = set(
    "frames atoms residues bars torsions torsion_histograms torsion_angles pca "
    "flexibility correlations stereochemistry".split()
)
EXPORTS = {"bfactors.pdb", "ensemble.pdb", "modes.nmd", "show.pml", "show.cxc"}


def test_it_writes_figures_tables_and_the_page(tmp_path, analysed, rendered):
    code, out, err = analysed()
    assert code == 0
    assert err == ""
    assert out.startswith(
        "verdict         A path of pushes, not an ensemble. 1 of 24 frames have a bar beyond "
        "tolerance; the run says so of each."
    )
    assert out.endswith(f"report          {tmp_path / 'out' / 'report.html'}\n")
    written = {path.name for path in (tmp_path / "out").iterdir()}
    made = {f"{n}.png" for n in FIGURES} | {f"{n}.csv" for n in TABLES} | EXPORTS
    assert written == made | {"report.html"}
    for name in FIGURES:
        assert (tmp_path / "out" / f"{name}.png").read_bytes().startswith(b"\x89PNG")


@without_figures
def test_json_has_the_numbers_that_numpy_finds(run, analysed, peptide):
    code, out, _ = analysed("--json")
    found = json.loads(out)
    with h5py.File(run) as file:
        positions = file["particles/trajectory/position/value"][()]
    ends = positions[:, peptide.bonds]
    lengths = np.linalg.norm(ends[:, :, 1] - ends[:, :, 0], axis=2)
    relative = np.abs(lengths / peptide.rest_lengths - 1)
    assert code == 0
    assert found["max_residual"] == pytest.approx(relative.max(), rel=1e-9)
    assert found["frames_beyond_tolerance"] == 1
    assert found["frames_not_converged"] == 1
    assert found["converged_but_beyond"] == 0
    assert found["verdict"] == "mixed"
    assert found["atoms"] == len(peptide.elements)
    assert found["bars"] == len(peptide.bonds)
    assert found["frames"] == 24
    assert found["sweeps_mean"] == pytest.approx(6.0)
    assert found["rotatable_bonds"] == 10  # phi, psi, omega; no phi before the first residue
    assert found["skipped"] == {}
    assert 0.99 < sum(found["pca_explained"]) <= 1.0 + 1e-9


@without_figures
def test_the_function_gives_what_the_command_prints(tmp_path, run, analysed):
    printed = json.loads(analysed("--json", "--select", "name CA CB")[1])
    chosen = {"select": "name CA CB", "dpi": 50}
    written = pliant.analyse(run, tmp_path / "out", **chosen)
    assert json.loads(json.dumps(plain(written.as_json()))) == printed
    assert written.verdict.kind == printed["verdict"] == "mixed"
    shutil.rmtree(tmp_path / "out")
    alone = pliant.analyse(run, **chosen)
    assert not (tmp_path / "out").exists()
    assert alone.outputs == {}
    np.testing.assert_array_equal(alone.analysis[Rmsd].fitted, written.analysis[Rmsd].fitted)


@without_figures
def test_the_table_of_frames(tmp_path, run, analysed, peptide):
    analysed("--quiet")
    rows = read_csv(tmp_path / "out" / "frames.csv")
    assert [int(row["frame"]) for row in rows] == list(range(24))
    assert [int(row["step"]) for row in rows] == [10 * k for k in range(24)]
    assert [row["within_tolerance"] for row in rows] == ["0" if k == 9 else "1" for k in range(24)]
    assert [row["converged"] for row in rows] == ["0" if k == 9 else "1" for k in range(24)]
    assert {int(rows[9]["worst_bar_i"]), int(rows[9]["worst_bar_j"])} & {4}
    with h5py.File(run) as file:
        observed = file["observables/max_residual/value"][()]
    measured = [float(row["max_relative_residual"]) for row in rows]
    np.testing.assert_allclose(measured, observed, rtol=1e-9, atol=1e-15)
    assert float(rows[0]["rmsd_angstrom"]) < 1e-5
    assert float(rows[0]["rmsd_all_angstrom"]) < 1e-5
    assert {"pc1_angstrom", "pc2_angstrom", "radius_of_gyration_angstrom", "sweeps"} <= set(rows[0])


@without_figures
def test_the_tables_of_atoms_residues_bars_torsions_and_components(tmp_path, analysed, peptide):
    analysed("--quiet")
    folder = tmp_path / "out"
    atoms = read_csv(folder / "atoms.csv")
    assert [row["name"] for row in atoms] == peptide.names
    residues = read_csv(folder / "residues.csv")
    assert [row["residue_name"] for row in residues] == ["ALA"] * 4
    for k, row in enumerate(residues):
        own = [float(a["rmsf_angstrom"]) for a in atoms if int(a["residue_number"]) == k + 1]
        assert float(row["rmsf_angstrom"]) == pytest.approx(np.sqrt(np.mean(np.square(own))))
    bars = read_csv(folder / "bars.csv")
    assert [(int(row["i"]), int(row["j"])) for row in bars] == [tuple(b) for b in peptide.bonds]
    assert bars[0]["name"] == "ALA1:N – ALA1:CA"
    torsions = read_csv(folder / "torsions.csv")
    assert {"ALA1 psi", "ALA2 phi", "ALA2 psi", "ALA1 omega"} <= {
        row["torsion"] for row in torsions
    }
    histograms = read_csv(folder / "torsion_histograms.csv")
    assert sum(float(row["ALA2 phi"]) for row in histograms) * 10 == pytest.approx(1.0)
    angles = read_csv(folder / "torsion_angles.csv")
    assert len(angles) == 24
    pca = read_csv(folder / "pca.csv")
    shares = [float(row["explained"]) for row in pca]
    assert shares == sorted(shares, reverse=True)
    assert float(pca[-1]["cumulative"]) == pytest.approx(1.0)


@without_figures
def test_a_frame_that_breaks_its_promise_is_called_bad(tmp_path, peptide, write_run, capsys):
    trajectory = np.array([peptide.positions] * 5)
    trajectory[2, 3] += 0.1
    path = write_run(tmp_path / "liar.h5md", peptide, trajectory)
    assert main([str(path), "-o", str(tmp_path / "out"), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["verdict"] == "bad"
    assert found["converged_but_beyond"] == 1
    assert "1 of which the run calls converged." in found["verdict_text"]


@without_figures
def test_frames_and_atoms_can_be_chosen(analysed):
    _, out, _ = analysed("--json", "--frames", "3:20:4", "--select", "resid 1:2")
    found = json.loads(out)
    assert found["frames"] == 5
    assert (found["first_frame"], found["last_frame"]) == (3, 19)
    assert found["atoms_analysed"] < found["atoms"]
    _, out, _ = analysed("--json", "--superpose", "name CA C N", "--mass-weighted")
    assert json.loads(out)["superposed_on"] == "atoms 'name CA C N'"


@without_figures
@pytest.mark.filterwarnings("ignore::UserWarning")
def test_two_workers_find_the_same(analysed):
    one = json.loads(analysed("--json")[1])
    two = json.loads(analysed("--json", "--workers", 2)[1])
    for key, value in one.items():
        if isinstance(value, (int, float)):
            assert two[key] == pytest.approx(value, rel=1e-6), key


@without_figures
def test_a_trajectory_of_another_program(tmp_path, peptide, wander, capsys):
    """Positions only, as MDAnalysis writes them: what needs bars is left out and said."""
    import MDAnalysis

    trajectory = wander(peptide, peptide.rotatable, 12, degrees=10.0)
    universe = MDAnalysis.Universe.empty(len(peptide.elements), trajectory=True)
    universe.load_new(trajectory)
    universe.atoms.write(str(tmp_path / "foreign.xtc"), frames="all")
    topology = tmp_path / "foreign.pdb"
    universe.add_TopologyAttr("names", peptide.names)
    universe.atoms.write(str(topology))
    code = main(
        [str(tmp_path / "foreign.xtc"), "--topology", str(topology), "-o", str(tmp_path / "out")]
    )
    text = capsys.readouterr()
    assert code == 0
    assert "note: no bar residuals: the trajectory holds no bars with rest lengths" in text.err
    assert "note: no sweeps: the file holds no /observables/sweeps" in text.err
    assert "note: no torsions: there are no bonds" in text.err
    assert not (tmp_path / "out" / "residuals.png").exists()
    assert (tmp_path / "out" / "rmsd.png").exists()
    assert (tmp_path / "out" / "report.html").exists()


@without_figures
def test_frames_that_are_no_numbers_are_left_out(tmp_path, peptide, write_run, capsys):
    trajectory = np.array([peptide.positions] * 6)
    trajectory[4, 0] = np.nan
    path = write_run(tmp_path / "holes.h5md", peptide, trajectory)
    assert main([str(path), "-o", str(tmp_path / "out"), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["frames"] == 5
    text = "1 frames hold coordinates that are not finite: left out"
    assert text in found["notes"]
    assert main([str(path), "-o", str(tmp_path / "out")]) == 0
    assert f"note: {text}\n" in capsys.readouterr().err


@without_figures
def test_a_file_that_was_cut_off_is_read_up_to_there(tmp_path, peptide, write_run, capsys):
    path = write_run(tmp_path / "cut.h5md", peptide, np.array([peptide.positions] * 6))
    with h5py.File(path, "a") as file:
        position = file["particles/trajectory/position"]
        steps = position["step"][:4]
        del position["step"]
        position["step"] = steps
    assert main([str(path), "-o", str(tmp_path / "out"), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["frames"] == 4
    assert "the last 2 frames are not complete: left out" in found["notes"]


@without_figures
def test_one_frame_is_enough(tmp_path, peptide, write_run, capsys):
    path = write_run(tmp_path / "one.h5md", peptide, [peptide.positions])
    assert main([str(path), "-o", str(tmp_path / "out"), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["verdicts"]["bars"]["kind"] == "good"
    assert found["skipped"] == {
        "RMSF": "a single frame does not fluctuate",
        "PCA": "it needs at least 3 frames",
        "flexibility": "it needs at least 4 frames",
    }


def refused(arguments, capsys):
    """Exit code of the command and the one line that it says."""
    code = main([*map(str, arguments)])
    error = capsys.readouterr().err
    assert error.startswith("pliant analyse: error: ")
    assert error.count("\n") == 1
    return code, error.removeprefix("pliant analyse: error: ").rstrip("\n")


@without_figures
def test_input_that_cannot_be_read_is_exit_code_1(tmp_path, peptide, write_run, capsys):
    text = tmp_path / "text.h5md"
    text.write_text("no HDF5")
    good = write_run(tmp_path / "good.h5md", peptide, [peptide.positions])
    missing = tmp_path / "none.pdb"
    for arguments, message in (
        ([missing], f"{missing}: no such file"),
        ([tmp_path], f"{tmp_path}: is a folder, expected a trajectory file"),
        ([good, "--topology", missing], f"{missing}: no such file"),
        ([good, "--reference", missing], f"{missing}: no such file"),
        ([good, "-o", text], f"{text}: is a file, expected a folder for the results"),
    ):
        assert refused(arguments, capsys) == (1, message)
    topology = tmp_path / "text.psf"
    topology.write_text("no topology")
    code, message = refused([good, "--topology", topology], capsys)
    assert code == 1
    assert message.startswith(f"{good} with topology {topology}: MDAnalysis cannot read it: ")


@without_figures
def test_a_choice_that_is_wrong_or_empty_is_exit_code_2(tmp_path, peptide, write_run, capsys):
    good = write_run(tmp_path / "good.h5md", peptide, [peptide.positions])
    for arguments, message in (
        (["--select", "name XX"], "--select 'name XX': selects no atoms"),
        (["--distance", "name CA", "name XX"], "--distance 'name XX': selects no atoms"),
        (["--frames", "5:"], "frames: choose none of the 1 frames"),
    ):
        assert refused([good, *arguments], capsys) == (2, message)
    code, message = refused([good, "--superpose", "resid ("], capsys)
    assert code == 2
    assert message.startswith("--superpose 'resid (': ")


@pytest.mark.parametrize(
    "arguments",
    [
        [],
        ["a", "b"],
        ["a", "--frames", "::0"],
        ["a", "--frames", "5"],
        ["a", "--workers", "x"],
        ["a", "--nonsense"],
    ],
)
@without_figures
def test_wrong_usage_is_exit_code_2(arguments, capsys):
    with pytest.raises(SystemExit) as ended:
        main(arguments)
    assert ended.value.code == 2
    assert "pliant analyse: error:" in capsys.readouterr().err


@without_figures
def test_scripts_for_viewers(tmp_path, analysed):
    analysed()
    pymol = (tmp_path / "out" / "show.pml").read_text()
    assert ";" not in pymol, "PyMOL runs what follows a semicolon, even after a #"
    assert ("scene F2" in pymol) == ("select domain1" in pymol)
    # Anything below 2 plays once: src/bundles/std_commands/src/coordset.py of ChimeraX.
    assert "coordset #1 1,-1 pauseFrames 4 loop 100" in (tmp_path / "out" / "show.cxc").read_text()


@without_figures
@pytest.mark.skipif(not Path("/usr/bin/pymol").exists(), reason="no PyMOL is installed")
def test_pymol_runs_the_script(tmp_path, analysed):
    analysed()
    count = "print('states', cmd.count_states())"
    words = ["/usr/bin/pymol", "-cq", "show.pml", "-d", "mstop", "-d", count]  # else it plays on
    done = subprocess.run(
        words,
        cwd=tmp_path / "out",
        capture_output=True,
        text=True,
        timeout=900,
        env={"PATH": "/usr/bin:/bin"},
    )
    assert "Error" not in done.stdout + done.stderr
    assert "states 24" in done.stdout
