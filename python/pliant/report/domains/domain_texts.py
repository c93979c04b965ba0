# SPDX-License-Identifier: MIT
"""Domains and hinges as a verdict, rows of tables, and JSON, always with how well they repeat."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from pliant.base.verdict import Verdict
from pliant.measure.domains import RESAMPLES, TOGETHER, Hinge
from pliant.measure.stages.parts import RigidDomains, Units

if TYPE_CHECKING:
    from pliant.measure.stages.analysis import Analysis

RULE = (
    f"Domains were looked for in {RESAMPLES} resamples of the frames (blocks drawn with "
    f"replacement). Shown is what is together in {100 * TOGETHER:.0f} % of them. That a domain "
    "repeats shows that the frames suffice to find it, not that the molecule has it."
)


def domain_verdict(analysis: Analysis) -> Verdict | None:
    """How many domains there are, or why none is shown; None where none was looked for."""
    part = analysis.get(RigidDomains)
    if part is None:
        return None
    found = part.found
    if found.count == 0:
        why = f"Number of domains: {numbers_text(analysis)}. {RULE}"
        return Verdict("open", "No reproducible domains were found.", why)
    if found.count == 1:
        one = "One piece: no two parts move against each other as rigid bodies."
        return Verdict("open", one, f"In {_percent(found.found[0])} of the resamples. {RULE}")
    least = found.found.min()
    share = "all" if least == 1.0 else f"at least {_percent(least)} of"
    sentence = f"{found.count} domains, each found in {share} {RESAMPLES} resamples of the frames."
    return Verdict("open", sentence, RULE)


def numbers_text(analysis: Analysis) -> str:
    """ "2 in 6 %, 3 in 94 % of the resamples"."""
    counts = sorted(analysis[RigidDomains].found.counts.items())
    return (
        ", ".join(f"{number} in {_percent(share)}" for number, share in counts)
        + " of the resamples"
    )


def domain_rows(analysis: Analysis) -> list[Sequence[str]]:
    """(what, residues, share) of domains, hinges and what is undecided; none for one piece."""
    part = analysis[RigidDomains]
    found = part.found
    if found.count == 1:
        return []
    rows: list[Sequence[str]] = []
    for k, share in enumerate(found.found):
        rows.append((f"{k + 1}", _text(analysis, part.of_unit == k), _percent(share)))
    for hinge in found.hinges:
        rows.append(("hinge", _hinge_text(analysis, hinge), _percent(hinge.share)))
    for sites, share in found.undecided:
        some = np.isin(np.arange(len(part.of_unit)), part.units_of(sites))
        rows.append(("undecided", _text(analysis, some), _percent(share)))
    return [*rows, ("how many", numbers_text(analysis), "")]


def domain_line(analysis: Analysis) -> str:
    """Domains and hinges of a molecule that has several, in one line."""
    part = analysis[RigidDomains]
    domains = "; ".join(
        f"{_text(analysis, part.of_unit == k)} ({_percent(share)})"
        for k, share in enumerate(part.found.found)
    )
    hinges = ", ".join(
        f"{_hinge_text(analysis, hinge)} ({_percent(hinge.share)})" for hinge in part.found.hinges
    )
    line = f"{part.found.count} domains (how often resampled frames show them): {domains}"
    return line + (f"; hinge {hinges}" if hinges else "")


def domain_json(analysis: Analysis) -> dict[str, Any]:
    """For summary.json."""
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
    labels, chains = analysis[Units].labels, analysis[Units].chains
    units = np.flatnonzero(some)
    ends = (np.diff(units) > 1) | (chains[units[1:]] != chains[units[:-1]])
    parts = np.split(units, np.flatnonzero(ends) + 1)
    return [[labels[part[0]], labels[part[-1]]] for part in parts]


def _text(analysis: Analysis, some: np.ndarray) -> str:
    return ", ".join(f"{first} to {last}" for first, last in stretches(analysis, some))


def _hinge_text(analysis: Analysis, hinge: Hinge) -> str:
    before, after, site = _ends(analysis, hinge)
    return f"between {before} and {after}, most often at {site}"


def _ends(analysis: Analysis, hinge: Hinge) -> list[str]:
    labels, sites = analysis[Units].labels, analysis[RigidDomains].sites
    return [labels[sites[k]] for k in (hinge.before, hinge.after, hinge.site)]


def _percent(share: float) -> str:
    return f"{100 * share:.0f} %"
