# SPDX-License-Identifier: MIT
"""Conformers of drugs by tools of others: PoseBusters' checks, GFN2-xTB's energies."""

import os
import warnings
from functools import cache
from types import SimpleNamespace

import numpy as np
import pytest

import pliant

pytest.importorskip("rdkit")
from pliant.jobs.conformers import energies, options
from rdkit import Chem
from rdkit.Chem import rdDistGeom
from rdkit.Chem import rdForceFieldHelpers as ForceFields

os.environ.setdefault("OMP_NUM_THREADS", "1")  # of tblite, which is loaded later
BOHR, KCAL = 0.529177211, 627.509474
DRUGS = {
    "amlodipine": "CCOC(=O)C1=C(COCCN)NC(C)=C(C(=O)OC)C1c1ccccc1Cl",
    "atenolol": "CC(C)NCC(O)COc1ccc(CC(N)=O)cc1",
    "bupropion": "CC(NC(C)(C)C)C(=O)c1cccc(Cl)c1",
    "captopril": "C[C@H](CS)C(=O)N1CCC[C@H]1C(=O)O",
    "celecoxib": "Cc1ccc(cc1)-c1cc(nn1-c1ccc(cc1)S(N)(=O)=O)C(F)(F)F",
    "citalopram": "CN(C)CCCC1(OCc2cc(C#N)ccc12)c1ccc(F)cc1",
    "diazepam": "CN1C(=O)CN=C(c2ccccc2)c2cc(Cl)ccc12",
    "fluconazole": "OC(Cn1cncn1)(Cn1cncn1)c1ccc(F)cc1F",
    "gliclazide": "Cc1ccc(cc1)S(=O)(=O)NC(=O)NN1CC2CCCC2C1",
    "ibuprofen": "CC(C)Cc1ccc(cc1)[C@H](C)C(=O)O",
    "metoclopramide": "CCN(CC)CCNC(=O)c1cc(Cl)c(N)cc1OC",
    "propranolol": "CC(C)NCC(O)COc1cccc2ccccc12",
    "sertraline": "CN[C@H]1CC[C@@H](c2ccc(Cl)c(Cl)c2)c2ccccc12",
    "sulfamethoxazole": "Cc1cc(NS(=O)(=O)c2ccc(N)cc2)no1",
    "tramadol": "CN(C)C[C@H]1CCCC[C@]1(O)c1cccc(OC)c1",
    "warfarin": "CC(=O)CC(c1ccccc1)C1=C(O)c2ccccc2OC1=O",
}


#: for GFN2: six of them, for it takes long
SOME = ("atenolol", "bupropion", "captopril", "citalopram", "sulfamethoxazole", "warfarin")
FEW = 20
FLAT = "non-aromatic_ring_non-flatness"
#: MMFF94s and GFN2-xTB both have its dihydropyridine flat, which PoseBusters takes for a fault
FLAT_RINGS = {"amlodipine": {FLAT}}


@cache
def conformers_of(name, energy="auto", count=50):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", pliant.PliantWarning)  # on centres that are left open
        return pliant.conformers(DRUGS[name], count, energy=energy)


def each_alone(molecule):
    for one in molecule.GetConformers():
        alone = Chem.Mol(molecule, True)
        alone.AddConformer(one, assignId=True)
        yield alone


def relaxed(molecule, steps):
    """Positions of all conformers after so many steps of MMFF94s."""
    terms = ForceFields.MMFFGetMoleculeProperties(molecule, "MMFF94s")
    for alone in each_alone(molecule):
        field = ForceFields.MMFFGetMoleculeForceField(alone, terms)
        field.Initialize()
        field.Minimize(maxIts=steps)
        yield alone.GetConformer().GetPositions()


def gfn2(molecule, positions):
    """kcal/mol in water, by tblite itself."""
    tblite = pytest.importorskip("tblite.interface")
    elements = np.array([atom.GetAtomicNum() for atom in molecule.GetAtoms()])
    found = tblite.Calculator("GFN2-xTB", elements, positions / BOHR)
    found.set("verbosity", 0)
    found.add("alpb-solvation", "water")
    return found.singlepoint().get("energy") * KCAL


