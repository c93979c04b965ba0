# SPDX-License-Identifier: MIT
"""A small experiment, run once, and tables made by hand."""

import sys
from pathlib import Path

import numpy as np
import pytest
from pliant.lab.experiment.laboratory import run_experiment
from pliant.lab.experiment.settings import Settings
from pliant.lab.experiment.table import Table

sys.path.insert(0, str(Path(__file__).parent))

SMALL = Settings(seed=7, graphs=3, forces=8)


@pytest.fixture(scope="session")
def experiment_folder(tmp_path_factory):
    """The folder of a finished small experiment. Do not write into it."""
    folder = tmp_path_factory.mktemp("experiment") / "study"
    run_experiment(SMALL, folder)
    return folder


@pytest.fixture
def made_table():
    """A function that makes a table of chosen numbers of sweeps: {(class, technique, w): rows}.

    Rows are (graphs, forces) whole numbers.
    """
    return make_table


def make_table(cells):
    columns = {name: [] for name in ("class", "graph", "force", "technique", "weighting", "sweeps")}
    for (kind, technique, weighting), rows in cells.items():
        rows = np.asarray(rows)
        graphs, forces = np.indices(rows.shape)
        columns["class"].append(np.full(rows.size, kind.encode(), "S20"))
        columns["technique"].append(np.full(rows.size, technique.encode(), "S20"))
        columns["weighting"].append(np.full(rows.size, weighting))
        columns["graph"].append(graphs.reshape(-1))
        columns["force"].append(forces.reshape(-1))
        columns["sweeps"].append(rows.reshape(-1))
    table = {name: np.concatenate(values) for name, values in columns.items()}
    reverse = np.char.endswith(table["technique"], b"_reverse")
    table["passes"] = np.where(reverse, (table["sweeps"] + 1) // 2, table["sweeps"])
    table["projections"] = 10 * table["sweeps"]
    table["converged"] = np.ones(len(table["sweeps"]), bool)
    table["final_residual"] = np.zeros(len(table["sweeps"]))
    kinds = tuple(dict.fromkeys(kind for kind, _, _ in cells))
    techniques = tuple(dict.fromkeys(technique for _, technique, _ in cells))
    return Table(Settings(classes=kinds, techniques=techniques), table)
