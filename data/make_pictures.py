# SPDX-License-Identifier: MIT
"""Draws the pictures of all README.md from runs that it makes itself.

Usage: .venv/bin/python data/make_pictures.py [NAME ...], the names those of PICTURES
"""

import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py
import matplotlib as mpl
import numpy as np

mpl.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.collections import LineCollection
from MDAnalysisTests import datafiles
from method_picture import make_method_picture
from structure_picture import make_structure_picture
from thesis_picture import make_thesis_picture

HERE = Path(__file__).parent
PLIANT = Path(sys.executable).parent / "pliant"
INK, PLIANT_BLUE, OPENMM_ORANGE = "#22313f", "#0072b2", "#d55e00"


def pliant(*arguments):
    """Runs the command quietly; what it prints."""
    done = subprocess.run(
        [PLIANT, *map(str, arguments)], check=True, capture_output=True, text=True
    )
    return done.stdout


def superposed(frames):
    """Frames (F, N, 3) moved onto the first (Kabsch, Acta Cryst. A32 (1976) 922)."""
    reference = frames[0] - frames[0].mean(axis=0)
    moved = []
    for frame in frames:
        centred = frame - frame.mean(axis=0)
        u, _, vt = np.linalg.svd(centred.T @ reference)
        turn = u @ np.diag([1.0, 1.0, np.sign(np.linalg.det(u @ vt))]) @ vt
        moved.append(centred @ turn)
    return np.array(moved)


def flat_view(points):
    """Points turned so that their longest axes lie along x and z."""
    _, _, axes = np.linalg.svd(points[0] - points[0].mean(axis=0), full_matrices=False)
    return points @ axes[[0, 2, 1]].T


def draw_ensemble(figure, place, trajectory, title):
    """All frames over one another, coloured by how far each bond's atoms move."""
    with h5py.File(trajectory) as file:
        frames = flat_view(superposed(file["particles/trajectory/position/value"][:]))
        bonds = file["connectivity/bonds"][:]
    rmsf = np.sqrt(((frames - frames.mean(axis=0)) ** 2).sum(axis=-1).mean(axis=0))
    values = rmsf[bonds].mean(axis=1)
    axes = figure.add_axes(place)
    for k, frame in enumerate(frames[::-1]):
        is_start = k == len(frames) - 1
        lines = LineCollection(
            frame[bonds][:, :, [0, 2]],
            array=values,
            cmap="viridis",
            linewidths=2.6 if is_start else 0.9,
            alpha=1.0 if is_start else 0.3,
            capstyle="round",
        )
        lines.set_clim(0, values.max())
        axes.add_collection(lines)
    axes.autoscale()
    axes.set_aspect("equal")
    axes.set_axis_off()
    figure.text(place[0] + place[2] / 2, 0.93, title, ha="center", color=INK, fontsize=12)
    bar = figure.add_axes([place[0] + place[2] * 0.3, 0.12, place[2] * 0.4, 0.025])
    figure.colorbar(lines, cax=bar, orientation="horizontal")
    bar.set_xlabel("RMSF of an atom (Å)", color=INK, fontsize=9)
    bar.tick_params(labelsize=8)


SERIES = {
    "Pliant, default": ("Pliant, as it comes (technique blocks)", PLIANT_BLUE, "o-"),
    "Pliant, sweeps of the thesis": ("Pliant, the thesis' bfs_cycle", "#56b4e9", "s-"),
    "OpenMM, as in dynamics": ("OpenMM's CCMA, as in dynamics", OPENMM_ORANGE, "D--"),
}


def draw_series(axes, row):
    """One method's time over the displacement; a cross where it did not repair all."""
    label, colour, style = SERIES[row["name"]]
    whole = [r for r in row["results"] if r["outcome"] == "whole"]
    size, time = [r["displacement"] for r in whole], [1e6 * r["seconds"] for r in whole]
    axes.loglog(size, time, style, color=colour, label=label, markersize=7, linewidth=2)
    failed = [r["displacement"] for r in row["results"] if r["outcome"] != "whole"]
    if failed:
        top = [1e6 * max(r["seconds"] for r in whole)] * len(failed)
        axes.loglog(failed, top, "X", color=colour, markersize=11, label="no number comes back")


