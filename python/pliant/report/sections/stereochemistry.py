# SPDX-License-Identifier: MIT
"""Whether the frames are a molecule: angles, chirality, planes, backbone, overlaps."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from pliant.base.console import Table
from pliant.base.verdict import Verdict
from pliant.measure.stages.analysis import Analysis
from pliant.measure.stages.names import phi_psi_pairs
from pliant.measure.stages.parts import Part, ReferenceStructure
from pliant.measure.stereochemistry import TWISTED, Stereochemistry, StereochemistryResults
from pliant.report.section import Columns, Values
from pliant.report.sections.headings import CHEMISTRY
from pliant.report.sections.measured import Measured, has, spread, why_skipped
from pliant.report.sections.torsions import Torsions

#: a bond angle may change by so much, degrees; molecular dynamics at 300 K changes some by 16
MOST_ANGLE = 20.0
#: a planar centre may leave its plane by so much, Angstrom
MOST_OUT_OF_PLANE = 0.3
#: heavy atoms may overlap anew by so much, Angstrom
MOST_OVERLAP = 0.4
#: share of residues outside the allowed regions that frames may have beyond the start structure
MORE_OUTLIERS = 0.01


@dataclass(frozen=True)
class Shapes(Part):
    """Stereochemistry of frames that are spread over all."""

    measured: Stereochemistry
    found: StereochemistryResults
    frames: np.ndarray  #: (f,) numbers in the file


def _measure(analysis: Analysis) -> Iterator[Shapes]:
    universe = analysis.universe
    elements = getattr(universe.atoms, "elements", None)
    if elements is None or not np.any(elements != ""):
        raise ValueError("the file does not say which elements the atoms are")
    if not hasattr(universe, "bonds") or len(universe.bonds) == 0:
        raise ValueError("the file has no bonds")
    known = analysis.get(Torsions)
    torsions = known.measured.torsions if known else []
    phi, psi = phi_psi_pairs(torsions)
    names = universe.residues.resnames if phi else []
    with_side_chain = [k for k, p in enumerate(phi) if names[torsions[p].residue] != "GLY"]
    measured = Stereochemistry(
        np.asarray(elements),
        np.asarray(universe.bonds.indices),
        analysis[ReferenceStructure].positions,
        [t.atoms for t in torsions if t.kind == "omega"],
        [torsions[phi[k]].atoms for k in with_side_chain],
        [torsions[psi[k]].atoms for k in with_side_chain],
    )
    looked_at = spread(analysis)
    found = measured.run(analysis.positions(k) for k in looked_at)
    yield Shapes(measured, found, analysis.frames[looked_at])


@dataclass(frozen=True)
class Row:
    """One question about stereochemistry."""

    name: str
    found: str  #: of the frames looked at
    start: str  #: of the structure compared with
    limit: str
    passed: bool


def _rows(part: Shapes) -> Iterator[Row]:
    """The questions that the molecule allows."""
    corners, found, start = part.measured.corners, part.found, part.found.reference
    most = float(found.angle.max())
    limit = f"change of {MOST_ANGLE:g}°"
    yield Row("bond angles", f"{most:.1f}° at most", "0°", limit, most <= MOST_ANGLE)
    deepest = float(found.overlap.max())
    overlaps = f"{found.overlaps.mean():.2g} new per frame, {deepest:.2f} Å deep at most"
    before = f"{start['overlaps']:.0f}, {start['overlap']:.2f} Å"
    few, limit = deepest <= MOST_OVERLAP, f"new ones of {MOST_OVERLAP:g} Å"
    yield Row("overlaps of heavy atoms", overlaps, before, limit, few)
    if len(corners.handed):
        flips = int(np.count_nonzero(found.flips))
        yield Row("chirality", f"{flips} frames with an inverted centre", "0", "none", flips == 0)
    if len(corners.planar):
        worst = float(found.plane.max())
        most = max(MOST_OUT_OF_PLANE, start["plane"] + 0.01)
        off, before = f"{worst:.2f} Å off at most", f"{start['plane']:.2f} Å"
        yield Row("planar groups", off, before, f"{most:.2g} Å", worst <= most)
    yield from _backbone(part)


def _backbone(part: Shapes) -> Iterator[Row]:
    found, start = part.found, part.found.reference
    if len(part.measured.omega):
        more = int(found.twisted.max())
        bonds, before = f"peptide bonds (ω beyond {TWISTED:g}°)", f"{start['twisted']:.0f}"
        few, most = more <= start["twisted"], f"{more} in a frame at most"
        yield Row(bonds, most, before, "no more than the start", few)
    if len(part.measured.phi):
        outliers = float(found.outliers.mean())
        few = outliers <= start["outliers"] + MORE_OUTLIERS
        shares = f"{100 * outliers:.1f} %", f"{100 * start['outliers']:.1f} %"
        yield Row("Ramachandran outliers", *shares, "1 % more than the start", few)
        shares = f"{100 * found.favoured.mean():.0f} %", f"{100 * start['favoured']:.0f} %"
        yield Row("Ramachandran favoured", *shares, "–", True)


def _verdict(analysis: Analysis) -> Verdict:
    if Shapes not in analysis:
        why = why_skipped(analysis, "stereochemistry")
        return Verdict("open", "Stereochemistry cannot be judged.", why, "stereochemistry")
    part, reference = analysis[Shapes], analysis[ReferenceStructure]
    rows = list(_rows(part))
    details = (
        f"{len(part.frames)} of {len(analysis.frames)} frames were compared with {reference.name}: "
        f"see the {len(rows)} checks in the table below."
    )
    failed = [f"{row.name} ({row.found})" for row in rows if not row.passed]
    if failed:
        return Verdict("bad", f"Stereochemistry is broken: {', '.join(failed)}.", details)
    some = " of the recorded atoms" if analysis.source.joints_of_whole else ""
    return Verdict("good", f"Stereochemistry{some} is intact.", details, "stereochemistry")


def _values(analysis: Analysis) -> Values:
    rows = _rows(analysis[Shapes])
    found = {row.name: {"found": row.found, "passed": bool(row.passed)} for row in rows}
    return {"stereochemistry": found}


def _tables(analysis: Analysis) -> Iterator[Table]:
    columns = ("question", "frames", analysis[ReferenceStructure].name, "allowed")
    rows = [
        (f"{'✓' if row.passed else '✕'} {row.name}", row.found, row.start, row.limit)
        for row in _rows(analysis[Shapes])
    ]
    yield Table("Stereochemistry", columns, rows)


def _per_frame_looked_at(analysis: Analysis) -> Columns:
    part = analysis[Shapes]
    found = part.found
    return {
        "frame": part.frames,
        "largest_angle_change_degrees": found.angle,
        "rms_angle_change_degrees": found.angle_rms,
        "centres_turned_over": found.flips,
        "furthest_out_of_plane_angstrom": found.plane,
        "omega_furthest_off_degrees": found.omega,
        "omega_beyond_30_degrees": found.twisted,
        "ramachandran_outliers": found.outliers,
        "ramachandran_favoured": found.favoured,
        "new_overlaps": found.overlaps,
        "deepest_new_overlap_angstrom": found.overlap,
    }


STEREOCHEMISTRY = Measured(
    name="stereochemistry",
    stage="stereochemistry",
    measure=_measure,
    heading=CHEMISTRY,
    applies=has(Shapes),
    verdict=_verdict,
    values=_values,
    tables=_tables,
    columns={"stereochemistry": _per_frame_looked_at},
    methods={
        "Stereochemistry": (
            "Up to 100 frames, spread over all. Bond angles against the start structure; inverted "
            "carbons; centres with three neighbours off their plane; phi and psi of residues but "
            "glycine and proline in regions that hold 90 % (favoured) and 99.5 % (allowed) of "
            "those of 500 crystal structures (Lovell 2003); heavy atoms more than three bonds "
            "apart that are nearer than the outer limits of Ramachandran and Sasisekharan (1968) "
            "and were not at the start."
        )
    },
)
