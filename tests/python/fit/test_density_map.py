# SPDX-License-Identifier: MIT
"""Density maps between points, blurred, simulated and compared, against SciPy and NumPy."""

import numpy as np
import pytest
from MDAnalysisTests.datafiles import PDB_small
from scipy.ndimage import gaussian_filter, map_coordinates
from scipy.spatial.transform import Rotation

import pliant

DRAWS = np.random.default_rng(2)
VALUES = DRAWS.normal(size=(8, 9, 10)).astype(np.float32)
MAP = pliant.DensityMap(VALUES, [2, 1.5, 3], [-5, 0, 7])
HELICES = pliant.read("data/proteins/three_helices.pdb")


def atoms_at(positions, elements=None):
    return pliant.Structure(
        positions=positions, elements=[6] * len(positions) if elements is None else elements
    )


def test_a_map_is_what_it_was_made_of():
    assert MAP.shape == (8, 9, 10)
    assert np.array_equal(MAP.values, VALUES)
    assert not MAP.values.flags.writeable
    assert np.array_equal(MAP.origin, [-5, 0, 7])
    assert np.array_equal(MAP.steps, np.diag(MAP.spacing))


@pytest.mark.parametrize(
    ("values", "spacing", "message"),
    [
        (VALUES[0], 1, "shape"),
        (VALUES[:1], 1, "2 points or more"),
        (VALUES * np.inf, 1, "finite"),
        (VALUES, 0, "steps from 0.001"),
        (VALUES, np.nan, "steps from 0.001"),
    ],
)
def test_what_is_no_map_is_refused(values, spacing, message):
    with np.errstate(invalid="ignore"), pytest.raises(pliant.InputError, match=message):
        pliant.DensityMap(values, [spacing] * 3)


def test_values_between_points_are_linear():
    on_grid = DRAWS.uniform(0, np.subtract(MAP.shape, 1), size=(500, 3))
    values, _, outside = MAP.at(MAP.origin + on_grid * MAP.spacing)
    expected = map_coordinates(VALUES.astype(float), on_grid.T, order=1, prefilter=False)
    assert np.allclose(values, expected, atol=1e-12)
    assert outside == 0


def test_gradients_are_those_of_the_values():
    places = MAP.origin + DRAWS.uniform(0, np.subtract(MAP.shape, 1), (500, 3)) * MAP.spacing
    gradients = MAP.at(places)[1]
    for axis, step in enumerate(1e-6 * np.eye(3)):
        change = (MAP.at(places + step)[0] - MAP.at(places - step)[0]) / 2e-6
        # Where a step crosses from one cell into the next, the gradient is none of both.
        assert np.sum(np.abs(change - gradients[:, axis]) > 1e-6) <= 3


def test_outside_there_is_nothing():
    last = MAP.origin + np.subtract(MAP.shape, 1) * MAP.spacing
    values, gradients, outside = MAP.at([MAP.origin, last, last + 0.01, [np.nan, 0, 0]])
    assert np.array_equal(values, [VALUES[0, 0, 0], VALUES[-1, -1, -1], 0, 0])
    assert np.all(gradients[2:] == 0)
    assert outside == 2


@pytest.mark.parametrize("resolution", [3.0, 8.0, 60.0])
def test_blurred_is_gaussian(resolution):
    sigma = 0.225 * resolution / MAP.spacing
    expected = gaussian_filter(VALUES.astype(float), sigma, mode="constant", truncate=5)
    assert np.allclose(MAP.blurred(resolution).values, expected, atol=2e-6)


def test_normalized_has_mean_0_and_deviation_1():
    values = MAP.normalized().values.astype(float)
    assert np.allclose([values.mean(), values.std()], [0, 1], atol=1e-6)
    with pytest.raises(pliant.InputError, match="all values are 0"):
        pliant.DensityMap(0 * VALUES, [1, 1, 1]).normalized()


@pytest.mark.parametrize("like", [None, MAP])
def test_simulated_is_a_sum_of_gaussians(like):
    positions = DRAWS.uniform(0, 12, size=(20, 3))
    elements = DRAWS.integers(1, 20, 20)
    found = pliant.DensityMap.from_structure(atoms_at(positions, elements), 6.0, like=like)
    places = found.origin + np.array(list(np.ndindex(found.shape))) @ found.steps
    squared = ((places[:, None] - positions) ** 2).sum(-1)
    expected = np.exp(-squared / (2 * (0.225 * 6.0) ** 2)) @ elements
    # Beyond 5 sigma there is nothing: exp(-12.5) of what an atom has.
    assert np.abs(found.values.ravel() - expected).max() < 4e-6 * elements.max() * 3
    assert found.shape == (like.shape if like else found.shape)


