# SPDX-License-Identifier: MIT
"""What the sections of the report say: the claims table, each claim, how it was measured."""

from __future__ import annotations

import dataclasses
from html import escape
from typing import Any

import numpy as np

from pliant.lab.experiment import document
from pliant.lab.experiment.contradictions import CONTRADICTIONS
from pliant.lab.experiment.document import Figure, Table
from pliant.lab.experiment.heat_maps import WORDS
from pliant.lab.experiment.settled import NEARLY_ALL, Settled, settings_text
from pliant.lab.experiment.statistics import REPLICATES, between
from pliant.lab.experiment.sweep import GRAPHS, PUSHES, SWEEP_CSV, THESIS_FAMILIES, Point
from pliant.lab.experiment.table import Table as Rows
from pliant.lab.experiment.verdict import CONFIDENCE, FAILS, HOLDS, OPEN, Verdict


def subtitle(table: Rows) -> str:
    """The experiment in one line."""
    made = table.settings
    return (
        f"{len(table)} resolves: {len(made.classes)} classes of graphs, {made.graphs} graphs a "
        f"class, {made.forces} forces a graph, {len(made.techniques)} techniques; seed "
        f"{made.seed}"
    )


def summary(settled: list[Settled], swept: bool) -> str:
    """How many claims hold, and the table of all."""
    words = [one.word for one in settled]
    verbs = {"holds": "hold", "depends": "depend", "fails": "fail"}
    verbs |= {"open": "are open", "untested": "are untested"}
    counts = ", ".join(f"{words.count(w)} {verb}" for w, verb in verbs.items() if w in words)
    text = f"Of {len(settled)} claims of chapter 5: {counts}."
    return document.block(
        document.paragraph(text), document.table(claims_table(settled, swept), "claims")
    )


def cannot_judge(settled: list[Settled], points: list[Point], quick: bool) -> str:
    """What a quick report, or one on a quick sweep, does not know; "" of a full one."""
    left_open = [one.claim.id for one in settled if one.word == OPEN]
    texts = []
    if left_open:
        texts.append(
            f"This report cannot judge {', '.join(left_open)}: they hold or fail in the table of "
            f"this experiment, but the sweep, which must confirm that, {_sweep_size(points)}. A "
            f"verdict takes {GRAPHS} graphs of each family and {PUSHES} forces a graph: remove "
            f"{SWEEP_CSV} and make the report without --quick."
        )
    if quick:
        texts.append(
            "It was asked to be quick: its open questions are answered on fewer and "
            "smaller graphs. It is for a look, not to be cited."
        )
    return document.block(*map(document.paragraph, texts)) if texts else ""


def _sweep_size(points: list[Point]) -> str:
    """ "has 4 graphs of each of 3 families and 5 forces a graph", from the points themselves."""
    graphs, pushes = ({getattr(point, name) for point in points} for name in ("graphs", "pushes"))
    if 0 in graphs | pushes:
        return "does not say how many graphs and forces it has"
    return (
        f"has {between(graphs)} graphs of each of {len(THESIS_FAMILIES)} families and "
        f"{between(pushes)} forces a graph"
    )


def claims_table(settled: list[Settled], swept: bool) -> Table:
    """One row a claim."""
    header = ["id", "the thesis claims", "verdict", "depends on, or note", "our numbers"]
    header += ["sweeps", "passes", "work"] + ["settings"] * swept
    made = Table("", header)
    for one in settled:
        claim = one.claim
        found = one.by_yardstick
        row = [claim.id, f"{', '.join(claim.families)}: {claim.text}", one.word, one.on_what or "–"]
        row += [headline(one), *(found[name].word if name in found else "–" for name in WORDS)]
        made.rows.append([*row, *([settings_text(one)] if swept else [])])
    return made


def headline(one: Settled) -> str:
    """The first statement on each family of graphs, in sweeps and, where it differs, in passes."""
    texts = []
    for name in ("sweeps", "passes"):
        seen = set()
        for statement in one.by_yardstick[name].statements if name in one.by_yardstick else []:
            if statement.tags["class"] not in seen:
                seen.add(statement.tags["class"])
                unit = "in passes, " if name == "passes" else ""
                texts.append(f"{unit}{statement.text}: {statement.numbers}")
    return ". ".join(texts)


def each_claim(settled: list[Settled], maps: dict[str, Figure]) -> str:
    """A card a claim: verdict, what stands for its words, every statement, its heat map."""
    return "\n".join(_one_claim(one, maps.get(one.claim.id)) for one in settled)


