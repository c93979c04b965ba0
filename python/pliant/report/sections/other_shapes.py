# SPDX-License-Identifier: MIT
"""What else the molecule could look like: shapes, what turned, contacts gone, pockets opened."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from pliant.base.console import Table
from pliant.base.verdict import Verdict
from pliant.measure.shapes.other_shapes import REMARK_OF_SHAPES, OtherShapes, Shape, other_shapes
from pliant.measure.stages.analysis import Analysis
from pliant.measure.stages.names import chains_of
from pliant.measure.stages.parts import ReferenceStructure
from pliant.report.multi_model import write_chosen
from pliant.report.section import Columns, Picture, Values
from pliant.report.sections.domains import split_stretches
from pliant.report.sections.headings import OTHER
from pliant.report.sections.measured import Measured, has, told
from pliant.report.sections.shape_pictures import shape_pictures

NO_POPULATION = (
    "The number of frames in a shape is not a population: it reflects how the frames were drawn, "
    "not energies or how often the molecule has that shape."
)
MORE_ROOM = (
    "Places with more room than at the start: pockets, or, where it is hundreds of Å³ more, often "
    "the gap between parts that moved away from each other"
)
#: contacts of a shape that the page names
NAMED = 4
#: what is less is neither open nor compact, or opens nor closes
LEAST_OPENNESS, LEAST_WIDER = 0.3, 0.01


def _verdict(analysis: Analysis) -> Verdict | None:
    """Whether there are other shapes; None where it makes no sense to ask."""
    part, count = analysis.get(OtherShapes), len(analysis.frames)
    if part is None:
        return None
    if part.groups is None:
        around = f"all {count} frames were drawn around the start."
        hint = "pliant sample --sampler reach goes further."
        return Verdict("open", f"No other shapes were searched for: {around}", hint)
    start, limit = analysis[ReferenceStructure].name, part.groups.limit
    alone = f"{part.alone} frames are far from the start and from each other. " * bool(part.alone)
    if not part.shapes:
        sentence = f"No other shape: no two frames beyond {limit:.1f} Å from {start} are alike."
        return Verdict("open", sentence, alone.strip())
    off = [shape.rmsd for shape in part.shapes]
    many = f"{len(off)} other shapes" if len(off) > 1 else "One other shape"
    far = f"{min(off):.1f} to {max(off):.1f}" if len(off) > 1 else f"{off[0]:.1f}"
    total = sum(shape.frames for shape in part.shapes)
    details = f"{total} of {count} frames are of {'these' if len(off) > 1 else 'it'}. {alone}"
    beyond = sum(map(part.is_beyond, part.shapes))
    if beyond and part.known is not None:
        details += f"{beyond} of {len(off)} are {_too_far(part.known)}. "
    return Verdict("open", f"{many}, {far} Å from {start} (CA).", details + NO_POPULATION)


def _too_far(known: np.ndarray) -> str:
    return f"further away than three of four known pairs of proteins as soft ({known[2]:.1f} Å)"


def _speaks_for(part: OtherShapes, shape: Shape) -> str:
    """What makes a shape plausible."""
    known, texts = part.known, []
    if known is not None and known[0] <= shape.rmsd <= known[2]:
        texts.append("as far as known pairs")
    if _goes_on(part, shape) < 0:
        closes = shape.wider < 0
        texts.append(f"{'closes, as open' if closes else 'opens, as compact'} proteins do")
    if shape.made:
        texts.append(f"pairs of residues that come together: {shape.made}")
    return "; ".join(texts) or "–"


def _speaks_against(part: OtherShapes, shape: Shape) -> str:
    """What makes it less so."""
    texts = []
    if part.known is not None and part.is_beyond(shape):
        texts.append(f"beyond the {part.known[2]:.1f} Å of most known pairs")
    if _goes_on(part, shape) > 0:
        opens = shape.wider > 0
        texts.append(f"{'opens further, though open' if opens else 'closes, though compact'}")
    return "; ".join(texts) or "–"


def _goes_on(part: OtherShapes, shape: Shape) -> int:
    """1 where an open start opens further or a compact one closes, -1 the other way round; 0 where
    it does neither, or the start is neither."""
    if abs(part.openness) < LEAST_OPENNESS or abs(shape.wider) < LEAST_WIDER:
        return 0
    return 1 if part.openness * shape.wider > 0 else -1


def turns_of(analysis: Analysis, shape: Shape) -> list[dict[str, Any]]:
    """Each piece that turned: its stretches, degrees, and the hinges at its ends."""
    atoms, turns = analysis.universe.atoms[analysis[OtherShapes].sites], shape.turns
    every, chains = analysis.residue_labels, chains_of(atoms)
    labels = [every[k] for k in atoms.resindices]
    turned = []
    for k in range(1, len(turns.angles)):
        parts = split_stretches(np.flatnonzero(turns.piece == k), chains)
        beside = [pair for pair in turns.hinges if k in turns.piece[pair]]
        residues = [[labels[part[0]], labels[part[-1]]] for part in parts]
        hinges = [[labels[a], labels[b]] for a, b in beside]
        angle = float(turns.angles[k])
        turned.append({"residues": residues, "degrees": angle, "hinges": hinges})
    return turned


def turns_text(analysis: Analysis, shape: Shape) -> str:
    """What turned, in words."""
    texts = []
    for turn in turns_of(analysis, shape):
        stretches = ", ".join(f"{a} to {b}" for a, b in turn["residues"])
        hinges = ", ".join(f"{a}/{b}" for a, b in turn["hinges"])
        about = f" about {hinges}" if hinges else ""
        texts.append(f"{stretches} by {turn['degrees']:.0f}°{about}")
    return "; ".join(texts) or "nothing as a whole: it bends"


def _contacts_gone(analysis: Analysis, shape: Shape) -> list[str]:
    """Names of the contacts of the start that a shape lacks."""
    contacts = analysis.source.contacts
    if contacts is None or shape.gone is None:
        return []
    labels, owners = analysis.residue_labels, analysis.universe.atoms.resindices
    pairs = owners[contacts.joints[shape.gone]]
    return [f"{labels[a]}-{labels[b]}" for a, b in pairs]


def _contacts_text(analysis: Analysis, shape: Shape) -> str:
    """How many, and some of them."""
    if shape.gone is None:
        return "not recorded"
    names = list(dict.fromkeys(_contacts_gone(analysis, shape)))
    more = f" and {len(names) - NAMED} more pairs" if len(names) > NAMED else ""
    return f"{len(shape.gone)}: {', '.join(names[:NAMED])}{more}" if names else "0"


def residues_text(analysis: Analysis, residues: np.ndarray) -> str:
    """Names of residues."""
    labels = analysis.residue_labels
    return " ".join(labels[k] for k in residues)


def _tables(analysis: Analysis) -> Iterator[Table]:
    part, start = analysis[OtherShapes], analysis[ReferenceStructure].name
    if part.groups is None:
        none = (f"all {part.near} around {start}", "none looked for: see --sampler reach")
        yield Table("", ("frames", "other shapes"), [none])
        return
    columns = ["how many", "frame shown", "RMSD (Å)", "spread (Å)", "what rotated", "contacts gone"]
    columns += ["for it", "against it"]
    yield Table(NO_POPULATION, ("frames are", *columns), list(_shape_rows(analysis)))
    pockets = [
        (
            f"shape {number}",
            f"{pocket.volume:.0f}",
            f"{pocket.at_start:.0f}",
            f"{pocket.around:.0f} ± {pocket.deviation:.0f}",
            residues_text(analysis, pocket.residues),
        )
        for number, shape in enumerate(part.shapes, 1)
        for pocket in shape.pockets
    ]
    headers = ("", "room (Å³)", "at the start", "around it, ± standard deviation", "lined by")
    yield Table(MORE_ROOM, headers, pockets)


def _shape_rows(analysis: Analysis) -> Iterator[Sequence[str]]:
    """Around the start, each shape, and frames that are alone."""
    part, start = analysis[OtherShapes], analysis[ReferenceStructure].name
    limit = f"up to {part.groups.limit:.1f}" if part.groups else ""
    yield f"around {start}", f"{part.near}", "–", limit, *"–" * 5
    for number, shape in enumerate(part.shapes, 1):
        what = turns_text(analysis, shape), _contacts_text(analysis, shape)
        far = f"{shape.rmsd:.1f}", f"{shape.spread:.1f}"
        speaks = _speaks_for(part, shape), _speaks_against(part, shape)
        yield f"shape {number}", f"{shape.frames}", f"{shape.frame}", *far, *what, *speaks
    if part.alone or not part.shapes:
        yield "like no other", f"{part.alone}", "–", "beyond", *"–" * 5
    if part.known is not None:
        half = f"{part.known[0]:.1f} to {part.known[2]:.1f}"
        pairs = "half of the known pairs of structures of proteins as soft"
        yield pairs, "–", "–", half, *"–" * 5


def _columns(analysis: Analysis) -> Columns:
    """One row per shape; no columns without any."""
    shapes = analysis[OtherShapes].shapes
    if not shapes:
        return {}
    turned = [turns_text(analysis, shape) if turns_of(analysis, shape) else "" for shape in shapes]
    columns = {
        "shape": np.arange(1, len(shapes) + 1),
        "frame": [shape.frame for shape in shapes],
        "frames": [shape.frames for shape in shapes],
        "rmsd_angstrom": [shape.rmsd for shape in shapes],
        "mean_rmsd_within_angstrom": [shape.spread for shape in shapes],
        "largest_turn_degrees": [float(shape.turns.angles.max()) for shape in shapes],
        "turned": turned,
        "rmsd_within_rigid_pieces_angstrom": [shape.turns.within for shape in shapes],
        "pairs_come_together": [shape.made for shape in shapes],
        "radius_of_gyration_change": [shape.wider for shape in shapes],
        "beyond_known_pairs": [int(analysis[OtherShapes].is_beyond(shape)) for shape in shapes],
    }
    if shapes[0].gone is not None:
        gone = [_contacts_gone(analysis, shape) for shape in shapes]
        columns["contacts_gone"] = [len(names) for names in gone]
        columns["contacts"] = [" ".join(names) for names in gone]
    return columns


def _pocket_columns(analysis: Analysis) -> Columns:
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


def _per_frame(analysis: Analysis) -> Columns:
    """0 around the start, number of the shape, else empty."""
    groups = analysis[OtherShapes].groups
    if groups is None:
        return {}
    shape: list[int | str] = np.where(groups.rmsd <= groups.limit, 0, -1).tolist()
    for number, members in enumerate(groups.members, 1):
        for place in members:
            shape[place] = number
    return {"shape": ["" if number == -1 else number for number in shape]}


def _values(analysis: Analysis) -> Values:
    part = analysis[OtherShapes]
    found = [
        {
            "frame": shape.frame,
            "frames": shape.frames,
            "rmsd": shape.rmsd,
            "mean_rmsd_within": shape.spread,
            "turned": turns_of(analysis, shape),
            "contacts_gone": None if shape.gone is None else len(shape.gone),
            "pairs_come_together": shape.made,
            "radius_of_gyration_change": shape.wider,
            "beyond_known_pairs": part.is_beyond(shape),
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


def _files(analysis: Analysis, folder: Path) -> list[Path]:
    part, path = analysis[OtherShapes], folder / "shapes.pdb"
    if not part.shapes:
        return []
    write_chosen(analysis, part.places, path, REMARK_OF_SHAPES)
    return [path]


OTHER_SHAPES = Measured(
    name="other shapes",
    stage="shapes",
    measure=other_shapes,
    heading=OTHER,
    applies=has(OtherShapes),
    verdict=_verdict,
    values=_values,
    lines=told("other shapes", _verdict),
    tables=_tables,
    columns={"shapes": _columns, "shape_pockets": _pocket_columns},
    per_frame=_per_frame,
    pictures=[
        Picture(
            "shapes",
            shape_pictures,
            "The frame that stands for each shape, in colour, superposed by its largest piece "
            "(blue) on the start, in grey. Other colours are pieces that turned against it, dots "
            "are hinge residues; seen along the axis of the largest turn. The bar is 10 Å.",
            suits=lambda analysis: bool(analysis[OtherShapes].shapes),
        )
    ],
    files=_files,
    methods={
        "Other shapes": (
            "Frames drawn to reach further than those around the start, if their RMSD from it (CA "
            "or P, superposed) is above 3 Å and above that of every frame around it. Up to eight "
            "are shown, at least 3 Å apart: each next one adds most to how well all frames are "
            "stood for, 1 - RMSD / 8 Å, where plausible frames count more. Plausible is what known "
            "pairs of structures have in common: they are as far apart as others of that softness, "
            "open ones close and compact ones open. Of the 24 directions on which this was chosen, "
            "the first shape is nearer to the other known structure than the start is in 71 %, one "
            "of the first three in 90 %. The spread is the mean RMSD of the frames nearest to a "
            "shape from it; frames 8 Å from all shapes, or alone in one, are not listed. What "
            "rotated are pieces that are rigid from the start to that frame (see Domains); angles "
            "are against the largest. A contact is gone when the frame lets it go, or exceeds it "
            "by more than 0.1 Å; residues come together from beyond 10 to within 8 Å (CA)."
        ),
        "Known pairs": (
            "How far apart two known structures of a protein are, for the 16 of 58 starts whose "
            "network is as soft (1 / lowest eigenvalue of Kirchhoff's matrix of alpha carbons): "
            "the quartiles. All are proteins that are known to move, so others may move less; of "
            "proteins left out, 57 % lay between the quartiles; but this softness was chosen among "
            "17 measures on the same pairs. Of single chains only. It is a hint, no limit."
        ),
        "Pockets": (
            "Room for a sphere of 1.4 Å that none of 4 Å from outside comes within 2.4 Å of, on a "
            "grid of 1 Å, between heavy atoms of protein and nucleic acids: of a closed cavity it "
            "finds 94 to 97 % of the volume. Ligands and water count as empty; a cleft open to "
            "water is no pocket. Listed is what has 100 Å³ more room beside its residues than at "
            "the start, and more than the mean and two standard deviations of five frames around "
            "it."
        ),
    },
)
