# SPDX-License-Identifier: MIT
"""Who makes conformers: ours, RDKit's ETKDGv3, CDPKit's CONFORGE, each by its public interface."""

from __future__ import annotations

import importlib.util
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from rdkit.Chem import Mol

Floats = npt.NDArray[np.float64]

_SEED = 11
_LEAST_RMSD = 0.3  #: Angstrom between conformers of CONFORGE, and of ours where many are asked for
_APART = 0.5  #: Angstrom between conformers of ours, as usual
_FEW = 50  #: conformers, at most, with the usual distance
_WINDOW = 20.0  #: kcal/mol above its best


@dataclass(frozen=True)
class Contender:
    """A way to make conformers from a molecule's graph and stereo."""

    name: str
    package: str  #: as it is imported
    distribution: str  #: as it is installed
    most: int  #: conformers that it is asked for
    make: Callable[[Mol, int], Floats]  #: (F, N, 3) Angstrom, F up to the number asked for
    is_prefix: bool = False  #: fewer conformers are the first ones of one run for the most
    needs_start: bool = False  #: is given one made by RDKit, whose time is counted

    @property
    def is_installed(self) -> bool:
        """Whether its package is."""
        return importlib.util.find_spec(self.package) is not None

    @property
    def how_to_install(self) -> str:
        """Says that it is left out, and what to do."""
        return f"{self.name} is left out: pip install {self.distribution}"


def _ours(molecule: Mol, count: int) -> Floats:
    """Best first. `pliant.conformers` draws from the start and from others that it makes."""
    import pliant

    apart = _APART if count <= _FEW else _LEAST_RMSD
    found = pliant.conformers(molecule, count, rms=apart, threads=1)
    return np.array([one.GetPositions() for one in found.GetConformers()])


def _etkdg(molecule: Mol, count: int) -> Floats:
    from rdkit import Chem
    from rdkit.Chem import rdDistGeom

    made = Chem.Mol(molecule)
    made.RemoveAllConformers()
    parameters: Any = rdDistGeom.ETKDGv3()
    parameters.randomSeed = _SEED
    parameters.numThreads = 1
    rdDistGeom.EmbedMultipleConfs(made, count, parameters)
    return np.array([one.GetPositions() for one in made.GetConformers()])


def _conforge(molecule: Mol, count: int) -> Floats:
    """As it comes, by energy. It says more than success or failure: what it made is its result.

    TOO_MUCH_SYMMETRY means that duplicates may be among them, and some versions keep what they had
    at a TIMEOUT. Only where nothing was made is its code a failure.
    """
    from CDPL import Base, Chem, ConfGen
    from rdkit.Chem import MolToMolBlock

    read = Chem.BasicMolecule()
    Chem.SDFMoleculeReader(Base.StringIOStream(MolToMolBlock(molecule) + "$$$$\n")).read(read)
    ConfGen.prepareForConformerGeneration(read)
    generator = ConfGen.ConformerGenerator()
    generator.settings.minRMSD = _LEAST_RMSD
    generator.settings.energyWindow = _WINDOW
    generator.settings.maxNumOutputConformers = count
    code = generator.generate(read)
    made = [generator.getConformer(k) for k in range(generator.getNumConformers())]
    if not made:
        raise RuntimeError(_code_name(code))
    return np.array([one.toArray(False) for one in made])


def _code_name(code: int) -> str:
    from CDPL.ConfGen import ReturnCode

    names = [
        name for name in dir(ReturnCode) if name.isupper() and getattr(ReturnCode, name) == code
    ]
    return names[0] if names else f"code {code}"


CONTENDERS = (
    Contender("Pliant", "pliant", "pliant", 1000, _ours, needs_start=True),
    Contender("ETKDGv3", "rdkit", "rdkit", 250, _etkdg),
    Contender("CONFORGE", "CDPL", "cdpkit", 250, _conforge, is_prefix=True),
)
