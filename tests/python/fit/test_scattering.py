# SPDX-License-Identifier: MIT
"""Curves of molecules against closed forms, Debye's sum in numpy, and gemmi's form factors."""

from pathlib import Path

import gemmi
import numpy as np
import pytest
from pliant._core import form_factors, partial_profiles, scattering_groups

import pliant

pytest.importorskip("MDAnalysisTests")
import MDAnalysisTests

OPEN = Path(MDAnalysisTests.__file__).parent / "data" / "adk_open.pdb"
Q = np.linspace(0, 0.5, 26)
ELEMENTS = (1, 6, 7, 8, 9, 11, 12, 15, 16, 17, 19, 20, 25, 26, 27, 28, 29, 30, 34, 35, 53)

pytestmark = pytest.mark.filterwarnings("ignore::pliant.PliantWarning")


def of_carbons(points, q=Q):
    """(6, K) of bare carbon atoms."""
    count = len(points)
    return partial_profiles([6] * count, [0] * count, np.array([points], dtype=float), q)[0]


def carbon(q=Q):
    return form_factors([6], [0], q)[0]


def of_gemmi(element, q=Q):
    coefficients = gemmi.Element(element).it92
    return np.array([coefficients.calculate_sf((one / (4 * np.pi)) ** 2) for one in q])


@pytest.mark.parametrize("element", ELEMENTS)
def test_form_factors_are_those_of_the_international_tables(element):
    assert form_factors([element], [0], Q)[0] == pytest.approx(of_gemmi(element), rel=2e-6)


def test_an_element_that_is_not_in_the_table_is_like_its_neighbour():
    assert form_factors([48], [0], Q)[0] == pytest.approx(48 / 53 * of_gemmi(53), rel=2e-6)


def test_hydrogens_add_their_own_and_their_volume():
    vacuum, displaced, volumes = form_factors([6], [3], Q)
    bond = np.sinc(Q * 1.09 / np.pi)
    assert vacuum == pytest.approx(of_gemmi(6) + 3 * of_gemmi(1) * bond, rel=2e-6)
    assert volumes == pytest.approx([31.89])
    radius = 31.89 ** (1 / 3)
    assert displaced == pytest.approx(
        0.334 * 31.89 * np.exp(-(Q**2) * radius**2 / (4 * np.pi)), rel=2e-6
    )


@pytest.mark.parametrize("apart", [1.525, 3.025, 40.025])
def test_two_atoms(apart):
    found = of_carbons([[0, 0, 0], [0, 0, apart]])[0]
    assert found == pytest.approx(carbon() ** 2 * (2 + 2 * np.sinc(Q * apart / np.pi)), rel=1e-6)


def test_a_solid_sphere_and_its_radius_of_gyration():
    radius, q = 20.0, np.linspace(0, 0.25, 26)
    axis = np.arange(-20.5, 21, 2.0)
    points = np.stack(np.meshgrid(axis, axis, axis), axis=-1).reshape(-1, 3)
    points = points[np.linalg.norm(points, axis=1) < radius]
    found = of_carbons(points, q)[0] / carbon(q) ** 2 / len(points) ** 2
    x = q[1:] * radius
    exact = (3 * (np.sin(x) - x * np.cos(x)) / x**3) ** 2
    assert found[0] == pytest.approx(1)
    assert np.abs(found[1:] - exact).max() < 0.005
    rg = np.sqrt(3 * np.log(found[0] / found[1])) / q[1]
    assert rg == pytest.approx(np.sqrt((points**2).sum(axis=1).mean()), rel=0.002)


@pytest.fixture(scope="module")
def molecule():
    model = pliant.build_model(pliant.read(OPEN))
    atoms, elements, hydrogens = scattering_groups(model.structure)
    return np.asarray(model.positions)[atoms], elements, hydrogens


def test_a_protein_against_debyes_sum(molecule):
    points, elements, hydrogens = molecule
    q = np.linspace(0, 0.35, 8)
    found = partial_profiles(elements, hydrogens, points[None], q)[0]
    vacuum, displaced, _ = form_factors(elements, hydrogens, q)
    vacuum, displaced = (x.reshape(len(points), -1) for x in (vacuum, displaced))
    apart = np.linalg.norm(points[:, None] - points, axis=2)
    for k, one in enumerate(q):
        wave = np.sinc(one * apart / np.pi)
        v, d = vacuum[:, k], displaced[:, k]
        pairs = v @ wave @ v, v @ wave @ d, d @ wave @ d
        assert found[:3, k] == pytest.approx(pairs, rel=1e-3)
        seen = found[0, k] - 2 * found[1, k] + found[2, k]
        assert seen == pytest.approx((v - d) @ wave @ (v - d), rel=1e-3)


