# SPDX-License-Identifier: MIT
"""Collective motions: the principal components of the frames."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pliant.base import style
from pliant.base.console import Table
from pliant.measure.collective import collectivity, moving_stretches, participation
from pliant.measure.flexibility import STILL
from pliant.measure.pca import PrincipalComponents
from pliant.measure.stages.analysis import Analysis
from pliant.measure.stages.parts import Measurement, Units
from pliant.report.figures.profile import chain_parts, outline
from pliant.report.section import Columns, Fact, Picture, Values
from pliant.report.sections.headings import COLLECTIVE
from pliant.report.sections.measured import Measured, caption, has
from pliant.report.sections.rmsf import AtomFluctuations
from pliant.trajectory.kind import ENSEMBLE

#: the table of coordinates that the PCA makes may be this large
PCA_BYTES = 1 << 29
#: components whose projections stand in frames.csv
PROJECTIONS = 10


@dataclass(frozen=True)
class Components(Measurement):
    """Principal components of the superposed atoms."""

    measured: PrincipalComponents
    stride: int  #: every so many frames analysed are in the PCA
    units: np.ndarray | None  #: (m,) numbers of the units that its atoms stand for, if one each


def _measure(analysis: Analysis) -> Iterator[Components]:
    """The directions of largest motion, and the units that move along them."""
    stride, known = _stride(analysis), analysis.get(AtomFluctuations)
    weighted = analysis.options.mass_weighted
    may_share = not weighted and stride == 1 and analysis.around_start is None
    measured = PrincipalComponents(
        analysis.fitted,
        mass_weighted=weighted,
        average=known.found.fitted_average if may_share and known else None,
        in_memory=False,
    )
    if len(analysis.run(measured, stride).eigenvalues) == 0:
        raise ValueError("the atoms do not move")
    thinned = (f"PCA uses every {stride}th frame, to fit into memory",) if stride > 1 else ()
    units = analysis[Units].of_atoms(analysis.fitted.ix)
    yield Components(measured, stride, units, notes=thinned)


def _stride(analysis: Analysis) -> int:
    """Every so many frames fit into memory; ValueError where that is none, or nothing moves."""
    if len(analysis.frames) < 3:
        raise ValueError("it needs at least 3 frames")
    found = analysis.get(AtomFluctuations)
    if found is not None:
        fitted = np.isin(analysis.atoms.ix, analysis.fitted.ix)
        if np.all(found.found.rmsf[fitted] < STILL):
            raise ValueError("nothing moves")
    stride = -(-24 * len(analysis.fitted) * len(analysis.frames) // PCA_BYTES)
    if len(analysis.frames) < 3 * stride:
        raise ValueError("too many atoms: choose fewer with --superpose")
    return stride


def _values(analysis: Analysis) -> Values:
    found = analysis[Components].found
    values = {"pca_explained": found.explained[:10].tolist()}
    if len(found.cosine_content):
        values["pca_cosine_content"] = found.cosine_content.tolist()
    return values


def _facts(analysis: Analysis) -> Iterator[Fact]:
    share = 100 * analysis[Components].found.explained[0]
    yield Fact(f"{share:.0f}", "%", "of the motion along one direction (PC1)")


def _per_component(analysis: Analysis) -> Columns:
    found = analysis[Components].found
    count, cosine = len(found.eigenvalues), found.cosine_content.tolist()
    unit = "u_angstrom2" if analysis.options.mass_weighted else "angstrom2"
    return {
        "component": np.arange(1, count + 1),
        f"eigenvalue_{unit}": found.eigenvalues,
        "explained": found.explained,
        "cumulative": np.cumsum(found.explained),
        "cosine_content": [*cosine, *(count - len(cosine)) * [""]],
    }


def _per_frame(analysis: Analysis) -> Columns:
    part = analysis[Components]
    if part.stride > 1:
        return {}
    projections = part.found.projections
    unit = "sqrt_u_angstrom" if analysis.options.mass_weighted else "angstrom"
    count = min(PROJECTIONS, projections.shape[1])
    return {f"pc{k + 1}_{unit}": projections[:, k] for k in range(count)}


def _tables(analysis: Analysis) -> Iterator[Table]:
    found = analysis[Components].found
    share, spread = participation(found.components[:5]), collectivity(found.components[:5])
    columns = ("", "share", "cosine content", "collectivity", "moves most")
    table = Table("Principal components", columns)
    for k, part in enumerate(found.explained[:5]):
        cosine = f"{found.cosine_content[k]:.2f}" if k < len(found.cosine_content) else "–"
        moves = _moves(analysis, share[k])
        row = (f"PC{k + 1}", f"{100 * part:.1f} %", cosine, f"{spread[k]:.2f}", moves)
        table.rows.append(row)
    yield table


def _moves(analysis: Analysis, share: np.ndarray) -> str:
    """Which stretches a component moves most, in words."""
    units, moved = analysis[Units], analysis[Components].units
    if moved is None:
        return "–"
    labels = [units.labels[k] for k in moved]
    if units.what == "atom":
        return ", ".join(labels[k] for k in np.argsort(-share, kind="stable")[:3])
    return ", ".join(
        labels[a] if a == b else f"{labels[a]} to {labels[b]}"
        for a, b, _ in moving_stretches(share, units.chains[moved])
    )


def _draw_motions(analysis: Analysis) -> Figure:
    """How far each of the first three components moves each unit."""
    found, units = analysis[Components].found, analysis[Units]
    count, moved = min(3, len(found.eigenvalues)), analysis[Components].units
    chains = units.chains[moved]
    figure, axes = style.new_figure(
        (style.WIDE[0], 0.6 + 1.15 * count), count, 1, sharex=True, squeeze=False
    )
    for k, row in enumerate(axes[:, 0]):
        share = participation(found.components[k : k + 1])[0]
        height = np.sqrt(share * found.eigenvalues[k])
        for part in chain_parts(chains):
            place, heights = outline(np.arange(len(height))[part], height[part])
            row.fill_between(place, heights, color=style.FAINT, lw=0)
            row.plot(place, heights, color=style.BLUE, lw=1.2)
        row.set_ylabel(f"PC{k + 1} (Å)")
        row.set_ylim(bottom=0)
        text = f"{100 * found.explained[k]:.0f} % of the motion"
        corner = {"ha": "right", "va": "top", "transform": row.transAxes}
        row.text(0.995, 0.93, text, color=style.INK, fontsize=8.5, **corner)
    style.chain_axis(axes[-1, 0], units.numbers[moved], chains)
    axes[0, 0].set_title("Collective motions: what each moves")
    return figure


def _draw_components(analysis: Analysis) -> Figure:
    """The frames along the first two components, and how much each component explains."""
    found = analysis[Components].found
    explained = 100 * found.explained[:10]
    figure, (plane, scree) = style.new_figure((style.WIDE[0], 3.1), 1, 2, width_ratios=[1.3, 1])
    style.pad(figure, 0.1)
    _draw_plane(plane, analysis)
    shares = [f"PC{k + 1} (Å), {share:.0f} %" for k, share in enumerate(explained[:2])]
    plane.set(xlabel=shares[0], ylabel=shares[1] if len(shares) > 1 else "")
    plane.set_aspect("equal", adjustable="datalim")
    numbers = np.arange(1, len(explained) + 1)
    scree.bar(numbers, explained, color=style.BLUE, width=0.7, label="each")
    scree.plot(
        numbers, np.cumsum(explained), color=style.ORANGE, marker="o", ms=4, label="together"
    )
    scree.set(xlabel="component", ylabel="share of the variance (%)", title="Scree")
    scree.set_ylim(0, 104)
    scree.set_xticks(numbers)
    scree.grid(False, axis="x")
    scree.legend(loc="center right")
    return figure


def _draw_plane(plane: Axes, analysis: Analysis) -> None:
    """Frames along two components: dots, in no order, or a path from start to end."""
    part, (x, label) = analysis[Components], analysis.axis
    first = part.found.projections[:, 0]
    one_only = part.found.projections.shape[1] < 2
    second = np.zeros_like(first) if one_only else part.found.projections[:, 1]
    dots: dict[str, Any] = {"s": style.mark_size(len(first)), "linewidths": 0}
    if analysis.kind == ENSEMBLE:
        plane.scatter(first, second, color=style.BLUE, alpha=0.6, **dots)
        plane.set_title("Frames in PCA")
        return
    plane.plot(first, second, color=style.GREY, alpha=0.45, lw=0.7, zorder=1)
    drawn = plane.scatter(first, second, c=x[:: part.stride], cmap=style.MAP, zorder=2, **dots)
    ring: dict[str, Any] = {
        "s": 70,
        "facecolors": "none",
        "edgecolors": style.INK,
        "linewidths": 1.1,
    }
    plane.scatter(first[:1], second[:1], label="start", zorder=3, **ring)
    plane.legend(loc="lower right", bbox_to_anchor=(1, 1.01), handletextpad=0.2)
    plane.set_title("Path in PCA")
    style.colour_bar(plane, drawn, label)


COMPONENTS = Measured(
    stage="PCA",
    measure=_measure,
    heading=COLLECTIVE,
    applies=has(Components),
    values=_values,
    facts=_facts,
    tables=_tables,
    columns={"pca": _per_component},
    per_frame=_per_frame,
    pictures=[
        Picture(
            "motions",
            _draw_motions,
            caption(
                "How far (one standard deviation) each of the three largest motions moves each "
                "residue.",
                path="Components of a random path look like slow waves: see the cosine content.",
            ),
            suits=lambda analysis: (
                analysis[Components].units is not None and analysis[Units].what == "residue"
            ),
        ),
        Picture(
            "pca",
            _draw_components,
            caption(
                "The frames along the two directions of largest motion, and how much of the "
                "motion each direction explains.",
                path="Dark to light as the run goes.",
                ensemble="Frames are independent: their even spread was an input, and says "
                "nothing about free energy.",
            ),
        ),
    ],
    methods={
        "Collectivity": (
            "exp of the entropy of the residues' shares, over their number (Brueschweiler 1995): 1 "
            "if all move equally."
        ),
        "PCA": (
            "Eigenvectors of the covariance of the superposed coordinates. A cosine content near 1 "
            "says that the motion along a component looks like a random walk: the run is too short "
            "to have visited its states repeatedly."
        ),
    },
)