def draw_times(figure, place, rows):
    """Time to make a broken protein whole, beside OpenMM's."""
    axes = figure.add_axes(place)
    for row in rows:
        if row["name"] in SERIES:
            draw_series(axes, row)
    axes.set_xlabel("every atom displaced by (Å, standard deviation)", color=INK)
    axes.set_ylabel("time to make 3365 bars whole (µs)", color=INK)
    axes.set_ylim(20, 20000)
    axes.set_xticks([0.01, 0.03, 0.1, 0.3], ["0.01", "0.03", "0.1", "0.3"])
    axes.minorticks_off()
    axes.grid(alpha=0.25)
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(frameon=False, fontsize=9, loc="upper left", ncols=1)
    middle, title = place[0] + place[2] / 2, "3341 atoms made whole to 1e-6"
    figure.text(middle, 0.93, title, ha="center", color=INK, fontsize=12)


def draw_pliant():
    """A peptide in motion, and the time to repair a protein beside OpenMM's."""
    with tempfile.TemporaryDirectory() as folder:
        peptide, protein = Path(folder) / "peptide.h5md", Path(folder) / "adk.h5md"
        start = HERE / "molecules" / "peptide_20.pdb"
        words = "--perturb displacement --technique blocks"
        pliant("run", start, "-o", peptide, "--steps", 200, "--every", 10, *words.split())
        pliant("run", datafiles.PDB_small, "-o", protein, "--steps", 20, *words.split())
        check = json.loads(pliant("check", protein, "--json"))
        figure = plt.figure(figsize=(11, 4.6), facecolor="white")
        draw_ensemble(
            figure,
            [0.02, 0.18, 0.58, 0.74],
            peptide,
            "a peptide in motion, every bond at its length",
        )
        draw_times(figure, [0.67, 0.17, 0.31, 0.7], check["side_by_side"])
        figure.savefig(HERE / "pictures" / "pliant.png", dpi=130)


# File, title, size of the pushes, joint whose path is shown, and from where it is seen (degrees
# around z, above).
MECHANISMS = [
    ("four_bar", "four-bar linkage", 25, "C", None),
    ("slider_crank", "slider and crank", 25, "S", None),
    ("peaucellier", "Peaucellier cell", 25, "S", None),
    ("elliptical_trammel", "elliptical trammel", 100, "T", None),
    ("puma", "PUMA arm", 10, "tool", (-60, 20)),
    ("chain_7r", "7R chain", 10, "tool", (-60, 15)),
    ("stewart_gough_octahedral", "octahedral platform, rigid", 5, None, (-75, 20)),
    ("stewart_gough_6_6", "6-6 platform, rigid", 5, None, (-75, 20)),
    ("double_banana", "double banana", 25, "f", (-90, 12)),
    ("bricard_octahedron", "Bricard octahedron", 25, None, (-50, 35)),
    ("kaleidocycle", "kaleidocycle", 70, None, (-90, 50)),
]


def seen_from(points, view):
    """Points (..., 3) in the plane of the picture."""
    if view is None:
        return points[..., :2]
    around, above = np.radians(view)
    right = [-np.sin(around), np.cos(around), 0.0]
    up = [-np.sin(above) * np.cos(around), -np.sin(above) * np.sin(around), np.cos(above)]
    return points @ np.array([right, up]).T


def free_superposed(frames, pinned):
    """Frames on top of one another where no ground holds them."""
    return frames if len(pinned) else superposed(frames)


def run_mechanism(path, force, folder):
    """Frames (F, N, 3), bars (B, 2), pinned joints and names of a run in small random steps."""
    trajectory = Path(folder) / "out.h5md"
    words = "--topology none --overwrite --steps 3000 --every 10 --damping 1 --seed 3"
    words += " --tolerance 1e-8 --max-sweeps 100000"
    pliant("run", path, "-o", trajectory, "--force", force, *words.split())
    names = re.findall(r'<joint id="([^"]+)"', path.read_text())
    pinned = re.findall(r'<joint id="([^"]+)".*pinned', path.read_text())
    with h5py.File(trajectory) as file:
        frames = file["particles/trajectory/position/value"][:]
        bars = file["connectivity/bars"][:]
    return free_superposed(frames, pinned), bars, [names.index(name) for name in pinned], names


