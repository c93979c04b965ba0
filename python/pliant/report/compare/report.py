# SPDX-License-Identifier: MIT
"""The comparison as text and as JSON."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from pliant import _core
from pliant.base.console import Table, printable_name
from pliant.report.compare.comparison_report import AtomComparison, ComparisonReport, Fluctuations
from pliant.report.compare.residue_tables import print_residues, residues_json

MOST_TORSIONS = 40  #: rows that the table shows


def print_report(report: ComparisonReport) -> None:
    """Prints the report on stdout: what follows first, the figures behind it after."""
    print(f"ours    {printable_name(report.path)}: {_frames(_count(report, 'ours'))}")
    for k, path in enumerate(report.theirs):
        frames = f": {_frames(_count(report, 'theirs'))}" if len(report.theirs) == 1 else ""
        print(f"{'theirs' if k == 0 else '      '}  {printable_name(path)}{frames}")
    print()
    if report.residues:
        print_residues(report.residues)
    if report.atoms:
        _print_atoms(report.atoms, bool(report.residues))
    if report.notes:
        print("\nnotes")
        print("\n".join(f"  {note}" for note in report.notes))
    for path in report.pictures:
        print(("\n" if path == report.pictures[0] else "") + f"picture  {printable_name(path)}")


def _count(report: ComparisonReport, whose: str) -> int:
    if report.residues is None:
        assert report.atoms is not None
        return len(getattr(report.atoms.ensembles, whose))
    profile = getattr(report.residues, whose)
    return profile.frames if profile else 1


def _print_atoms(found: AtomComparison, is_second: bool) -> None:
    ensembles = found.ensembles
    if is_second:
        print()
    print(f"{len(ensembles.atoms)} atoms, {found.modes.atoms} of them fitted\n")
    _summary_table(found).print()
    if found.torsions:
        print()
        _torsion_table(found).print()


def _frames(count: int) -> str:
    return f"{count} frame{'s' if count != 1 else ''} compared"


def _number(value: float, form: str = ".2f") -> str:
    return f"{value:{form}}" if math.isfinite(value) else "-"


def _summary_table(report: AtomComparison) -> Table:
    table = Table("how far they agree", ["what", "ours", "theirs", "agreement"])
    add = table.rows.append
    add(_fluctuation_row("RMSF of atoms, mean (A)", report.atom_fluctuations))
    if report.residue_fluctuations:
        add(_fluctuation_row("RMSF of alpha carbons, mean (A)", report.residue_fluctuations))
    modes = report.modes
    count = min(modes.overlaps.shape, default=0)
    shares = (_number(modes.share_ours), _number(modes.share_theirs))
    add((f"first {count} modes, share of the variance", *shares, f"RMSIP {_number(modes.rmsip)}"))
    halves = (_number(modes.halves_ours), _number(modes.halves_theirs))
    add(("  RMSIP of its two halves", *halves, f"{_number(modes.chance)} by chance"))
    radii = [f"{np.mean(r):.2f} +- {np.std(r):.2f}" for r in report.radii]
    add(("radius of gyration (A)", *radii, ""))
    bars = report.bars
    if len(bars.labels):
        spreads = (np.sqrt(np.mean(s**2)) for s in (bars.spread_ours, bars.spread_theirs))
        add(("lengths of bars, standard deviation (A)", *(f"{s:.1e}" for s in spreads), ""))
        worst = (f"{bars.residual_ours:.1e}", f"{bars.residual_theirs:.1e}")
        add(("  furthest from rest, relative", *worst, ""))
    if report.torsions:
        mean = float(np.mean([torsion.distance for torsion in report.torsions]))
        noise = float(np.mean([torsion.halves_theirs for torsion in report.torsions]))
        apart = f"{_number(noise)} between halves"
        add(("torsions, Jensen-Shannon distance, mean", "", apart, _number(mean)))
    return table


def _fluctuation_row(what: str, found: Fluctuations) -> tuple[str, str, str, str]:
    means = _number(found.ours.mean()), _number(found.theirs.mean())
    return (what, *means, f"Pearson r {_number(found.pearson)}")


def _torsion_table(report: AtomComparison) -> Table:
    table = Table(
        "torsions: Jensen-Shannon distance, 0 the same, 1 nothing in common",
        ["torsion", "ours to theirs", "halves of theirs"],
    )
    for torsion in report.torsions[:MOST_TORSIONS]:
        table.rows.append(
            (torsion.label, _number(torsion.distance), _number(torsion.halves_theirs))
        )
    if len(report.torsions) > MOST_TORSIONS:
        table.rows.append((f"and {len(report.torsions) - MOST_TORSIONS} more", "", ""))
    return table


def as_json(report: ComparisonReport) -> dict[str, Any]:
    """The report as one JSON object; what was not compared is null."""
    names: str | list[str] = report.theirs if len(report.theirs) > 1 else report.theirs[0]
    return {
        "pliant": _core.version(),
        "ours": {"file": report.path, "frames": _count(report, "ours")},
        "theirs": {"file": names, "frames": _count(report, "theirs")},
        "conclusions": report.conclusions,
        "cautions": report.residues.cautions if report.residues else [],
        "residues": residues_json(report.residues) if report.residues else None,
        **_atoms_json(report.atoms),
        "notes": report.notes,
        "pictures": report.pictures,
    }


def _atoms_json(found: AtomComparison | None) -> dict[str, Any]:
    if found is None:
        keys = ("atoms", "matched", "rmsf", "modes", "torsions", "bars", "radius_of_gyration")
        return dict.fromkeys(keys)
    ensembles, modes, bars = found.ensembles, found.modes, found.bars
    residues = found.residue_fluctuations
    return {
        "atoms": len(ensembles.atoms),
        "matched": ensembles.pairing.how,
        "rmsf": {
            "atoms": _fluctuations_json(found.atom_fluctuations),
            "residues": _fluctuations_json(residues) if residues else None,
        },
        "modes": {**vars(modes), "overlaps": modes.overlaps},
        "torsions": [dict(vars(torsion)) for torsion in found.torsions],
        "bars": dict(vars(bars)),
        "radius_of_gyration": {
            name: {"mean": np.mean(radii), "standard_deviation": np.std(radii)}
            for name, radii in zip(("ours", "theirs"), found.radii, strict=True)
        },
    }


def _fluctuations_json(found: Fluctuations) -> dict[str, Any]:
    return {
        "labels": found.labels,
        "ours": found.ours,
        "theirs": found.theirs,
        "pearson": found.pearson,
    }
