# SPDX-License-Identifier: MIT
"""What is asked of conformers, the same for command and Python."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Any

from pliant._core import FileError, OptionError, conformer_rows
from pliant._extras import need
from pliant._refusals import shown
from pliant.conformers.core import A_CONFORMER, FRAMES

ENERGIES = ("auto", "none", "MMFF94s", "UFF", "own")
OF_RDKIT = ("MMFF94s", "UFF")
SALTS = ("largest", "refuse")
#: how the command calls each
_OPTIONS = {row["name"]: row.get("opposite", row["name"]) for row in conformer_rows()}


@dataclass(frozen=True)
class ConformerOptions:
    """Options of one molecule's conformers; ranges are checked by `check`."""

    most: int = 50  #: conformers of a molecule
    frames: int | None = None  #: candidates drawn, from all starts together
    starts: int = 5  #: structures with other lengths and angles to draw from
    rms: float = 0.5  #: Angstrom, heavy atoms; nearer ones are left out
    window: float | None = None  #: kcal/mol above the lowest energy
    energy: str = "own"  #: one of ENERGIES, or a force field of OpenMM (.xml)
    minimise: bool = False  #: by the energy
    seed: int = 0
    embed: bool = False  #: drawings, and molecules without hydrogens, are made 3-D by RDKit
    salts: str = "largest"  #: of several molecules in a record: the largest, or refuse
    amides: bool = False  #: secondary amides turn, too
    max_input: int = 2_000_000_000  #: bytes of a library, once it is decompressed
    smiles: str | None = None  #: of a ligand: its bond orders, charges and hydrogens
    #: of a ligand: what was given of `conformer_rows()`, by name
    molecule: dict[str, Any] = field(default_factory=dict)
    dashes: str = ""  #: before the names of options in messages: "--" for the command

    @property
    def candidates(self) -> int:
        """How many are drawn of a molecule."""
        return self.frames or max(FRAMES, A_CONFORMER * self.most)

    @property
    def remedy(self) -> str:
        """What helps where a molecule is not 3-D and whole."""
        asked = "--embed" if self.dashes else "embed=True"
        return f"{asked} makes it 3-D, with hydrogens, by RDKit"

    @property
    def of_more_input(self) -> str:
        """The option that allows larger libraries."""
        return "--max-input" if self.dashes else "max_input"

    @property
    def asked_smiles(self) -> str:
        """What gives the bond orders, charges and hydrogens of a ligand."""
        return "pliant conformers FILE --smiles TEXT" if self.dashes else "smiles=TEXT"

    def check(self) -> None:
        """Raises OptionError naming the option, what was expected and what was found."""
        dashes = self.dashes
        for name, least in (("most", 1), ("starts", 1), ("seed", 0), ("rms", 0), ("max_input", 1)):
            value = getattr(self, name)
            if not least <= value < math.inf:
                called = name if name != "most" else "max" if dashes else "n"
                raise OptionError(
                    f"{dashes}{called}: expected a number from {least}, found {shown(value)}"
                )
        if self.frames is not None and not self.frames >= 1:
            raise OptionError(
                f"{dashes}frames: expected a number from 1, found {shown(self.frames)}"
            )
        if self.window is not None and not 0 < self.window < math.inf:
            raise OptionError(
                f"{dashes}window: expected a number above 0, found {shown(self.window)}"
            )
        if self.salts not in SALTS:
            raise OptionError(
                f"{dashes}salts: expected {' or '.join(SALTS)}, found {shown(self.salts)}"
            )
        self._check_energy()

    def check_source(self, *, is_ligand: bool) -> None:
        """Raises OptionError for what only the file of one ligand has, or a Structure."""
        if self.molecule and not is_ligand:
            name = next(iter(self.molecule))
            if self.dashes:
                name = "--" + _OPTIONS[name].replace("_", "-")
            other = "" if self.dashes else ", or a Structure"
            raise OptionError(f"{name}: goes with a PDB, mmCIF or XYZ file of one ligand{other}")

    def _check_energy(self) -> None:
        dashes = self.dashes
        asked = f"{dashes}energy {self.energy}"
        if self.energy.lower().endswith(".xml"):
            if not Path(self.energy).is_file():
                raise FileError(f"{asked}: there is no such file")
            need(asked, "openmm")
        elif self.energy not in ENERGIES:
            known = ", ".join(ENERGIES)
            raise OptionError(
                f"{dashes}energy: expected {known} or a force field of OpenMM (.xml), found "
                f"{shown(self.energy)}"
            )
        if self.energy in OF_RDKIT:
            need(asked, "rdkit")
        if self.window is not None and self.energy == "none":
            raise OptionError(f"{dashes}window: needs an energy, not {dashes}energy none")
        if self.minimise and self.energy in ("none", "own"):
            raise OptionError(f"{dashes}minimise: needs MMFF94s, UFF or a force field, not {asked}")
        if self.minimise and self.energy == "auto":
            need(f"{dashes}minimise", "rdkit")

    def as_json(self) -> dict[str, Any]:
        """For the journal and ``--json``."""
        names = [one.name for one in fields(self) if one.name != "dashes"]
        return {name: getattr(self, name) for name in names}


USUAL = ConformerOptions()
