# SPDX-License-Identifier: MIT
"""``pliant analyse DIR``: what the shards of an ensemble tell, as tables, a figure and numbers."""

from __future__ import annotations

import csv
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from pliant.base.console import counted
from pliant.base.csv_cells import harmless
from pliant.base.new_file import new_text
from pliant.measure.flexibility import STILL
from pliant.report.shards.draw import draw_flexibility
from pliant.shards.flexibility import EnsembleFlexibility, flexibility
from pliant.trajectory.superposition import superpose_onto

#: What the report of one file has, and this one has not.
LEFT_OUT = (
    "torsions, stereochemistry, domains, shapes and the page: pliant analyse of a shard's file "
    "has them for its frames"
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
    tables.append(_write_clusters(found, output))
    models = _write_representatives(found, output)
    on_stage("figure")
    figure = draw_flexibility(found, output / "flexibility.png", dpi)
    outputs = {
        "tables": [str(path) for path in tables],
        "figures": [str(figure)],
        "models": [str(models)],
    }
    return {**_numbers(folder, found), "outputs": outputs, "left_out": LEFT_OUT}


def _numbers(folder: Path, found: EnsembleFlexibility) -> dict[str, Any]:
    share = found.variances / found.total_variance if found.total_variance > 0 else np.empty(0)
    return {
        "ensemble": str(folder),
        "frames": found.frames,
        "flexibility_frames": found.near,
        "walkers": found.walkers if found.what == "walkers" else None,
        "unit": found.units.what,
        "units": len(found.units.labels),
        "nothing_moves": found.still,
        "amplitude_asked": found.amplitude,
        "flexibility_mean": float(found.rmsf.mean()),
        "flexibility_error_mean": float(found.error.mean()),
        "halves_correlation": found.correlation,
        "halves_difference_max": float(np.abs(found.halves[0] - found.halves[1]).max()),
        "halves_rmsip": found.rmsip,
        "variance_shares": share,
        "modes": found.why_no_modes or None,
        "max_residual": found.max_residual,
        "contacts": len(found.contacts),
        "cluster_shares": found.clusters.shares,
        "cluster_errors": found.clusters.errors,
        "cluster_halves_difference_max": float(
            np.abs(np.diff(found.clusters.halves, axis=0)).max()
        ),
        "cluster_frames": found.clusters.frames,
    }


def _write_flexibility(found: EnsembleFlexibility, folder: Path) -> Path:
    rows = zip(found.units.labels, found.rmsf, found.error, *found.halves, strict=True)
    halves = [f"rmsf_even_{found.what}", f"rmsf_odd_{found.what}"]
    head = [found.units.what, "rmsf_angstrom", "standard_error", *halves]
    return _write(folder / "flexibility.csv", head, rows)


def _write_modes(found: EnsembleFlexibility, folder: Path) -> Path:
    count = len(found.variances)
    parts = found.modes.T.reshape(count, -1, 3)
    rows = (
        (k + 1, found.variances[k], label, *parts[k, unit])
        for k in range(count)
        for unit, label in enumerate(found.units.labels)
    )
    head = ["mode", "variance_angstrom2", found.units.what, "x", "y", "z"]
    return _write(folder / "modes.csv", head, rows)


def _write_contacts(found: EnsembleFlexibility, folder: Path) -> Path:
    return _write(folder / "contacts.csv", ["contact", "kind", "share_held"], found.contacts)


def _write_clusters(found: EnsembleFlexibility, folder: Path) -> Path:
    chosen, what = found.clusters, found.what
    own = ["walker", "step"] if what == "walkers" else ["step"]
    columns = zip(chosen.shares, chosen.errors, *chosen.halves, chosen.distances, strict=True)
    rows = (
        (k + 1, int(frame), *(record[name] for name in own), *numbers)
        for k, (frame, record, numbers) in enumerate(
            zip(chosen.frames, chosen.records, columns, strict=True)
        )
    )
    head = ["cluster", "frame", *own, "share_of_frames", "standard_error"]
    head += [f"share_even_{what}", f"share_odd_{what}", "mean_rmsd_angstrom"]
    return _write(folder / "clusters.csv", head, rows)


def _write_representatives(found: EnsembleFlexibility, folder: Path) -> Path:
    """The frame of each cluster as a model, superposed on the first."""
    from pliant.report.multi_model import write_models

    chosen = found.clusters
    moved = superpose_onto(chosen.positions, slice(None), chosen.positions[0])
    remarks = ["each stands for the frames nearest to it; populations are not claimed"]
    remarks += [f"model {k + 1}: frame {frame}" for k, frame in enumerate(chosen.frames)]
    path = folder / "representatives.pdb"
    write_models(path, found.atoms, moved, np.zeros(len(found.atoms)), remarks)
    return path


def _write(path: Path, head: Sequence[str], rows: Iterable[Sequence[Any]]) -> Path:
    with new_text(path, overwrite=True) as file:
        table = csv.writer(file)
        table.writerow(head)
        for row in rows:
            table.writerow([harmless(cell) if isinstance(cell, str) else cell for cell in row])
    return path


def print_report(numbers: dict[str, Any]) -> None:
    """The same numbers, as text."""
    walkers = numbers["walkers"]
    source = "independent of each other" if walkers is None else f"of {counted(walkers, 'walker')}"
    print(f"frames          {numbers['frames']}, {source}")
    if numbers["flexibility_frames"] < numbers["frames"]:
        print(
            f"{'':<16}flexibility is that of the {numbers['flexibility_frames']} around the start"
        )
    if numbers["nothing_moves"]:
        _print_still(numbers)
    else:
        _print_motion(numbers)
    print(f"worst residual  {numbers['max_residual']:.2e} of the bar's length")
    print(f"left out        {numbers['left_out']}")
    for path in (path for paths in numbers["outputs"].values() for path in paths):
        print(f"written         {path}")


def _print_still(numbers: dict[str, Any]) -> None:
    units = counted(numbers["units"], numbers["unit"])
    print(f"flexibility     nothing moves: RMSF of all {units} is below {STILL:g} Angstrom")
    print("clusters        1: all frames have one shape")


def _print_motion(numbers: dict[str, Any]) -> None:
    mean, error = numbers["flexibility_mean"], numbers["flexibility_error_mean"]
    units = counted(numbers["units"], numbers["unit"])
    print(f"flexibility     {mean:.3f} Angstrom, mean RMSF of {units}; {error:.4f} standard error")
    if numbers["amplitude_asked"] is not None:
        asked = numbers["amplitude_asked"]
        print(
            f"amplitude       asked {asked:.2f} Angstrom: how far all moves is an input, which "
            "parts move more than others is a result"
        )
    r, most = numbers["halves_correlation"], numbers["halves_difference_max"]
    alike = "" if np.isnan(r) else f"correlates at {r:.3f}, "
    print(f"two halves      RMSF {alike}differs by {most:.3f} Angstrom at most")
    _print_modes(numbers)
    shares = numbers["cluster_shares"]
    print(
        f"clusters        {len(shares)}; the largest has {shares[0]:.0%} of the frames, the halves "
        f"differ by {numbers['cluster_halves_difference_max']:.0%} at most"
    )


def _print_modes(numbers: dict[str, Any]) -> None:
    if numbers["modes"] is not None:
        print(f"modes           left out: {numbers['modes']}")
        return
    share = float(np.sum(numbers["variance_shares"]))
    rmsip = numbers["halves_rmsip"]
    print(f"modes           ten hold {share:.0%} of the variance; RMSIP of the halves {rmsip:.3f}")
