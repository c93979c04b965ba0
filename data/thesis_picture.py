# SPDX-License-Identifier: MIT
"""Draws data/pictures/thesis.png: what became of the thesis' claims."""

import tempfile
from pathlib import Path

import numpy as np
from pliant.base.processes import usual_workers
from pliant.lab.experiment.claims import CLAIMS, evidence_by_yardstick
from pliant.lab.experiment.drawings import group_bars
from pliant.lab.experiment.laboratory import run_experiment
from pliant.lab.experiment.settings import Settings
from pliant.lab.experiment.settled import settle
from pliant.lab.experiment.statistics import Evidence
from pliant.lab.experiment.sweep import run_sweep

from pliant.base import style

SHOWN = ["random", "bfs_cycle", "bfs_reverse", "dfs_cycle", "dfs_reverse"]
SHORT = {
    "T1": "trees, root outwards: one sweep", "T2": "trees, random 1: nearly one sweep",
    "T3": "trees, 1: better than Ragdoll", "T4": "trees: weighting over ordering",
    "C1": "bfs_cycle 0.5 is best", "C2": "0.5 is best for others, too",
    "C3": "bfs_cycle 1 is far worst", "C4": "cycle 0.5 is at or below Ragdoll",
    "C5": "mode 3 of random and dfs_cycle", "C6": "mode 1 of bfs_cycle",
    "C7": "spread of bfs_cycle by weighting", "R1": "bfs_reverse 0.5 is best of all",
    "R2": "modes of reverse", "R3": "reverse 0.5 spreads less",
    "A1": "bfs_adapt is worst", "B1": "bfs_random is like bfs_cycle",
}  # fmt: skip  # some pairs a line
WORDS = {"holds": style.GREEN, "depends": style.ORANGE, "fails": style.VERMILION}


def draw_means(axis, evidence):
    """Figure 5.6 of the thesis, its first panel, by one yardstick."""
    group_bars(axis, evidence, "1-cycle", SHOWN, "mean")
    axis.set_ylim(0, 8)
    axis.set_title(f"1-cycle graphs: mean {evidence.yardstick}")
    axis.set_xlabel("weighting")
    axis.set_ylabel(evidence.yardstick)


def share_of(points, identity, yardstick):
    """Mean share of a claim's statements that hold, over the settings of the sweep."""
    shares = [
        p.holding / p.statements
        for p in points
        if (p.claim, p.yardstick) == (identity, yardstick) and p.statements
    ]
    return 100 * np.mean(shares) if shares else None


def draw_claims(axis, settled, points):
    """One bar a claim, in the colour of its verdict; a mark where passes say otherwise."""
    for row, one in enumerate(settled):
        share = share_of(points, one.claim.id, "sweeps")
        axis.barh(row, share, 0.72, color=WORDS[one.word])
        passes = share_of(points, one.claim.id, "passes")
        if passes is not None:
            axis.plot(passes, row, "D", color=style.INK, markersize=4.5)
    axis.set_yticks(
        range(len(settled)), [f"{SHORT[one.claim.id]}  {one.claim.id}" for one in settled]
    )
    axis.set_ylim(len(settled) - 0.4, -0.6)
    axis.set_xlim(0, 103)
    axis.grid(axis="y", visible=False)
    axis.set_xlabel("statements that hold in the sweep (%)")
    axis.set_title("the 16 claims of chapter 5")


def draw_legend(axis, settled):
    """Counts of verdicts."""
    found = [one.word for one in settled]
    handles = [
        axis.bar(0, 0, color=color, label=f"{word}: {found.count(word)}")
        for word, color in WORDS.items()
    ]
    handles += axis.plot([], [], "D", color=style.INK, markersize=4.5, label="counted in passes")
    axis.figure.legend(handles=handles, loc="outside lower right", ncols=4, fontsize=8.5)


def make_thesis_picture(path):
    """Runs the default experiment and the sweep, and draws them."""
    with tempfile.TemporaryDirectory() as folder:
        settings = Settings(seed=1)
        table = run_experiment(settings, Path(folder) / "study", workers=usual_workers())
        points = run_sweep(settings, Path(folder), usual_workers())
    draw(table, points, path)


def draw(table, points, path):
    """The picture of an experiment and its sweep."""
    all_evidence = evidence_by_yardstick(Evidence(table))
    settled = settle(all_evidence, points)
    assert len(settled) == len(CLAIMS)
    with style.styled():
        figure, axes = style.new_figure((12.6, 4.2), 1, 3, width_ratios=(1, 1, 1.1))
        for axis, name in zip(axes, ("sweeps", "passes"), strict=False):
            draw_means(axis, all_evidence[name])
        axes[0].legend(*axes[1].get_legend_handles_labels(), loc="upper left", ncols=3, fontsize=8)
        draw_claims(axes[2], settled, points)
        draw_legend(axes[2], settled)
        figure.savefig(path, dpi=120, metadata={"Software": None})
