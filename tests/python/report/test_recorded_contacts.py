# SPDX-License-Identifier: MIT
"""Which contact of the model is held, broken or off in which frame: in files and reports."""

import csv
from pathlib import Path

import h5py
import numpy as np
import pytest
from pliant.trajectory.opened import one_file
from pliant.trajectory.recover.recover import recover

import pliant
from pliant import analyse

pytestmark = pytest.mark.usefixtures("no_drawing")

PEPTIDE = Path(__file__).parents[3] / "data" / "molecules" / "cyclic_hexapeptide.pdb"
FRAMES = 400
CONTACT_ENERGY = 3.0  # kcal/mol


@pytest.fixture(scope="module")
def diluted(tmp_path_factory):
    path = tmp_path_factory.mktemp("diluted") / "d.h5md"
    with pytest.warns(pliant.PliantWarning, match="held too tightly to move that far"):
        pliant.sample(
            pliant.read(PEPTIDE),
            frames=FRAMES,
            sampler="dilute",
            contact_energy=CONTACT_ENERGY,
            amplitude=0.3,
            output=path,
        )
    return path


def test_each_is_on_as_often_as_its_energy_says(diluted):
    contacts = one_file(diluted).contacts
    assert contacts.states.shape == (FRAMES, len(contacts.kinds))
    shares = contacts.shares(np.arange(FRAMES))
    assert (shares[:, 1] == 0).all()
    np.testing.assert_allclose(shares.sum(axis=1), 1, rtol=1e-14)
    on = 1 - np.exp(-np.abs(contacts.energies) / CONTACT_ENERGY)
    error = np.sqrt(on * (1 - on) / FRAMES)
    assert (np.abs(shares[:, 0] - on) < 4 * error + 1e-12).all()
    assert len(set(contacts.states.sum(axis=1).tolist())) > 1


def test_the_report_has_a_row_for_each(diluted, tmp_path):
    folder = tmp_path / "report"
    analyse(diluted, folder, start=100)
    with open(folder / "held_contacts.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    contacts = one_file(diluted).contacts
    assert [row["kind"] for row in rows] == contacts.kinds
    share = (contacts.states[100:] == 2).mean(axis=0)
    np.testing.assert_allclose([float(row["share_off"]) for row in rows], share)
    names = pliant.read(PEPTIDE).names
    assert rows[0]["first"].rpartition(":")[2] in names


@pytest.mark.long
def test_energies_are_those_of_the_model_in_kcal(diluted, tmp_path):
    analyse(diluted, tmp_path / "report")
    with open(tmp_path / "report" / "held_contacts.csv", encoding="utf-8") as file:
        written = [float(row["energy_kcal_per_mol"]) for row in csv.DictReader(file)]
    listed = pliant.build_model(pliant.read(PEPTIDE)).contacts["energy"]
    np.testing.assert_allclose(written, listed, rtol=1e-12)
    with h5py.File(diluted) as file:
        stored = file["parameters/limit/energy"]
        assert stored.attrs["unit"] == b"kJ mol-1" or stored.attrs["unit"] == "kJ mol-1"
        np.testing.assert_allclose(sorted(set(stored[:])), sorted(4.184 * listed), rtol=1e-12)


def test_they_are_saved_from_a_broken_file(diluted, tmp_path):
    recover(diluted, tmp_path / "saved.h5md")
    saved, before = one_file(tmp_path / "saved.h5md").contacts, one_file(diluted).contacts
    assert np.array_equal(saved.states, before.states)
    assert saved.kinds == before.kinds


@pytest.mark.long
def test_a_file_without_them_says_so(diluted, tmp_path):
    old = tmp_path / "old.h5md"
    old.write_bytes(diluted.read_bytes())
    with h5py.File(old, "a") as file:
        del file["connectivity/contact_states"]
    contacts = one_file(old).contacts
    assert contacts.states is None
    with pytest.raises(ValueError, match="does not say which contact is held"):
        contacts.shares(np.arange(3))
    assert not [path for path in analyse(old, tmp_path / "r").outputs["tables"] if "held" in path]


def test_a_run_of_bars_has_none(tmp_path):
    water = pliant.read_text("3\nwater\nO 0 0 0\nH 0.96 0 0\nH -0.24 0.93 0\n", "water.xyz")
    pliant.run(water, output=tmp_path / "w.h5md", steps=3)
    assert one_file(tmp_path / "w.h5md").contacts is None
