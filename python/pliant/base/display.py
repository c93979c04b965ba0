# SPDX-License-Identifier: MIT
"""How objects show themselves: ``_repr_html_`` in notebooks, ``str`` where they are printed."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable
from typing import Any

import numpy as np

from pliant import _core

#: what is shown of an object: (what it is, its value as text)
Facts = list[tuple[str, str]]

TABLE = '<table class="pliant" style="text-align: left"><caption><b>{}</b></caption>{}</table>'
ROW = (
    '<tr><td style="text-align: left">{}</td>'
    '<td style="text-align: left; white-space: pre-wrap">{}</td></tr>'
)


_ESCAPES = str.maketrans({"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#x27;"})


def as_html(title: str, facts: Iterable[tuple[str, str]]) -> str:
    """The facts as a table; text is escaped."""
    rows = "".join(ROW.format(_escaped(what), _escaped(value)) for what, value in facts)
    return TABLE.format(_escaped(title), rows)


def _escaped(text: str) -> str:
    """As html.escape, which is slow to import: it knows 2231 names of characters."""
    return text.translate(_ESCAPES)


def as_text(title: str, facts: Iterable[tuple[str, str]]) -> str:
    """The facts as lines, what they are in a column."""
    rows = list(facts)
    width = max((len(what) for what, _ in rows), default=0)
    return "\n".join([title, *(f"  {what:<{width}}  {value}" for what, value in rows)])


class Displayed:
    """A report that shows itself by its `facts`."""

    def facts(self) -> Facts:
        """What it comes down to: (what, value)."""
        raise NotImplementedError

    def _repr_html_(self) -> str:
        return as_html(f"pliant.{type(self).__name__}", self.facts())

    def __str__(self) -> str:
        return as_text(f"pliant.{type(self).__name__}", self.facts())


def _counted(names: np.ndarray) -> str:
    return ", ".join(f"{name} {count}" for name, count in Counter(names.tolist()).most_common())


def _structure(shown: _core.Structure) -> Facts:
    chains = [name for name in dict.fromkeys(shown.chains.tolist()) if name]
    residues = f"{shown.residue_count}" + (f", chains {', '.join(chains)}" if chains else "")
    orders = _counted(shown.bond_origins)
    facts = [
        ("file", shown.source),
        ("title", shown.title),
        ("atoms", f"{len(shown)}: {_counted(shown.symbols)}" if len(shown) else "0"),
        ("residues", residues),
        ("bonds", f"{len(shown.bonds)}" + (f", known from: {orders}" if orders else "")),
    ]
    return [(what, value) for what, value in facts if value]


def _framework(shown: _core.Framework) -> Facts:
    graph = shown.graph_facts()
    return [
        ("joints", f"{shown.joint_count}, {len(shown.pinned)} pinned"),
        ("bars", f"{shown.bar_count}"),
        ("limits", f"{len(shown.limits)}"),
        ("sterics", "yes" if shown.has_sterics else "no"),
        ("components", f"{graph.components}"),
        ("independent cycles", f"{graph.cycles}"),
        ("bridges", f"{graph.bridges} bars on no cycle"),
        ("blocks", f"{graph.blocks} ring systems, {graph.largest_block} bars in the largest"),
    ]


def _graph_facts(shown: _core.GraphFacts) -> Facts:
    names = ("joints", "bars", "components", "cycles", "bridges", "blocks", "largest_block")
    return [(name.replace("_", " "), str(getattr(shown, name))) for name in names]


def _residual_summary(shown: _core.ResidualSummary) -> Facts:
    return [
        ("within the tolerance", "yes" if shown.within else "no"),
        ("worst bar", f"off by {shown.max_relative:.2g} of its length, bar {shown.worst_bar}"),
        ("r.m.s.", f"{shown.rms_relative:.2g} of a length"),
        ("worst limit", f"off by {shown.max_limit:.2g} Å"),
        ("worst overlap", f"{shown.max_overlap:.2g} Å"),
    ]


def _resolve_summary(shown: _core.ResolveSummary) -> Facts:
    return [
        ("ended as", shown.stop.name),
        ("sweeps", f"{shown.sweeps}"),
        ("bars looked at", f"{shown.projections}"),
        ("worst bar", f"off by {shown.max_residual:.2g} of its length, bar {shown.worst_bar}"),
        ("time", f"{shown.seconds:.2g} s"),
    ]


def _run_summary(shown: _core.RunSummary) -> Facts:
    late = shown.unconverged_steps
    missed = f"{late}, the first is step {shown.first_unconverged_step}" if late else "0"
    return [
        ("steps", f"{shown.steps}, {shown.frames} frames shown or recorded"),
        ("not converged", missed),
        ("sweeps per step", f"{shown.mean_sweeps:.3g}, {shown.max_sweeps} at most"),
        ("bars looked at", f"{shown.projections}"),
        ("worst bar", f"off by {shown.worst_residual:.2g} of its length, bar {shown.worst_bar}"),
        ("time", f"{shown.seconds:.2g} s, resolving {shown.resolve_seconds:.2g} s"),
    ]


def _sample_summary(shown: _core.SampleSummary | _core.SampledFrames) -> Facts:
    mean = float(np.mean(shown.rmsf)) if len(shown.rmsf) else 0.0
    return [
        ("RMSF", f"{mean:.2f} Å, mean over atoms"),
        ("amplitude", f"{shown.amplitude_reached:.2f} Å reached: an input, not a prediction"),
        ("drawn again", f"{shown.redrawn} frames; {shown.failed} failed"),
        ("worst bar", f"off by {shown.max_residual:.2g} of its length"),
        ("worst contact", f"off by {shown.max_limit:.2g} Å"),
        ("worst overlap", f"{shown.max_overlap:.2g} Å"),
    ]


def _ensemble(shown: _core.SampledFrames) -> Facts:
    frames, atoms, _ = shown.positions.shape
    return [("frames", f"{frames}, of {atoms} atoms"), *_sample_summary(shown)]


def _summary_of_frames(shown: _core.SampleSummary) -> Facts:
    return [("frames", f"{shown.frames}"), *_sample_summary(shown)]


def _model(shown: _core.MolecularModel) -> Facts:
    framework = shown.framework
    kinds = _counted(shown.contacts["kind"])
    return [
        ("model", shown.kind),
        ("atoms", f"{framework.joint_count}"),
        ("bars", f"{framework.bar_count}"),
        ("contacts", f"{len(shown.contacts)}" + (f": {kinds}" if kinds else "")),
        *(("done", line) for line in shown.notes),
        *(("missing", line) for line in shown.missing),
    ]


def _rigidity(shown: _core.Rigidity) -> Facts:
    sizes = shown.cluster_sizes
    return [
        ("atoms", f"{len(shown.cluster)}"),
        ("internal degrees of freedom", f"{shown.degrees_of_freedom}"),
        ("bonds that may turn", f"{shown.hinges}, {shown.flexible_bonds} flexible"),
        ("bars", f"{shown.bars}, {shown.redundant} redundant"),
        (
            "rigid clusters",
            f"{shown.rigid_clusters} of 3 atoms or more; {sizes[:1].sum()} in the largest",
        ),
        ("small pieces", f"{shown.small_pieces} of one or two atoms"),
    ]


#: how each kind of object is shown
SHOWN: dict[type, Callable[[Any], Facts]] = {
    _core.Structure: _structure,
    _core.Framework: _framework,
    _core.GraphFacts: _graph_facts,
    _core.ResidualSummary: _residual_summary,
    _core.ResolveSummary: _resolve_summary,
    _core.RunSummary: _run_summary,
    _core.SampleSummary: _summary_of_frames,
    _core.SampledFrames: _ensemble,
    _core.MolecularModel: _model,
    _core.Rigidity: _rigidity,
}


def _attach(kind: type, facts: Callable[[Any], Facts]) -> None:
    for name, make in (("_repr_html_", as_html), ("__str__", as_text)):

        def show(self: Any, make: Callable[[str, Facts], str] = make) -> str:
            return make(f"pliant.{type(self).__name__}", facts(self))

        setattr(kind, name, show)


def show_in_notebooks() -> None:
    """Gives the objects of the compiled part their tables."""
    for kind, facts in SHOWN.items():
        _attach(kind, facts)