def test_hydrogens_on_carbon_count_that_are_not_there(molecule, tmp_path):
    pliant.convert(OPEN, tmp_path / "heavy.pdb", select="not element H")
    model = pliant.build_model(pliant.read(tmp_path / "heavy.pdb"))
    assert np.sum(np.asarray(model.structure.elements) == 1) < 500
    _, elements, hydrogens = scattering_groups(model.structure)
    assert np.array_equal(elements, molecule[1])
    assert np.array_equal(hydrogens[elements == 6], molecule[2][elements == 6])


def test_order_and_company_do_not_change_the_bits(molecule):
    points, elements, hydrogens = molecule
    some = np.random.default_rng(0).permutation(len(points))
    alone = partial_profiles(elements, hydrogens, points[None], Q)[0]
    moved = np.stack([points * 1.1, points, points * 0.9])
    assert np.array_equal(partial_profiles(elements, hydrogens, moved, Q)[1, :3], alone[:3])
    other = partial_profiles(elements[some], hydrogens[some], points[None, some], Q)[0]
    assert other == pytest.approx(alone, rel=1e-4)


def test_a_turned_molecule_has_the_same_curve(molecule):
    points, elements, hydrogens = molecule
    turn = np.linalg.qr(np.random.default_rng(1).normal(size=(3, 3)))[0]
    found = partial_profiles(elements, hydrogens, np.stack([points, points @ turn]), Q)
    curves = found[:, 0] - 2 * found[:, 1] + found[:, 2] + 2 * found[:, 3] - 2 * found[:, 4]
    assert curves[1] == pytest.approx(curves[0], rel=5e-3)


def test_water_is_where_the_solvent_touches():
    water = form_factors([8], [2], Q)[0]
    assert of_carbons([[0, 0, 0]])[5] == pytest.approx(water**2)
    assert of_carbons([[0, 0, 0]])[3] == pytest.approx(water * carbon())
    # A sphere of 1.9 + 1.8 Angstrom at the rim of an equal one keeps three quarters of its surface.
    two = of_carbons([[0, 0, 0], [0, 0, 3.7]])[5, 0]
    assert np.sqrt(two) / water[0] == pytest.approx(1.5, abs=2 / 64)
    axis = np.arange(-6.0, 7, 3)
    points = np.stack(np.meshgrid(axis, axis, axis), axis=-1).reshape(-1, 3)
    inside = np.argmin(np.linalg.norm(points, axis=1))
    rest = np.delete(points, inside, axis=0)
    assert of_carbons(points)[5] == pytest.approx(of_carbons(rest)[5])


def test_amplitudes_at_zero_are_squares(molecule):
    points, elements, hydrogens = molecule
    vv, vd, dd, vw, dw, ww = partial_profiles(elements, hydrogens, points[None], [0.0])[0, :, 0]
    assert np.sqrt(vv) == pytest.approx((elements + hydrogens).sum(), rel=1e-3)
    assert vd**2 == pytest.approx(vv * dd)
    assert vw**2 == pytest.approx(vv * ww)
    assert dw**2 == pytest.approx(dd * ww)


def test_what_is_wrong_is_said():
    with pytest.raises(pliant.InputError, match=r"frames: expected 2 positions each, .* found 1"):
        partial_profiles([6, 6], [0, 0], np.zeros((1, 1, 3)), Q)
    with pytest.raises(pliant.InputError, match=r"frames: frame 1 is not finite"):
        partial_profiles([6], [0], np.array([[[0, 0, 0]], [[np.nan, 0, 0]]]), Q)
    with pytest.raises(
        pliant.InputError, match=r"distances of at most 20000 Angstrom, found 1000000"
    ):
        of_carbons([[0, 0, 0], [1e6, 0, 0]])
    with pytest.raises(pliant.InputError, match="hydrogens: expected one for each element"):
        form_factors([6], [0, 0], Q)
    with pytest.raises(pliant.InputError, match=r"row 1: expected an atomic number"):
        form_factors([6, 0], [0, 0], Q)
