# SPDX-License-Identifier: MIT
"""Conformers of small molecules (samplers torsions), against RDKit's view of the same molecules."""

import numpy as np
import pytest

import pliant

pytest.importorskip("rdkit")
from rdkit import Chem
from rdkit.Chem import AllChem, rdMolTransforms

MOLECULES = {
    "ibuprofen": "CC(C)Cc1ccc(cc1)[C@H](C)C(=O)O",
    "threonine amide": "C[C@@H](O)[C@H](N)C(=O)NC",
    "fentanyl": "CCC(=O)N(c1ccccc1)C1CCN(CCc2ccccc2)CC1",
    "menthol": "CC(C)[C@@H]1CC[C@@H](C)C[C@H]1O",
    "lactone": "O=C1CCCCCCCCCCO1",
    "muscone": "C[C@@H]1CCCCCCCCCCCCC(=O)C1",
    "cyclic peptide": "O=C1CNC(=O)[C@H](C)NC(=O)CNC(=O)[C@@H](C)NC(=O)CNC(=O)[C@H](CO)N1",
    "paracyclophane": "C1CCCCc2ccc(CCCCC1)cc2",
    "cis decalol": "O[C@H]1CC[C@H]2CCCC[C@H]2C1",
    "testosterone": "C[C@]12CC[C@H]3[C@H]([C@@H]1CC[C@@H]2O)CCC4=CC(=O)CC[C@]34C",
    "tropine": "CN1[C@H]2CC[C@@H]1C[C@H](O)C2",
    "charged": "C[NH2+]CCC(=O)[O-]",
    "crotonoyl proline": "C/C=C/C(=O)N1CCC[C@H]1C(=O)O",
    "Z butenyl": "C/C=C\\CN(C)C(=O)[C@@H](C)O",
}


def molecule(smiles, tmp_path):
    """RDKit's molecule with one conformer, and its file."""
    made = Chem.AddHs(Chem.MolFromSmiles(smiles))
    AllChem.EmbedMolecule(made, randomSeed=7)
    AllChem.MMFFOptimizeMolecule(made)
    path = tmp_path / "molecule.sdf"
    Chem.MolToMolFile(made, str(path))
    return made, path


@pytest.fixture(params=MOLECULES)
def sampled(request, tmp_path):
    made, path = molecule(MOLECULES[request.param], tmp_path)
    return made, pliant.sample(pliant.read(path), 60)


def with_positions(made, positions):
    copy = Chem.Mol(made)
    copy.RemoveAllConformers()
    conformer = Chem.Conformer(copy.GetNumAtoms())
    conformer.SetPositions(np.asarray(positions, dtype=np.float64))
    copy.AddConformer(conformer)
    return copy


def at_puckered_rings(made, one, other):
    """Which pairs lie across an angle that has a bond of a ring of five or six for a side."""
    atoms = {k for ring in made.GetRingInfo().AtomRings() if len(ring) < 7 for k in ring}
    atoms = {k for k in atoms if not made.GetAtomWithIdx(k).GetIsAromatic()}
    return np.array([(a in atoms) or (b in atoms) for a, b in zip(one, other, strict=True)])


def test_lengths_and_angles_are_those_of_the_start(sampled):
    """Angles at puckered rings change with their form, by up to 0.12 Angstrom."""
    made, ensemble = sampled
    near = Chem.GetDistanceMatrix(made)
    one, other = np.nonzero(np.triu((near == 1) | (near == 2)))
    start = made.GetConformer().GetPositions()
    wanted = np.linalg.norm(start[one] - start[other], axis=1)
    gives_way = at_puckered_rings(made, one, other) & (near[one, other] == 2)
    off = np.array([np.linalg.norm(x[one] - x[other], axis=1) - wanted for x in ensemble.positions])
    assert np.abs(off[:, ~gives_way]).max() < 2e-4  # of the file's digits
    assert np.abs(off).max() < 0.1205
    assert ensemble.max_residual < 1e-10


def with_stereo(made, positions):
    """Isomeric SMILES, of handedness and double bonds as positions show them."""
    copy = Chem.RemoveAllHs(with_positions(made, positions))
    Chem.AssignStereochemistryFrom3D(copy)
    return Chem.MolToSmiles(copy)


def test_handedness_and_double_bonds_are_kept(sampled):
    made, ensemble = sampled
    start = with_stereo(made, made.GetConformer().GetPositions())
    for frame in ensemble.positions:
        assert with_stereo(made, frame) == start