def draw_mechanism(axes, title, run, traced, view):
    """The first position in full, five others faint, the ground as triangles, a path as dots."""
    frames, bars, pinned, names = run
    points = seen_from(frames, view)
    for k in np.linspace(0, len(points) - 1, 6).astype(int)[::-1]:
        first = k == 0
        axes.add_collection(
            LineCollection(
                points[k][bars],
                colors=INK if first else PLIANT_BLUE,
                linewidths=1.6 if first else 0.8,
                alpha=1.0 if first else 0.35,
                zorder=3 if first else 1,
                capstyle="round",
            )
        )
    if traced:
        path = points[:, names.index(traced)]
        axes.plot(*path.T, ".", color=OPENMM_ORANGE, markersize=2.2, zorder=4)
    free = np.setdiff1d(np.arange(len(names)), pinned)
    axes.plot(*points[0][free].T, "o", color=INK, markersize=3, zorder=5)
    axes.plot(*points[0][pinned].T, "^", color="white", markeredgecolor=INK, markersize=7, zorder=6)
    axes.set_title(title, color=INK, fontsize=11)
    axes.autoscale()
    axes.margins(0.08)
    axes.set_aspect("equal", adjustable="datalim")
    axes.set_axis_off()


def draw_legend(axes):
    """What lines and marks mean, in words."""
    marks = [
        axes.plot([], [], "-", color=INK, linewidth=1.6, label="bars, as in the file")[0],
        axes.plot([], [], "-", color=PLIANT_BLUE, alpha=0.5, label="later in the run")[0],
        axes.plot([], [], "o", color=INK, markersize=3, label="joint")[0],
        axes.plot([], [], "^", color="white", markeredgecolor=INK, markersize=7,
                  label="joint of the ground (pinned)")[0],
        axes.plot([], [], ".", color=OPENMM_ORANGE, label="path of one joint")[0],
    ]  # fmt: skip  # a table: a row a line
    axes.legend(handles=marks, loc="center", frameon=False, fontsize=10)
    axes.set_axis_off()


def draw_mechanisms():
    """data/pictures/mechanisms.png."""
    figure, grid = plt.subplots(3, 4, figsize=(11, 8.2), facecolor="white", layout="constrained")
    with tempfile.TemporaryDirectory() as folder:
        for axes, (name, title, force, traced, view) in zip(grid.flat, MECHANISMS, strict=False):
            run = run_mechanism(HERE / "mechanisms" / f"{name}.xml", force, folder)
            draw_mechanism(axes, title, run, traced, view)
    draw_legend(grid.flat[-1])
    figure.savefig(HERE / "pictures" / "mechanisms.png", dpi=100)


def draw_work_precision():
    """Run time against error of every technique, OpenMM, and GROMACS if installed, on a protein."""
    words = ["--quiet", "--repeats", 15, "-o", HERE / "pictures" / "work_precision.png"]
    pliant("lab", "bench", "work-precision", datafiles.PDB_small, *words)


def draw_thesis():
    """What became of the thesis' claims."""
    make_thesis_picture(HERE / "pictures" / "thesis.png")


def draw_methods():
    """How `blocks` goes outward, and what a push of one atom costs."""
    make_method_picture(HERE / "pictures" / "methods.png")


def draw_structure():
    """How data flows through the folders of the library."""
    make_structure_picture(HERE / "pictures" / "structure.png")


PICTURES = {
    "thesis": draw_thesis,
    "pliant": draw_pliant,
    "work_precision": draw_work_precision,
    "mechanisms": draw_mechanisms,
    "methods": draw_methods,
    "structure": draw_structure,
}


def main():
    """Draws the pictures that are named, or all."""
    for name in sys.argv[1:] or PICTURES:
        PICTURES[name]()


if __name__ == "__main__":
    main()
