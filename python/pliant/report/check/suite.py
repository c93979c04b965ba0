# SPDX-License-Identifier: MIT
"""The whole check of one trajectory: what is asked of OpenMM, and what the answers mean."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence

import numpy as np

from pliant._core import InputError
from pliant.base.checked import ABOVE_0, POSITIVES, SEED, checked, whole
from pliant.base.console import note, progress
from pliant.base.extras import late, need
from pliant.base.force_field_options import ONE_OF_CHARGES, ForceFieldOptions
from pliant.checks import contest as side_by_side
from pliant.checks import ours, theirs
from pliant.checks.check_energy import check_energy, energy_job
from pliant.checks.check_frames import broken_copies, check_frames, frame_job
from pliant.checks.check_record import Remeasured, check_record, remeasure
from pliant.checks.contest import DISPLACEMENTS, Contest
from pliant.checks.fewer_bars import for_constraints, note_on
from pliant.checks.force_field.minimise import QUICK, THOROUGH, Wanted, minimise_file, why_not_file
from pliant.checks.force_field.verdicts import findings_of, skipped
from pliant.checks.openmm.child import TIME_LIMIT, Outcome, run_jobs
from pliant.checks.sample import Sample, take_sample
from pliant.measure import bars as _bars
from pliant.report.check.check_report import CheckReport
from pliant.trajectory.h5md import FramesOfH5md
from pliant.trajectory.kind import ENSEMBLE
from pliant.trajectory.opened import one_file

pictures = late("pliant.report.check.pictures")

FRAMES = 20
ENERGY_DISPLACEMENT = 0.1  #: Angstrom; of the copies whose energies are compared
MOST_ENERGIES = 10


@checked(
    frames=whole(1, name="all"),
    displacements=POSITIVES,
    seed=SEED,
    time_limit=ABOVE_0,
    starts=whole(1, name="all"),
    long_starts=whole(0),
    md_steps=whole(0),
    total_limit=ABOVE_0,
    charges=ONE_OF_CHARGES,
)
def check(
    path: str | os.PathLike[str],
    *,
    frames: int | str = FRAMES,
    displacements: Sequence[float] = DISPLACEMENTS,
    seed: int = 0,
    time_limit: float = TIME_LIMIT,
    force_field: bool | None = None,
    thorough: bool = False,
    starts: int | str | None = None,
    long_starts: int | None = None,
    md_steps: int | None = None,
    start: str | os.PathLike[str] | None = None,
    total_limit: float = Wanted.total_limit,
    charges: str = "am1-bcc",
    ligands: Mapping[str, str] | None = None,
    platform: str = "auto",
    picture: str | os.PathLike[str] | None = None,
    quiet: bool = True,
) -> CheckReport:
    """Checks a trajectory that ``pliant run`` or ``pliant sample`` wrote against OpenMM.

    Every bar of every frame is measured in double precision. Then OpenMM, in a process of its own,
    gets some of the frames: its constraints must leave whole frames unchanged and move copies with
    one broken bar, and its harmonic bonds must have the energy that Pliant computes. Then frames
    of a run are broken at random, and Pliant's techniques and OpenMM's CCMA repair the same ones.

    For an ensemble of a protein, OpenMM minimises a few frames and the start structure, all in the
    same way: amber14 and implicit water (OBC2), missing hydrogens placed by rule. The result says
    whether the frames can be used to start MD; `report.covers` says which frames and which parts of
    the molecule it covers. With `thorough` there are more frames, some are minimised for longer,
    and frames of a short MD are shown beside them: that takes minutes. Results do not depend on
    the number of cores.

    Parameters
    ----------
    path : str or path
        H5MD file.
    frames : int or "all"
        How many frames OpenMM gets, spread evenly, the worst among them.
    displacements : floats
        Standard deviations of the displacements that break frames, Angstrom.
    seed : int
        Seed of the displacements.
    time_limit : float
        A job of OpenMM is given up after so many seconds.
    force_field : bool, optional
        Whether OpenMM minimises frames; by default where the file is an ensemble of a protein, or
        `start` is given.
    thorough : bool
        Look at 20 frames, minimise 3 of them for 500 steps, and make 250 steps of MD.
    starts : int or "all", optional
        Frames that are minimised for 100 steps, spread evenly. Default: 5 of a molecule of up to
        2000 atoms, 3 of a larger one; 20 if `thorough`.
    long_starts : int, optional
        How many of these are minimised for 500 steps. Default: 0; 3 if `thorough`.
    md_steps : int, optional
        Steps of 4 fs of the MD from the start structure, 0 for none. Default: 0; 250 if `thorough`.
    start : str or path, optional
        The structure that the ensemble began with; by default the PDB beside the trajectory.
    total_limit : float
        After so many seconds of minimising no structure is begun; what there is by then is given,
        and called partial.
    charges : "am1-bcc", "gasteiger" or "none"
        Of ligands, which get GAFF2 parameters by AmberTools; "none": they are left out.
    ligands : mapping, optional
        SMILES of ligands by residue name: bond orders, charges and hydrogens. Default: those of the
        file, else guessed, which the report says.
    platform : str
        Of OpenMM: "CUDA", "HIP", "OpenCL", "CPU" or "Reference". Default: the fastest that works.
    picture : str or path, optional
        Where to draw a PNG.
    quiet : bool
        Show no progress.

    Raises
    ------
    ImportError
        OpenMM, or matplotlib for a picture, is not installed; the message says how to install it.
    InputError
        The file is missing or not a trajectory of Pliant, or `force_field` is true and there is no
        start structure or no protein; the message says what is missing.
    OptionError
        An option is out of range, or OpenMM does not have the platform here.
    OSError
        The picture cannot be written.
    """
    need("pliant.check", "openmm")
    if picture is not None:
        need("a picture of pliant.check", "matplotlib")
    recording = one_file(path)
    if recording.joints_of_whole:
        raise InputError(
            f"{path}: holds {recording.atom_count} of the molecule's {recording.joints_of_whole} "
            "atoms (--save): a check by a force field needs all of them"
        )
    with progress("measuring frames", quiet) as show:
        remeasured = remeasure(recording, show)
    sample = take_sample(recording, frames, remeasured.worst_frame(recording.converged))
    report = _ask_openmm(recording, sample, remeasured, displacements, seed, time_limit, quiet)
    report.findings.insert(0, check_record(recording, remeasured))
    usual = THOROUGH if thorough else QUICK
    wanted = Wanted(
        usual.starts if starts is None else starts,
        usual.long_starts if long_starts is None else long_starts,
        usual.md_steps if md_steps is None else md_steps,
        start,
        time_limit,
        total_limit,
        ForceFieldOptions(charges, ligands or {}, platform),
    )
    if force_field is None and start is None:
        if recording.kind == ENSEMBLE:
            _minimise_where_it_applies(report, wanted, quiet)
    elif force_field is not False:
        _minimise(report, wanted, quiet)
    if picture is not None:
        report.picture = os.fspath(picture)
        pictures.draw(report, report.picture)
    return report


def _minimise_where_it_applies(report: CheckReport, wanted: Wanted, quiet: bool) -> None:
    """Leaves the force field out, and says why, of what it is not for."""
    why = why_not_file(report.recording.name)
    if why:
        report.findings += skipped(why)
    else:
        _minimise(report, wanted, quiet)


def _minimise(report: CheckReport, wanted: Wanted, quiet: bool) -> None:
    say = (lambda _: None) if quiet else note
    with progress("structures minimised by OpenMM", quiet, lines=True) as show:
        found = minimise_file(report.recording.name, wanted, show, say)
    report.force_field = found
    report.findings += skipped(found.why_not) if found.why_not else findings_of(found)


def _ask_openmm(
    recording: FramesOfH5md,
    sample: Sample,
    remeasured: Remeasured,
    displacements: Sequence[float],
    seed: int,
    time_limit: float,
    quiet: bool,
) -> CheckReport:
    report = CheckReport(recording, sample, remeasured, [], [], "", 0.0)
    report.notes += _notes_on(recording)
    if len(recording.bars) == 0:
        none = sample.positions[:0]
        report.findings += [
            *check_frames(sample, none, None),
            *check_energy(sample, none, none, None),
        ]
        return report
    shown = for_constraints(sample)
    report.notes += note_on(sample, shown)
    broken = broken_copies(shown)
    shaken = _bars.displaced(sample.positions[:MOST_ENERGIES], ENERGY_DISPLACEMENT, seed)
    arena = side_by_side.prepare_contest(sample, displacements, seed + 1)
    resolved = ours.resolved_copies(recording, shaken, arena.tolerance)
    ways = () if recording.kind == ENSEMBLE else theirs.ways_for(arena)
    jobs = [
        frame_job(shown, broken),
        energy_job(recording, np.concatenate([sample.positions, shaken, resolved])),
        *(theirs.contest_jobs(arena, ways) if ways else ()),
    ]
    with progress("OpenMM jobs", quiet) as show:
        outcomes, report.openmm_version = run_jobs(jobs, time_limit, show)
    report.findings += check_frames(shown, broken, outcomes[0])
    report.findings += check_energy(sample, shaken, resolved, outcomes[1])
    if ways:
        _hold_contest(report, arena, ways, outcomes[2:])
    return report


def _hold_contest(
    report: CheckReport, arena: Contest, ways: Sequence[theirs.Way], outcomes: list[Outcome]
) -> None:
    report.methods = ours.our_methods(arena) + theirs.their_methods(arena, ways, outcomes)
    report.tolerance = arena.tolerance
    report.findings.append(side_by_side.check_honesty(report.methods))
    report.notes += [note for note in (arena.note, theirs.cpu_note(len(ways), outcomes)) if note]


def _notes_on(recording: FramesOfH5md) -> list[str]:
    notes = []
    pinned = int(recording.pinned.sum())
    if pinned:
        notes.append(
            f"{pinned} pinned joints are free wherever bars are repaired, by us and by OpenMM, "
            "which refuses a constraint between an atom of mass 0 and another"
        )
    if recording.kind == ENSEMBLE:
        notes.append(
            "frames of an ensemble are drawn, none is a repair of the one before: Pliant and "
            "OpenMM do not race to repair them, which they do for trajectories of pliant run"
        )
    elif recording.angle_bars:
        notes.append(
            "bars made of angles depend on each other: CCMA inverts a matrix that is then "
            "singular, so what OpenMM does with broken frames is shown, but not judged"
        )
    if recording.is_single:
        notes.append("positions are stored as 32-bit floats: what that changes is allowed for")
    return notes