def test_atoms_keep_their_distance(sampled):
    made, ensemble = sampled
    far = np.nonzero(np.triu(Chem.GetDistanceMatrix(made) > 3))
    elements = np.array([atom.GetAtomicNum() for atom in made.GetAtoms()])
    heavy = (elements[far[0]] > 1) & (elements[far[1]] > 1)
    start = made.GetConformer().GetPositions()
    at_start = np.linalg.norm(start[far[0]] - start[far[1]], axis=1)[heavy]
    least = np.minimum(2.5, at_start) - 0.1
    for frame in ensemble.positions:
        assert np.all(np.linalg.norm(frame[far[0]] - frame[far[1]], axis=1)[heavy] > least)


def test_rotors_are_those_of_rdkit(tmp_path):
    """Each goes all round the circle: of 1 the mean of exp(i torsion) does not turn."""
    from rdkit.Chem.rdMolDescriptors import CalcNumRotatableBonds

    made, path = molecule(MOLECULES["ibuprofen"], tmp_path)
    heavy = Chem.RemoveHs(made)
    frames = pliant.sample(pliant.read(path), 400).positions[3::4]  # torsions from all the circle
    rotor = Chem.MolFromSmarts("*~[!$(*#*)&!D1]-&!@[!$(*#*)&!D1]~*")
    means = {}
    for i, a, b, j in heavy.GetSubstructMatches(rotor):
        points = frames[:, [i, a, b, j]]
        along = points[:, 2] - points[:, 1]
        one = np.cross(points[:, 1] - points[:, 0], along)
        other = np.cross(along, points[:, 3] - points[:, 2])
        cosine = np.sum(one * other, axis=1)
        sine = np.sum(np.cross(one, other) * along, axis=1) / np.linalg.norm(along, axis=1)
        means[frozenset((a, b))] = abs(np.mean(np.exp(1j * np.arctan2(sine, cosine))))
    assert len(means) == CalcNumRotatableBonds(heavy)
    assert max(means.values()) < 0.6


def usual(ensemble):
    """Frames whose torsions are near those that are usual: three of four."""
    return ensemble.positions[np.arange(len(ensemble.positions)) % 4 != 3]


def angles_about(made, pattern, positions):
    """(frames) degrees from 0 to 360 of the first match."""
    four = made.GetSubstructMatch(Chem.MolFromSmarts(pattern))
    conformers = (with_positions(made, x).GetConformer() for x in positions)
    return np.array([rdMolTransforms.GetDihedralDeg(c, *four) for c in conformers]) % 360


def test_tertiary_amides_are_cis_and_trans(tmp_path):
    """Turned by 180 degrees as a whole: whatever the start's torsion is, others are not met."""
    made, path = molecule("CCC(=O)N(C)CC", tmp_path)
    positions = pliant.sample(pliant.read(path), 60).positions
    found = angles_about(made, "O=C-N-[CH3]", positions)
    start = angles_about(made, "O=C-N-[CH3]", [made.GetConformer().GetPositions()])[0]
    turned = np.abs((found - start + 90) % 360 - 90 - 180) < 0.01
    kept = np.abs((found - start + 180) % 360 - 180) < 0.01
    assert np.all(turned | kept)
    assert 15 < np.sum(turned) < 45


@pytest.mark.parametrize(
    ("smiles", "pattern"), [("CCC(=O)NCC", "O=C-N-[CH2]"), ("CCC(=O)OCC", "O=C-O-C")]
)
def test_other_amides_and_esters_stay(smiles, pattern, tmp_path):
    made, path = molecule(smiles, tmp_path)
    positions = pliant.sample(pliant.read(path), 60).positions
    found = angles_about(made, pattern, positions)
    assert np.abs((found + 180) % 360 - 180).max() < 25  # Z


def test_rings_of_five_pucker_at_each_atom(tmp_path):
    """The atom furthest from the mean plane, and its side."""
    made, path = molecule("CC1CCCC1", tmp_path)
    ring = made.GetRingInfo().AtomRings()[0]
    seen = set()
    for x in pliant.sample(pliant.read(path), 200).positions[:, ring]:
        centred = x - x.mean(axis=0)
        normal = sum(np.cross(centred[k], centred[(k + 1) % 5]) for k in range(5))
        heights = centred @ normal / np.linalg.norm(normal)
        seen.add((int(np.abs(heights).argmax()), float(np.sign(heights[np.abs(heights).argmax()]))))
    assert len({atom for atom, _ in seen}) >= 4
    assert len(seen) >= 6


