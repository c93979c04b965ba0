# SPDX-License-Identifier: MIT
"""What moves together: correlations, and domains with hinges, with how well they repeat."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from pliant.base import style
from pliant.base.console import Table
from pliant.base.verdict import Verdict
from pliant.measure.domains import (
    LOOSE,
    RESAMPLES,
    TOGETHER,
    Domains,
    Hinge,
    correlations,
    find_domains,
)
from pliant.measure.stages.analysis import Analysis
from pliant.measure.stages.parts import Part, Units
from pliant.report.figures.profile import NAMED_BARS, domain_strip
from pliant.report.section import Columns, Fact, Picture, Values
from pliant.report.sections import headings
from pliant.report.sections.measured import Measured, caption, has, told
from pliant.trajectory.frame_store import FrameStore
from pliant.trajectory.kind import ENSEMBLE

#: chains shorter than this have no domains
LEAST_CHAIN = 20
#: domains are of at most so many units; more are thinned along their chains
MOST_DOMAIN_SITES = 1000
#: sites up to which each pair is drawn as a square; more take a hundred bytes each
MOST_SQUARES = 500

RULE = (
    f"Domains were looked for in {RESAMPLES} resamples of the frames (blocks drawn with "
    f"replacement). Shown is what is together in {100 * TOGETHER:.0f} % of them. That a domain "
    "repeats shows that the frames suffice to find it, not that the molecule has it."
)
#: `pliant lab bench domains --repeats 2`: two ensembles of each structure of the twelve pairs of
#: docs/pages/protein.md, on which the thresholds were chosen; what it prints last
KNOWN = (
    "In ensembles of 24 structures of proteins that are known in two shapes, where several domains "
    "were found, 93 % of the pairs of residues were placed as the other shape has them: in one "
    "domain, or in two."
)


@dataclass(frozen=True)
class Correlations(Part):
    """Correlations of the displacements of units."""

    matrix: np.ndarray  #: (s, s) of every `site_stride`-th unit


@dataclass(frozen=True)
class RigidDomains(Part):
    """Domains that move as rigid bodies."""

    found: Domains  #: of some units of chains, the sites
    sites: np.ndarray  #: (s,) numbers of these units
    of_unit: np.ndarray  #: (n,) domain of each unit; LOOSE where it has none
    hinge_share: np.ndarray  #: (n,) share of the resamples in which a unit is a hinge

    def units_of(self, sites: np.ndarray) -> np.ndarray:
        """Numbers of the units that some sites stand for."""
        ends = np.append(self.sites[1:], self.sites[-1] + 1)
        ranges = [np.arange(self.sites[k], ends[k]) for k in sites]
        return np.concatenate(ranges) if ranges else np.zeros(0, dtype=np.int64)


def domains(
    analysis: Analysis, moved: FrameStore, blocks: list[np.ndarray], far: FrameStore | None = None
) -> Iterator[Correlations | RigidDomains]:
    """Of the units' superposed positions; blocks of frames that count as independent; far: of those
    frames that reach further."""
    units = analysis[Units]
    every = np.arange(len(units.labels))[:: units.site_stride]
    yield Correlations(correlations(_sites(units, moved, every)))
    chain = np.flatnonzero(units.of_chain)
    if len(chain) < LEAST_CHAIN:
        return
    stride = -(-len(chain) // MOST_DOMAIN_SITES)
    thinned = chain[::stride]
    whole = None if analysis.kind == ENSEMBLE else blocks
    reached = None if far is None else _sites(units, far, thinned)
    found = find_domains(_sites(units, moved, thinned), units.chains[thinned], whole, reached)
    of_unit, hinge_share = np.full(len(units.labels), LOOSE), np.zeros(len(units.labels))
    of_unit[chain] = np.repeat(found.domain, stride)[: len(chain)]
    hinge_share[chain] = np.repeat(found.hinge_share, stride)[: len(chain)]
    yield RigidDomains(found, thinned, of_unit, hinge_share)


def _sites(units: Units, moved: FrameStore, chosen: np.ndarray) -> np.ndarray:
    """(F, k, 3) centres of some units."""
    return np.concatenate([units.sites(block)[:, chosen] for block in moved.blocks()])


def domain_verdict(analysis: Analysis) -> Verdict | None:
    """How many domains there are, or why none is shown; None where none was looked for."""
    part = analysis.get(RigidDomains)
    if part is None:
        return None
    found = part.found
    if found.count == 0:
        why = f"Number of domains: {_numbers(part)}. {RULE}"
        return Verdict("open", "No reproducible domains were found.", why)
    if found.count == 1:
        one = "One piece: no two parts move against each other as rigid bodies."
        return Verdict("open", one, f"In {_percent(found.found[0])} of the resamples. {RULE}")
    least = found.found.min()
    share = "all" if least == 1.0 else f"at least {_percent(least)} of"
    sentence = f"{found.count} domains, each found in {share} {RESAMPLES} resamples of the frames."
    return Verdict("open", sentence, f"{RULE} {KNOWN}")


def _numbers(part: RigidDomains) -> str:
    """ "2 in 6 %, 3 in 94 % of the resamples"."""
    counts = sorted(part.found.counts.items())
    return ", ".join(f"{n} in {_percent(share)}" for n, share in counts) + " of the resamples"


def _rows(analysis: Analysis) -> Iterator[Sequence[str]]:
    """(what, residues, share) of domains, hinges and what is undecided."""
    part = analysis[RigidDomains]
    for k, share in enumerate(part.found.found):
        yield f"{k + 1}", named_stretches(analysis, part.of_unit == k), _percent(share)
    for hinge in part.found.hinges:
        yield "hinge", _hinge_text(analysis, hinge), _percent(hinge.share)
    for sites, share in part.found.undecided:
        some = np.isin(np.arange(len(part.of_unit)), part.units_of(sites))
        yield "undecided", named_stretches(analysis, some), _percent(share)
    yield "how many", _numbers(part), ""


def domain_line(analysis: Analysis) -> str:
    """Domains and hinges of a molecule that has several, in one line."""
    part = analysis[RigidDomains]
    found = [
        f"{named_stretches(analysis, part.of_unit == k)} ({_percent(share)})"
        for k, share in enumerate(part.found.found)
    ]
    hinges = ", ".join(
        f"{_hinge_text(analysis, hinge)} ({_percent(hinge.share)})" for hinge in part.found.hinges
    )
    shown = f"{part.found.count} domains (how often resampled frames show them)"
    return f"{shown}: {'; '.join(found)}" + (f"; hinge {hinges}" if hinges else "")


def _values(analysis: Analysis) -> Values:
    part = analysis[RigidDomains]
    found = part.found
    hinges = [(_ends(analysis, hinge), hinge.share) for hinge in found.hinges]
    return {
        "domains": found.count,
        "domains_explained": found.explained,
        "domain_numbers": {str(number): share for number, share in found.counts.items()},
        "domain_table": [
            {"residues": stretches(analysis, part.of_unit == k), "share": float(share)}
            for k, share in enumerate(found.found)
        ],
        "hinges": [
            {"between": ends[:2], "residue": ends[2], "share": share} for ends, share in hinges
        ],
    }


def stretches(analysis: Analysis, some: np.ndarray) -> list[list[str]]:
    """First and last label of each stretch of units (n, bool) along their chains."""
    units = analysis[Units]
    parts = split_stretches(np.flatnonzero(some), units.chains)
    return [[units.labels[part[0]], units.labels[part[-1]]] for part in parts]


def split_stretches(places: np.ndarray, chains: np.ndarray) -> list[np.ndarray]:
    """Places that follow each other in one chain; chains: of every place there is."""
    ends = (np.diff(places) > 1) | (chains[places[1:]] != chains[places[:-1]])
    return np.split(places, np.flatnonzero(ends) + 1)


def named_stretches(analysis: Analysis, some: np.ndarray) -> str:
    """The same in words."""
    return ", ".join(f"{first} to {last}" for first, last in stretches(analysis, some))


def _hinge_text(analysis: Analysis, hinge: Hinge) -> str:
    before, after, site = _ends(analysis, hinge)
    return f"between {before} and {after}, most often at {site}"


def _ends(analysis: Analysis, hinge: Hinge) -> list[str]:
    labels, sites = analysis[Units].labels, analysis[RigidDomains].sites
    return [labels[sites[k]] for k in (hinge.before, hinge.after, hinge.site)]


def _percent(share: float) -> str:
    return f"{100 * share:.0f} %"


def _facts(analysis: Analysis) -> Iterator[Fact]:
    found = analysis[RigidDomains].found
    share = f"domains, which explain {100 * found.explained:.0f} % of the motion by moving rigidly"
    few = ("reproducible domains", "piece: no domains were found")
    yield Fact(str(found.count), "", share if found.count > 1 else few[found.count])


def _tables(analysis: Analysis) -> Iterator[Table]:
    if analysis[RigidDomains].found.count != 1:
        columns = ("domain", "residues", "found in")
        yield Table("Domains that move as rigid bodies", columns, list(_rows(analysis)))


def _correlations(analysis: Analysis) -> Columns:
    """The matrix, rounded to 4 digits; one column a unit."""
    units = analysis[Units]
    labels = units.labels[:: units.site_stride]
    unique = len(set(labels)) == len(labels)
    names = labels if unique else [f"{label} ({k})" for k, label in enumerate(labels)]
    columns: Columns = {"unit": names}
    return columns | dict(zip(names, np.round(analysis[Correlations].matrix, 4), strict=True))


def domains_of_units(analysis: Analysis) -> np.ndarray:
    """(n,) the domain of each unit, where there are several; else LOOSE."""
    part = analysis.get(RigidDomains)
    if part is None or part.found.count < 2:
        return np.full(len(analysis[Units].labels), LOOSE)
    return part.of_unit


def _draw(analysis: Analysis) -> Figure:
    """The correlation matrix, with the domains along its edge."""
    matrix, units = analysis[Correlations].matrix, analysis[Units]
    figure, axes = style.new_figure((4.9, 4.1))
    colours: dict[str, Any] = {"cmap": "PuOr_r", "vmin": -1, "vmax": 1}
    extent = (-0.5, len(matrix) * units.site_stride - 0.5) * 2
    how = "nearest" if len(matrix) <= MOST_SQUARES else None
    colours |= {"origin": "lower", "extent": extent, "interpolation": how}
    image = axes.imshow(matrix.astype(np.float32), **colours)
    if len(units.labels) <= NAMED_BARS:
        place = np.arange(len(units.labels))
        axes.set_xticks(place, units.labels, rotation=90, fontsize=7)
        axes.set_yticks(place, units.labels, fontsize=7)
    else:
        style.chain_axis(axes, units.numbers, units.chains, units.what)
        axes.set_yticks(axes.get_xticks(), [t.get_text() for t in axes.get_xticklabels()])
        axes.set_ylabel(f"{units.what} number")
    domain_strip(axes, domains_of_units(analysis))
    axes.set(title="What moves together", aspect="equal")
    axes.grid(False)
    style.colour_bar(axes, image, "correlation of displacements")
    return figure


CORRELATIONS = Measured(
    heading=headings.TOGETHER,
    applies=has(Correlations),
    columns={"correlations": _correlations},
    pictures=[
        Picture(
            "correlations",
            _draw,
            caption(
                "Correlation of displacements: 1 moves along with, −1 against, 0 neither, or at "
                "right angles, which this measure cannot tell apart. It depends on what was "
                "superposed.",
                path="Random pushes move neighbours together; far correlations of one path are "
                "chance.",
            ),
        )
    ],
)

DOMAINS = Measured(
    name="domains",
    heading=headings.TOGETHER,
    applies=has(RigidDomains),
    verdict=domain_verdict,
    values=_values,
    facts=_facts,
    tables=_tables,
    lines=told("domains", domain_verdict),
    methods={
        "Domains": (
            "Residues are split in two, at any places of their chains, where the share of the "
            "fluctuation that is gone once both parts move rigidly (after Hayward and Berendsen "
            "1998), less twice the share of contacts (8 Å) between them, is largest: a third or "
            "more. Each part is split again if that is half or more of its own. A part has 30 "
            "residues or more, and a split explains 6 % of all motion or more, of frames around "
            "the start and of those that reach further. This is done for 50 "
            "resamples of the frames (blocks drawn with replacement). A domain is what is together "
            "in 90 % of the resamples, and a part by itself in 80 %; two domains are apart in 90 "
            "%; what is neither is undecided. A hinge is where a chain goes from one domain to the "
            "next, with the share of resamples in which the residue is there."
        )
    },
)
