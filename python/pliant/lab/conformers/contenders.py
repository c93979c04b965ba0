# SPDX-License-Identifier: MIT
"""Who makes conformers: ours, RDKit's ETKDGv3, CDPKit's CONFORGE, each by its public interface.

They work in processes of their own: CPU time is measured, and they may be killed. There this file
is run as ``checks/openmm/worker.py`` is. They are given a molecule in its start, never the known
conformer.
"""

from __future__ import annotations

import importlib.util
import pathlib
import resource
import signal
import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache, partial
from typing import Any

import numpy as np
import numpy.typing as npt
from rdkit import Chem, rdBase
from rdkit.Chem import Mol, rdDistGeom

import pliant
from pliant.checks.openmm import worker
from pliant.lab.conformers.known import start_of

Floats = npt.NDArray[np.float64]

_SEED = 11
_LEAST_RMSD = 0.3  #: Angstrom between conformers of CONFORGE, as of ours
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
    found = pliant.conformers(molecule, count, threads=1)
    return np.array([one.GetPositions() for one in found.GetConformers()])


def _etkdg(molecule: Mol, count: int) -> Floats:
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
    from CDPL import Base, ConfGen
    from CDPL import Chem as TheirChem

    read, text = TheirChem.BasicMolecule(), Chem.MolToMolBlock(molecule) + "$$$$\n"
    TheirChem.SDFMoleculeReader(Base.StringIOStream(text)).read(read)
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


def user_seconds() -> float:
    """CPU time of this process and of what it started."""
    kinds = (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)
    return sum(resource.getrusage(kind).ru_utime for kind in kinds)


@cache
def _warm_up(contender: Contender) -> None:
    """Imports and reads libraries of rules, which a program does once, are not counted."""
    contender.make(start_of(Chem.AddHs(Chem.MolFromSmiles("CCCCO"))), 2)


def make(contender: Contender, job: Mapping[str, Any]) -> dict[str, Floats]:
    """Conformers (F, N, 3), the user seconds that they took, and those of their start in them."""
    molecule = Chem.MolFromMolBlock(str(job["block"]), removeHs=False)
    Chem.AssignStereochemistryFrom3D(molecule)
    _warm_up(contender)
    before = user_seconds()
    signal.setitimer(signal.ITIMER_VIRTUAL, float(job["limit"]))  # which ends the process
    given = start_of(molecule) if contender.needs_start else molecule
    of_start = user_seconds() - before if contender.needs_start else 0.0
    frames = contender.make(given, int(job["count"]))
    signal.setitimer(signal.ITIMER_VIRTUAL, 0.0)
    seconds = user_seconds() - before
    return {"frames": frames, "seconds": np.array(seconds), "start_seconds": np.array(of_start)}


if __name__ == "__main__":
    rdBase.DisableLog("rdApp.*")
    kinds = {one.name: partial(make, one) for one in CONTENDERS}
    worker.main(pathlib.Path(sys.argv[1]), int(sys.argv[2]), kinds)
