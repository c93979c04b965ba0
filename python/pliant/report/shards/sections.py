# SPDX-License-Identifier: MIT
"""The sections of the report of an ensemble in many files."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from pliant.base import style
from pliant.base.console import counted
from pliant.measure.flexibility import STILL, precision
from pliant.report.figures.profile import NAMED_BARS, draw_profile
from pliant.report.multi_model import write_models
from pliant.report.section import Columns, Picture, Section
from pliant.shards.flexibility import EnsembleFlexibility
from pliant.trajectory.superposition import superpose_onto

#: what the report of one file has, and this one has not
LEFT_OUT = (
    "torsions, stereochemistry, domains, shapes and the page: pliant analyse of a shard's file "
    "has them for its frames"
)

SIZE = (9, 3.2)  #: of the figure, inches; the legend stands beside the lines

Lines = Iterator[tuple[str, str]]


def _frames(found: EnsembleFlexibility) -> Lines:
    walkers = f"of {counted(found.walkers, 'walker')}"
    source = walkers if found.what == "walkers" else "independent of each other"
    yield "frames", f"{found.frames}, {source}"
    if found.near < found.frames:
        yield "", f"flexibility is that of the {found.near} around the start"


def _flexibility(found: EnsembleFlexibility) -> Lines:
    units = counted(len(found.units.labels), found.units.what)
    if found.still:
        yield "flexibility", f"nothing moves: RMSF of all {units} is below {STILL:g} Angstrom"
        return
    mean = f"{found.rmsf.mean():.3f} Angstrom, mean RMSF of {units}"
    yield "flexibility", f"{mean}; {precision(found.rmsf, found.error)}"
    if found.amplitude is not None:
        asked = f"asked {found.amplitude:.2f} Angstrom"
        what = "how far all moves is an input, which parts move more than others is a result"
        yield "amplitude", f"{asked}: {what}"
    alike = "" if np.isnan(found.correlation) else f"correlates at {found.correlation:.3f}, "
    yield "two halves", f"RMSF {alike}differs by {_apart(found.halves):.3f} Angstrom at most"


def _apart(halves: np.ndarray) -> float:
    return float(np.abs(np.diff(halves, axis=0)).max())


def flexibility_figure(found: EnsembleFlexibility) -> Figure:
    """RMSF of each unit with twice its error, and of both halves."""
    what, units = found.what, found.units
    figure, axes = style.new_figure(SIZE)
    names = (
        f"all {found.walkers} {what}",
        f"even-numbered {what}",
        f"odd-numbered {what}",
        f"2 standard errors, between {what}",
    )
    draw_profile(axes, units.chains, found.rmsf, found.error, found.halves, names)
    if len(units.labels) <= NAMED_BARS:
        style.named_axis(axes, units.labels)
        axes.set_xlabel(units.what)
    else:
        style.chain_axis(axes, units.numbers, units.chains, units.what)
    axes.set_ylabel("RMSF (Å)")
    axes.set_ylim(0, 1.04 * float((found.rmsf + 2 * found.error).max()) or 1.0)
    axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0))
    if found.still:
        axes.set_title("Nothing moves")
    return figure


def _shares(found: EnsembleFlexibility) -> np.ndarray:
    return found.variances / found.total_variance if found.total_variance > 0 else np.empty(0)


def _modes(found: EnsembleFlexibility) -> Lines:
    if found.still:
        return
    if found.why_no_modes:
        yield "modes", f"left out: {found.why_no_modes}"
    else:
        share = f"ten hold {_shares(found).sum():.0%} of the variance"
        yield "modes", f"{share}; RMSIP of the halves {found.rmsip:.3f}"


def _mode_columns(found: EnsembleFlexibility) -> Columns:
    """One row for each unit in each mode; none without modes."""
    count, units = len(found.variances), found.units
    if count == 0:
        return {}
    columns: Columns = {
        "mode": np.repeat(np.arange(1, count + 1), len(units.labels)),
        "variance_angstrom2": np.repeat(found.variances, len(units.labels)),
        units.what: count * list(units.labels),
    }
    return columns | dict(zip("xyz", found.modes.T.reshape(-1, 3).T, strict=True))


def _contact_columns(found: EnsembleFlexibility) -> Columns:
    names = ("contact", "kind", "share_held")
    return dict(zip(names, zip(*found.contacts, strict=True), strict=False))  # {} without any


def _clusters(found: EnsembleFlexibility) -> Lines:
    shares = found.clusters.shares
    largest = f"the largest has {shares[0]:.0%} of the frames"
    apart = f"the halves differ by {_apart(found.clusters.halves):.0%} at most"
    alike = "1: all frames have one shape"
    yield "clusters", alike if found.still else f"{len(shares)}; {largest}, {apart}"


def _cluster_columns(found: EnsembleFlexibility) -> Columns:
    chosen, what = found.clusters, found.what
    own = ("walker", "step") if what == "walkers" else ("step",)
    return {
        "cluster": np.arange(1, len(chosen.frames) + 1),
        "frame": chosen.frames,
        **{name: [record[name] for record in chosen.records] for name in own},
        "share_of_frames": chosen.shares,
        "standard_error": chosen.errors,
        f"share_even_{what}": chosen.halves[0],
        f"share_odd_{what}": chosen.halves[1],
        "mean_rmsd_angstrom": chosen.distances,
    }


def _representatives(found: EnsembleFlexibility, folder: Path) -> list[Path]:
    """The frame of each cluster as a model, superposed on the first."""
    chosen = found.clusters
    moved = superpose_onto(chosen.positions, slice(None), chosen.positions[0])
    remarks = ["each stands for the frames nearest to it; populations are not claimed"]
    remarks += [f"model {k + 1}: frame {frame}" for k, frame in enumerate(chosen.frames)]
    path = folder / "representatives.pdb"
    write_models(path, found.atoms, moved, np.zeros(len(found.atoms)), remarks)
    return [path]


def _bars(found: EnsembleFlexibility) -> Lines:
    yield "worst residual", f"{found.max_residual:.2e} of the bar's length"
    yield "left out", LEFT_OUT


SECTIONS = (
    Section(
        lines=_frames,
        values=lambda found: {
            "frames": found.frames,
            "flexibility_frames": found.near,
            "walkers": found.walkers if found.what == "walkers" else None,
            "unit": found.units.what,
            "units": len(found.units.labels),
        },
    ),
    Section(
        lines=_flexibility,
        values=lambda found: {
            "nothing_moves": found.still,
            "amplitude_asked": found.amplitude,
            "flexibility_mean": float(found.rmsf.mean()),
            "flexibility_error_mean": float(found.error.mean()),
            "halves_correlation": found.correlation,
            "halves_difference_max": _apart(found.halves),
        },
        pictures=[Picture("flexibility", flexibility_figure)],
        columns={
            "flexibility": lambda found: {
                found.units.what: found.units.labels,
                "rmsf_angstrom": found.rmsf,
                "standard_error": found.error,
                f"rmsf_even_{found.what}": found.halves[0],
                f"rmsf_odd_{found.what}": found.halves[1],
            }
        },
    ),
    Section(
        lines=_modes,
        values=lambda found: {
            "halves_rmsip": found.rmsip,
            "variance_shares": _shares(found),
            "modes": found.why_no_modes or None,
        },
        columns={"modes": _mode_columns},
    ),
    Section(
        values=lambda found: {"contacts": len(found.contacts)},
        columns={"contacts": _contact_columns},
    ),
    Section(
        lines=_clusters,
        values=lambda found: {
            "cluster_shares": found.clusters.shares,
            "cluster_errors": found.clusters.errors,
            "cluster_halves_difference_max": _apart(found.clusters.halves),
            "cluster_frames": found.clusters.frames,
        },
        columns={"clusters": _cluster_columns},
        files=_representatives,
    ),
    Section(
        lines=_bars, values=lambda found: {"max_residual": found.max_residual, "left_out": LEFT_OUT}
    ),
)