def test_a_molecule_agrees_with_its_own_map():
    own = pliant.DensityMap.from_structure(HELICES, 8.0)
    assert own.correlation(HELICES, 8.0) == pytest.approx(1)
    local = own.local_correlation(HELICES, 8.0)
    assert local.shape == (HELICES.residue_count,)
    assert local.min() > 0.999
    scaled = pliant.DensityMap(3 * np.array(own.values) - 7, own.spacing, own.origin)
    assert scaled.correlation(HELICES, 8.0) == pytest.approx(1)
    assert own.unexplained(HELICES)[0] == 0


def test_correlation_is_that_of_the_points_near_to_atoms():
    positions = np.array([[0.0, 5, 15], [3, 6, 18]])
    simulated = pliant.DensityMap.from_structure(atoms_at(positions), 5.0, like=MAP)
    places = MAP.origin + np.array(list(np.ndindex(MAP.shape))) @ MAP.steps
    distances = np.sqrt(((places[:, None] - positions) ** 2).sum(-1))
    near = distances.min(1) <= 4.0
    expected = np.corrcoef(VALUES.ravel()[near], simulated.values.ravel()[near])[0, 1]
    assert MAP.correlation(atoms_at(positions), 5.0, 4.0) == pytest.approx(expected, abs=1e-6)


def test_a_residue_that_is_elsewhere_is_found():
    moved = np.array(HELICES.positions)
    chosen = HELICES.residue_of == 10
    moved[chosen] += [12, 0, 0]
    own = pliant.DensityMap.from_structure(HELICES, 5.0)
    wrong = pliant.read("data/proteins/three_helices.pdb")
    wrong.positions[:] = moved
    local = own.local_correlation(wrong, 5.0)
    assert np.argmin(local) == 10


def test_density_without_atoms_is_found():
    extra = HELICES.positions.mean(0) + np.array([0, 0, 45])
    both = atoms_at(
        np.vstack([HELICES.positions, DRAWS.normal(extra, 2, (150, 3))]),
        [*HELICES.elements, *[6] * 150],
    )
    share, centers, shares = pliant.DensityMap.from_structure(both, 8.0).unexplained(HELICES)
    assert 0.1 < share < 0.9
    assert np.linalg.norm(centers[0] - extra) < 1.5
    assert shares.sum() <= share + 1e-12
    assert list(shares) == sorted(shares, reverse=True)
    with pytest.raises(pliant.OptionError, match="threshold = 1000000"):
        MAP.unexplained(HELICES, 1e6)


def test_a_molecule_outside_of_the_map_is_refused():
    far = atoms_at([[500.0, 0, 0], [501, 0, 0]])
    with pytest.raises(pliant.InputError, match="the molecule is outside of the map"):
        MAP.correlation(far, 8.0)
    assert np.array_equal(MAP.local_correlation(far, 8.0), [0])


def test_a_surface_holds_the_volume_that_its_level_was_chosen_for():
    own = pliant.DensityMap.from_structure(HELICES, 8.0)
    vertices, triangles = own.surface(own.level_around(20_000))
    assert vertices.shape == (len(vertices), 3)
    assert triangles.dtype == np.uint32
    one, two, three = np.moveaxis(vertices[triangles], 1, 0)
    volume = np.einsum("ij,ij->", one, np.cross(two, three)) / 6
    assert volume == pytest.approx(20_000, rel=0.05)
    with pytest.raises(pliant.OptionError, match=r"^level = 1000000: must be at most the greatest"):
        own.surface(1e6)
    with pytest.raises(pliant.OptionError, match=r"^volume = 0: must be above 0"):
        own.level_around(0)


@pytest.mark.parametrize("resolution", [0, -1, np.nan, 1e9])
def test_no_such_resolution(resolution):
    for call in (MAP.blurred, lambda given: MAP.correlation(HELICES, given)):
        with pytest.raises(pliant.OptionError, match=r"^resolution = .*: must be from 0.5 to 200"):
            call(resolution)


def turned_away(positions, seed):
    """Turned at random about its center, and 30 Angstrom away from where it was."""
    center = positions.mean(0)
    away = np.random.default_rng(seed).normal(size=3)
    turned = Rotation.random(random_state=seed).apply(positions - center)
    return turned + center + 30 * away / np.linalg.norm(away)


@pytest.mark.filterwarnings("ignore:.*no element:pliant.PliantWarning")
@pytest.mark.parametrize("beside", [False, True], ids=["alone", "beside_a_larger_one"])
def test_a_molecule_is_put_back_into_its_map(beside):
    positions, elements = HELICES.positions, np.array(HELICES.elements)
    density = pliant.DensityMap.from_structure(HELICES, 8.0)
    if beside:
        larger = pliant.read(PDB_small)
        shift = positions.mean(0) - larger.positions.mean(0) + np.array([0, 50, 0])
        both = np.vstack([positions, larger.positions + shift])
        density = pliant.DensityMap.from_structure(
            atoms_at(both, [*elements, *larger.elements]), 8.0
        )
    for seed in range(1 if beside else 3):
        away = atoms_at(turned_away(positions, seed), elements)
        placed, _ = density.place(away, 8.0)
        assert np.sqrt(((placed - positions) ** 2).sum(1).mean()) < 0.5
