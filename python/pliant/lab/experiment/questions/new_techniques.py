# SPDX-License-Identifier: MIT
"""New techniques against all of the thesis at equal work, on random graphs and on molecules."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes

import pliant
from pliant.base import plotting
from pliant.lab.experiment.answer import Answer, Figure, Table
from pliant.lab.experiment.questions.root_adaptation import family_trials
from pliant.lab.experiment.specimens import SMILES, Specimen, packaged_proteins, rdkit_molecules
from pliant.lab.experiment.trials import (
    LIMIT,
    THESIS,
    Combination,
    Trial,
    Work,
    as_text,
    combinations,
    digits,
    label,
    mean_interval,
    pushes_of,
    ratio_interval,
    replicates,
    with_interval,
    work_of,
)

TITLE = "Which new techniques do better?"
ORDER = 6

#: the thesis' own, and what only compares with them
NOT_NEW = {*THESIS, "bfs_tree", "dfs_tree", "input", "auto"}
SETTINGS = {"0.01 Å": (0.01, 1e-6), "1e-6 relative": (None, 1e-6)}
LISTED = 6  #: of the thesis, in the table of work
NAMES = (
    "glutathione", "ibuprofen", "sucrose", "caffeine", "crown-18-6", "penicillin G", "cholesterol",
    "morphine", "porphine", "adamantane", "cyclohexaglycine", "quinine",
)  # fmt: skip  # a table: a row a line
COLORS = [plotting.GREEN, plotting.BLUE, plotting.VERMILION, plotting.ORANGE, plotting.PURPLE]
COLORS += [plotting.SKY, "black", plotting.GREY, "#7F5539", "#44AA99"]

Results = dict[tuple[str, str], dict[Combination, Work]]  #: (family, tolerance) -> each technique


def answer(out: Path, seed: int, quick: bool) -> Answer:
    """The same pushes for all; each new technique over the thesis' best of the same class."""
    graphs, pushes = (2, 4) if quick else (20, 25)
    trials = dict(family_trials(graphs, pushes, seed))
    words = []
    try:
        trials |= _molecule_trials(seed, quick)
    except ImportError:
        words.append("RDKit is not installed: small molecules are left out.")
    thesis = combinations(THESIS)
    new = [(name, w) for name, w in combinations(_new()) if w != 0.75]
    found: Results = {}
    for family, own in trials.items():
        for name, (length, relative) in SETTINGS.items():
            found[family, name] = {
                c: work_of(own, *c, length=length, relative=relative, limit=_limit(family))
                for c in (*thesis, *new)
            }
    return Answer(
        TITLE,
        _verdict(found, new, seed),
        [*_paragraphs(new), *words],
        as_text([_ratio_table(found, new, seed), _work_table(found, seed)]),
        [_draw(found, new, seed, out)],
    )


def _new() -> list[str]:
    return [row.name for row in pliant.techniques() if row.name not in NOT_NEW]


def _limit(family: str) -> int:
    return 300 if family.startswith("protein") else LIMIT


def _molecule_trials(seed: int, quick: bool) -> dict[str, list[Trial]]:
    pushes = 3 if quick else 8
    names = list(NAMES[:3] if quick else NAMES)
    assert all(name in SMILES for name in names)
    found = {
        f"molecules, {bars}": _trials_of(rdkit_molecules(names, bars), pushes, seed)
        for bars in ("bonds", "angles")
    }
    if not quick:
        proteins = [p for p in packaged_proteins()[0] if p.framework.bar_count < 4000]
        found["proteins, bonds"] = _trials_of(proteins, 3, seed)
    return {family: trials for family, trials in found.items() if trials}


def _trials_of(specimens: Iterable[Specimen], pushes: int, seed: int) -> list[Trial]:
    trials: list[Trial] = []
    for number, specimen in enumerate(specimens):
        trials += pushes_of(specimen.framework, specimen.positions, pushes, (seed, number), 0.2)
    return trials


def _best_of_thesis(works: dict[Combination, Work]) -> Combination:
    """The least mean projections; a failure counts with the work done until the limit."""
    return min(combinations(THESIS), key=lambda c: works[c].projections.mean())


def _gain(
    works: dict[Combination, Work], new: Combination, seed: int
) -> tuple[float, float, float]:
    """How many times the new technique's work the thesis' best takes, with its interval."""
    best = works[_best_of_thesis(works)]
    return ratio_interval(best.projections, works[new].projections, replicates(best.graphs, seed))


def _verdict(found: Results, new: list[Combination], seed: int) -> str:
    winners = []
    for combination in new:
        gains = [
            _gain(works, combination, seed)
            for (family, _), works in found.items()
            if family.endswith("cycle")
        ]
        if all(gain[1] > 1.0 for gain in gains):
            ratios = [gain[0] for gain in gains]
            winners.append(f"{label(combination)} by {min(ratios):.1f} to {max(ratios):.1f} times")
    if not winners:
        none = "None beats the thesis' best technique of every cyclic class at both tolerances."
        return f"{none} {_of_angles(found)}"
    return (
        "On 1-, 2- and n-cycles, at both tolerances, these take less work than the thesis' best "
        f"technique of the same class, chosen afterwards: {', '.join(winners)} (all 95 % intervals "
        f"above 1). {_of_angles(found)}"
    )


