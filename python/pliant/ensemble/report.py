# SPDX-License-Identifier: MIT
"""``pliant analyse DIR``: what the shards of an ensemble tell, as tables, a figure and numbers."""

from __future__ import annotations

import csv
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from pliant._csv_cells import harmless
from pliant.ensemble.clusters import Clusters
from pliant.ensemble.flexibility import MOST_FOR_MODES, Flexibility, flexibility
from pliant.ensemble.sums import superposed

#: What the report of one file has, and this one has not.
LEFT_OUT = (
    "torsions, stereochemistry, domains and the page: pliant analyse of a shard's file "
    "has them for its walkers"
)


def report_ensemble(
    folder: Path,
    output: Path,
    workers: int = 1,
    dpi: int = 150,
    on_stage: Callable[[str], None] = lambda name: None,
) -> dict[str, Any]:
    """Analyses an ensemble and writes the results into `output`; returns them for ``--json``."""
    found = flexibility(folder, workers, on_stage)
    output.mkdir(parents=True, exist_ok=True)
    tables = [_write_flexibility(found, output)]
    if len(found.variances):
        tables.append(_write_modes(found, output))
    if found.contacts:
        tables.append(_write_contacts(found, output))
    tables.append(_write_clusters(found.clusters, output))
    models = _write_representatives(found, output)
    on_stage("figure")
    figure = _draw(found, output / "flexibility.png", dpi)
    outputs = {
        "tables": [str(path) for path in tables],
        "figures": [str(figure)],
        "models": [str(models)],
    }
    return {**_numbers(folder, found), "outputs": outputs, "left_out": LEFT_OUT}


def _numbers(folder: Path, found: Flexibility) -> dict[str, Any]:
    share = found.variances / found.total_variance if found.total_variance > 0 else np.empty(0)
    return {
        "ensemble": str(folder),
        "frames": found.frames,
        "walkers": found.walkers,
        "unit": found.unit,
        "units": len(found.labels),
        "flexibility_mean": float(found.rmsf.mean()),
        "flexibility_error_mean": float(found.error.mean()),
        "halves_correlation": found.correlation,
        "halves_difference_max": float(np.abs(found.halves[0] - found.halves[1]).max()),
        "halves_rmsip": found.rmsip,
        "variance_shares": share,
        "modes": None if len(found.variances) else f"more than {MOST_FOR_MODES} units",
        "max_residual": found.max_residual,
        "contacts": len(found.contacts),
        "cluster_shares": found.clusters.shares,
        "cluster_errors": found.clusters.errors,
        "cluster_halves_difference_max": float(
            np.abs(np.diff(found.clusters.halves, axis=0)).max()
        ),
        "cluster_frames": found.clusters.frames,
    }


def _write_flexibility(found: Flexibility, folder: Path) -> Path:
    rows = zip(found.labels, found.rmsf, found.error, *found.halves, strict=True)
    head = [found.unit, "rmsf_angstrom", "standard_error", "rmsf_even_walkers", "rmsf_odd_walkers"]
    return _write(folder / "flexibility.csv", head, rows)


def _write_modes(found: Flexibility, folder: Path) -> Path:
    count = len(found.variances)
    parts = found.modes.T.reshape(count, -1, 3)
    rows = (
        (k + 1, found.variances[k], label, *parts[k, unit])
        for k in range(count)
        for unit, label in enumerate(found.labels)
    )
    head = ["mode", "variance_angstrom2", found.unit, "x", "y", "z"]
    return _write(folder / "modes.csv", head, rows)


def _write_contacts(found: Flexibility, folder: Path) -> Path:
    return _write(folder / "contacts.csv", ["contact", "kind", "share_held"], found.contacts)


def _write_clusters(found: Clusters, folder: Path) -> Path:
    rows = (
        (k + 1, int(frame), told.get("walker", told["step"]), told["step"], *numbers)
        for k, (frame, told, *numbers) in enumerate(
            zip(found.frames, found.told, found.shares, found.errors, *found.halves,
                found.distances, strict=True)
        )
    )  # fmt: skip
    head = ["cluster", "frame", "walker", "step", "share_of_frames", "standard_error",
            "share_even_walkers", "share_odd_walkers", "mean_rmsd_angstrom"]  # fmt: skip
    return _write(folder / "clusters.csv", head, rows)


def _write_representatives(found: Flexibility, folder: Path) -> Path:
    """The frame of each cluster as a model, superposed on the first."""
    from pliant.analyse.multi_model import write_models

    chosen = found.clusters
    moved = superposed(chosen.positions, chosen.positions[0])
    remarks = ["each stands for the frames nearest to it; populations are not claimed"]
    remarks += [f"model {k + 1}: frame {frame}" for k, frame in enumerate(chosen.frames)]
    path = folder / "representatives.pdb"
    write_models(path, found.atoms, moved, np.zeros(len(found.atoms)), remarks)
    return path


def _write(path: Path, head: Sequence[str], rows: Iterable[Sequence[Any]]) -> Path:
    with open(path, "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file)
        table.writerow(head)
        for row in rows:
            table.writerow([harmless(cell) if isinstance(cell, str) else cell for cell in row])
    return path


def _draw(found: Flexibility, path: Path, dpi: int) -> Path:
    from matplotlib.figure import Figure

    figure = Figure(figsize=(9, 3.6), layout="constrained")
    axes = figure.subplots()
    place = np.arange(1, len(found.rmsf) + 1)
    low, high = found.rmsf - 2 * found.error, found.rmsf + 2 * found.error
    axes.fill_between(place, low, high, alpha=0.3, label="2 standard errors, between walkers")
    axes.plot(place, found.rmsf, label=f"all {found.walkers} walkers")
    for name, half in zip(("even", "odd"), found.halves, strict=True):
        axes.plot(place, half, lw=0.6, label=f"walkers of {name} numbers")
    axes.set(xlabel=found.unit, ylabel="RMSF (Å)", ylim=(0, None))
    axes.margins(x=0.01)
    axes.legend(frameon=False, fontsize=8)
    figure.savefig(path, dpi=dpi)
    return path


def print_report(numbers: dict[str, Any]) -> None:
    """The same numbers, as text."""
    print(f"frames          {numbers['frames']}, of {numbers['walkers']} walkers")
    mean, error = numbers["flexibility_mean"], numbers["flexibility_error_mean"]
    units = f"{numbers['units']} {numbers['unit']}s"
    print(f"flexibility     {mean:.3f} Angstrom, mean RMSF of {units}; {error:.4f} standard error")
    print(
        f"two halves      RMSF correlates at {numbers['halves_correlation']:.3f}, "
        f"differs by {numbers['halves_difference_max']:.3f} Angstrom at most"
    )
    if numbers["modes"] is None:
        share = float(np.sum(numbers["variance_shares"]))
        print(f"modes           ten hold {share:.0%} of the variance; ", end="")
        print(f"RMSIP of the halves {numbers['halves_rmsip']:.3f}")
    else:
        print(f"modes           left out: {numbers['modes']}")
    shares = numbers["cluster_shares"]
    print(
        f"clusters        {len(shares)}; the largest has {shares[0]:.0%} of the frames, the halves "
        f"differ by {numbers['cluster_halves_difference_max']:.0%} at most"
    )
    print(f"worst residual  {numbers['max_residual']:.2e} of the bar's length")
    print(f"left out        {numbers['left_out']}")
    for path in (path for paths in numbers["outputs"].values() for path in paths):
        print(f"written         {path}")
