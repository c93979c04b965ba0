# SPDX-License-Identifier: MIT
"""The page of a molecule's rigidity: one HTML file with everything in it."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterator
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from pliant._core import FileError
from pliant.base.new_file import write_text
from pliant.report.page.html import (
    disclosure,
    fact,
    scripts,
    sentence,
    table,
    template,
    text_of,
    version,
)
from pliant.report.rigidity.rigidity_facts import COLOURS, RigidityFacts, facts_of
from pliant.report.rigidity.rigidity_methods import METHODS, READING
from pliant.report.rigidity.rigidity_profile import profile_svg
from pliant.report.rigidity.rigidity_scene import LEAST_RESIDUES, rigidity_scene

if TYPE_CHECKING:
    from pliant._core import Rigidity

#: rows of the table of segments
MOST_SEGMENTS = 200


def write_rigidity_page(
    found: Rigidity,
    path: str | os.PathLike[str],
    *,
    dilution: bool = False,
    overwrite: bool = False,
) -> None:
    """``Rigidity.write_page``. Raises FileError if the file exists or cannot be written."""
    save_rigidity_page(facts_of(found, dilution), path, overwrite=overwrite)


def save_rigidity_page(
    facts: RigidityFacts, path: str | os.PathLike[str], *, overwrite: bool
) -> None:
    """Writes the page as a whole or not at all."""
    target = Path(path)
    if target.exists() and not overwrite:
        raise FileError(f"{target}: exists; --overwrite replaces it")
    write_text(target, rigidity_page(facts), overwrite=overwrite)


def rigidity_page(facts: RigidityFacts) -> str:
    """The page as text."""
    shown = rigidity_scene(facts)
    name = facts.file or "molecule"
    return template("page.html").substitute(
        generator=escape(f"pliant {version()}"),
        title=escape(f"Rigidity of {name}"),
        subtitle=escape(_subtitle(facts)),
        style=text_of("page.css"),
        eyebrow="pliant rigidity",
        lead=_lead(facts),
        viewer=text_of("viewer.html"),
        facts="\n".join(fact(*row) for row in _numbers(facts)),
        notes=_notes(shown["notes"]),
        sections="\n".join(_sections(facts)),
        details=_methods(),
        footer=escape(f"pliant {version()}"),
        scripts=scripts(shown),
    )


def _subtitle(facts: RigidityFacts) -> str:
    parts = [f"{len(facts.names):,} atoms"]
    if len(facts.chains) > 1:
        parts.append(f"{len(facts.chains):,} residues")
    return " · ".join([*parts, _counted_with(facts)])


def _counted_with(facts: RigidityFacts) -> str:
    if not len(facts.energies):
        return "no hydrogen bonds"
    weakest = f"{facts.energies.max():.2f}".replace("-", "−")
    bonds = "hydrogen bonds and salt bridges, the weakest of"
    return f"{len(facts.energies)} {bonds} {weakest} kcal/mol"


def _percent(part: int, whole: int) -> str:
    return f"{100 * part / max(whole, 1):.0f} %"


#: what a count cannot see
SIX = "counted as rigid. At fixed angles a chair is, but a boat moves through twist-boats."


def _lead(facts: RigidityFacts) -> str:
    """What was found in one sentence, and what it hangs on."""
    text = f"{facts.clusters} rigid cluster{'' if facts.clusters == 1 else 's'}"
    if facts.named:
        share = _percent(int(facts.sizes[0]), len(facts.names))
        text += f"; the largest has {share} of the atoms"
        if len(facts.chains) >= LEAST_RESIDUES:
            text += f" and spans residues {facts.ranges(facts.residues_in(0))}"
    elif facts.clusters:
        text += ", none larger than a side chain"
    free = facts.counts["degrees_of_freedom"]
    more = f"{free} internal degrees of freedom, counted with {_counted_with(facts)}."
    if rings := facts.counts["rings_of_six"]:
        more += f" {rings} ring{'' if rings == 1 else 's'} of six bonds that may turn: {SIX}"
    if len(facts.energies):
        more += f" One cut-off is one answer. {READING}"
    return (
        f'<section class="verdict card"><p><strong>{escape(sentence(text))}</strong>'
        f"<span>{escape(more)}</span></p></section>"
    )


def _numbers(facts: RigidityFacts) -> list[tuple[str, str, str]]:
    counts = facts.counts
    clustered = int(facts.sizes[: facts.clusters].sum())
    hinges = f"of {counts['bonds_that_may_turn']} bonds that can rotate are flexible"
    return [
        (f"{counts['degrees_of_freedom']:,}", "", "internal degrees of freedom"),
        (
            str(facts.clusters),
            "",
            f"rigid clusters of 3 atoms or more, {facts.named} with a colour",
        ),
        (_percent(clustered, len(facts.names)), "", "of the atoms are in them"),
        (f"{counts['small_pieces']:,}", "", "small pieces of one or two atoms"),
        (f"{counts['flexible_bonds']:,}", "", hinges),
        (f"{counts['redundant']:,}", "", f"of {counts['bars']:,} constraints are redundant"),
        (str(counts["parts"]), "", "parts that nothing links" if counts["parts"] > 1 else "part"),
    ]


def _notes(notes: list[str]) -> str:
    if not notes:
        return ""
    text = f"To keep the page small, the 3-D view shows {' and '.join(notes)}."
    return f'<h2>Please note</h2><section class="notes card"><p>{escape(text)}</p></section>'


def _sections(facts: RigidityFacts) -> Iterator[str]:
    yield "<h2>Rigid clusters</h2>" + _clusters(facts)
    if len(facts.chains) >= LEAST_RESIDUES:
        yield "<h2>Along the chain</h2>"
        yield _picture(profile_svg(facts), PROFILE_CAPTION)
        yield _segments(facts)
    if facts.dilution_svg:
        yield "<h2>As hydrogen bonds are removed</h2>" + _picture(
            facts.dilution_svg, DILUTION_CAPTION
        )


def _clusters(facts: RigidityFacts) -> str:
    has_residues = len(facts.chains) >= LEAST_RESIDUES
    rows = []
    for k in range(facts.named):
        size = int(facts.sizes[k])
        where = facts.ranges(facts.residues_in(k)) if has_residues else _formula(facts, k)
        rows.append((f"■ {k + 1}", str(size), _percent(size, len(facts.names)), where))
    small = facts.clusters - facts.named
    caption = f"{small} smaller clusters are grey" if small else ""
    what = "residues" if has_residues else "formula"
    made = table(("cluster", "atoms", "share", what), rows, caption)
    for k in range(facts.named):
        chip = f'<i style="color:{COLOURS[k]};font-style:normal">■</i> {k + 1}<'
        made = made.replace(f"<td>■ {k + 1}<", f"<td>{chip}")
    return made


def _formula(facts: RigidityFacts, cluster: int) -> str:
    """ "C6 H4": carbon first, hydrogen second, then by the alphabet (Hill)."""
    counts = Counter(facts.elements[k] for k in np.flatnonzero(facts.cluster == cluster))
    order = sorted(counts, key=lambda one: (one != "C", one != "H", one))
    return " ".join(f"{one}{counts[one] if counts[one] > 1 else ''}" for one in order)


def _segments(facts: RigidityFacts) -> str:
    rows = []
    for first, last, cluster in facts.segments():
        mean = float(facts.flexibility[first : last + 1].mean())
        what = f"cluster {cluster + 1}" if cluster >= 0 else "in no cluster with a colour"
        rows.append((facts.stretch(first, last), what, str(last - first + 1), f"{mean:.2f}"))
    more = len(rows) - MOST_SEGMENTS
    caption = f"The first {MOST_SEGMENTS} of {len(rows)} stretches" if more > 0 else ""
    headers = ("residues", "belong to", "residues", "mean flexibility")
    made = table(headers, rows[:MOST_SEGMENTS], caption)
    text = disclosure(f"{len(rows)} stretches by cluster", made)
    return f'<div style="margin-top:12px">{text}</div>'


PROFILE_CAPTION = (
    "Flexibility of each residue (mean of its N-CA and CA-C bonds: 1 rotates freely, 0 locked, "
    "below 0 locked by more constraints than needed), and the cluster of its alpha carbon."
)

DILUTION_CAPTION = (
    "Hydrogen bonds and salt bridges are removed one by one, weakest first; one line each "
    "time that clusters change. What lasts longest is the core; it comes apart at hinges."
)


def _picture(svg: str, caption: str) -> str:
    """A picture that scrolls sideways where the screen is narrow."""
    return (
        f'<figure class="card"><div style="overflow-x:auto">{svg}</div>'
        f"<figcaption>{escape(caption)}</figcaption></figure>"
    )


def _methods() -> str:
    return disclosure(
        "Methods", "".join(f"<p><b>{escape(a)}.</b> {escape(b)}</p>" for a, b in METHODS)
    )