def test_rings_of_six_take_both_chairs(tmp_path):
    """From a twist-boat, whose lengths and angles chairs can have as well."""
    made, path = molecule("CC1CCCCC1", tmp_path)
    ensemble = pliant.sample(pliant.read(path), 40)
    ring = made.GetRingInfo().AtomRings()[0]

    def torsions(positions):
        copy = with_positions(made, positions).GetConformer()
        around = [[ring[(k + m) % 6] for m in range(4)] for k in range(6)]
        return np.array([rdMolTransforms.GetDihedralDeg(copy, *four) for four in around])

    start = torsions(made.GetConformer().GetPositions())
    assert np.abs(start).min() < 40
    found = np.array([torsions(frame) for frame in ensemble.positions])
    chairs = found[np.abs(found).min(axis=1) > 45]
    assert len(chairs) > 15
    assert np.all(np.diff(np.sign(chairs), axis=1) != 0)
    assert set(np.sign(chairs[:, 0])) == {1.0, -1.0}


def chairs_of(made, positions):
    """(frames, rings of six) 1 and -1: the two chairs, 0: none."""
    signs = []
    for ring in made.GetRingInfo().AtomRings():
        first = ring.index(min(ring))
        ring = ring[first:] + ring[:first]
        ring = ring if ring[1] < ring[-1] else ring[:1] + ring[:0:-1]
        four = [[ring[(k + m) % 6] for m in range(4)] for k in range(6)]
        conformers = [with_positions(made, x).GetConformer() for x in positions]
        found = np.array(
            [[rdMolTransforms.GetDihedralDeg(c, *at) for at in four] for c in conformers]
        )
        alternates = np.all(np.diff(np.sign(found), axis=1) != 0, axis=1)
        signs.append(
            np.where(alternates & (np.abs(found).min(axis=1) > 20), np.sign(found[:, 0]), 0)
        )
    return np.array(signs, dtype=int).T


def test_cis_decalin_turns_over_as_a_whole(tmp_path):
    """Both rings at once: one chair alone cannot turn over."""
    made, path = molecule("C1CC[C@H]2CCCC[C@H]2C1", tmp_path)
    chairs = chairs_of(made, pliant.sample(pliant.read(path), 100).positions)
    both = {tuple(row) for row in chairs if np.all(row != 0)}
    assert len(both) == 2
    one, other = both
    assert np.all(np.array(one) == -np.array(other))


def test_trans_decalin_keeps_its_chairs(tmp_path):
    """It has boats, but no second pair of chairs."""
    made, path = molecule("C1CC[C@@H]2CCCC[C@H]2C1", tmp_path)
    chairs = chairs_of(made, pliant.sample(pliant.read(path), 100).positions)
    assert len({tuple(row) for row in chairs if np.all(row != 0)}) == 1
    assert np.sum(np.all(chairs != 0, axis=1)) > 30
    assert np.any(chairs == 0)


def test_bridged_rings_take_chairs_and_boats(tmp_path):
    made, path = molecule("C1CC2CCCC(C1)C2", tmp_path)
    chairs = chairs_of(made, pliant.sample(pliant.read(path), 100).positions)
    assert {int(n) for n in np.sum(chairs != 0, axis=1)} >= {1, 2}


@pytest.mark.parametrize("smiles", ["C1CCc2ccccc2NC1", "C1Cc2ccccc2Cc2ccccc12"])
def test_rings_of_seven_beside_benzene_turn_over(tmp_path, smiles):
    """A bond of benzene keeps such a ring from turning as a loop."""
    made, path = molecule(smiles, tmp_path)
    (seven,) = [ring for ring in made.GetRingInfo().AtomRings() if len(ring) == 7]
    rows = []
    for x in pliant.sample(pliant.read(path), 60).positions:
        at = with_positions(made, x).GetConformer()
        around = [[seven[(k + j) % 7] for j in range(4)] for k in range(7)]
        rows.append([rdMolTransforms.GetDihedralDeg(at, *four) for four in around])
    signs = {tuple(np.sign(np.where(np.abs(row) < 25, 0, row)).astype(int)) for row in rows}
    assert any(tuple(-sign for sign in row) in signs for row in signs)  # mirror images