def _one_claim(one: Settled, heat_map: Figure | None) -> str:
    claim = one.claim
    title = escape(f"{claim.id} · {claim.text}")
    parts = [
        f"<h3>{title} {document.badge(one.word)}</h3>",
        document.paragraph(
            f"Thesis, section {claim.section}; {', '.join(claim.families)}."
            + (f" Judged as: {claim.measured_as}." if claim.measured_as else "")
        ),
    ]
    if one.on_what:
        parts.append(document.paragraph(f"{one.word.capitalize()}: {one.on_what}."))
    if claim.contradiction:
        parts.append(document.paragraph(f"The thesis itself: {claim.contradiction}"))
    if one.settings:
        parts.append(document.paragraph(_in_sweep(one)))
    count = len(one.here.statements)
    parts.append(document.fold(f"Its {count} statements", document.table(_statements(one.here))))
    if heat_map is not None:
        parts.append(document.figures([heat_map], wide=True))
    return document.block(*parts)


def _in_sweep(one: Settled) -> str:
    return f"Settings of the sweep in which every statement holds: {settings_text(one)}."


def _statements(verdict: Verdict) -> Table:
    made = Table("", ["counted in", "statement", "numbers [95 %]", "verdict", "replicates"])
    for statement in verdict.statements:
        row = [WORDS[statement.tags["yardstick"]], statement.text, statement.numbers]
        made.rows.append([*row, statement.verdict, f"{100 * statement.share:.0f} %"])
    return made


def method(table: Rows, points: list[Point], replicates: int = REPLICATES) -> str:
    """How the numbers are to be read."""
    made = table.settings
    broken = int(np.sum(table.columns["sweeps"] == 0))
    stuck = int(np.sum(~table.columns["converged"]))
    start = (
        "each on one joint of the graph at rest"
        if not made.consecutive
        else "each where the last one led"
    )
    texts = [
        f"Each graph gets {made.forces} forces, {start}; a force of {made.force:g} kJ/(mol Å) "
        f"moves its joint (1 u) by {made.push_length:g} Å in one Verlet step of "
        f"{made.timestep:g} ps. A bar is whole within {made.tolerance_length:g} Å. The thesis "
        "gives none of these numbers.",
        "Yardsticks: a sweep is one direction of an ordering, as the thesis counts for all but the "
        "reverse techniques; a pass is there and back for those; work is bars looked at "
        "(projections).",
        f"Statistics are over the pushes that broke a bar: {broken} of {len(table)} resolves had "
        f"nothing to do and are left out. {stuck} met the limit of {made.max_sweeps} sweeps, and "
        "count as that.",
        f"Intervals are 95 % of {replicates} bootstrap replicates, in which whole graphs are drawn "
        f"with replacement. A statement holds or fails if {CONFIDENCE:.0%} of the replicates say "
        "what the sample says, else it is open. A claim holds if all its statements do, fails if "
        "none does and one fails, and else depends; over the sweep, one that holds must hold in "
        f"{NEARLY_ALL:.0%} of the settings, one that fails in at most {1 - NEARLY_ALL:.0%}.",
    ]
    if points:
        texts.append(_sweep_text(points))
    return document.block(*map(document.paragraph, texts))


def _sweep_text(points: list[Point]) -> str:
    names = ("tolerance_length", "force", "size", "box", "consecutive")
    settings = len({tuple(getattr(point, name) for name in names) for point in points})
    return (
        f"The sweep of {settings} settings {_sweep_size(points)}. It varies "
        "tolerance with the length of the push, the size of graphs (from mostly "
        "cycle to mostly tree), the box, pushes from rest or in turn, and pushes in "
        "turn on small graphs such as the thesis draws. Lengths scale: only push and "
        "tolerance over the lengths of bars matter, so the box is another view on both."
    )


def contradictions() -> str:
    """Where the thesis contradicts itself."""
    made = Table("", ["where", "it says", "and also"], [list(row) for row in CONTRADICTIONS])
    text = "No experiment can agree with all of the following."
    return document.block(document.paragraph(text), document.table(made, "claims"))


def settings(table: Rows) -> str:
    """Every option."""
    values = dataclasses.asdict(table.settings)
    made = Table("", ["option", "value"])
    for name, value in values.items():
        made.rows.append([name, ", ".join(map(str, value)) if isinstance(value, tuple) else value])
    return document.block(document.table(made))


def as_json(settled: list[Settled]) -> list[dict[str, Any]]:
    """The claims table for programs."""
    return [_claim_json(one) for one in settled]


def _claim_json(one: Settled) -> dict[str, Any]:
    found = [(s, s.tags["yardstick"]) for s in one.here.statements]
    made: dict[str, Any] = {"id": one.claim.id, "claim": one.claim.text, "verdict": one.word}
    made |= {"depends_on": one.on_what, "settings_held": one.held_by, "settings": one.settings}
    made |= {word: sum(s.verdict == word for s, _ in found) for word in (HOLDS, FAILS)}
    keys = ("text", "yardstick", "numbers", "verdict", "share")
    rows = [(s.text, yardstick, s.numbers, s.verdict, s.share) for s, yardstick in found]
    return made | {"statements": [dict(zip(keys, row, strict=True)) for row in rows]}
