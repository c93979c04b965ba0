# SPDX-License-Identifier: MIT
"""Energies of conformers: our own with a part of RDKit's MMFF94s, by its MMFF94s or UFF, by a
force field of OpenMM, or by GFN2-xTB of tblite; kcal/mol.

MMFF94s: T. A. Halgren, J. Comput. Chem. 20 (1999) 720. UFF: A. K. Rappe et al., J. Am. Chem. Soc.
114 (1992) 10024. GFN2-xTB: C. Bannwarth et al., J. Chem. Theory Comput. 15 (2019) 1652; water as
ALPB: S. Ehlert et al., ibid. 17 (2021) 4250.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache
from importlib import metadata
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from pliant._core import InputError, Structure
from pliant.adapters.openmm import to_openmm
from pliant.base.extras import is_there, late

if TYPE_CHECKING:
    from rdkit.Chem import Mol

Chem = late("rdkit.Chem")
Fields = late("rdkit.Chem.rdForceFieldHelpers")
app = late("openmm.app")
openmm = late("openmm")
rdBase = late("rdkit.rdBase")
rdkit = late("rdkit")
tblite = late("tblite.interface")
unit = late("openmm.unit")

Positions = npt.NDArray[np.float64]

MOST_STEPS = 500  #: of a minimisation of one conformer
KJ_PER_KCAL = 4.184
KCAL_PER_HARTREE, BOHR = 627.509474, 0.529177211  #: BOHR in Angstrom
OWN = "Pliant's own energy, kcal/mol"
#: of our own, beside torsions and charges of MMFF94s; and the dielectric constant of these. Against
#: GFN2-xTB of relaxed conformers their ranks correlate better than those of either alone
OWN_SHARE, DIELECTRIC = 0.5, 3.0
MMFF_PART = "torsions and charges of MMFF94s"


@dataclass(frozen=True)
class Energy:
    """An energy of one molecule."""

    name: str  #: in words, with its unit
    of: Callable[[Positions], float]  #: of (N, 3) Angstrom
    minimised: Callable[[Positions], Positions] = np.copy  #: the same atoms at a minimum near by
    own_share: float = 0.0  #: of our own, which is added
    #: of those that are kept, instead of `of`, for one that costs more than all else; not-a-number
    #: where it has none
    of_kept: Callable[[Positions], float] | None = None


def energy_of(
    name: str, structure: Structure, molecule: Callable[[], Mol], minimise: bool = False
) -> Energy | None:
    """The energy asked for; None where it is our own, or where none is.

    `molecule` makes that of RDKit, and is asked for where RDKit is to work. To `minimise`, "auto"
    is MMFF94s or UFF. Raises InputError where the force field lacks parameters.
    """
    if name in ("none", "own") or (name == "auto" and not is_there("rdkit")):
        return None
    if name.lower().endswith(".xml"):
        return _of_openmm(name, structure)
    if name == "GFN2":
        return _of_gfn2(structure, molecule(), minimise)
    return _of_rdkit(name, molecule()) if minimise or name != "auto" else _beside_own(molecule)


def _beside_own(molecule: Callable[[], Mol]) -> Energy | None:
    """Torsions and damped charges of MMFF94s, beside our own energy; None where RDKit does not
    accept the molecule, or lacks parameters."""
    with rdBase.BlockLogs():
        try:
            own = _for_positions(molecule())
            Chem.SanitizeMol(own)
        except (InputError, ValueError):
            return None
        terms = Fields.MMFFGetMoleculeProperties(own, "MMFF94s")
    if terms is None:
        return None
    for left_out in ("Bond", "Angle", "StretchBend", "Oop", "VdW"):
        getattr(terms, f"SetMMFF{left_out}Term")(False)
    terms.SetMMFFDielectricConstant(DIELECTRIC)
    field = Fields.MMFFGetMoleculeForceField(own, terms)
    field.Initialize()
    name = f"Pliant's own energy, {MMFF_PART} (RDKit {rdkit.__version__}), kcal/mol"
    return Energy(
        name, lambda at: float(field.CalcEnergy(at.ravel().tolist())), own_share=OWN_SHARE
    )


def _for_positions(molecule: Mol) -> Mol:
    """A copy with one conformer, of zeros."""
    own: Mol = Chem.Mol(molecule, True)  # without conformers
    own.AddConformer(Chem.Conformer(own.GetNumAtoms()))
    return own


def _of_rdkit(name: str, molecule: Mol) -> Energy:
    own = _for_positions(molecule)
    used, field = name, None
    with rdBase.BlockLogs():
        if name != "UFF" and Fields.MMFFHasAllMoleculeParams(own):
            used = "MMFF94s"
            properties = Fields.MMFFGetMoleculeProperties(own, "MMFF94s")
            field = Fields.MMFFGetMoleculeForceField(own, properties)
        elif name != "MMFF94s" and Fields.UFFHasAllMoleculeParams(own):
            used = "UFF" if name == "UFF" else "UFF, as MMFF94s lacks parameters"
            field = Fields.UFFGetMoleculeForceField(own)
    if field is None:
        asked = "MMFF94s and UFF" if name == "auto" else name
        raise InputError(f"{asked} of RDKit: parameters of an atom are missing")
    field.Initialize()

    def of(positions: Positions) -> float:
        return float(field.CalcEnergy(positions.ravel().tolist()))

    def minimised(positions: Positions) -> Positions:
        own.GetConformer().SetPositions(np.ascontiguousarray(positions))
        if used == "MMFF94s":
            Fields.MMFFOptimizeMolecule(own, "MMFF94s", maxIters=MOST_STEPS)
        else:
            Fields.UFFOptimizeMolecule(own, maxIters=MOST_STEPS)
        found: Positions = own.GetConformer().GetPositions()
        return found

    return Energy(f"{used}, RDKit {rdkit.__version__}, kcal/mol", of, minimised)


@lru_cache(maxsize=1)
def _force_field(path: str) -> Any:
    return app.ForceField(path)


def _of_openmm(path: str, structure: Structure) -> Energy:
    modeller = to_openmm(structure)
    try:
        field = _force_field(path)
        system = field.createSystem(
            modeller.topology, nonbondedMethod=app.NoCutoff, constraints=None, rigidWater=False
        )
    except Exception as error:  # OpenMM raises plain ones
        raise InputError(f"{path}: {str(error).splitlines()[0]}") from None
    platform = openmm.Platform.getPlatformByName("Reference")  # the same bits each time
    context = openmm.Context(system, openmm.VerletIntegrator(0.001), platform)

    def of(positions: Positions) -> float:
        context.setPositions(positions / 10)
        found = context.getState(getEnergy=True).getPotentialEnergy()
        return float(found.value_in_unit(unit.kilojoule_per_mole)) / KJ_PER_KCAL

    def minimised(positions: Positions) -> Positions:
        context.setPositions(positions / 10)
        openmm.LocalEnergyMinimizer.minimize(context, maxIterations=MOST_STEPS)
        found = context.getState(getPositions=True).getPositions(asNumpy=True)
        return np.array(found.value_in_unit(unit.angstrom), dtype=np.float64)

    return Energy(f"{path}, OpenMM {openmm.__version__}, kcal/mol", of, minimised)


def _of_gfn2(structure: Structure, molecule: Mol, minimise: bool) -> Energy:
    """GFN2-xTB in water, of conformers that "auto" chooses (and minimises)."""
    chosen_by = energy_of("auto", structure, lambda: molecule, minimise)
    if chosen_by is None:
        chosen_by = Energy(OWN, lambda _: 0.0, own_share=1.0)
    charge, elements = float(Chem.GetFormalCharge(molecule)), np.asarray(structure.elements)

    def of(positions: Positions) -> float:
        calculator = tblite.Calculator("GFN2-xTB", elements, positions / BOHR, charge=charge)
        calculator.set("verbosity", 0)
        try:
            calculator.add("alpb-solvation", "water")
            return float(calculator.singlepoint().get("energy")) * KCAL_PER_HARTREE
        except RuntimeError:  # its electrons do not converge
            return float("nan")

    at = f", minimised by {chosen_by.name.split(',')[0]}" if minimise else ""
    name = f"GFN2-xTB in water (ALPB), tblite {metadata.version('tblite')}, kcal/mol{at}"
    return replace(chosen_by, name=name, of_kept=of)