def as_they_come(molecule):
    return [one.GetPositions() for one in molecule.GetConformers()]


def ranking(name, energy):
    """Spearman's rank correlation with GFN2 after 50 steps of MMFF94s."""
    made = conformers_of(name, energy, FEW)
    ours = [one.GetDoubleProp("pliant_energy") for one in made.GetConformers()]
    theirs = [gfn2(made, positions) for positions in relaxed(made, 50)]
    return np.corrcoef(np.argsort(np.argsort(ours)), np.argsort(np.argsort(theirs)))[0, 1]


@pytest.mark.long
@pytest.mark.parametrize("name", DRUGS)
def test_every_conformer_passes_posebusters(name):
    posebusters = pytest.importorskip("posebusters")
    found = posebusters.PoseBusters(config="mol").bust(each_alone(conformers_of(name)), None, None)
    assert {check for check in found if not found[check].all()} <= FLAT_RINGS.get(name, set())


@pytest.mark.long
def test_ranks_are_those_of_gfn2_as_far_as_the_page_says():
    assert np.median([ranking(name, "auto") for name in SOME]) > 0.35
    assert np.median([ranking(name, "GFN2") for name in SOME]) > 0.6


@pytest.mark.long
def test_strain_by_gfn2_is_below_that_of_etkdg():
    ours, theirs = [], []
    for name in SOME:
        made, options = conformers_of(name, count=10), rdDistGeom.ETKDGv3()
        options.randomSeed = 1
        others = Chem.Mol(made, True)
        rdDistGeom.EmbedMultipleConfs(others, 10, options)
        lowest = min(gfn2(made, positions) for positions in relaxed(made, 500))
        ours.append(np.median([gfn2(made, at) for at in as_they_come(made)]) - lowest)
        theirs.append(np.median([gfn2(made, at) for at in as_they_come(others)]) - lowest)
    assert max(ours) < 15.0
    assert np.median(ours) < 0.5 * np.median(theirs)


def test_gfn2_is_that_of_tblite():
    pytest.importorskip("tblite")
    for given in ({}, {"minimise": True}):
        made = pliant.conformers("OCC(C)=O", 4, energy="GFN2", frames=40, starts=2, **given)
        name = made.GetProp("pliant_energy_name")
        assert name.startswith("GFN2-xTB in water (ALPB), tblite ")
        assert name.endswith(", minimised by MMFF94s") == bool(given)
        energies = [one.GetDoubleProp("pliant_energy") for one in made.GetConformers()]
        assert energies == sorted(energies)
        assert energies == pytest.approx([gfn2(made, at) for at in as_they_come(made)], abs=1e-3)


def test_a_conformer_whose_electrons_do_not_converge_is_left_out_and_told(monkeypatch):
    class Tblite:
        """Converges every other time, or never."""

        calls = 0

        def __init__(self, *_, **__):
            Tblite.calls += 1

        def set(self, *_): ...
        def add(self, *_): ...
        def get(self, _):
            return -1.0

        def singlepoint(self):
            if Tblite.calls % Tblite.every == 0:
                raise RuntimeError("SCF not converged")
            return self

    monkeypatch.setattr(options, "need", lambda *_: None)
    monkeypatch.setattr(energies.metadata, "version", lambda _: "1")
    monkeypatch.setattr(energies, "tblite", SimpleNamespace(Calculator=Tblite))
    asked = {"energy": "GFN2", "frames": 40, "starts": 2}
    Tblite.every = 2
    made = pliant.conformers(pliant.from_smiles("OCC(C)=O"), 4, **asked)
    assert len(made.positions) == 2
    told = "2 conformers left out: GFN2-xTB in water (ALPB) does not converge"
    assert told in made.notes
    Tblite.every = 1
    with pytest.raises(pliant.InputError, match=r"^GFN2-xTB in water \(ALPB\): no energy of 4 con"):
        pliant.conformers("OCC(C)=O", 4, **asked)
