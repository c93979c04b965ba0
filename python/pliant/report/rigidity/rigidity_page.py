# SPDX-License-Identifier: MIT
"""The page of a molecule's rigidity: its sections, and one HTML file with everything in it."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterator
from html import escape
from pathlib import Path

import numpy as np

from pliant._core import Rigidity, contact_kinds
from pliant.base.console import counted
from pliant.base.new_file import expect_none, write_text
from pliant.report.build import Report
from pliant.report.page.html import disclosure, sentence, table
from pliant.report.page.page import Page, headline, methods, sections_of
from pliant.report.rigidity.rigidity_facts import COLOURS, RigidityFacts, facts_of
from pliant.report.rigidity.rigidity_profile import profile_svg
from pliant.report.rigidity.rigidity_scene import LEAST_RESIDUES, rigidity_scene
from pliant.report.section import Fact, Section

#: rows of the table of segments
MOST_SEGMENTS = 200
BARS = ", ".join(f"{kind.singular} {kind.bars}" for kind in contact_kinds())
READING = (
    "Believe what holds together over a range of cut-offs. A cluster is not necessarily stiff, and "
    "a degree of freedom is not an amplitude."
)
#: what a count cannot see
SIX = "counted as rigid. At fixed angles a chair is, but a boat moves through twist-boats."


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
    expect_none([target], overwrite)
    write_text(target, rigidity_page(facts).text(), overwrite=overwrite)


def rigidity_page(facts: RigidityFacts) -> Page:
    """The page that its sections make."""
    report, headings = Report(facts, SECTIONS), [row.heading for row in SECTIONS]
    return Page(
        title=f"Rigidity of {facts.file or 'molecule'}",
        subtitle=_subtitle(facts),
        made_by="pliant rigidity",
        lead=_lead(facts),
        facts=report.facts(headings),
        sections=sections_of(report, {}, headings, wide=headings),
        scene=rigidity_scene(facts),
        details={"Methods": methods(report.methods)},
    )


def _subtitle(facts: RigidityFacts) -> list[str]:
    parts = [f"{len(facts.names):,} atoms"]
    if len(facts.chains) > 1:
        parts.append(f"{len(facts.chains):,} residues")
    return [*parts, _counted_with(facts)]


def _counted_with(facts: RigidityFacts) -> str:
    if not len(facts.energies):
        return "no hydrogen bonds"
    weakest = f"{facts.energies.max():.2f}".replace("-", "−")
    bonds = "hydrogen bonds and salt bridges, the weakest of"
    return f"{len(facts.energies)} {bonds} {weakest} kcal/mol"


def _percent(part: int, whole: int) -> str:
    return f"{100 * part / max(whole, 1):.0f} %"


def _lead(facts: RigidityFacts) -> str:
    """What was found in one sentence, and what it hangs on."""
    text = counted(facts.clusters, "rigid cluster")
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
        more += f" {counted(rings, 'ring')} of six bonds that may turn: {SIX}"
    if len(facts.energies):
        more += f" One cut-off is one answer. {READING}"
    return headline(sentence(text), more)


def _facts(facts: RigidityFacts) -> Iterator[Fact]:
    counts, atoms = facts.counts, len(facts.names)
    clustered = int(facts.sizes[: facts.clusters].sum())
    coloured = f"rigid clusters of 3 atoms or more, {facts.named} with a colour"
    hinges = f"of {counts['bonds_that_may_turn']} bonds that can rotate are flexible"
    parts = "parts that nothing links" if counts["parts"] > 1 else "part"
    yield Fact(f"{counts['degrees_of_freedom']:,}", "", "internal degrees of freedom")
    yield Fact(str(facts.clusters), "", coloured)
    yield Fact(_percent(clustered, atoms), "", "of the atoms are in them")
    yield Fact(f"{counts['small_pieces']:,}", "", "small pieces of one or two atoms")
    yield Fact(f"{counts['flexible_bonds']:,}", "", hinges)
    yield Fact(f"{counts['redundant']:,}", "", f"of {counts['bars']:,} constraints are redundant")
    yield Fact(str(counts["parts"]), "", parts)


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


def _picture(svg: str, caption: str) -> str:
    """A picture that scrolls sideways where the screen is narrow."""
    return (
        f'<figure class="card"><div style="overflow-x:auto">{svg}</div>'
        f"<figcaption>{escape(caption)}</figcaption></figure>"
    )


PROFILE = (
    "Flexibility of each residue (mean of its N-CA and CA-C bonds: 1 rotates freely, 0 locked, "
    "below 0 locked by more constraints than needed), and the cluster of its alpha carbon."
)
DILUTION = (
    "Hydrogen bonds and salt bridges are removed one by one, weakest first; one line each "
    "time that clusters change. What lasts longest is the core; it comes apart at hinges."
)

METHODS = {
    "Count": (
        "Each atom is a body with six freedoms. A bond that can rotate removes five (a hinge), "
        f"one that does not six, a contact its own number ({BARS}), unless they "
        "depend on those before: internal degrees of freedom = 6 atoms - independent constraints - "
        "6 parts (D. J. Jacobs, M. F. Thorpe, Phys. Rev. Lett. 75 (1995) 4051; D. J. Jacobs, A. J. "
        "Rader, L. A. Kuhn, M. F. Thorpe, Proteins 44 (2001) 150)."
    ),
    "Which constraints are independent": (
        "The (6,6) pebble game: each body has six pebbles, an independent constraint takes one, "
        "and it is independent if seven can be gathered at its ends (A. Lee, I. Streinu, Discrete "
        "Math. 308 (2008) 1425). For constraints in general directions that is the rank of the "
        "rigidity matrix (T.-S. Tay, J. Combin. Theory B 36 (1984) 95; W. Whiteley, SIAM J. "
        "Discrete Math. 1 (1988) 237); that hinges at one atom meet there changes nothing, the "
        "molecular conjecture (N. Katoh, S. Tanigawa, Discrete Comput. Geom. 45 (2011) 647)."
    ),
    "Flexibility": (
        "Of a bond between clusters: the freedoms of its block over those that the bonds of the "
        "block would have each alone. Of a bond in a cluster: - redundant constraints / "
        "constraints. Of a residue: the mean of N-CA and CA-C."
    ),
    "Dilution": (
        "Hydrogen bonds are removed one by one, weakest first (B. M. Hespenheide, A. J. Rader, M. "
        "F. Thorpe, L. A. Kuhn, J. Mol. Graph. Model. 21 (2002) 195)."
    ),
    "Not claimed": (
        "The count ignores positions: flat rings and axes that meet by symmetry may move where it "
        "says rigid. Contacts are there or not; everything depends on which of them count."
    ),
}

SECTIONS: tuple[Section[RigidityFacts], ...] = (
    Section(
        heading="Rigid clusters",
        facts=_facts,
        blocks=lambda facts: [_clusters(facts)],
        methods=METHODS,
    ),
    Section(
        heading="Along the chain",
        applies=lambda facts: len(facts.chains) >= LEAST_RESIDUES,
        blocks=lambda facts: [_picture(profile_svg(facts), PROFILE), _segments(facts)],
    ),
    Section(
        heading="As hydrogen bonds are removed",
        applies=lambda facts: bool(facts.dilution_svg),
        blocks=lambda facts: [_picture(facts.dilution_svg, DILUTION)],
    ),
)
