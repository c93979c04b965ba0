# SPDX-License-Identifier: MIT
"""The sections of a comparison: what follows first, the figures behind it after."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Iterator, Sequence
from dataclasses import asdict

import numpy as np

from pliant import _core
from pliant.base.console import Table, counted, printable_name
from pliant.measure.agreement import TEN
from pliant.measure.compared.residue_report import ResidueComparison, Subspaces
from pliant.report.build import Report, print_lines
from pliant.report.compare.comparison_report import AtomComparison, ComparisonReport, Fluctuations
from pliant.report.compare.conclusions import figure_text, mean_text
from pliant.report.section import Line, Section, Values

WIDTH = 96  #: of a line
MOST_TORSIONS = 40  #: rows that the table shows


def print_report(report: ComparisonReport) -> None:
    """Prints the report on stdout."""
    print_lines(Report(report, SECTIONS).lines())


def _compared(report: ComparisonReport) -> Iterator[Line]:
    ours, theirs = (counted(_count(report, whose), "frame") for whose in ("ours", "theirs"))
    yield f"ours    {printable_name(report.path)}: {ours} compared"
    for k, path in enumerate(report.theirs):
        frames = f": {theirs} compared" if len(report.theirs) == 1 else ""
        yield f"{'theirs' if k == 0 else '      '}  {printable_name(path)}{frames}"


def _compared_values(report: ComparisonReport) -> Values:
    names: str | list[str] = report.theirs if len(report.theirs) > 1 else report.theirs[0]
    return {
        "pliant": _core.version(),
        "ours": {"file": report.path, "frames": _count(report, "ours")},
        "theirs": {"file": names, "frames": _count(report, "theirs")},
    }


def _count(report: ComparisonReport, whose: str) -> int:
    if report.residues is None:
        assert report.atoms is not None
        return len(getattr(report.atoms.ensembles, whose))
    profile = getattr(report.residues, whose)
    return profile.frames if profile else 1


def _number(value: float, form: str = ".2f") -> str:
    return f"{value:{form}}" if math.isfinite(value) else "-"


def _listed(title: str, lines: Sequence[str]) -> Iterator[Line]:
    """Lines under a title, after an empty line; nothing without any."""
    if lines:
        yield f"\n{title}"
    for line in lines:
        yield textwrap.fill(line, WIDTH, initial_indent="  ", subsequent_indent="    ")


def _residues(report: ComparisonReport) -> Iterator[Line]:
    found = report.residues
    if found is not None:
        yield from _listed("what follows", found.conclusions)
        yield from _listed("what cannot be concluded", found.cautions)
        if found.theirs is not None:
            yield from ("", _residue_table(found))
        yield from _listed("residues", found.notes)


def _residue_table(found: ResidueComparison) -> Table:
    table = Table(
        "figures, of residues: +- one standard error, precision: two",
        ["what", "ours", "theirs", "agreement", "ceiling", "by chance"],
    )
    add = table.rows.append
    assert found.theirs is not None
    means = (mean_text(one, found.core) for one in (found.ours, found.theirs))
    add(("RMSF, mean (A)", *means, f"r {figure_text(found.r)}", _number(found.r_ceiling), "0"))
    if found.ends:
        add(("  with free ends", "", "", f"r {_number(found.r_all)}", "", ""))
    if math.isfinite(found.r_in_time):
        add(("  first and second half of theirs", "", "", "", _number(found.r_in_time), ""))
    if found.subspaces is not None:
        _add_modes(table, found.subspaces)
    return table


def _add_modes(table: Table, both: Subspaces) -> None:
    shares = _number(both.ours.share), _number(both.theirs.share)
    found = f"RMSIP {figure_text(both.rmsip)}", _number(both.ceiling), _number(both.chance)
    table.rows.append((f"first {TEN} modes, share of motion", *shares, *found))
    table.rows.append(("  of theirs within ours", "", "", _number(both.share_covered), "", ""))
    for k in range(3):
        covered = _at(both.covered_ours, k), _at(both.covered_theirs, k)
        table.rows.append((f"  mode {k + 1} in the other's {TEN}", *covered, "", "", ""))


def _at(values: np.ndarray, place: int) -> str:
    return _number(float(values[place])) if place < len(values) else "-"


def _residue_values(report: ComparisonReport) -> Values:
    found = report.residues
    said: Values = {
        "conclusions": report.conclusions,
        "cautions": found.cautions if found else [],
        "residues": None,
    }
    return said | {"residues": _residues_json(found)} if found else said


def _residues_json(found: ResidueComparison) -> Values:
    return {
        "kind": found.kind,
        "labels": found.labels,
        "core": found.core.tolist(),
        "free_ends": found.ends,
        "rmsf": {
            name: None if one is None else {"value": one.rmsf, "error": one.error}
            for name, one in (("ours", found.ours), ("theirs", found.theirs))
        },
        "r": {
            "value": found.r.value,
            "error": found.r.error,
            "with_free_ends": found.r_all,
            "ceiling": found.r_ceiling,
            "halves_in_time": found.r_in_time,
        },
        "scale": found.scale,
        "more_in_ours": [asdict(one) for one in found.more_stretches],
        "less_in_ours": [asdict(one) for one in found.less_stretches],
        "modes": _modes_json(found.subspaces) if found.subspaces else None,
        "displacement": asdict(found.displacement) if found.displacement else None,
        "notes": found.notes,
    }


def _modes_json(both: Subspaces) -> Values:
    return {
        "rmsip": asdict(both.rmsip),
        "ceiling": both.ceiling,
        "chance": both.chance,
        "overlaps": both.overlaps,
        "covered_ours": both.covered_ours,
        "covered_theirs": both.covered_theirs,
        "share_ours": both.ours.share,
        "share_theirs": both.theirs.share,
        "share_of_theirs_within_ours": both.share_covered,
        "of_ours_alone": [asdict(one) for one in both.of_ours_alone],
        "of_theirs_alone": [asdict(one) for one in both.of_theirs_alone],
    }


def _atoms(report: ComparisonReport) -> Iterator[Line]:
    found = report.atoms
    if found is not None:
        yield f"\n{len(found.ensembles.atoms)} atoms, {found.modes.atoms} of them fitted\n"
        yield _summary_table(found)
        if found.torsions:
            yield from ("", _torsion_table(found))


def _summary_table(report: AtomComparison) -> Table:
    table = Table("how far they agree", ["what", "ours", "theirs", "agreement"])
    add = table.rows.append
    add(_fluctuation_row("RMSF of atoms, mean (A), no error", report.atom_fluctuations))
    if report.residue_fluctuations:
        add(
            _fluctuation_row(
                "RMSF of alpha carbons, mean (A), no error", report.residue_fluctuations
            )
        )
    modes = report.modes
    count = min(modes.overlaps.shape, default=0)
    shares = (_number(modes.share_ours), _number(modes.share_theirs))
    add((f"first {count} modes, share of the variance", *shares, f"RMSIP {_number(modes.rmsip)}"))
    halves = (_number(modes.halves_ours), _number(modes.halves_theirs))
    add(("  RMSIP of its two halves", *halves, f"{_number(modes.chance)} by chance"))
    radii = [f"{np.mean(r):.2f} ({np.std(r):.2f})" for r in report.radii]
    add(("radius of gyration (A), mean (standard deviation)", *radii, ""))
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


def _atom_values(report: ComparisonReport) -> Values:
    found = report.atoms
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


def _fluctuations_json(found: Fluctuations) -> Values:
    return {
        "labels": found.labels,
        "ours": found.ours,
        "theirs": found.theirs,
        "pearson": found.pearson,
    }


def _pictures(report: ComparisonReport) -> Iterator[Line]:
    for k, path in enumerate(report.pictures):
        yield f"{'' if k else chr(10)}picture  {printable_name(path)}"


SECTIONS: tuple[Section[ComparisonReport], ...] = (
    Section(lines=_compared, values=_compared_values),
    Section(lines=_residues, values=_residue_values),
    Section(lines=_atoms, values=_atom_values),
    Section(
        lines=lambda report: _listed("notes", report.notes),
        values=lambda report: {"notes": report.notes},
    ),
    Section(lines=_pictures, values=lambda report: {"pictures": report.pictures}),
)
