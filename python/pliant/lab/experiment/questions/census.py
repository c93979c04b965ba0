# SPDX-License-Identifier: MIT
"""How real molecules compare with the thesis' classes: components, cycles, bridges, blocks."""

from __future__ import annotations

from pathlib import Path

import numpy as np

import pliant
from pliant.base import style
from pliant.lab.experiment.document import Answer, Figure, Table, as_text
from pliant.lab.experiment.specimens import SMILES, Specimen, packaged_proteins, rdkit_molecules
from pliant.lab.experiment.statistics import number

TITLE = "How do real molecules compare with the thesis' classes?"

CLASSES = tuple(
    "tree 1-cycle-bar 1-cycle-ring 2-cycle-bars 2-cycle-shared 2-cycle-tree 2-cycle-path "
    "n-cycle".split()
)
SMALL = 20  #: bonds: steroids and porphyrin rings are about as large


def answer(out: Path, seed: int, quick: bool) -> Answer:
    """Counts on the bonds of molecules and proteins, and on the thesis' random graphs."""
    molecules, proteins, missing = _gather(quick)
    random = {
        kind: [
            pliant.generate(kind, seed, k).framework.graph_facts()
            for k in range(3 if quick else 20)
        ]
        for kind in CLASSES
    }
    every = [facts for group in random.values() for facts in group]
    small, large = ([one.framework.graph_facts() for one in own] for own in (molecules, proteins))
    tables = [_class_table(small), _specimen_table(molecules, proteins), _random_table(random)]
    return Answer(
        TITLE,
        _verdict(small, large, every),
        _paragraphs(missing, len(molecules)),
        as_text(tables),
        [_draw(small, large, every, out)],
    )


def _gather(quick: bool) -> tuple[list[Specimen], list[Specimen], list[str]]:
    names = list(SMILES)[:: 8 if quick else 1]
    proteins, missing = packaged_proteins()
    try:
        molecules = list(rdkit_molecules(names))
    except ImportError:
        return [], proteins, [*missing, "RDKit is not installed"]
    short = len(names) - len(molecules)
    if short:
        missing.append(f"RDKit found no positions for {short} of {len(names)} molecules")
    return molecules, proteins, missing


def _share(facts: pliant.GraphFacts) -> float:
    return facts.bars_in_blocks / max(facts.bars, 1)


def _rings(facts: pliant.GraphFacts) -> float:
    """Independent cycles a block."""
    return facts.cycles / facts.blocks if facts.blocks else 0.0


def _verdict(
    molecules: list[pliant.GraphFacts],
    proteins: list[pliant.GraphFacts],
    random: list[pliant.GraphFacts],
) -> str:
    parts = []
    if molecules:
        few = sum(f.cycles <= 2 for f in molecules)
        parts.append(
            f"{few} of {len(molecules)} small molecules are trees, 1-cycles or 2-cycles of the "
            f"thesis, and on average {100 * np.mean([_share(f) for f in molecules]):.0f} % of "
            "their bonds lie on cycles"
        )
    if proteins:
        cycles = [f.cycles for f in proteins]
        small = sum(f.largest_block <= SMALL for f in proteins)
        parts.append(
            f"{len(proteins)} proteins and peptides are n-cycles ({min(cycles)} to {max(cycles)} "
            "independent cycles), but mostly of small ring systems strung on a tree: in "
            f"{small} of them none has more than {SMALL} bonds, and the median has "
            f"{np.median([_rings(f) for f in proteins]):.2f} cycles a ring system and "
            f"{100 * np.median([_share(f) for f in proteins]):.0f} % of its bonds on cycles"
        )
    words = "; ".join(parts or ["no molecule could be made or read here"])
    cyclic = [_share(f) for f in random if f.cycles]
    return (
        words[:1].upper()
        + words[1:]
        + f". In the thesis' random cyclic graphs {100 * np.mean(cyclic):.0f} % of the bars do."
    )


