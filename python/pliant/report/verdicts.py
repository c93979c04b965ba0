# SPDX-License-Identifier: MIT
"""What to believe of an analysis: one verdict for each question."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from pliant.base.verdict import Verdict
from pliant.measure.stages.amplitude import asked_amplitude
from pliant.measure.stages.parts import ReferenceStructure, Shapes, UnitFlexibility
from pliant.measure.stereochemistry import TWISTED
from pliant.report.bar_verdict import bar_verdict
from pliant.report.domains.domain_texts import domain_verdict
from pliant.report.shapes.shape_texts import shapes_verdict
from pliant.trajectory.kind import ENSEMBLE, MEANING, PATH, TRANSITION

if TYPE_CHECKING:
    from pliant.measure.stages.analysis import Analysis

#: kinds of frames of which fluctuations are no property of the molecule
NO_ENSEMBLES = (PATH, TRANSITION)

#: a bond angle may change by so much, degrees; molecular dynamics at 300 K changes some by 16
MOST_ANGLE = 20.0
#: a planar centre may leave its plane by so much, Angstrom
MOST_OUT_OF_PLANE = 0.3
#: heavy atoms may overlap anew by so much, Angstrom
MOST_OVERLAP = 0.4
#: share of residues outside the allowed regions that frames may have beyond the start structure
MORE_OUTLIERS = 0.01

#: share of frames that may have been drawn again
MOST_DRAWN_AGAIN = 0.05
#: so many of them are named
NAMED = 10

#: where frames reached less than this share of the amplitude asked for, the verdict is a warning
LEAST_REACHED = 0.5


@dataclass(frozen=True)
class ShapeRow:
    """One question about stereochemistry."""

    name: str
    found: str  #: of the frames looked at
    start: str  #: of the structure compared with
    limit: str
    passed: bool


def shape_rows(analysis: Analysis) -> list[ShapeRow]:
    """The questions about stereochemistry that the molecule allows."""
    part = analysis.get(Shapes)
    if part is None:
        return []
    shape, found, start = part.measured, part.found, part.found.reference
    rows = [
        ShapeRow(
            "bond angles",
            f"{found.angle.max():.1f}° at most",
            "0°",
            f"change of {MOST_ANGLE:g}°",
            bool(found.angle.max() <= MOST_ANGLE),
        ),
        ShapeRow(
            "overlaps of heavy atoms",
            f"{found.overlaps.mean():.2g} new per frame, {found.overlap.max():.2f} Å deep at most",
            f"{start['overlaps']:.0f}, {start['overlap']:.2f} Å",
            f"new ones of {MOST_OVERLAP:g} Å",
            bool(found.overlap.max() <= MOST_OVERLAP),
        ),
    ]
    if len(shape.corners.handed):
        flips = int(np.count_nonzero(found.flips))
        rows.append(
            ShapeRow(
                "chirality", f"{flips} frames with an inverted centre", "0", "none", flips == 0
            )
        )
    if len(shape.corners.planar):
        worst = float(found.plane.max())
        limit = max(MOST_OUT_OF_PLANE, start["plane"] + 0.01)
        off, before = f"{worst:.2f} Å off at most", f"{start['plane']:.2f} Å"
        rows.append(ShapeRow("planar groups", off, before, f"{limit:.2g} Å", worst <= limit))
    return rows + _backbone_rows(part)


def _backbone_rows(part: Shapes) -> list[ShapeRow]:
    shape, found = part.measured, part.found
    start, rows = found.reference, []
    if len(shape.omega):
        more = int(found.twisted.max())
        bonds, before = f"peptide bonds (ω beyond {TWISTED:g}°)", f"{start['twisted']:.0f}"
        few, most = more <= start["twisted"], f"{more} in a frame at most"
        rows.append(ShapeRow(bonds, most, before, "no more than the start", few))
    if len(shape.phi):
        outliers = float(found.outliers.mean())
        few = outliers <= start["outliers"] + MORE_OUTLIERS
        shares = f"{100 * outliers:.1f} %", f"{100 * start['outliers']:.1f} %"
        rows.append(ShapeRow("Ramachandran outliers", *shares, "1 % more than the start", few))
        shares = f"{100 * found.favoured.mean():.0f} %", f"{100 * start['favoured']:.0f} %"
        rows.append(ShapeRow("Ramachandran favoured", *shares, "–", True))
    return rows


def verdicts(analysis: Analysis) -> dict[str, Verdict]:
    """Name -> verdict of each question, in the order of the page."""
    made = {
        "what it is": _what_it_is(analysis),
        "convergence": _convergence(analysis),
        "stereochemistry": _stereochemistry(analysis),
        "bars": bar_verdict(analysis),
    }
    more = {
        "domains": domain_verdict(analysis),
        "other shapes": shapes_verdict(analysis),
        "amplitude": _amplitude(analysis),
        "draws": _draws(analysis),
    }
    return made | {name: one for name, one in more.items() if one is not None}


def _sentence(text: str) -> str:
    return f"{text[:1].upper()}{text[1:]}." if text else ""


def _what_it_is(analysis: Analysis) -> Verdict:
    sentence, details = MEANING[analysis.kind]
    kind = "mixed" if analysis.kind in NO_ENSEMBLES else "open"
    return Verdict(kind, f"{sentence}.", details)


def _convergence(analysis: Analysis) -> Verdict:
    if analysis.kind == TRANSITION:
        return Verdict("open", "A path has an end, and does not converge.", "")
    part = analysis.get(UnitFlexibility)
    if part is None:
        why = _sentence(analysis.skipped.get("flexibility", ""))
        return Verdict("open", "Convergence cannot be judged.", why, "convergence")
    found = part.found
    if found.still:
        return Verdict(
            "mixed",
            "Nothing moves.",
            f"Nothing fluctuates by more than {found.rmsf.max():.1g} Å: all frames are alike.",
        )
    details = (
        f"RMSF profiles of the two halves of the frames correlate at {found.correlation:.3f} and "
        f"differ by {100 * found.difference:.0f} % on average (converged: at least 0.95, at most "
        f"10 %). Errors are estimated from {found.blocks} blocks of frames. They say how well "
        "frames made anew in the same way would repeat these numbers, not how near these are to "
        "the molecule's."
    )
    if analysis.kind == ENSEMBLE and len(analysis.frames) < 200:
        details += " Fewer than 200 frames do not fill two blocks: errors may be too large."
    if found.converged:
        what = (
            "The halves agree" if analysis.kind in NO_ENSEMBLES else "The flexibility is converged"
        )
        return Verdict("good", f"{what}.", details, "convergence")
    return Verdict("mixed", "The flexibility is not converged: the halves differ.", details)


def _stereochemistry(analysis: Analysis) -> Verdict:
    rows = shape_rows(analysis)
    if not rows:
        why = _sentence(analysis.skipped.get("stereochemistry", ""))
        return Verdict("open", "Stereochemistry cannot be judged.", why, "stereochemistry")
    looked_at, reference = analysis[Shapes].frames, analysis[ReferenceStructure]
    details = (
        f"{len(looked_at)} of {len(analysis.frames)} frames were compared with {reference.name}: "
        f"see the {len(rows)} checks in the table below."
    )
    failed = [f"{row.name} ({row.found})" for row in rows if not row.passed]
    if failed:
        return Verdict("bad", f"Stereochemistry is broken: {', '.join(failed)}.", details)
    some = " of the recorded atoms" if analysis.stored.joints_of_whole else ""
    return Verdict("good", f"Stereochemistry{some} is intact.", details, "stereochemistry")


def _amplitude(analysis: Analysis) -> Verdict | None:
    asked = asked_amplitude(analysis.record.parameters if analysis.record else {})
    part = analysis.get(UnitFlexibility)
    if asked is None or part is None or analysis.kind != ENSEMBLE:
        return None
    reached = float(part.found.rmsf.mean())
    sentence = f"Amplitude: {asked:.2f} Å requested, {reached:.2f} Å reached."
    details = (
        "This is the mean RMSF after superposition. It is an input: which parts move more than "
        "others is a result, how far they move overall is not."
    )
    kind = "mixed" if reached < LEAST_REACHED * asked else "open"
    return Verdict(kind, sentence, details)


def _draws(analysis: Analysis) -> Verdict | None:
    """Which frames are none of the first draw, and so not quite what the network asked for."""
    redraws = analysis.observable("redraws")
    if redraws is None or analysis.kind != ENSEMBLE:
        return None
    again, count = analysis.frames[redraws > 0], len(redraws)
    if len(again) == 0:
        sentence, details = "No frame had to be redrawn.", ""
    else:
        sentence = f"{len(again)} of {count} frames had to be redrawn."
        named = ", ".join(str(frame) for frame in again[:NAMED])
        more = f" and {len(again) - NAMED} more" if len(again) > NAMED else ""
        details = (
            f"The first attempts at frames {named}{more} failed; each took up to "
            f"{int(redraws.max()) + 1} attempts. Motions in these directions "
            "are under-represented."
        )
    missing = _missing_frames(analysis)
    if missing:
        details += f" {missing} frames could not be resolved at all and are left out."
    share = (len(again) + missing) / (count + missing)
    kind = "good" if share <= MOST_DRAWN_AGAIN else "mixed"
    return Verdict(kind, sentence, details.strip(), "few frames redrawn")


def _missing_frames(analysis: Analysis) -> int:
    if analysis.steps is None or analysis.options.step not in (None, 1):
        return 0
    return int(analysis.steps[-1] - analysis.steps[0] + 1 - len(analysis.steps))
