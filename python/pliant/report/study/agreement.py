# SPDX-License-Identifier: MIT
"""Whether molecule and data agree: the answer of a study, and the section of its page."""

from __future__ import annotations

import re
from collections.abc import Iterator

import numpy as np

from pliant.base.console import Table, listed
from pliant.base.verdict import Verdict
from pliant.jobs.fit.fitted import Agreement
from pliant.jobs.fit.in_map import MapAgreement
from pliant.measure.stages.analysis import Analysis
from pliant.report.page.additions import Answer
from pliant.report.page.html import Marked
from pliant.report.page.map_surface import VOLUME
from pliant.report.section import Columns, Picture, Section
from pliant.report.sections.headings import DATA
from pliant.report.study.agreement_pictures import fitted_picture, residues_picture
from pliant.report.study.data_fit import DataFit

MOST_NAMED = 3  #: residues that are determined worst
MOST_BARE = 40  #: residues without density that the page names


def agreement_answer(fit: DataFit) -> Answer:
    """Whether they agree, and to what the structure is determined."""
    return Answer(_with_units(fit.found.verdict()), _determined(fit), figure="fitted")


def agreement_section(fit: DataFit) -> Section[Analysis]:
    """Its pictures and tables."""
    return Section(
        name="data",
        heading=DATA,
        verdict=lambda _: _verdict(fit),
        tables=lambda _: _tables(fit),
        pictures=[
            Picture("fitted", lambda _: fitted_picture(fit), _caption(fit)),
            Picture("fit_by_residue", lambda _: residues_picture(fit), _residues_caption(fit)),
        ],
        columns={"fit_residues": lambda _: _columns(fit)},
        methods={
            "Data": "As pliant fit: frames far from START are starts of fits to the data; atoms "
            "then walk to the best, bonds and angles exact. Each distance is also predicted by "
            "fits to the others. The spread is that of the fits that agree about as well as the "
            "best: precision, not accuracy."
        },
    )


def _with_units(text: str) -> str:
    """Angstrom as the page writes them."""
    return re.sub(r"(?<=\d) A\b", " Å", text)


def _determined(fit: DataFit) -> str:
    spread = fit.found.spread
    half, most = np.percentile(spread, [50, 90])
    worst = np.argsort(-spread, kind="stable")[:MOST_NAMED]
    names = ", ".join(fit.labels[k] for k in worst)
    return (
        f"The fitted structure is {fit.found.rmsd_from_start:.1f} Å from START. Half of the "
        f"residues are determined to {half:.1f} Å, nine of ten to {most:.1f} Å, {names} worst, to "
        f"{spread.max():.1f} Å: precision, not accuracy."
    )


def _verdict(fit: DataFit) -> Verdict:
    found, said = fit.found, _with_units(fit.found.verdict())
    let_go = [one.name for one in found.data if one.contradicts]
    if found.agrees and let_go:
        few = f"{len(let_go)} of {len(found.data)} distances cannot hold with the others"
        return Verdict("mixed", f"{few}: {listed(let_go, MOST_NAMED)}.", said)
    if found.agrees and not found.is_predicted:
        text = "The data do not predict each other: do not rely on the structure fitted to them."
        return Verdict("mixed", text, said)
    first, _, rest = said.partition(". ")
    return Verdict("good" if found.agrees else "mixed", f"{first.rstrip('.')}.", rest, "data")


def _tables(fit: DataFit) -> Iterator[Table]:
    rows = [_row(one, off) for one, off in zip(fit.found.data, fit.off, strict=True)]
    columns = ("asked (Å)", "START", "fitted", "by the others", "")
    title = "Distances; those that do not hold, or were let go, in red"
    yield Table(title, ("residues", *columns), rows)
    if fit.found.density is not None:
        yield _map_table(fit, fit.found.density)


def _row(one: Agreement, off: bool) -> list[str]:
    asked = f"{one.low:.1f} to {one.high:.1f}"
    if one.high == np.inf:
        asked = f"from {one.low:.1f}"
    elif one.low == 0:
        asked = f"to {one.high:.1f}"
    predicted = "–" if one.predicted is None else f"{one.predicted:.1f}"
    how = "let go" if one.contradicts else f"off by {one.violation:+.1f}" if off else "holds"
    row = [one.name, asked, f"{one.at_start:.1f}", f"{one.found:.1f}", predicted, how]
    return [Marked(cell) for cell in row] if off else row


def _map_table(fit: DataFit, density: MapAgreement) -> Table:
    bare = set(density.unsupported)
    names = [label for label, own in zip(fit.labels, fit.found.labels, strict=True) if own in bare]
    facts = dict(density.facts())
    worst, before = density.by_residue.min(), density.by_residue_at_start.min()
    rows = [
        ("correlation", f"{density.found:.2f}", f"{density.at_start:.2f}"),
        ("of the worst residue", f"{worst:.2f}", f"{before:.2f}"),
        ("unexplained", _with_units(facts["unexplained"]), "–"),
        ("residues without density", listed(names, MOST_BARE) if names else "none", "–"),
    ]
    if density.judged is not None:
        rows.insert(1, ("other half", f"{density.judged:.2f}", f"{density.judged_at_start:.2f}"))
    title = f"The map, at {density.resolution:g} Å: correlations are about the means, near to atoms"
    return Table(title, ("", "fitted", "START"), rows)


def _columns(fit: DataFit) -> Columns:
    """One row per residue."""
    found, density = fit.found, fit.found.density
    columns: Columns = {"residue": fit.labels, "spread_angstrom": found.spread}
    if density is not None:
        columns["correlation_start"] = density.by_residue_at_start
        columns["correlation_fitted"] = density.by_residue
    return columns


def _caption(fit: DataFit) -> str:
    lines = (
        " Lines are the distances: light blue where they hold, red where not."
        if fit.pairs.size
        else ""
    )
    surface = (
        ""
        if fit.surface is None
        else f" The map is shown where it holds the volume of the molecule, {VOLUME} Å³ a dalton."
    )
    return (
        "The fitted structure in colour over START in grey, superposed by its largest piece "
        "(blue); other colours are pieces that turned against it, dots are hinge residues."
        f"{lines}{surface} The bar is 10 Å. The 3-D view has all of it."
    )


def _residues_caption(fit: DataFit) -> str:
    spread = "How far fits that agree with the data differ: what is low is determined."
    if fit.found.density is None:
        return spread
    return f"Correlation of each residue with the map, fitted (blue) and START (orange). {spread}"
