# SPDX-License-Identifier: MIT
"""The tidy table of an experiment: one row a resolve, as CSV and as HDF5.

They depend on the settings alone: equal settings give equal bytes.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import h5py
import numpy as np

from pliant import FileError, InputError
from pliant.base.new_file import new_file, new_text
from pliant.lab.experiment.settings import NO_WEIGHTING, Settings

COLUMNS = tuple(
    "class graph force technique weighting sweeps passes projections converged "
    "final_residual".split()
)
TABLE_CSV, TABLE_H5 = "table.csv", "table.h5"

#: A column and what it says, as attributes of the HDF5 datasets have it.
MEANINGS = {
    "class": "class of the graph: a name in pliant.graph_classes()",
    "graph": "number of the graph: pliant.generate(class, seed, graph)",
    "force": "number of the push, from 0",
    "technique": "a name in pliant.techniques()",
    "weighting": f"share of the far joint; {NO_WEIGHTING:g} (empty in CSV): the technique has none",
    "sweeps": "passes over the ordering in one direction; 0 if the push broke nothing",
    "passes": "as sweeps, but there and back counts as one for reverse techniques",
    "projections": "bars looked at",
    "converged": "every bar is within the tolerance",
    "final_residual": "largest |length - rest| / rest at the end",
}


@dataclass
class Table:
    """The table in memory: one array a column."""

    settings: Settings
    columns: dict[str, np.ndarray]

    def __len__(self) -> int:
        return len(self.columns["graph"])


def join(settings: Settings, parts: Iterator[tuple[str, int, np.ndarray]]) -> Table:
    """One table of the rows of all graphs: (class, number, rows of subject.ROW)."""
    pieces: dict[str, list[np.ndarray]] = {name: [] for name in COLUMNS}
    for kind, number, rows in parts:
        combinations = settings.combinations(kind)
        names = np.array([name.encode() for name, _ in combinations])
        weightings = np.array([weighting for _, weighting in combinations])
        pieces["class"].append(np.full(len(rows), kind.encode()))
        pieces["graph"].append(np.full(len(rows), number, np.int64))
        pieces["technique"].append(names[rows["combination"]])
        pieces["weighting"].append(weightings[rows["combination"]])
        for name in (rows.dtype.names or ())[1:]:
            pieces[name].append(rows[name])
    return Table(settings, {name: np.concatenate(list_) for name, list_ in pieces.items()})


def write(table: Table, folder: Path) -> None:
    """Writes both files, each at once: a reader never sees half of one."""
    _write_csv(table, folder / TABLE_CSV)
    _write_h5(table, folder / TABLE_H5)


def _write_csv(table: Table, path: Path) -> None:
    columns = [_words(table.columns[name]) for name in COLUMNS]
    with new_text(path, overwrite=True) as file:
        file.write(",".join(COLUMNS) + "\n")
        file.writelines(",".join(row) + "\n" for row in zip(*columns, strict=True))


def _words(column: np.ndarray) -> list[str]:
    if column.dtype.kind == "S":
        return [value.decode() for value in column.tolist()]
    if column.dtype.kind == "b":
        return ["true" if value else "false" for value in column.tolist()]
    return [_number(value) for value in column.tolist()]


def _number(value: int | float) -> str:
    """The shortest text that reads back to the same bits; nothing for a missing weighting."""
    if value == NO_WEIGHTING:
        return ""
    return str(int(value)) if value == int(value) and abs(value) < 1e15 else repr(value)


def _write_h5(table: Table, path: Path) -> None:
    with (
        new_file(path, overwrite=True, tells_late=True) as new,
        h5py.File(new, "w", libver="v110") as file,
    ):
        file.attrs["settings"] = table.settings.text()
        for name in COLUMNS:
            values = table.columns[name]
            how = {"compression": "gzip", "shuffle": True, "track_times": False}
            file.create_dataset(name, data=values, **how).attrs["meaning"] = MEANINGS[name]


def read(folder: Path) -> Table:
    """Reads ``table.h5`` of an experiment's folder.

    Raises FileError if it cannot be opened, InputError if it is something else.
    """
    path = folder / TABLE_H5
    if not path.is_file():
        raise FileError(f"{path}: no such file: run pliant lab experiment -o {folder} first")
    try:
        with h5py.File(path, "r") as file:
            settings = Settings.from_text(file.attrs["settings"])
            columns = {name: file[name][:] for name in COLUMNS}
    except OSError as error:
        raise FileError(f"{path}: cannot be read: {error}") from error
    except (KeyError, TypeError, ValueError) as error:
        raise InputError(f"{path}: no table of pliant lab experiment: {error}") from error
    return Table(settings, columns)
