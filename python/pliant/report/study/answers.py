# SPDX-License-Identifier: MIT
"""The answers of a study, each a sentence: for the terminal, the head of the page and the JSON."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from pliant.base.console import counted, listed
from pliant.measure.flexibility import precision
from pliant.measure.shapes.other_shapes import OtherShapes
from pliant.measure.stages.parts import Units
from pliant.report.page.additions import Answer
from pliant.report.page.html import sentence
from pliant.report.sections.domains import RigidDomains, domain_line, domain_verdict
from pliant.report.sections.flexible import UnitFlexibility
from pliant.report.sections.other_shapes import turns_of, turns_text
from pliant.report.sections.shape_pictures import FIRST
from pliant.report.sections.torsions import Torsions
from pliant.report.study.agreement import agreement_answer

if TYPE_CHECKING:
    from pliant.jobs.path.found import MolecularPath
    from pliant.measure.stages.analysis import Analysis
    from pliant.report.study.studied import Study

MOST_NAMED = 5  #: residues, ligands or hinges that a line names


def answers(study: Study) -> dict[str, Answer]:
    """Question in a word -> its answer: what a reader wants first, then what it is of."""
    analysis = study.report.analysis
    small = analysis[Units].what == "atom"
    found = {"verdict": Answer(study.report.verdict.sentence)}
    if study.fit is not None:
        found["data"] = agreement_answer(study.fit)
    found |= {
        "how far": _how_far(study),
        "flexible": _flexible(study),
        "together": _rotatable(analysis) if small else _together(analysis),
        "other shapes": _conformers(study) if small else _other_shapes(analysis),
    }
    if study.path is not None:
        found["path"] = _path(study.path, study.end)
    if not small:
        found["MD starts"] = Answer(_md_starts(study))
    found["molecule"] = Answer(_molecule(analysis))
    found["left out"] = Answer(sentence("; ".join(study.sampled.facts["left_out"]) or "nothing"))
    found["page"] = Answer(str(study.page))
    found["files"] = Answer(_files(study))
    return found


def _files(study: Study) -> str:
    """What a user would open, and what is in it."""
    models = {"representatives": study.representatives and len(study.representatives.frames)}
    models["shapes"] = (
        len(shapes.shapes) if (shapes := study.report.analysis.get(OtherShapes)) else 0
    )
    shown = [f"{name}.pdb ({counted(n, 'model')})" for name, n in models.items() if n]
    path = [study.outputs[name].name for name in ("fitted", "path") if name in study.outputs]
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


def _how_far(study: Study) -> Answer:
    alone = _how_far_alone(study)
    if study.path is None:
        return alone
    to_end = f"{study.path.frames[0].to_end:.1f} Å to {study.end} (RMSD of CA)."
    return Answer(to_end, str(alone))


def _how_far_alone(study: Study) -> Answer:
    """What is known of it: the size of motions around the start was an input."""
    analysis, mean = study.report.analysis, _mean(study)
    if mean is None:
        return Answer("Not known.")
    if analysis[Units].what == "atom":
        return Answer(f"An atom by {mean:.2f} Å on average, over all conformers (RMSF).")
    around = f"Around the start a residue moves by {mean:.2f} Å on average (RMSF): an input."
    part = analysis.get(OtherShapes)
    if part is None or not part.shapes:
        return Answer(f"How far it moves is not known. {around}")
    off = [shape.rmsd for shape in part.shapes]
    here = f"The shapes here are {min(off):.1f} to {max(off):.1f} Å from the start (RMSD of CA)"
    if part.known is None:
        return Answer(f"{here}; how far the molecule goes is not known.", around)
    low, high = part.known[[0, 2]]
    known = "half of the known mobile proteins as soft as this one move that far"
    return Answer(f"Perhaps {low:.1f} to {high:.1f} Å: {known}.", f"{here}. {around}")


def _mean(study: Study) -> float | None:
    """RMSF of the units that are ranked, Angstrom; None where it was not measured."""
    analysis = study.report.analysis
    part = analysis.get(UnitFlexibility)
    return float(part.found.rmsf[analysis[Units].ranked].mean()) if part else None


def _flexible(study: Study) -> Answer:
    analysis = study.report.analysis
    part, units = analysis.get(UnitFlexibility), analysis[Units]
    if part is None or part.found.still:
        why = sentence(f"not known: {analysis.skipped.get('flexibility', '')}")
        return Answer("Nothing moves." if part else why)
    found = part.found
    among = np.flatnonzero(units.ranked)
    most = among[np.argsort(-found.rmsf[among], kind="stable")][:MOST_NAMED]
    mean = found.rmsf[among].mean()
    names = ", ".join(units.labels[k] for k in most)
    times = f"{found.rmsf[most].mean() / mean:.1f} times as far as the average {units.what}"
    doubt = "" if found.converged else " This is not converged."
    size = f"{mean:.2f} on average"
    if study.sampled.facts["amplitude_asked"] > 0:  # none of conformers
        size += ", an input: which parts move more than others is the result"
    rmsf = ", ".join(f"{found.rmsf[k]:.1f}" for k in most)
    anew = precision(found.rmsf[among], found.error[among])
    accuracy = "accuracy, how near this is to the molecule, is not known"
    more = f"RMSF {rmsf} Å; {size}. Frames made anew: {anew}; {accuracy}."
    return Answer(f"{names} move most, {times}.{doubt}", more, colour="mobility")


def _rotatable(analysis: Analysis) -> Answer:
    torsions = analysis.get(Torsions)
    if torsions is None:
        return Answer("Not known.")
    return Answer(f"{counted(len(torsions.measured.torsions), 'rotatable bond')}.")


def _conformers(study: Study) -> Answer:
    frames, chosen = len(study.report.analysis.frames), study.representatives
    if chosen is None or study.report.analysis[UnitFlexibility].found.still:
        return Answer(f"None: all {frames} frames are alike.")
    return Answer(
        f"{frames} conformers; {len(chosen.frames)} stand for all, within "
        f"{chosen.mean_distance:.1f} Å on average, {chosen.largest_distance:.1f} Å at most."
    )


def _together(analysis: Analysis) -> Answer:
    verdict = domain_verdict(analysis)
    if verdict is None:
        return Answer("Not known: too few residues, or nothing moves.")
    part = analysis[RigidDomains]
    if part.found.count < 2:
        return Answer(verdict.sentence)
    labels, at = analysis[Units].labels, part.sites[[hinge.site for hinge in part.found.hinges]]
    hinges = listed(list(dict.fromkeys(labels[k] for k in at)), MOST_NAMED)
    about = f", with hinges at {hinges}" if hinges else ""
    text = f"{part.found.count} domains move against each other{about}."
    return Answer(text, f"{domain_line(analysis)}.", colour="domain")


def _other_shapes(analysis: Analysis) -> Answer:
    part = analysis.get(OtherShapes)
    if part is None or part.groups is None:
        return Answer("None was looked for: the frames were drawn around the start.")
    if not part.shapes:
        return Answer("None was found: the frames far from the start are all unlike each other.")
    first = part.shapes[0]
    far = f"{first.rmsd:.1f} Å from the start"
    if part.is_beyond(first):
        far += ", further than most known pairs are apart"
    turned = turns_of(analysis, first)
    bent = "it bends, and no part rotates as a whole"
    what = _turned(max(turned, key=lambda turn: float(turn["degrees"]))) if turned else bent
    each = [
        f"in {k} ({shape.rmsd:.1f} Å) {turns_text(analysis, shape)}"
        for k, shape in enumerate(part.shapes[:FIRST], 1)
    ]
    text = f"{counted(len(part.shapes), 'shape')}; in the most plausible, {far}, {what}."
    return Answer(text, f"Rotated: {'; '.join(each)}.", figure="first_shapes")


def _turned(turn: dict[str, Any]) -> str:
    """What rotated by how much."""
    residues = ", ".join(f"{first} to {last}" for first, last in turn["residues"])
    return f"{residues} is rotated by {turn['degrees']:.0f}°"


def _path(path: MolecularPath, end: str) -> Answer:
    far, last = path.frames[0].to_end, path.frames[-1]
    how = f"{last.lost} of {path.only_start} contacts lost, {last.made} of {path.only_end} made"
    if path.arrived:
        near = f"from {far:.1f} Å to {path.reached:.2f} Å from {end}"
        return Answer(f"Found, {near} in {len(path.frames)} frames; {how}.")
    return Answer(
        f"Not found: {path.reached:.1f} Å of {far:.1f} Å to {end} are left; pliant path --both "
        "--backtrack tries other ways."
    )


def _md_starts(study: Study) -> str:
    if study.check is None:
        return sentence(f"not tested: {study.why_no_check}")
    return study.check.verdicts["MD starts"].sentence
