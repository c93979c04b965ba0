# SPDX-License-Identifier: MIT
"""What a biologist may conclude from a comparison, and what not, in plain words."""

from __future__ import annotations

import math

import numpy as np

from pliant.measure.agreement import TEN, Figure
from pliant.measure.compared.reference import MODELS, STRUCTURE, STRUCTURES, TRAJECTORY
from pliant.measure.compared.residue_report import MissingMode, Profile, ResidueComparison, Stretch
from pliant.measure.flexibility import precision

STRONG, FAIR, WEAK = 0.8, 0.6, 0.3  #: r and cumulative overlaps, less their error
FEW_FRAMES = 40  #: of which halves are too small for a ceiling
FEW_RESIDUES = 20
SMALL = 0.3  #: Angstrom, about the error of coordinates of crystals at 2 A resolution
APART = 0.05  #: an agreement this far below the ceiling is below it
SHOWN = 4  #: stretches in a sentence

NAMES = {
    TRAJECTORY: "trajectory",
    MODELS: "models",
    STRUCTURES: "structures",
    STRUCTURE: "one structure",
}


def conclude(found: ResidueComparison) -> None:
    """Fills in conclusions and cautions."""
    if found.displacement is not None:
        found.conclusions = _of_one_structure(found)
    else:
        found.conclusions = [
            _which_parts(found),
            _which_directions(found),
            _how_far(found),
            *_differences(found),
        ]
    found.cautions = _cautions(found)


def figure_text(figure: Figure) -> str:
    """ "0.93 +- 0.02": a standard error."""
    error = f" +- {figure.error:.2f}" if math.isfinite(figure.error) else ""
    return f"{figure.value:.2f}{error}" if math.isfinite(figure.value) else "-"


def mean_text(one: Profile, core: np.ndarray, unit: str = "") -> str:
    """ "0.61 A, precision 2 %" of the mean RMSF."""
    rmsf = one.rmsf[core]
    return f"{rmsf.mean():.2f}{unit}, {precision(rmsf, one.error[core])}"


def _which_parts(found: ResidueComparison) -> str:
    low = found.r.value - (found.r.error if math.isfinite(found.r.error) else 0.0)
    if not math.isfinite(low):
        return "Which parts move cannot be compared: one of the two does not move."
    if low >= STRONG:
        text = "The same parts move"
    elif low >= FAIR:
        text = "Mostly the same parts move"
    elif low >= WEAK:
        text = "Only some of the same parts move"
    else:
        text = "It cannot be said that the same parts move"
    ceiling = f"; halves of theirs {found.r_ceiling:.2f}" if math.isfinite(found.r_ceiling) else ""
    text += f": r = {figure_text(found.r)} over {int(found.core.sum())} residues{ceiling}."
    if found.ends:
        text += f" Free ends ({found.ends}) are left out; with them r = {found.r_all:.2f}."
    return text


def _which_directions(found: ResidueComparison) -> str:
    both = found.subspaces
    assert both is not None
    count = min(len(both.ours.vectors), len(both.theirs.vectors))
    if count == 0:
        return "Directions cannot be compared: one of the two does not move."
    share = math.sqrt(both.share_covered)
    whole = f"{both.share_covered:.0%} of their motion lies within our first {TEN} modes"
    if count < TEN:
        return f"{_same_ways(share)}: {whole} (by chance {_chance_share(found):.0%})."
    whole += f" and {both.theirs.share:.0%} within their own"
    text = f"{_same_ways(both.rmsip.value)}: RMSIP({TEN}) = {figure_text(both.rmsip)}"
    if math.isfinite(both.ceiling):
        below = both.rmsip.value < both.ceiling - APART
        text += f", {'less than' if below else 'as alike as'} halves of theirs ({both.ceiling:.2f})"
    return f"{text}; by chance {both.chance:.2f}; {whole}."


def _same_ways(alike: float) -> str:
    if alike >= 0.7:
        return "They move in the same directions"
    if alike >= 0.5:
        return "They move in partly the same directions"
    return "They move in other directions"


