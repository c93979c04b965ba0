# SPDX-License-Identifier: MIT
"""Which contacts of residues are kept, lost and gained, and which of the model were held."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from matplotlib.figure import Figure

from pliant.base import style
from pliant.base.console import Table
from pliant.measure.overlaps import ResidueContacts
from pliant.measure.rotatable import is_hydrogen
from pliant.measure.stages.analysis import Analysis
from pliant.measure.stages.names import atom_labels
from pliant.measure.stages.parts import Part, ReferenceStructure, Units
from pliant.report.section import Columns, Fact, Picture
from pliant.report.sections.domains import LEAST_CHAIN
from pliant.report.sections.headings import CHEMISTRY
from pliant.report.sections.measured import Measured, caption, has, spread

#: share of the frames from which a contact counts as kept, and below which as lost
KEPT, LOST = 0.9, 0.1
#: share of the frames from which a contact that the start lacks counts as gained
GAINED = 0.5


@dataclass(frozen=True)
class ContactFrequencies(Part):
    """Pairs of residues in contact (heavy atoms within 4.5 Angstrom) and how often."""

    pairs: np.ndarray  #: (k, 2) numbers of units
    share: np.ndarray  #: (k,) of the frames looked at
    at_start: np.ndarray  #: (k,) bool: in the reference structure
    frames: int  #: that were looked at


def _measure(analysis: Analysis) -> Iterator[ContactFrequencies]:
    """Of frames spread over all, and of the reference."""
    units = analysis[Units]
    if units.what != "residue" or len(units.labels) < LEAST_CHAIN:
        return
    heavy = analysis.atoms[~is_hydrogen(analysis.atoms)]
    heavy = heavy[np.isin(heavy.resindices, units.owners)]
    finder = ResidueContacts(np.searchsorted(units.owners, heavy.resindices), units.chains)
    at_start = finder.of(analysis[ReferenceStructure].positions[heavy.ix])
    looked_at = spread(analysis)
    keys = counts = np.zeros(0, dtype=np.int64)
    for k in looked_at:
        found = finder.of(analysis.positions(k)[heavy.ix])
        both = np.union1d(keys, found)
        more = np.isin(both, found).astype(np.int64)
        more[np.searchsorted(both, keys)] += counts
        keys, counts = both, more
    every = np.union1d(keys, at_start)
    share = np.zeros(len(every))
    share[np.searchsorted(every, keys)] = counts / len(looked_at)
    pairs = np.stack(np.divmod(every, len(units.labels)), axis=1)
    yield ContactFrequencies(pairs, share, np.isin(every, at_start), len(looked_at))


def _facts(analysis: Analysis) -> Iterator[Fact]:
    found = analysis[ContactFrequencies]
    kept = np.count_nonzero(found.at_start & (found.share >= KEPT))
    text = f"of {np.count_nonzero(found.at_start)} contacts of residues kept in 90 % of frames"
    yield Fact(str(kept), "", text)


def _columns(analysis: Analysis) -> Columns:
    """One row per pair of residues that are in contact at the start or in any frame looked at."""
    found, labels = analysis[ContactFrequencies], analysis[Units].labels
    return {
        "first": [labels[k] for k in found.pairs[:, 0]],
        "second": [labels[k] for k in found.pairs[:, 1]],
        "share_of_frames": found.share,
        "at_start": found.at_start.astype(int),
    }


def _tables(analysis: Analysis) -> Iterator[Table]:
    found, labels = analysis[ContactFrequencies], analysis[Units].labels
    start, share = found.at_start, found.share
    classes = (
        ("kept", "of the start, in 90 % of frames and more", start & (share >= KEPT)),
        ("come and go", "of the start, between", start & (share < KEPT) & (share > LOST)),
        ("lost", "of the start, in 10 % and less", start & (share <= LOST)),
        ("gained", "not of the start, in 50 % and more", ~start & (share >= GAINED)),
    )
    rows = [(name, meaning, str(np.count_nonzero(some))) for name, meaning, some in classes]
    least = np.flatnonzero(start)
    for k in least[np.argsort(share[least], kind="stable")][:5]:
        a, b = found.pairs[k]
        rows.append((f"{labels[a]} – {labels[b]}", "among the least kept", f"{share[k]:.0%}"))
    title = f"Contacts of residues, in {found.frames} frames"
    yield Table(title, ("contacts", "", "number, share"), rows)


def _draw(analysis: Analysis) -> Figure:
    """The contact map: share of frames above the diagonal, the start structure below."""
    found, units = analysis[ContactFrequencies], analysis[Units]
    figure, axes = style.new_figure((4.9, 4.1))
    first, second = found.pairs.T
    start, seen = found.at_start, found.share > 0
    look = {"s": float(np.clip(900 / len(units.labels), 1.0, 14)), "marker": "s", "lw": 0}
    axes.scatter(second[start], first[start], c=style.GREY, **look)
    shades = {"c": 100 * found.share[seen], "cmap": f"{style.MAP}_r", "vmin": 0, "vmax": 100}
    dots = axes.scatter(first[seen], second[seen], **shades, **look)
    ends = -0.5, len(units.labels) - 0.5
    axes.plot(ends, ends, color=style.FAINT, lw=1)
    style.chain_axis(axes, units.numbers, units.chains)
    axes.set_yticks(axes.get_xticks(), [t.get_text() for t in axes.get_xticklabels()])
    axes.set(xlim=ends, ylim=ends, aspect="equal", ylabel="residue number", title="Contacts")
    style.colour_bar(axes, dots, "kept (% of frames)")
    return figure


CONTACTS = Measured(
    stage="contacts",
    measure=_measure,
    heading=CHEMISTRY,
    applies=has(ContactFrequencies),
    facts=_facts,
    tables=_tables,
    columns={"contacts": _columns},
    pictures=[
        Picture(
            "contacts",
            _draw,
            caption(
                "Residues with heavy atoms within 4.5 Å, more than three apart in the chain. Below "
                "the diagonal those of the start, above it the share of frames that have each.",
                ensemble="What the model holds together at the start is held by construction.",
            ),
        )
    ],
)


def _held(analysis: Analysis) -> Columns:
    """One row per contact of the model: in what share of the frames it is held, broken, off."""
    contacts = analysis.source.contacts
    if contacts is None or contacts.states is None or len(contacts.states) <= max(analysis.frames):
        return {}
    names = atom_labels(analysis.universe.atoms)
    shares = contacts.shares(analysis.frames)
    return {
        "first": [names[joint] for joint in contacts.joints[:, 0]],
        "second": [names[joint] for joint in contacts.joints[:, 1]],
        "kind": contacts.kinds,
        "energy_kcal_per_mol": ["" if e != e else e for e in contacts.energies.tolist()],
        "share_held": shares[:, 0],
        "share_broken": shares[:, 1],
        "share_off": shares[:, 2],
    }


HELD_CONTACTS = Measured(columns={"held_contacts": _held})
