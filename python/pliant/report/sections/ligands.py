# SPDX-License-Identifier: MIT
"""Which contacts the ligands of a molecule keep and lose, and which poses they take."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from pliant.base.console import Table
from pliant.measure.pockets.ligand_contacts import (
    APART,
    LigandContacts,
    LigandFound,
    ligand_contacts,
)
from pliant.measure.stages.analysis import Analysis
from pliant.report.multi_model import write_chosen
from pliant.report.section import Columns, Values
from pliant.report.sections.contacts import KEPT
from pliant.report.sections.headings import LIGANDS
from pliant.report.sections.measured import Measured, has

CAPTION = (
    "Contacts are found anew in each frame, by geometry. Those that the model holds "
    "(held_contacts.csv) are kept by construction: only what is lost tells something. A share of "
    "frames is no probability. Bonds that a ligand without hydrogens gives are guessed. What less "
    "than 5 % of frames have, and the start has not, is in ligand_contacts.csv only."
)
POSES = "Groups of poses, {} Å apart. How large a group is does not say how often it occurs."
REMARK = "poses of the ligands, one a group; populations are not claimed"
MOST_POSES = 10  #: in the table
LEAST_SHARE = 0.05  #: of frames, of contacts in the table that the start has not


def _kind(name: str) -> str:
    return name.replace("_", " ")


def _told(ligand: LigandFound) -> str:
    start = ligand.at_start
    kept = np.count_nonzero(start & (ligand.share >= KEPT))
    poses = len(ligand.medoids)
    groups = f"{poses} groups of poses" if poses > 1 else "one group of poses"
    return (
        f"{ligand.name}: {groups}, up to {ligand.moved.max():.1f} Å from the start; {kept} of "
        f"{np.count_nonzero(start)} contacts kept in 90 % of frames"
    )


def _lines(analysis: Analysis) -> Iterator[tuple[str, str]]:
    for ligand in analysis[LigandContacts].ligands:
        yield "ligand", _told(ligand)


def _tables(analysis: Analysis) -> Iterator[Table]:
    part = analysis[LigandContacts]
    for ligand in part.ligands:
        is_shown = ligand.at_start | (ligand.share >= LEAST_SHARE)
        order = [k for k in np.lexsort((-ligand.share, ~ligand.at_start)) if is_shown[k]]
        rows = [
            (
                ligand.partners[k][0],
                _kind(ligand.partners[k][1]),
                "yes" if ligand.at_start[k] else "no",
                f"{ligand.share[k]:.0%}",
                f"{np.count_nonzero(~ligand.seen[:, k])}" if ligand.at_start[k] else "",
            )
            for k in order
        ]
        header = ("residue", "contact", "at the start", "in frames", "lost in")
        yield Table(f"{_told(ligand)}. {CAPTION}", header, rows)
        poses = [
            (
                f"{k + 1}",
                f"{np.count_nonzero(ligand.pose == k)}",
                f"{analysis.frames[part.places[place]]}",
                f"{ligand.moved[place]:.1f}",
            )
            for k, place in enumerate(ligand.medoids[:MOST_POSES])
        ]
        columns = ("group", "frames", "stood for by frame", "from the start (Å)")
        yield Table(POSES.format(f"{APART:g}"), columns, poses)


def _contact_columns(analysis: Analysis) -> Columns:
    """One row per contact of a ligand: kinds with one residue."""
    rows = [
        (ligand.name, *partner, int(start), share)
        for ligand in analysis[LigandContacts].ligands
        for partner, start, share in zip(
            ligand.partners, ligand.at_start, ligand.share.tolist(), strict=True
        )
    ]
    names = ("ligand", "residue", "kind", "at_start", "share_of_frames")
    return dict(zip(names, map(list, zip(*rows, strict=True)), strict=True)) if rows else {}


def _pose_columns(analysis: Analysis) -> Columns:
    """One row per frame looked at: the group and the r.m.s. distance of each ligand, and 1 for each
    contact that there is."""
    part = analysis[LigandContacts]
    columns: Columns = {"frame": analysis.frames[part.places]}
    for ligand in part.ligands:
        columns[f"{ligand.name} group"] = ligand.pose + 1
        columns[f"{ligand.name} from start (angstrom)"] = np.round(ligand.moved, 3)
        for (residue, kind), seen in zip(ligand.partners, ligand.seen.T, strict=True):
            columns[f"{ligand.name} {residue} {kind}"] = seen.astype(int)
    return columns


def _values(analysis: Analysis) -> Values:
    part = analysis[LigandContacts]

    def of(ligand: LigandFound) -> Values:
        contacts = zip(ligand.partners, ligand.at_start, ligand.share.tolist(), strict=True)
        return {
            "name": ligand.name,
            "contacts": [
                {"residue": residue, "kind": kind, "at_start": bool(start), "share": share}
                for (residue, kind), start, share in contacts
            ],
            "poses": [
                {
                    "frame": int(analysis.frames[part.places[place]]),
                    "frames": int(np.count_nonzero(ligand.pose == k)),
                    "from_start": float(ligand.moved[place]),
                }
                for k, place in enumerate(ligand.medoids)
            ],
        }

    found = [of(ligand) for ligand in part.ligands]
    return {"ligands": {"frames": len(part.places), "found": found}}


def _write_poses(analysis: Analysis, folder: Path) -> list[Path]:
    """A model for each group of each ligand."""
    part = analysis[LigandContacts]
    chosen = np.unique(np.concatenate([one.medoids[:MOST_POSES] for one in part.ligands]))
    path = folder / "ligand_poses.pdb"
    write_chosen(analysis, part.places[chosen], path, REMARK, overwrite=True)
    return [path]


LIGAND_CONTACTS = Measured(
    stage="ligands",
    measure=ligand_contacts,
    heading=LIGANDS,
    applies=has(LigandContacts),
    values=_values,
    lines=_lines,
    tables=_tables,
    columns={"ligand_contacts": _contact_columns, "ligand_frames": _pose_columns},
    files=_write_poses,
    methods={
        "ligands": (
            "Residues of six heavy atoms and more that are neither polymer nor water, and bonded "
            "to nothing else; up to 400 frames. Contacts are those that pliant contacts finds in a "
            "structure: a ligand without hydrogens in the file donates no hydrogen bond. Poses are "
            "compared as they lie, alpha carbons within 10 Å of the ligand superposed, each atom "
            "with the nearest that bonds and elements do not tell apart, and grouped by average "
            f"linkage at {APART:g} Å."
        )
    },
)
