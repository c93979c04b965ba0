# SPDX-License-Identifier: MIT
"""What is asked of conformers, the same for command and Python."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

from pliant._core import FileError, OptionError, conformer_options, job_rows
from pliant.base.extras import need
from pliant.base.refusals import shown

ENERGIES = ("auto", "none", "MMFF94s", "UFF", "own", "GFN2")
#: the packages that some need
_PACKAGES = {"MMFF94s": ["rdkit"], "UFF": ["rdkit"], "GFN2": ["rdkit", "tblite"]}
ROWS = job_rows("conformers")
#: how the command calls each
_OPTIONS = {row["name"]: row.get("opposite", row["name"]) for row in ROWS}


class ConformerOptions(SimpleNamespace):
    """Options of one molecule's conformers, by the names of ROWS; ranges are checked.

    `molecule` has what one ligand is read and prepared by, and is not as usual. `dashes` stand
    before the names of options in messages: "--" for the command.
    """

    def __init__(self, dashes: str = "", /, **given: Any) -> None:
        super().__init__(dashes=dashes, **conformer_options(**given))
        self.smiles = given.get("smiles")  # "" is none that is given, and wrong

    @property
    def remedy(self) -> str:
        """What helps where a molecule is not 3-D and whole."""
        asked = "--embed" if self.dashes else "embed=True"
        return f"{asked} makes it 3-D, with hydrogens, by RDKit"

    @property
    def asked_smiles(self) -> str:
        """What gives the bond orders, charges and hydrogens of a ligand."""
        return "pliant conformers FILE --smiles TEXT" if self.dashes else "smiles=TEXT"

    def called(self, name: str) -> str:
        """An option as messages have it: "--max-input" or "max_input"."""
        return "--" + _OPTIONS[name].replace("_", "-") if self.dashes else name

    def check_source(self, *, is_ligand: bool) -> None:
        """Raises OptionError for what only the file of one ligand has, or a Structure."""
        given = [*(["smiles"] if self.smiles is not None else []), *self.molecule]
        if given and not is_ligand:
            name, other = self.called(given[0]), "" if self.dashes else ", or a Structure"
            raise OptionError(f"{name}: goes with a PDB, mmCIF or XYZ file of one ligand{other}")

    def check_energy(self) -> None:
        """Raises OptionError or FileError for one that is not there, or does not do what it has to.

        MissingPackageError where its package is not installed.
        """
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
        need(asked, *_PACKAGES.get(self.energy, []))
        if self.window and self.energy == "none":
            raise OptionError(f"{dashes}window: needs an energy, not {dashes}energy none")
        if self.minimise and self.energy in ("none", "own"):
            raise OptionError(f"{dashes}minimise: needs MMFF94s, UFF or a force field, not {asked}")
        if self.minimise and self.energy == "auto":
            need(f"{dashes}minimise", "rdkit")

    def as_json(self) -> dict[str, Any]:
        """For the journal and ``--json``: what changes the result."""
        values = {**vars(self), **self.molecule}
        for name in ("dashes", "threads", "molecule"):
            del values[name]
        return values


USUAL = ConformerOptions()
