# SPDX-License-Identifier: MIT
"""Elastic networks beside numpy, and ensembles by numpy's own measures."""

from pathlib import Path

import expected_warnings
import numpy as np
import pytest

import pliant

MDA = pytest.importorskip("MDAnalysisTests.datafiles")
PAGE = Path(__file__).parents[3] / "src" / "pliant" / "sample" / "README.md"


@pytest.fixture(scope="module")
def kinase():
    """Adenylate kinase, 214 residues."""
    structure = expected_warnings.read_without_elements(MDA.PDB_small)
    structure.perceive_bonds()
    return structure


def nodes_apart(nodes):
    """Distances of nodes, infinite on the diagonal."""
    apart = np.linalg.norm(nodes[:, None] - nodes[None], axis=2)
    np.fill_diagonal(apart, np.inf)
    return apart


def hessian(nodes, springs):
    """Second derivatives of the energy of springs at rest, by the textbook."""
    apart = nodes_apart(nodes)
    along = (nodes[:, None] - nodes[None]) / apart[:, :, None]
    blocks = -np.einsum("ij,ija,ijb->iajb", springs, along, along)
    for i in range(len(nodes)):
        blocks[i, :, i] = -blocks[i].sum(axis=1)
    return blocks.reshape(3 * len(nodes), -1)


def lowest(springs, nodes, count=60):
    """Variances and modes, rows, of all but six motions of the whole."""
    values, vectors = np.linalg.eigh(hessian(nodes, springs))
    return 1.0 / values[6 : 6 + count], vectors[:, 6 : 6 + count].T


def same_modes(found, expected):
    """Whether variances are in the same ratios, and directions the same but for their sign."""
    variances, directions = found[0], found[1].reshape(len(found[0]), -1)
    np.testing.assert_allclose(
        variances / variances.sum(), expected[0] / expected[0].sum(), rtol=1e-8
    )
    np.testing.assert_allclose(np.abs((directions * expected[1]).sum(axis=1)), 1.0, rtol=1e-7)


@pytest.mark.parametrize(
    ("network", "spring"), [("anm", lambda r: (r < 15.0) * 1.0), ("pfanm", lambda r: r**-2.0)]
)
def test_modes_are_those_of_numpy(kinase, network, spring):
    found = pliant.network_modes(kinase, network)
    same_modes(found, lowest(spring(nodes_apart(found[2])), found[2]))


def test_gnm_is_that_of_numpy(kinase):
    variances, directions, nodes = pliant.network_modes(kinase, "gnm", 30)
    springs = (nodes_apart(nodes) < 10.0) * 1.0
    values, vectors = np.linalg.eigh(np.diag(springs.sum(axis=1)) - springs)
    np.testing.assert_allclose(variances[::3], 1.0 / values[1:11], rtol=1e-9)
    np.testing.assert_allclose(directions[::3, :, 1:], 0.0)
    np.testing.assert_allclose(
        np.abs((directions[::3, :, 0] * vectors[:, 1:11].T).sum(axis=1)), 1.0, rtol=1e-9
    )


def shared_springs(nodes):
    """Springs of contacts and of the chain, as the page on sampling has them."""
    apart = nodes_apart(nodes)
    near = (apart < 18.0) * 1.0
    share = (near @ near) / np.sqrt(np.outer(near.sum(axis=1), near.sum(axis=1)))
    contacts = ((6.0 / apart) ** 6 + 0.1 * (apart < 15.0)) * (
        share / share[apart < 8.0].mean()
    ) ** 2
    chain = np.zeros_like(contacts)
    for k in (1, 2, 3):
        i = np.flatnonzero(apart.diagonal(k) < 4.3 * k)
        chain[i, i + k] = chain[i + k, i] = 3.0
    return contacts, chain


def domains_by_scipy(nodes, variances, modes, count):
    """Clusters of average linkage by changes of distances in ten modes."""
    hierarchy = pytest.importorskip("scipy.cluster.hierarchy")
    apart = nodes_apart(nodes)
    along = (nodes[:, None] - nodes[None]) / apart[:, :, None]
    squares = np.zeros_like(apart)
    for variance, mode in zip(variances[:10], modes[:10], strict=True):
        u = mode.reshape(-1, 3)
        squares += variance * ((u[:, None] - u[None]) * along).sum(axis=2) ** 2
    upper = np.sqrt(squares)[np.triu_indices(len(nodes), 1)]
    return hierarchy.fcluster(hierarchy.linkage(upper, "average"), count, "maxclust")


def test_the_average_over_domains_is_that_of_numpy_and_scipy(kinase):
    found = pliant.network_modes(kinase)
    nodes = found[2]
    contacts, chain = shared_springs(nodes)
    whole = lowest(contacts + chain, nodes)
    mean = (whole[1].T * whole[0]) @ whole[1] / whole[0].sum()
    for count in (2, 3, 4):
        domain = domains_by_scipy(nodes, *whole, count)
        cut = np.where(domain[:, None] == domain[None], contacts, 0.1 * contacts)
        variances, modes = lowest(cut + chain, nodes)
        mean += (modes.T * variances) @ modes / variances.sum()
    values, vectors = np.linalg.eigh(mean / 4.0)
    same_modes(found, (values[::-1][:60], vectors[:, ::-1][:, :60].T))


