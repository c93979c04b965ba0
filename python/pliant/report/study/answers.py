# SPDX-License-Identifier: MIT
"""The answers of a study, each in a line: for the terminal and for the head of the page."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pliant.base.console import counted, listed
from pliant.measure.shapes.other_shapes import OtherShapes
from pliant.measure.stages.parts import Units
from pliant.report.sections.domains import RigidDomains, domain_line, domain_verdict
from pliant.report.sections.flexible import UnitFlexibility
from pliant.report.sections.other_shapes import turns_text
from pliant.report.sections.torsions import Torsions

if TYPE_CHECKING:
    from pliant.jobs.path.found import MolecularPath
    from pliant.measure.flexibility import Flexibility
    from pliant.measure.stages.analysis import Analysis
    from pliant.report.study.studied import Study

MOST_NAMED = 5  #: residues, ligands or hinges that a line names


def answers(study: Study) -> dict[str, str]:
    """Question in a word -> its answer in a line."""
    analysis = study.report.analysis
    small = analysis[Units].what == "atom"
    lines = {
        "verdict": study.report.verdict.sentence,
        "molecule": _molecule(analysis),
        "left out": "; ".join(study.sampled.facts["left_out"]) or "nothing",
        "flexible": _flexible(study),
        "together": _rotatable(analysis) if small else _together(analysis),
        "other shapes": _conformers(study) if small else _other_shapes(analysis),
    }
    if study.path is not None:
        lines["path"] = _path(study.path, study.end)
    if not small:
        lines["MD starts"] = _md_starts(study)
    lines["page"] = str(study.page)
    lines["files"] = _files(study)
    return lines


def _files(study: Study) -> str:
    """What a user would open, and what is in it."""
    models = {"representatives": study.representatives and len(study.representatives.frames)}
    models["shapes"] = (
        len(shapes.shapes) if (shapes := study.report.analysis.get(OtherShapes)) else 0
    )
    shown = [f"{name}.pdb ({counted(n, 'model')})" for name, n in models.items() if n]
    path = ["path.h5md"] if study.path is not None else []
    scripts = ["show.pml (PyMOL)", "show.cxc (ChimeraX)"]
    return f"in {study.folder}: " + ", ".join(
        ["ensemble.h5md", "ensemble.pdb", *shown, *path, *scripts]
    )


def _molecule(analysis: Analysis) -> str:
    units, atoms = analysis[Units], f"{len(analysis.universe.atoms):,} atoms"
    if units.what == "atom":
        return f"{atoms}, a small molecule: its frames are conformers"
    names = sorted(set(units.chains[units.of_chain]) - {""})
    chains = f", chain{'s' * (len(names) > 1)} {', '.join(names)}" if names else ""
    others = [units.labels[k] for k in np.flatnonzero(~units.of_chain)]
    beside = f"; beside them {listed(others, MOST_NAMED)}" if others else ""
    return f"{np.count_nonzero(units.of_chain)} residues{chains}, {atoms}{beside}"


def _flexible(study: Study) -> str:
    analysis = study.report.analysis
    part, units = analysis.get(UnitFlexibility), analysis[Units]
    if part is None or part.found.still:
        return "nothing moves" if part else f"not known: {analysis.skipped.get('flexibility', '')}"
    found = part.found
    among = np.flatnonzero(units.ranked)
    most = among[np.argsort(-found.rmsf[among], kind="stable")][:MOST_NAMED]
    named = ", ".join(f"{units.labels[k]} {found.rmsf[k]:.1f}" for k in most)
    doubt = "" if found.converged else "; not converged"
    mean = f"{found.rmsf[among].mean():.2f} Å on average"
    if study.sampled.facts["amplitude_asked"] > 0:  # none of conformers
        mean += ", an input: which parts move more than others is the result"
    return f"{named} Å ({mean}; sampling error {_percent(found, among)}){doubt}"


def _percent(found: Flexibility, among: np.ndarray) -> str:
    """Two standard errors, as a share of the RMSF: the size of the latter is an input."""
    return f"{200 * found.error[among].mean() / found.rmsf[among].mean():.0f} %"


def _rotatable(analysis: Analysis) -> str:
    torsions = analysis.get(Torsions)
    return counted(len(torsions.measured.torsions), "rotatable bond") if torsions else "not known"


def _conformers(study: Study) -> str:
    frames, chosen = len(study.report.analysis.frames), study.representatives
    if chosen is None or study.report.analysis[UnitFlexibility].found.still:
        return f"none: all {frames} frames are alike"
    return (
        f"{frames} conformers; {len(chosen.frames)} stand for all, within "
        f"{chosen.mean_distance:.1f} Å on average, {chosen.largest_distance:.1f} Å at most"
    )


def _together(analysis: Analysis) -> str:
    verdict = domain_verdict(analysis)
    if verdict is None:
        return "not known: too few residues, or nothing moves"
    several = analysis[RigidDomains].found.count > 1
    return domain_line(analysis) if several else verdict.sentence


def _other_shapes(analysis: Analysis) -> str:
    part = analysis.get(OtherShapes)
    if part is None or part.groups is None:
        return "none looked for: the frames were drawn around the start"
    if not part.shapes:
        return "none found: the frames far from the start are all unlike each other"
    first = part.shapes[0]
    far = f"the most plausible {first.rmsd:.1f} Å away"
    if part.is_beyond(first):
        far += ", further than most known pairs are apart"
    return f"{len(part.shapes)}, {far}: rotated {turns_text(analysis, first)}"


def _path(path: MolecularPath, end: str) -> str:
    far, last = path.frames[0].to_end, path.frames[-1]
    how = f"{last.lost} of {path.only_start} contacts lost, {last.made} of {path.only_end} made"
    if path.arrived:
        near = f"from {far:.1f} Å to {path.reached:.2f} Å from {end}"
        return f"found, {near} in {len(path.frames)} frames; {how}"
    return (
        f"not found: {path.reached:.1f} Å of {far:.1f} Å to {end} are left; pliant path --both "
        "--backtrack tries other ways"
    )


def _md_starts(study: Study) -> str:
    if study.check is None:
        return f"not tested: {study.why_no_check}"
    return study.check.verdicts["MD starts"].sentence
