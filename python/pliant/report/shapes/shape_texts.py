# SPDX-License-Identifier: MIT
"""The other shapes as a verdict, rows of tables, and JSON."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from pliant.base.verdict import Verdict
from pliant.measure.shapes.other_shapes import OtherShapes, Shape
from pliant.measure.stages.names import chains_of, residue_labels
from pliant.measure.stages.parts import ReferenceStructure

if TYPE_CHECKING:
    from pliant.measure.stages.analysis import Analysis

NO_POPULATION = (
    "The number of frames in a shape is not a population: it reflects how the frames were drawn, "
    "not energies or how often the molecule has that shape."
)
#: contacts of a shape that the page names
NAMED = 4


def shapes_verdict(analysis: Analysis) -> Verdict | None:
    """Whether there are other shapes; None where it makes no sense to ask."""
    part, count = analysis.get(OtherShapes), len(analysis.frames)
    if part is None:
        return None
    if part.groups is None:
        sentence = (
            f"No other shapes were searched for: all {count} frames were drawn around the start."
        )
        return Verdict("open", sentence, "pliant sample --sampler reach goes further.")
    start, limit = analysis[ReferenceStructure].name, part.groups.limit
    alone = (
        f"{part.alone} frames are far from the start and from each other. " if part.alone else ""
    )
    if not part.shapes:
        sentence = f"No other shape: no two frames beyond {limit:.1f} Å from {start} are alike."
        return Verdict("open", sentence, alone.strip())
    off = [shape.rmsd for shape in part.shapes]
    many = f"{len(off)} other shapes" if len(off) > 1 else "One other shape"
    far = f"{off[-1]:.1f} to {off[0]:.1f}" if len(off) > 1 else f"{off[0]:.1f}"
    total = sum(shape.frames for shape in part.shapes)
    details = f"{total} of {count} frames are of {'these' if len(off) > 1 else 'it'}. {alone}"
    return Verdict("open", f"{many}, {far} Å from {start} (CA).", details + NO_POPULATION)


def turns_of(analysis: Analysis, shape: Shape) -> list[dict[str, Any]]:
    """Each piece that turned: its stretches, degrees, and the hinges at its ends."""
    labels, turns = _labels(analysis), shape.turns
    chains = chains_of(analysis.universe.atoms[analysis[OtherShapes].sites])
    turned = []
    for k in range(1, len(turns.angles)):
        sites = np.flatnonzero(turns.piece == k)
        ends = (np.diff(sites) > 1) | (chains[sites[1:]] != chains[sites[:-1]])
        parts = np.split(sites, np.flatnonzero(ends) + 1)
        beside = [pair for pair in turns.hinges if k in turns.piece[pair]]
        turned.append(
            {
                "residues": [[labels[p[0]], labels[p[-1]]] for p in parts],
                "degrees": float(turns.angles[k]),
                "hinges": [[labels[a], labels[b]] for a, b in beside],
            }
        )
    return turned


def turns_text(analysis: Analysis, shape: Shape) -> str:
    """The same in words."""
    texts = []
    for turn in turns_of(analysis, shape):
        stretches = ", ".join(f"{a} to {b}" for a, b in turn["residues"])
        hinges = ", ".join(f"{a}/{b}" for a, b in turn["hinges"])
        about = f" about {hinges}" if hinges else ""
        texts.append(f"{stretches} by {turn['degrees']:.0f}°{about}")
    return "; ".join(texts) or "nothing as a whole: it bends"


def _labels(analysis: Analysis) -> list[str]:
    every = residue_labels(analysis.universe.residues)
    return [every[k] for k in analysis.universe.atoms[analysis[OtherShapes].sites].resindices]


def contacts_gone(analysis: Analysis, shape: Shape) -> list[str]:
    """Names of the contacts of the start that a shape lacks."""
    contacts = analysis.record.contacts if analysis.record else None
    if contacts is None or shape.gone is None:
        return []
    labels, owners = residue_labels(analysis.universe.residues), analysis.universe.atoms.resindices
    pairs = owners[contacts.joints[shape.gone]]
    return [f"{labels[a]}-{labels[b]}" for a, b in pairs]


def contacts_text(analysis: Analysis, shape: Shape) -> str:
    """How many, and some of them."""
    if shape.gone is None:
        return "not recorded"
    names = list(dict.fromkeys(contacts_gone(analysis, shape)))
    more = f" and {len(names) - NAMED} more pairs" if len(names) > NAMED else ""
    return f"{len(shape.gone)}: {', '.join(names[:NAMED])}{more}" if names else "0"


def residues_text(analysis: Analysis, residues: np.ndarray) -> str:
    """Names of residues."""
    labels = residue_labels(analysis.universe.residues)
    return " ".join(labels[k] for k in residues)


def page_rows(analysis: Analysis) -> list[Sequence[str]]:
    """Rows of the page: around the start, each shape, and frames that are alone."""
    part, start = analysis[OtherShapes], analysis[ReferenceStructure].name
    if part.groups is None:
        return [(f"all {part.near} around {start}", "none looked for: see --sampler reach")]
    limit = f"up to {part.groups.limit:.1f}"
    rows: list[Sequence[str]] = [(f"around {start}", f"{part.near}", "–", limit, "–", "–", "–")]
    for number, shape in enumerate(part.shapes, 1):
        what = turns_text(analysis, shape), contacts_text(analysis, shape)
        far = f"{shape.rmsd:.1f}", f"{shape.spread:.1f}"
        rows.append((f"shape {number}", f"{shape.frames}", f"{shape.frame}", *far, *what))
    if part.alone or not part.shapes:
        rows.append(("like no other", f"{part.alone}", "–", "beyond", "–", "–", "–"))
    if part.known is not None:
        half = f"{part.known[0]:.1f} to {part.known[2]:.1f}"
        pairs = "half of the known pairs of structures of proteins as soft"
        rows.append((pairs, "–", "–", half, "–", "–", "–"))
    return rows


def pocket_rows(analysis: Analysis) -> list[Sequence[str]]:
    """Rows of the page: pockets that have more room than at the start."""
    return [
        (
            f"shape {number}",
            f"{pocket.volume:.0f}",
            f"{pocket.at_start:.0f}",
            f"{pocket.around:.0f} ± {pocket.deviation:.0f}",
            residues_text(analysis, pocket.residues),
        )
        for number, shape in enumerate(analysis[OtherShapes].shapes, 1)
        for pocket in shape.pockets
    ]


def shapes_columns(analysis: Analysis) -> dict[str, Any]:
    """One row per shape; no columns without any."""
    shapes = analysis[OtherShapes].shapes
    if not shapes:
        return {}
    turns = [turns_of(analysis, shape) for shape in shapes]
    columns = {
        "shape": np.arange(1, len(shapes) + 1),
        "frame": [shape.frame for shape in shapes],
        "frames": [shape.frames for shape in shapes],
        "rmsd_angstrom": [shape.rmsd for shape in shapes],
        "mean_rmsd_within_angstrom": [shape.spread for shape in shapes],
        "largest_turn_degrees": [float(shape.turns.angles.max()) for shape in shapes],
        "turned": [
            turns_text(analysis, shape) if t else "" for shape, t in zip(shapes, turns, strict=True)
        ],
        "rmsd_within_rigid_pieces_angstrom": [shape.turns.within for shape in shapes],
    }
    if shapes[0].gone is not None:
        columns["contacts_gone"] = [len(contacts_gone(analysis, shape)) for shape in shapes]
        columns["contacts"] = [" ".join(contacts_gone(analysis, shape)) for shape in shapes]
    return columns


def pocket_columns(analysis: Analysis) -> dict[str, Any]:
    """One row per pocket that has more room than at the start; no columns without any."""
    shapes = analysis[OtherShapes].shapes
    found = [(k, shape, pocket) for k, shape in enumerate(shapes, 1) for pocket in shape.pockets]
    if not found:
        return {}
    return {
        "shape": [k for k, _, _ in found],
        "frame": [shape.frame for _, shape, _ in found],
        "volume_angstrom3": [pocket.volume for *_, pocket in found],
        "volume_at_start_angstrom3": [pocket.at_start for *_, pocket in found],
        "volume_around_start_angstrom3": [pocket.around for *_, pocket in found],
        "deviation_around_start_angstrom3": [pocket.deviation for *_, pocket in found],
        "residues": [residues_text(analysis, pocket.residues) for *_, pocket in found],
    }


def frame_shapes(analysis: Analysis) -> dict[str, Any]:
    """The column of frames.csv: 0 around the start, number of the shape, else empty."""
    part = analysis.get(OtherShapes)
    if part is None or part.groups is None:
        return {}
    shape: list[Any] = np.where(part.groups.rmsd <= part.groups.limit, 0, -1).tolist()
    for number, members in enumerate(part.groups.members, 1):
        for place in members:
            shape[place] = number
    return {"shape": ["" if number < 0 else number for number in shape]}


def shapes_json(analysis: Analysis) -> dict[str, Any]:
    """JSON-ready values."""
    part = analysis[OtherShapes]
    found = [
        {
            "frame": shape.frame,
            "frames": shape.frames,
            "rmsd": shape.rmsd,
            "mean_rmsd_within": shape.spread,
            "turned": turns_of(analysis, shape),
            "contacts_gone": None if shape.gone is None else len(shape.gone),
            "pockets": [
                {
                    "volume": pocket.volume,
                    "volume_at_start": pocket.at_start,
                    "volume_around_start": [pocket.around, pocket.deviation],
                    "residues": residues_text(analysis, pocket.residues).split(),
                }
                for pocket in shape.pockets
            ],
        }
        for shape in part.shapes
    ]
    return {"shapes_looked_for": part.looked_for, "shapes": found, "frames_alone": part.alone} | (
        {} if part.known is None else {"known_pairs_quartiles": part.known.tolist()}
    )
