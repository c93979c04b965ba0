# SPDX-License-Identifier: MIT
"""The experiment of the thesis' chapter 5: every graph, force, technique and weighting."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np

from pliant import FileError, OptionError
from pliant.base.new_file import new_file, write_text
from pliant.lab.experiment import table as tables
from pliant.lab.experiment.settings import Settings
from pliant.lab.experiment.subject import ROW, Subject, make_subject, measure_subject
from pliant.lab.pool import each_done

SETTINGS = "settings.json"
PARTS = "parts"  #: folder of what is done of an experiment that is not finished

Show = Callable[[int, int], None]
Source = Callable[[Settings, str, int], Subject]  #: settings, class, number


def run_experiment(
    settings: Settings,
    out: Path,
    graphs: list[tuple[str, int]] | None = None,
    source: Source = make_subject,
    workers: int = 1,
    show: Show = lambda done, total: None,
) -> tables.Table:
    """Fills the folder `out` with the table, and returns it.

    What an earlier call with the same settings has done is not done again, whenever and however
    that one ended: each graph is a file below ``parts``, put in place in one go.
    `graphs` are (class, number), by default settings.graphs of each class; `source` makes them.
    Raises OptionError if `out` holds an experiment with other settings.
    """
    settings.check()
    _claim_folder(settings, out)
    if (out / tables.TABLE_H5).is_file():  # written last: all is there
        _clear_parts(out)
        return tables.read(out)
    (out / PARTS).mkdir(exist_ok=True)
    todo = graphs or [(kind, k) for kind in settings.classes for k in range(settings.graphs)]
    _measure_missing(settings, out, todo, source, workers, show)
    table = tables.join(settings, _parts(out, todo))
    tables.write(table, out)
    _clear_parts(out)
    return table


def _claim_folder(settings: Settings, out: Path) -> None:
    """Makes the folder one of this experiment, or refuses it."""
    path = out / SETTINGS
    if not path.exists():
        if out.exists() and not _is_free(out):
            raise OptionError(f"-o {out}: is there and holds no experiment")
        try:
            out.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise FileError(f"{out}: cannot be made: {error.strerror}") from error
        write_text(path, settings.text(), overwrite=True)
        return
    try:
        theirs = Settings.from_text(path.read_text(encoding="utf-8"))
    except (ValueError, TypeError, KeyError) as error:
        raise OptionError(f"-o {out}: {SETTINGS} is no settings file: {error}") from error
    if theirs != settings:
        differences = "; ".join(theirs.differences(settings))
        raise OptionError(f"-o {out}: holds another experiment: {differences}")


def _is_free(out: Path) -> bool:
    """An empty folder, but for what a killed writer may have left."""
    return out.is_dir() and all(path.suffix == ".partial" for path in out.iterdir())


def _part(out: Path, kind: str, number: int) -> Path:
    return out / PARTS / f"{kind}-{number:06d}.npy"


def _measure_missing(
    settings: Settings,
    out: Path,
    todo: list[tuple[str, int]],
    source: Source,
    workers: int,
    show: Show,
) -> None:
    missing = [task for task in todo if not _part(out, *task).is_file()]
    work = functools.partial(_measure_one, settings, out, source)
    done = len(todo) - len(missing)
    show(done, len(todo))
    for _ in each_done(work, missing, workers):
        done += 1
        show(done, len(todo))


def _measure_one(settings: Settings, out: Path, source: Source, task: tuple[str, int]) -> None:
    rows = measure_subject(source(settings, *task), settings)
    with new_file(_part(out, *task), overwrite=True) as file:
        np.save(file, rows, allow_pickle=False)


def _parts(out: Path, todo: list[tuple[str, int]]) -> Iterator[tuple[str, int, np.ndarray]]:
    for task in todo:
        rows = np.load(_part(out, *task), allow_pickle=False)
        if rows.dtype != ROW:
            raise FileError(f"{_part(out, *task)}: of another version of Pliant: remove {out}")
        yield (*task, rows)


def _clear_parts(out: Path) -> None:
    if not (out / PARTS).exists():
        return
    for path in (out / PARTS).iterdir():
        path.unlink()
    (out / PARTS).rmdir()
