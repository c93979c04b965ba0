# SPDX-License-Identifier: MIT
"""What the report of a study has besides that of its ensemble: the input, the path, MD starts."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from pliant.base.console import Table
from pliant.base.verdict import Verdict
from pliant.measure.stages.analysis import Analysis
from pliant.measure.stages.parts import Units
from pliant.report.check.check_report import findings_table
from pliant.report.page.additions import Additions
from pliant.report.page.html import sentence
from pliant.report.section import Picture, Section
from pliant.report.sections.headings import ON_THE_WAY, STARTS
from pliant.report.sections.other_shapes import OTHER_SHAPES
from pliant.report.sections.shape_pictures import first_shapes
from pliant.report.study.agreement import agreement_section
from pliant.report.study.studied import LABELS

if TYPE_CHECKING:
    from pliant.jobs.path.found import MolecularPath
    from pliant.report.study.studied import Study

#: answers that the page gives elsewhere
NOT_AT_THE_HEAD = ("verdict", "page", "files")
MODELS = ("representatives", "fitted")  #: files that show.pml and show.cxc load


#: under no heading: its figure stands at the head
FIRST_SHAPES: Section[Analysis] = Section(
    applies=OTHER_SHAPES.applies,
    pictures=[Picture("first_shapes", first_shapes, suits=OTHER_SHAPES.pictures[0].suits)],
)


def early_sections(study: Study) -> Iterator[Section[Analysis]]:
    """Those with figures, which are drawn meanwhile."""
    yield FIRST_SHAPES
    if study.fit is not None:
        yield agreement_section(study.fit)


def sections(study: Study) -> Iterator[Section[Analysis]]:
    """Of a study that has all but its answers."""
    yield from early_sections(study)
    yield Section(name="input", verdict=lambda _: _input(study))
    path, check = study.path, study.check
    if path is not None:
        yield Section(
            name="path",
            heading=ON_THE_WAY,
            verdict=lambda _: _path_verdict(path, study.end),
            tables=lambda _: [_path_table(path, study.end)],
        )
    if check is not None:
        yield from (_only(name, verdict) for name, verdict in check.verdicts.items())
        caption = f"Checked with OpenMM: {check.covers.text}"
        yield Section(heading=STARTS, tables=lambda _: [findings_table(check, caption)])
    elif study.report.analysis[Units].what != "atom":
        why = f"MD starts were not tested: {study.why_no_check}."
        yield _only("MD starts", Verdict("open", why, "", "MD starts"))


def _only(name: str, verdict: Verdict) -> Section[Analysis]:
    return Section(name=name, verdict=lambda _: verdict)


def additions(study: Study) -> Additions:
    """What the report of its ensemble has besides, once its answers are there."""
    said = study.answered.items()
    answers = {LABELS.get(k, k): text for k, text in said if k not in NOT_AT_THE_HEAD}
    files = [study.sampled.ensemble, *study.outputs.values()]
    models = [study.outputs[name] for name in MODELS if name in study.outputs]
    overlay = None if study.fit is None else study.fit.overlay()
    return Additions("pliant study", answers, [*sections(study)], files, overlay, models)


def _input(study: Study) -> Verdict | None:
    """What the structure lacks, which matters, and what else was guessed of it."""
    missing, said = (study.sampled.facts[name] for name in ("missing", "warnings"))
    if missing:
        more = f" (and {len(missing) - 1} more)" if len(missing) > 1 else ""
        others = _sentences([text for text in said if text != missing[0]])
        return Verdict("mixed", f"The structure is incomplete: {missing[0]}{more}.", others)
    if said:
        return Verdict("open", "Something about the input was guessed.", _sentences(said))
    return None


def _sentences(texts: list[str]) -> str:
    return " ".join(map(sentence, texts))


def _path_verdict(path: MolecularPath, end: str) -> Verdict:
    if path.arrived:
        return Verdict("good", f"A path to {end} was found.", "", f"path to {end}")
    left = f"{path.reached:.1f} Å of {path.frames[0].to_end:.1f} Å are left"
    return Verdict("mixed", f"No path to {end} was found: {left}.", "")


def _path_table(path: MolecularPath, end: str) -> Table:
    first, last = path.frames[0], path.frames[-1]
    tight = [
        (f"tightest, frame {one.step}", f"{one.atoms}: {one.overlap:.2f} Å too near")
        for one in path.tight_places()
    ]
    rows = [
        ("arrived", "yes" if path.arrived else "no"),
        ("distance at first", f"{first.to_end:.2f} Å, {path.atoms} of {path.matched} residues"),
        ("distance at last", f"{last.to_end:.2f} Å"),
        ("frames", f"{len(path.frames)}, each with exact bonds and angles"),
        ("contacts of both", f"{path.held}, held"),
        ("contacts of the start alone", f"{last.lost} of {path.only_start} lost"),
        ("contacts of the end alone", f"{last.made} of {path.only_end} made"),
        *tight,
    ]
    caption = (
        f"A path to {end}: it shows that a way exists, not how fast or how likely it is, or that "
        "the molecule takes it"
    )
    return Table(caption, ("", "path"), rows)
