# SPDX-License-Identifier: MIT
"""Whether frames can be used to start MD: the criteria, and the answers."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from pliant.base.verdict import Verdict
from pliant.checks.findings import CANNOT, FAILED, OF_MD_STARTS, SKIPPED, Finding, verdict
from pliant.checks.force_field.minimised import LONG, SHORT, ForceFieldReport, Minimised

SHARE = 0.95  #: of the frames that must be within each of the three limits below
MOST_ABOVE = {SHORT: 3.0, LONG: 1.0}  #: kJ/mol a residue above the start, by steps
MOST_MOVED = 0.4  #: Angstrom, alpha carbons in 100 steps
MOST_LIGAND_MOVED = 1.0  #: Angstrom, a ligand without hydrogens in 100 steps
MOST_STRAIN = 50.0  #: kJ/mol of a ligand above its strain in the start
MOST_FORCE = 1e9  #: kJ/(mol nm) on an atom before: more is two atoms nearer than some 0.7 Angstrom
LEAST_RESIDUES = 30  #: of fewer a single contact lost is more than the limits of energy
MOST_NAMED = 3

OF_LIGANDS = ("starts_ligands", "starts_strain")
TITLES = {
    "starts_finite": f"{OF_MD_STARTS}frames that stay finite when minimised",
    "starts_energy_100": f"{OF_MD_STARTS}energy per residue above the start's, 100 steps",
    "starts_energy_500": f"{OF_MD_STARTS}energy per residue above the start's, 500 steps",
    "starts_moved": f"{OF_MD_STARTS}shift of alpha carbons in 100 steps",
    "starts_ligands": f"{OF_MD_STARTS}shift of ligands in 100 steps",
    "starts_strain": f"{OF_MD_STARTS}strain of ligands above the start's, 100 steps",
    "starts_shape": f"{OF_MD_STARTS}frames with atoms in one place, with changed chirality",
}


def findings_of(report: ForceFieldReport) -> list[Finding]:
    """The rows of the verdict."""
    frames = report.usable
    if report.why_not or not frames or report.start.outcome:
        rows = [name for name in TITLES if report.ligands or name not in OF_LIGANDS]
        return [Finding(name, TITLES[name], CANNOT) for name in rows]
    return [
        _finite(report, frames),
        _energy(report, frames, SHORT),
        *([_energy(report, frames, LONG)] if report.long_starts else []),
        _moved(report, frames),
        *(_of_ligands(report, frames) if report.ligands else []),
        _shape(frames),
    ]


def skipped(why: str) -> list[Finding]:
    """One row that says why the force field was not asked."""
    title = f"{OF_MD_STARTS}frames minimised by OpenMM"
    return [Finding("starts_finite", title, SKIPPED, notes=[f"no force field: {why}"])]


def md_verdict(report: ForceFieldReport, frames: int) -> Verdict:
    """Whether MD can be started from frames of a file of `frames`, once they are minimised."""
    findings = findings_of(report)
    failed = [finding.in_words for finding in findings if finding.status == FAILED]
    of = report.subject
    tested = f"{len(report.usable)} of {frames} frames tested"
    details = f"What frames do near {report.without} is not tested." if report.left_out else ""
    if any(finding.status == CANNOT for finding in findings):
        sentence = "OpenMM could not minimise a frame: whether MD can be started is not known."
        return Verdict("mixed", sentence, details)
    if failed:
        why = f"{'; '.join(failed)}. {tested}."
        return Verdict("mixed", f"Do not start MD{of} from these frames: {why}", details)
    sentence = f"MD{of} can be started from these frames, once minimised. {tested}."
    return Verdict("good", sentence, details, f"MD starts{of} ({tested})")


def reached(values: np.ndarray) -> float:
    """What 95 % of the values do not exceed."""
    return float(np.sort(values)[math.ceil(SHARE * len(values)) - 1])


def _finite(report: ForceFieldReport, frames: Sequence[Minimised]) -> Finding:
    bad = [frame.name for frame in frames if not frame.is_finite]
    finding = Finding(
        "starts_finite",
        TITLES["starts_finite"],
        verdict(not bad),
        measured=f"{len(frames) - len(bad)} of {len(frames)}",
        allowed="all",
        figures={"frames": len(frames), "finite": len(frames) - len(bad)},
    )
    if bad:
        finding.notes.append(f"no finite energy or position after 100 steps: {_named(bad)}")
    late = [frame for frame in report.frames if frame.outcome]
    if late:
        finding.notes.append(
            f"partial: {len(frames)} of {len(report.frames)} frames were minimised; "
            f"{late[0].name}: {late[0].outcome}"
        )
    return finding


def _energy(report: ForceFieldReport, frames: Sequence[Minimised], steps: int) -> Finding:
    name, most = f"starts_energy_{steps}", MOST_ABOVE[steps]
    above = report.above_start(frames, steps)
    if len(above) == 0:
        why = f"no frame was minimised for {steps} steps"
        return Finding(name, TITLES[name], SKIPPED, notes=[why])
    by_frame = {f.name: report.above_start([f], steps) for f in frames}
    high = [name for name, found in by_frame.items() if len(found) and found[0] > most]
    finding = _within(name, above, most, "kJ/mol", sign="+")
    if report.residues < LEAST_RESIDUES:
        finding.status = SKIPPED
        finding.notes.append(
            f"energy after {steps} steps is not judged: with only {report.residues} residues, one "
            "lost contact exceeds the limit, which is meant for proteins"
        )
    elif high:
        finding.notes.append(
            f"more than {most:g} kJ/mol a residue above the start after {steps} steps: "
            f"{_named(high)}"
        )
    return finding


def _moved(report: ForceFieldReport, frames: Sequence[Minimised]) -> Finding:
    finding = _within("starts_moved", report.moved(frames), MOST_MOVED, "A", sign="")
    finding.figures["start"] = report.start.moved
    return finding


def _of_ligands(report: ForceFieldReport, frames: Sequence[Minimised]) -> list[Finding]:
    """How far the ligand goes that goes furthest, and how strained the most strained one is."""
    finite = [frame for frame in frames if frame.is_finite]
    shifts = [max(one.moved for one in frame.ligands.values()) for frame in finite]
    strains = [_strained_most(report, frame) for frame in finite]
    moved, strain = OF_LIGANDS
    more = np.array([most for most, _ in strains] or [np.inf])
    found = [
        _within(moved, np.array(shifts or [np.inf]), MOST_LIGAND_MOVED, "A", sign=""),
        _within(strain, more, MOST_STRAIN, "kJ/mol", sign="+"),
    ]
    if high := [name for most, name in strains if not most <= MOST_STRAIN]:
        text = f"strain of a ligand more than {MOST_STRAIN:g} kJ/mol above the start's"
        found[1].notes.append(f"{text}: {_named(high)}")
    return found


def _strained_most(report: ForceFieldReport, frame: Minimised) -> tuple[float, str]:
    """kJ/mol above the start's, and which frame and ligand."""
    start = report.start.ligands
    more = {label: one.strain - start[label].strain for label, one in frame.ligands.items()}
    label = max(more, key=more.__getitem__)
    return more[label], f"{frame.name} ({label}, {more[label]:+.0f})"