def test_rigid_rings_are_those_of_one_form(tmp_path):
    _, path = molecule("CCCC1CC2CCC1C2", tmp_path)
    ensemble = pliant.sample(pliant.read(path), 20)
    ring = [3, 4, 5, 6, 7, 8, 9]
    apart = ensemble.positions[:, ring][:, :, None] - ensemble.positions[:, ring][:, None]
    lengths = np.linalg.norm(apart, axis=-1)
    assert np.abs(lengths - lengths[0]).max() < 1e-9


def heavy_conformers(made, positions):
    """Without hydrogens."""
    copy = Chem.Mol(made)
    copy.RemoveAllConformers()
    for x in positions:
        conformer = Chem.Conformer(copy.GetNumAtoms())
        conformer.SetPositions(np.asarray(x, dtype=np.float64))
        copy.AddConformer(conformer, assignId=True)
    return Chem.RemoveHs(copy)


@pytest.mark.long
def test_large_rings_find_the_conformers_of_rdkit(tmp_path):
    """Minima of MMFF within 10 kcal/mol. Bent at random, 1000 frames reached 0.57 of them."""
    made, path = molecule("O=C1CCCCCCCCCCCCCCO1", tmp_path)
    ours = heavy_conformers(made, pliant.sample(pliant.read(path), 300).positions)
    theirs = Chem.Mol(made)
    AllChem.EmbedMultipleConfs(theirs, 40, randomSeed=5)
    energies = np.array([e for _, e in AllChem.MMFFOptimizeMoleculeConfs(theirs, maxIters=2000)])
    theirs = Chem.RemoveHs(theirs)
    low = np.nonzero(energies < energies.min() + 10)[0]
    near = [
        min(AllChem.AlignMol(ours, theirs, k, int(m)) for k in range(ours.GetNumConformers()))
        for m in low
    ]
    assert len(low) > 20
    assert np.mean(np.array(near) < 0.75) > 0.8


def test_large_rings_have_staggered_torsions(tmp_path):
    """Nearly usual torsions, where a ring can close with them; at random a third is that far."""
    made, path = molecule("C1CCCCCCCCCCCCC1", tmp_path)
    frames = usual(pliant.sample(pliant.read(path), 52))
    ring = list(made.GetRingInfo().AtomRings()[0])
    copies = [with_positions(made, x).GetConformer() for x in frames]
    four = [[ring[(k + m) % 14] for m in range(4)] for k in range(14)]
    found = np.array([[rdMolTransforms.GetDihedralDeg(c, *at) for at in four] for c in copies])
    off = np.abs((found % 120) - 60)
    assert np.mean(off > 40) < 0.2
    anti = np.mean(np.abs(found) > 150)
    assert 0.25 < anti < 0.8


def test_esters_of_large_rings_stay_planar(tmp_path):
    made, path = molecule(MOLECULES["lactone"], tmp_path)
    positions = pliant.sample(pliant.read(path), 60).positions
    found = angles_about(made, "O=C-O-C", positions)
    start = angles_about(made, "O=C-O-C", [made.GetConformer().GetPositions()])[0]
    off = np.abs((found - start + 180) % 360 - 180)
    assert np.quantile(off, 0.9) < 25
    assert off.max() < 60


def test_preferred_torsions_are_staggered(tmp_path):
    made, path = molecule("CCCC", tmp_path)
    frames = usual(pliant.sample(pliant.read(path), 200))
    angles = np.array(
        [
            rdMolTransforms.GetDihedralDeg(with_positions(made, x).GetConformer(), 0, 1, 2, 3)
            for x in frames
        ]
    )
    off = np.abs((angles - 60 + 60) % 120 - 60)
    assert np.mean(off < 15) > 0.7  # one torsion of five is any angle
    counts = np.bincount(np.round((angles[off < 15] % 360) / 60).astype(int), minlength=6)
    assert counts[[0, 2, 4]].tolist() == [0, 0, 0]
    assert counts[3] > max(counts[1], counts[5])  # anti is lower than gauche
    assert min(counts[1], counts[5]) > 0


def test_loops_that_hang_on_rotors_turn_with_them(tmp_path):
    """A loop is cut at one atom, which stands twice in the plan of bodies."""
    _, path = molecule("C" * 16 + "C1CCCCCC1", tmp_path)
    ensemble = pliant.sample(pliant.read(path), 5)
    assert ensemble.failed == 0
    assert ensemble.max_residual < 1e-10
