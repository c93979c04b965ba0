# SPDX-License-Identifier: MIT
"""Draws data/pictures/methods.png: the outward pass of `blocks`, and the work list after a push."""

from collections import deque
from pathlib import Path

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.patches import Polygon
from rdkit import Chem
from rdkit.Chem import AllChem

import pliant
from pliant.base import style

MOLECULES = Path(__file__).parent / "molecules"
ROOT = 0  # of aspirin: its methyl carbon


def outward_steps(framework, root):
    """(near, far, bar) of each bridge and (entry, joints) of each block, in the order of a pass."""
    blocks, bridges = framework.blocks(), framework.bridges()
    around = [[] for _ in range(framework.joint_count)]
    for k, (a, b) in enumerate(framework.bars):
        around[a].append((k, b))
        around[b].append((k, a))
    steps, seen, entered, waiting = [], {root}, set(), deque([root])
    while waiting:
        here = waiting.popleft()
        for bar, there in around[here]:
            block = blocks[bar]
            if bridges[bar] and there not in seen:
                steps.append((here, there, bar))
                seen.add(there)
                waiting.append(there)
            elif not bridges[bar] and block not in entered:
                entered.add(block)
                joints = list(dict.fromkeys(map(int, framework.bars[blocks == block].ravel())))
                steps.append((here, joints))
                waiting.extend(j for j in joints if j not in seen)
                seen.update(joints)
    return steps


def draw_outward_pass(axis):
    """Aspirin as RDKit lays it out flat, each bridge and the ring numbered by when it is whole."""
    structure = pliant.read(MOLECULES / "aspirin.sdf")
    framework = structure.framework()
    molecule = Chem.MolFromMolFile(str(MOLECULES / "aspirin.sdf"), removeHs=False)
    AllChem.Compute2DCoords(molecule)
    x = molecule.GetConformer().GetPositions()[:, :2]
    axis.add_collection(LineCollection(x[framework.bars], colors=style.GREY, linewidths=1.2))
    for number, step in enumerate(outward_steps(framework, ROOT), start=1):
        if len(step) == 2:
            draw_ring(axis, x, step[1], number)
        else:
            draw_bridge(axis, x[step[0]], x[step[1]], number)
    axis.plot(*x.T, "o", color=style.INK, markersize=3.5, zorder=4)
    axis.plot(*x[ROOT], "o", color=style.VERMILION, markersize=9, zorder=5)
    place = {"textcoords": "offset points", "fontsize": 9}
    axis.annotate("pushed joint", x[ROOT], (10, 6), color=style.VERMILION, **place)
    axis.set_title("blocks: one pass outward over aspirin")
    tidy(axis)


def draw_bridge(axis, near, far, number):
    """An arrow to the joint that moves."""
    arrow = {"arrowstyle": "-|>", "color": style.BLUE, "linewidth": 1.6}
    axis.annotate("", far, near, arrowprops=arrow | {"shrinkA": 3, "shrinkB": 2})
    side = np.array([near[1] - far[1], far[0] - near[0]])
    place = 0.5 * (near + far) + 0.26 * side / np.linalg.norm(side)
    axis.text(*place, str(number), ha="center", va="center", fontsize=8, color=style.BLUE)


def draw_ring(axis, x, joints, number):
    """A filled ring: all of its bars by Newton's method."""
    centre = x[joints].mean(axis=0)
    turn = np.argsort(np.arctan2(*(x[joints] - centre).T))
    axis.add_patch(Polygon(x[joints][turn], color=style.ORANGE, alpha=0.45, linewidth=0))
    axis.text(*centre, f"{number}\nNewton", ha="center", va="center", fontsize=9, color=style.INK)


def draw_work_list(axis):
    """A peptide after one push of one atom: which atoms moved, how many bars were looked at."""
    structure = pliant.read(MOLECULES / "peptide_20.pdb")
    structure.perceive_bonds()
    framework = structure.framework()
    state = pliant.State(structure.positions)
    done = pliant.run(framework, state, steps=1, technique="blocks", seed=6)
    moved = np.any(state.positions != structure.positions, axis=1)
    centred = structure.positions - structure.positions.mean(axis=0)
    x = centred @ np.linalg.svd(centred, full_matrices=False)[2][:2].T
    axis.add_collection(LineCollection(x[framework.bars], colors=style.GREY, linewidths=0.9))
    edge = {"markeredgecolor": style.GREY, "markeredgewidth": 0.6}
    kept = f"{np.sum(~moved)} atoms not touched"
    axis.plot(*x[~moved].T, "o", color=style.FAINT, markersize=4, label=kept, **edge)
    label = f"{np.sum(moved)} atoms moved"
    axis.plot(*x[moved].T, "o", color=style.VERMILION, markersize=5, zorder=4, label=label)
    axis.set_title(
        f"after a push of one atom: {done.projections} of {framework.bar_count} bars looked at"
    )
    axis.legend(loc="lower center", bbox_to_anchor=(0.5, -0.12), ncols=2, frameon=False)
    tidy(axis)


def tidy(axis):
    """A drawing, not a plot."""
    axis.autoscale()
    axis.set_aspect("equal")
    axis.set_axis_off()


def make_method_picture(path):
    """Both drawings side by side."""
    with style.styled():
        figure, axes = style.new_figure((10.4, 4.4), 1, 2, width_ratios=(1, 1.25))
        draw_outward_pass(axes[0])
        draw_work_list(axes[1])
        figure.savefig(path, dpi=110, bbox_inches="tight", metadata={"Software": None})