def _within(name: str, values: np.ndarray, most: float, unit: str, sign: str) -> Finding:
    worst = reached(values)
    share = "in 95 %" if worst < values.max() else "at most"  # of fewer than 20 frames all must be
    return Finding(
        name,
        TITLES[name],
        verdict(worst <= most),
        measured=f"{worst:{sign}.2f} {unit} {share}",
        allowed=f"{most:{sign}g} {unit} {share}",
        figures={
            "frames": len(values),
            "in_95_percent": worst,
            "mean": float(values.mean()),
            "most": float(values.max()),
        },
    )


def _shape(frames: Sequence[Minimised]) -> Finding:
    together = [frame.name for frame in frames if not frame.worst_force <= MOST_FORCE]
    turned = [
        f"{frame.name} ({', '.join(frame.inverted[:2])})" for frame in frames if frame.inverted
    ]
    finding = Finding(
        "starts_shape",
        TITLES["starts_shape"],
        verdict(not together and not turned),
        measured=f"{len(together)} and {len(turned)} frames",
        allowed="none",
        figures={
            "atoms_in_one_place": len(together),
            "hand_changed": len(turned),
            "worst_force": max(frame.worst_force for frame in frames),
        },
    )
    if together:
        finding.notes.append(
            f"a force above {MOST_FORCE:.0e} kJ/(mol nm), as of atoms in one place: "
            f"{_named(together)}"
        )
    if turned:
        finding.notes.append(f"residues whose chirality changed: {_named(turned)}")
    return finding


def _named(names: Sequence[str]) -> str:
    return ", ".join(names[:MOST_NAMED]) + (", ..." if len(names) > MOST_NAMED else "")