def _paragraphs(missing: list[str], count: int) -> list[str]:
    words = [
        f"Bars are bonds. The {count} small molecules (chains, rings, fused rings, cages, "
        "macrocycles, drugs, natural products) were chosen for variety and are no fair sample of "
        "chemistry. Of protein files what has fewer than ten atoms (water, ions) is left out; the "
        "crystal structures have no hydrogens, hence fewer bars off cycles. A bridge is a bar on "
        "no cycle; a block is a ring system of two or more bars. Large ring systems of proteins "
        "are closed by disulfide bridges (neopetrosiamide) and by haems bound at several residues "
        "(cytochrome).",
        "For techniques this is good news: what proteins have many of are small ring systems that "
        "do not touch, each as easy as a 1-cycle or 2-cycle, and joined by bridges that are "
        "projected once (see blocks). The bars of the thesis' n-cycles join random pairs: "
        "their cycles share most of their bars.",
    ]
    return [*words, "Not counted: " + "; ".join(missing) + "."] if missing else words


def _class_table(facts: list[pliant.GraphFacts]) -> Table:
    table = Table(
        "Small molecules by number of independent cycles.",
        ["class", "molecules", "mean bars", "mean bars on cycles"],
    )
    groups = {"tree": (0, 0), "1-cycle": (1, 1), "2-cycle": (2, 2)}
    groups |= {"3 to 5 cycles": (3, 5), "6 and more": (6, 10**9)}
    for name, (low, high) in groups.items():
        own = [f for f in facts if low <= f.cycles <= high]
        if own:
            mean, share = np.mean([f.bars for f in own]), np.mean([_share(f) for f in own])
            table.rows.append([name, len(own), number(float(mean)), f"{100 * share:.0f} %"])
    return table


def _specimen_table(molecules: list[Specimen], proteins: list[Specimen]) -> Table:
    columns = ["name", "atoms", "bars", "components", "cycles", "bridges", "blocks"]
    columns += ["bars of the largest block", "bars on cycles"]
    table = Table("Each protein or peptide, and some molecules.", columns)
    for specimen in (*proteins, *molecules[:: max(1, len(molecules) // 12)]):
        f = specimen.framework.graph_facts()
        sizes = f.joints, f.bars, f.components, f.cycles, f.bridges, f.blocks, f.largest_block
        table.rows.append([specimen.name, *sizes, f"{100 * _share(f):.0f} %"])
    return table


def _random_table(random: dict[str, list[pliant.GraphFacts]]) -> Table:
    table = Table(
        "The thesis' classes, as the default experiment makes them: means.",
        ["class", "bars", "cycles", "blocks", "bars on cycles"],
    )
    for kind, facts in random.items():
        sizes = np.mean([(f.bars, f.cycles, f.blocks) for f in facts], axis=0)
        share = f"{100 * np.mean([_share(f) for f in facts]):.0f} %"
        table.rows.append([kind, *map(number, sizes), share])
    return table


def _draw(
    molecules: list[pliant.GraphFacts],
    proteins: list[pliant.GraphFacts],
    random: list[pliant.GraphFacts],
    out: Path,
) -> Figure:
    groups = (
        ("thesis' random graphs", random, style.GREY, "o"),
        ("small molecules", molecules, style.BLUE, "^"),
        ("proteins, peptides", proteins, style.VERMILION, "s"),
    )
    with style.figure(1, 2, panel=(4.8, 3.7)) as (plot, axes):
        left, right = axes[0]
        for name, facts, color, marker in groups:
            look = {"s": 22, "color": color, "marker": marker, "alpha": 0.65, "linewidths": 0}
            bars = [f.bars for f in facts]
            left.scatter(bars, [f.cycles for f in facts], label=name, **look)
            right.scatter(bars, [100 * f.largest_block / max(f.bars, 1) for f in facts], **look)
        left.set(xscale="log", xlabel="bars", ylabel="independent cycles")
        left.set_yscale("symlog", linthresh=1)
        left.set_ylim(bottom=-0.2)
        right.set(xscale="log", xlabel="bars", ylabel="bars in the largest ring system (%)")
        plot.legend(*left.get_legend_handles_labels(), loc="outside upper center", ncols=3)
        style.save(plot, out / "census.png")
    return Figure(
        out / "census.png",
        "Left: independent cycles against size. Right: how much of the framework is one ring "
        "system; in most proteins next to nothing is.",
    )