def _of_angles(found: Results) -> str:
    """On molecules whose angles are held sweeps of any kind are the wrong choice; say so."""
    works = found.get(("molecules, angles", "1e-6 relative"))
    if works is None:
        return ""
    lost = {c: 100 * work.failures / len(work.sweeps) for c, work in works.items()}
    return (
        "Of molecules with angles held at 1e-6 the thesis' best leaves "
        f"{min(lost[c] for c in combinations(THESIS)):.0f} % unresolved after {LIMIT} sweeps, "
        f"anderson {lost['anderson', 0.5]:.0f} %, blocks {lost['blocks', 0.5]:.0f} %."
    )


def _paragraphs(new: list[Combination]) -> list[str]:
    summaries = {row.name: row.summary for row in pliant.techniques()}
    names = dict.fromkeys(name for name, _ in new)
    return [
        "Work is projections: bars looked at to move them. Looking whether all is whole is not "
        "counted, for any technique; a push that meets the limit of sweeps counts with the work "
        "done until then, which flatters whatever meets it more often. The thesis' best is the one "
        "of its seven orderings and three weightings with the least mean work in that class, so "
        "that every new technique is measured against a choice made with hindsight. "
        + "; ".join(f"{n}: {summaries[n]}" for n in names)
        + ".",
        "What is not in the projections: Anderson acceleration costs about ten scalar products of "
        "the positions a sweep; a Newton iteration solves a system of equations. The last column "
        "of the second table therefore gives time too. blocks holds the pushed joint where it was "
        "pushed to and carries the rest after it, as weighting 1 does on trees; sweeps at 0.5 "
        "meet it half way.",
    ]


def _ratio_table(found: Results, new: list[Combination], seed: int) -> Table:
    table = Table(
        "How many times the work of a new technique the thesis' best takes (95 % of the bootstrap "
        "over graphs); above 1 the new one is better.",
        ["class", "tolerance", "thesis' best", *[label(c) for c in new]],
    )
    for (family, tolerance), works in found.items():
        best = _best_of_thesis(works)
        cells = [with_interval(_gain(works, c, seed)) + _lost(works[c]) for c in new]
        table.rows.append([family, tolerance, label(best) + _lost(works[best]), *cells])
    return table


def _lost(work: Work) -> str:
    return f" ({work.failures} of {len(work.sweeps)} unresolved)" if work.failures else ""


def _work_table(found: Results, seed: int) -> Table:
    table = Table(
        f"The new techniques and the {LISTED} best of the thesis: mean projections and sweeps, "
        "pushes that met the limit, median time; at 0.01 Å (random graphs) or 1e-6 of a bar "
        "(molecules).",
        ["class", "technique", "projections", "sweeps", "met the limit", "µs"],
    )
    for (family, tolerance), works in found.items():
        if (tolerance == "0.01 Å") != family.endswith("cycle"):
            continue
        for combination in _listed(works):
            work = works[combination]
            mean = mean_interval(work.projections, replicates(work.graphs, seed))
            row = [family, label(combination), with_interval(mean), digits(work.sweeps.mean())]
            row += [f"{work.failures} of {len(work.sweeps)}"]
            table.rows.append([*row, digits(1e6 * float(np.median(work.seconds)))])
    return table


def _listed(works: dict[Combination, Work]) -> list[Combination]:
    """All new ones and the best of the thesis, by their work."""

    def effort(combination: Combination) -> float:
        return float(works[combination].projections.mean())

    thesis = sorted(combinations(THESIS), key=effort)[:LISTED]
    new = [combination for combination in works if combination[0] not in THESIS]
    return sorted([*thesis, *new], key=effort)


def _mark_gains(axis: Axes) -> None:
    """Ticks at round numbers, as many as the axis has room for."""
    low, high = axis.get_xlim()
    ticks = [t for t in (0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50) if low <= t <= high]
    axis.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    axis.minorticks_off()


def _draw(found: Results, new: list[Combination], seed: int, out: Path) -> Figure:
    families = list(dict.fromkeys(family for family, _ in found))
    with plotting.figure(1, 2, panel=(5.0, 0.85 * len(families) + 1.2)) as (plot, axes):
        for axis, tolerance in zip(axes[0], SETTINGS, strict=True):
            for place, combination in enumerate(new):
                gains = np.array([_gain(found[f, tolerance], combination, seed) for f in families])
                rows = np.arange(len(families)) + (place - 0.5 * (len(new) - 1)) * 0.8 / len(new)
                errors = (gains[:, 0] - gains[:, 1], gains[:, 2] - gains[:, 0])
                look = {"label": label(combination), "color": COLORS[place % len(COLORS)]}
                fmt, sizes = "os^DvPX*<>"[place % 10], {"markersize": 4.5, "elinewidth": 1.0}
                axis.errorbar(gains[:, 0], rows, xerr=errors, fmt=fmt, capsize=2, **look, **sizes)
            axis.axvline(1.0, color="black", linewidth=0.9)
            axis.set_yticks(range(len(families)), families)
            axis.invert_yaxis()
            axis.set(xscale="log", xlabel="work of the thesis' best / work", title=tolerance)
            _mark_gains(axis)
        axes[0][1].set_yticklabels([])
        plot.legend(*axes[0][0].get_legend_handles_labels(), loc="outside upper center", ncols=4)
        plotting.save(plot, out / "gains.png")
    return Figure(
        out / "gains.png",
        "How many times the work of each new technique the thesis' best technique of that class "
        "takes; right of the line the new one is better. Bars: 95 % of the bootstrap over graphs.",
    )
