# SPDX-License-Identifier: MIT
"""What a run writes, and what is refused before it writes."""

from __future__ import annotations

import os
import warnings
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any

from pliant import _core
from pliant._output_names import check_trajectory_name
from pliant._trajectory.results import RunResult

#: What an observer is: it looks at a frame, and anything true that it returns ends the run.
Observer = Callable[[_core.Frame], object]

Value = bool | int | float | str


def without_h5md(
    steps_to: Callable[..., _core.RunSummary],
    output: str | os.PathLike[str] | None,
    structure: _core.Structure | None,
    overwrite: bool,
    observers: Iterable[Observer],
    forces: _core.ForceRecorder | None,
) -> RunResult:
    """A run that writes no frames, or models of a PDB file."""
    if output is None:
        return RunResult(steps_to(list(observers), forces), structure)
    if structure is None:
        raise TypeError("run: models of a PDB file need a structure")
    with _core.PdbRecorder(output, structure, overwrite=overwrite) as models:
        made = steps_to([models, *observers], forces)
    return RunResult(made, structure, output)


def write_topology(
    path: str | os.PathLike[str] | None,
    structure: _core.Structure | None,
    start: _core.State,
    save: str,
    overwrite: bool,
) -> None:
    """Names and bonds of what is recorded, where the run starts; None: not asked for."""
    if path is None:
        return
    if structure is None:
        raise TypeError("run: a topology needs a structure")
    positions = start.positions
    if save:
        positions = positions[_core.select_atoms(structure, save)]
        with warnings.catch_warnings():  # that bonds lead out of the part is what was asked for
            warnings.simplefilter("ignore", _core.PliantWarning)
            structure = structure.select(save)
    _core.write_topology_pdb(path, structure, positions=positions, overwrite=overwrite)


def refuse_options_of_h5md(
    output: str | os.PathLike[str] | None, save: str, precision: float
) -> None:
    """A file of models has no place for them."""
    for name, given in (("save", save), ("precision", precision)):
        if given and output is not None:
            raise _core.OptionError(f"{name}: goes with H5MD, not with {os.fspath(output)}")


def refuse_to_overwrite(
    structure: _core.Structure | None,
    trajectory: str | os.PathLike[str] | None,
    *others: str | os.PathLike[str] | None,
) -> None:
    """Refuses to write over the file that the structure was read from."""
    if trajectory is not None:
        check_trajectory_name(trajectory, "run")
    if structure is None or not os.path.exists(structure.source):
        return
    for output in (trajectory, *others):
        if output and os.path.exists(output) and os.path.samefile(output, structure.source):
            raise _core.OptionError(f"{os.fspath(output)}: is both input and output")


def force_recorder(
    path: str | os.PathLike[str] | None,
    framework: _core.Framework,
    options: _core.RunOptions,
    overwrite: bool,
    guide: _core.Guide | None,
    made_of: tuple[_core.Structure | None, _core.State, Mapping[str, Value]],
) -> _core.ForceRecorder | None:
    """Writes the push of each step; None where nobody asked for it.

    `made_of`: the structure, where it starts, and how its framework was built.
    """
    if path is None:
        return None
    if guide is not None and not options.replay:
        raise _core.OptionError("record_forces: a guide pushes by no force: give no guide")
    if not options.replay and options.perturb != "force":
        raise _core.OptionError(
            "record_forces: a force file holds one force on one joint a step, which "
            f'{options.perturb} is not; use perturb="force"'
        )
    structure, start, built = made_of
    made_from = _force_input(structure, built)
    return _core.ForceRecorder(
        path, framework, options, overwrite, structure=structure, start=start, input=made_from
    )


def _force_input(
    structure: _core.Structure | None, built: Mapping[str, Value]
) -> list[tuple[str, str]]:
    """How the command makes the same framework: options by name, those that are not as usual."""
    if not built:
        return []
    usual = {"input/select": "", "input/lengths": "geometry", "input/pin": "", "input/bars": None}
    values = [(path, str(value)) for path, value in built.items() if value != usual[path]]
    if structure is not None and structure.model != 1:
        values.append(("input/frame", str(structure.model)))
    return [(path.removeprefix("input/"), value) for path, value in values]


def recording_of(single: bool, compress: bool, precision: float, save: str) -> dict[str, Any]:
    """How frames are recorded: options of H5mdRecorder that its file tells."""
    return {"single": single, "compress": compress, "precision": precision, "save": save}


def parameters_of(
    framework: _core.Framework,
    structure: _core.Structure | None,
    options: _core.RunOptions,
    recording: Mapping[str, Value],
) -> dict[str, Value]:
    """What a file says of its run, by path below /parameters."""
    values: dict[str, Value] = {f"record/{name}": value for name, value in recording.items()}
    if structure is not None and structure.source:
        values |= {"input/file": Path(structure.source).name, "input/model": structure.model}
    return values | options.parameters(framework)