@pytest.fixture(scope="module")
def ensemble(kinase):
    return pliant.sample(kinase, frames=12, seed=3)


def test_bars_are_whole_by_numpy(ensemble):
    framework = ensemble.model.framework
    a, b = framework.bars.T
    lengths = np.linalg.norm(ensemble.positions[:, a] - ensemble.positions[:, b], axis=2)
    assert ensemble.positions.shape == (12, framework.joint_count, 3)
    assert np.abs(lengths / framework.rest_lengths - 1.0).max() < 1e-10
    assert ensemble.max_residual < 1e-10
    assert ensemble.max_limit <= 0.08
    assert ensemble.max_overlap <= 0.08
    assert ensemble.failed == 0


def test_the_amplitude_is_reached_nearly(ensemble):
    """Exact units cannot follow all the way, and no frame goes further than it was asked."""
    assert 0.9 < ensemble.amplitude_reached < 1.5
    alpha = np.flatnonzero(ensemble.model.structure.names == "CA")
    frames = superposed(ensemble.positions, ensemble.model.positions, alpha)
    spread = frames - frames.mean(axis=0)
    rmsf = np.sqrt((spread**2).sum(axis=2).mean(axis=0))
    np.testing.assert_allclose(ensemble.rmsf, rmsf, rtol=1e-7)
    assert ensemble.amplitude_reached == pytest.approx(rmsf[alpha].mean(), rel=1e-7)
    assert ensemble.amplitude_asked == 1.4


def superposed(frames, start, fitted):
    """Each frame on the start by the fitted atoms (Kabsch)."""
    out = []
    goal = start[fitted].mean(axis=0)
    for frame in frames:
        centre = frame[fitted].mean(axis=0)
        u, _, vt = np.linalg.svd((frame[fitted] - centre).T @ (start[fitted] - goal))
        u[:, 2] *= np.sign(np.linalg.det(u @ vt))
        out.append((frame - centre) @ u @ vt + goal)
    return np.array(out)


def test_the_amplitude_may_be_that_of_models_or_b_factors(kinase, tmp_path):
    """Beside numpy."""
    alpha = np.flatnonzero(kinase.names == "CA")
    rng = np.random.default_rng(1)
    frames = [kinase.positions + rng.normal(scale=0.3, size=(1, 3)) for _ in range(3)]
    for frame in frames:
        frame[alpha] += rng.normal(scale=0.5, size=(len(alpha), 3))
    with pliant.PdbRecorder(tmp_path / "models.pdb", kinase) as recorder:
        for frame in frames:
            recorder.record(frame)
    with pytest.warns(pliant.PliantWarning, match="the amplitude is from 3 models: few"):
        found = pliant.sample(kinase, 1, amplitude=tmp_path / "models.pdb")
    assert found.amplitude_asked == pytest.approx(0.5 * np.sqrt(3 * 2 / 3), rel=0.05)
    assert found.amplitude_reason.startswith("3 models of ")
    with open(MDA.PDB_small) as file:
        b = np.array([float(line[60:66]) for line in file if line[12:16].strip() == "CA"])
    with pytest.warns(pliant.PliantWarning, match="the amplitude is from B factors, which contain"):
        found = pliant.sample(kinase, 1, amplitude="bfactors")
    assert found.amplitude_asked == pytest.approx(np.sqrt(3 * b / (8 * np.pi**2)).mean(), rel=1e-6)


def test_a_model_may_be_given_and_pieces_are_the_same(ensemble):
    with pytest.warns(pliant.PliantWarning, match="frames reach an amplitude of 0.56 of the 1.40"):
        piece = pliant.sample(ensemble.model, frames=2, first_frame=5, seed=3, sampler="modes")
    assert np.array_equal(piece.positions, ensemble.positions[5:7])


def test_what_makes_no_sense_is_refused(kinase, ensemble):
    with pytest.raises(pliant.OptionError, match="model: goes with a structure, not with a model"):
        pliant.sample(ensemble.model, model="protein")
    with pytest.raises(pliant.OptionError, match="frames = 0: must be a whole number from 1"):
        pliant.sample(kinase, frames=0)
    with pytest.raises(pliant.OptionError, match='no sampler named "mode"'):
        pliant.sample(kinase, sampler="mode")


def test_tables_have_what_options_name():
    assert [row.name for row in pliant.networks()] == ["shared", "anm", "pfanm", "gnm"]
    rows = PAGE.read_text().split("| sampler |")[1].split("\n\n")[0].splitlines()[2:]
    assert [row.split("`")[1] for row in rows] == [row.name for row in pliant.samplers()]