def _chance_share(found: ResidueComparison) -> float:
    both = found.subspaces
    assert both is not None
    dimensions = max(3 * int(found.core.sum()) - 6, 1)
    return min(1.0, len(both.ours.vectors) / dimensions)


def _how_far(found: ResidueComparison) -> str:
    assert found.theirs is not None
    ours, theirs = (mean_text(one, found.core, " A") for one in (found.ours, found.theirs))
    return (
        f"How far: ours {ours}; theirs {theirs}. Our amplitude was an input, not a result; below, "
        "ours is scaled to theirs."
    )


def _differences(found: ResidueComparison) -> list[str]:
    lines = []
    for stretches, word in ((found.more_stretches, "more"), (found.less_stretches, "less")):
        if stretches:
            lines.append(f"Move {word} in ours, by more than the error: {_listed(stretches)}.")
    both = found.subspaces
    if both is not None:
        lines += [_missing("theirs", "ours", mode) for mode in both.of_theirs_alone[:SHOWN]]
        lines += [_missing("ours", "theirs", mode) for mode in both.of_ours_alone[:SHOWN]]
    return lines


def _listed(stretches: list[Stretch]) -> str:
    shown = [f"{s.residues} ({s.ours:.2f} against {s.theirs:.2f} A)" for s in stretches[:SHOWN]]
    rest = len(stretches) - len(shown)
    return ", ".join(shown) + (f" and {rest} more" if rest else "")


def _missing(whose: str, other: str, mode: MissingMode) -> str:
    where = f"; most of it moves {mode.residues}" if mode.residues else ""
    return (
        f"Mode {mode.mode} of {whose} ({mode.share:.0%} of its motion{where}) is hardly in {other} "
        f"({mode.covered:.2f})."
    )


def _of_one_structure(found: ResidueComparison) -> list[str]:
    way = found.displacement
    assert way is not None
    if way.distance == 0.0:
        return ["Theirs is the mean structure of ours."]
    low = way.overlap.value - way.overlap.error
    how = "moves" if low >= STRONG else "moves partly" if low >= WEAK else "hardly moves"
    return [
        f"Ours {how} towards theirs: {figure_text(way.overlap)} of the way lies within our first "
        f"{TEN} modes (cumulative overlap; by chance {way.chance:.2f}).",
        f"Theirs is {way.distance:.2f} A from the mean structure of ours; our nearest frame is "
        f"{way.nearest:.2f} A away.",
    ]


def _cautions(found: ResidueComparison) -> list[str]:
    lines = []
    if found.kind == STRUCTURE:
        lines.append(
            "Theirs is one structure: it has no fluctuations, so r and RMSIP cannot be computed."
        )
    else:
        lines += _cautions_of_frames(found)
    if int(found.core.sum()) < FEW_RESIDUES:
        lines.append(f"{int(found.core.sum())} residues are few: r and modes mean little.")
    return lines


def _cautions_of_frames(found: ResidueComparison) -> list[str]:
    assert found.theirs is not None
    lines = []
    count, name = found.theirs.frames, NAMES[found.kind]
    of = f"frames of a {name}" if found.kind == TRAJECTORY else name
    if count < 4:
        lines.append(f"{count} {of}: too few for an error or a ceiling.")
    elif count < FEW_FRAMES:
        lines.append(
            f"{count} {of} are few: their halves agree little with each other, so the ceiling is "
            "low and agreement near it is no proof."
        )
    mean = float(found.theirs.rmsf[found.core].mean())
    if found.kind != TRAJECTORY and mean < SMALL:
        lines.append(
            f"Theirs differ by {mean:.2f} A on average, about as much as coordinates of crystals "
            "are uncertain: what differs may be error, not motion."
        )
    if math.isfinite(found.r_in_time) and found.r_in_time < found.r_ceiling - APART:
        lines.append(
            f"Their first and second half agree with r = {found.r_in_time:.2f} only: the "
            "trajectory has not converged."
        )
    if found.kind == STRUCTURES:
        lines.append(
            "Which structures exist was up to those who solved them: how often a shape is among "
            "them says nothing about how often it occurs."
        )
    if found.kind == MODELS and count < 100:
        lines.append("Models of NMR files may be spread by few restraints, not by motion.")
    return lines
