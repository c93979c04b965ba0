# SPDX-License-Identifier: MIT
"""The sections of a comparison of two paths."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import asdict

from pliant.base.console import Table, printable_name
from pliant.measure.compared.paths import PathComparison
from pliant.report.section import Line, Section, Values

#: what is measured of both, and its name among the numbers
MEASURES = {
    "mean of the nearest of theirs": "nearest_theirs",
    "mean of the nearest of ours": "nearest_ours",
    "Hausdorff distance": "hausdorff",
    "Frechet distance": "frechet",
}


def _compared(found: PathComparison) -> Iterator[Line]:
    yield f"ours    {printable_name(found.path)}: {found.frames[0]} frames compared"
    yield f"theirs  {printable_name(found.theirs[0])}: {found.frames[1]} frames compared"
    ends = f"first frames {found.ends[0]:.2f} A apart, last {found.ends[1]:.2f} A"
    yield f"\n{found.residues} residues; {ends}\n"
    yield Table(
        "how near the paths are, Angstrom",
        ["what", "ours", "straight line"],
        [
            (what, *(f"{getattr(one, name):.2f}" for one in (found.ours, found.line)))
            for what, name in MEASURES.items()
        ],
    )
    yield (
        "\nthe line joins the ends of theirs; a path no nearer to theirs than the line shows "
        "that a way exists, not which one is taken"
    )
    yield from (f"note: {note}" for note in found.notes)


def _values(found: PathComparison) -> Values:
    """All but the table of distances."""
    return {name: value for name, value in asdict(found).items() if name != "rmsd"}


PATHS: tuple[Section[PathComparison], ...] = (Section(lines=_compared, values=_values),)
