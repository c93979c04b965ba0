# SPDX-License-Identifier: MIT
"""A whole run as one call: perturb, resolve, observe and record."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from pathlib import Path

import numpy as np
import numpy.typing as npt

from pliant import _core
from pliant._checked import checked
from pliant._output_names import is_pdb_name
from pliant._run_outputs import (
    Observer,
    Value,
    force_recorder,
    parameters_of,
    recording_of,
    refuse_options_of_h5md,
    refuse_to_overwrite,
    without_h5md,
    write_topology,
)
from pliant._trajectory.results import MOST_KEPT, RunResult
from pliant._trajectory.sources import Molecule, structure_of

#: A technique of your own: called with (positions, sweep, framework) it makes one sweep.
Sweep = Callable[[npt.NDArray[np.float64], int, _core.Framework], None]

#: A force on a joint during one step: joint, (x, y, z) in kJ/(mol Angstrom).
JointForce = tuple[int, tuple[float, float, float]]

#: Bars in the sequence of a sweep: (bar, near, is_tree), each (B,), as `order` gives them.
Ordering = tuple[npt.ArrayLike, npt.ArrayLike, npt.ArrayLike]


@checked()
def run(
    framework: _core.Framework | _core.Structure | Molecule,
    state: _core.State | npt.ArrayLike | None = None,
    output: str | os.PathLike[str] | None = None,
    *,
    topology: str | os.PathLike[str] | None = None,
    steps: int = 1000,
    every: int = 1,
    technique: str | Sweep = "auto",
    weighting: float = 0.5,
    mass_weighted: bool = False,
    ordering: Ordering | None = None,
    tolerance: float = 1e-6,
    tolerance_length: float | None = None,
    tolerance_limit: float = 0.01,
    tolerance_overlap: float = 0.1,
    max_sweeps: int = 10000,
    perturb: str = "force",
    force: float = 50.0,
    timestep: float = 0.01,
    damping: float = 0.0,
    displacement: float = 0.1,
    replay: Sequence[JointForce] | None = None,
    guide: _core.Guide | None = None,
    record_forces: str | os.PathLike[str] | None = None,
    seed: int = 0,
    walker: int = 0,
    select: str = "",
    bars: str | os.PathLike[str] = "bonds",
    lengths: str = "geometry",
    pin: str = "",
    structure: _core.Structure | None = None,
    observers: Iterable[Observer] = (),
    parameters: Mapping[str, Value] | None = None,
    overwrite: bool = False,
    single: bool = False,
    compress: bool = False,
    precision: float = 0.0,
    save: str = "",
    flush_seconds: float = 1.0,
    durable: bool = False,
) -> RunResult:
    """Push a framework again and again, resolve the bars that break, and record each step.

    Each step breaks bars by a perturbation (position Verlet: Verlet, Phys. Rev. 159 (1967) 98; or
    random displacements, as in FRODA) and makes them whole by a technique, as `resolve` does. Step
    0 is the start, resolved first if it is broken. The same arguments give the same bits. Other
    Python threads run meanwhile. Ctrl-C ends the run after a sweep: the file is closed properly,
    then KeyboardInterrupt is raised.

    Parameters
    ----------
    framework : Framework, Structure, path, Universe, AtomGroup, rdkit.Chem.Mol, ...
        A framework, or a molecule as `sample` takes it, whose framework is built with `bars`,
        `lengths` and `pin`. A file is read as the command does: a molecule with the bonds that it
        lacks perceived, or graph XML.
    state : State or (N, 3) Angstrom, optional
        Where to start. A State is changed in place; positions are copied. Default: those of the
        structure.
    output : str or path, optional
        H5MD file to write, or a PDB file of a model a frame where the name ends in .pdb.
    topology : str or path, optional
        PDB file to write as well, with the names and bonds of the structure.
    steps, every : int
        Number of steps. Observers see step 0, every `every`-th step and the last.
    technique, weighting, mass_weighted, ordering
        As for `resolve`. A function as technique is recorded as "custom".
    tolerance, tolerance_length, tolerance_limit, tolerance_overlap, max_sweeps
        As for `resolve`.
    perturb : str
        A name in `perturbations()`.
    force, timestep, damping, displacement : float
        Size of a random force, kJ/(mol Angstrom); length of a step, ps; share of its velocity that
        a pushed joint loses per step, 0 to 1; length of a random displacement, Angstrom.
    replay : sequence of (joint, (x, y, z)), optional
        Forces in kJ/(mol Angstrom), one per step, in place of `perturb`. The last ends the run.
    guide : Guide, optional
        Where joints are asked to go, in place of `perturb`, until they have arrived; `displacement`
        at most in a step.
    record_forces : str or path, optional
        Force file to write: the push of each step, which `read_force_file` reads for `replay`.
        Only for `perturb="force"` or a replay, not for pushes of all joints. The file also holds
        the technique, tolerance and timestep, and, where they are known, the structure's
        fingerprint and how its framework was made. It exists once the run has ended.
    seed, walker : int
        All random numbers are functions of these, the step and the joint.
    select : str
        Selection of atoms to take of a structure or file; `state` and `bars` count these alone.
    bars, lengths, pin : str (bars: or path)
        As for `Structure.framework`; ignored unless a structure is given.
    structure : Structure, optional
        The structure whose bonds and masses are recorded with a framework that you have made.
    observers : callables
        Each is called with a `Frame`. If one returns something true, the run ends after that
        frame. If one raises an exception, the run ends with it.
    parameters : dict, optional
        Further values for /parameters of the file, by path.
    overwrite : bool
        Replace existing outputs, but never the file that the structure was read from.
    single, compress, precision, save, flush_seconds, durable
        As for `H5mdRecorder`; `save` also holds for the topology.

    Returns
    -------
    RunResult
        A RunSummary with the frames. Its `state` is where the run ended. Steps that did not
        converge are counted; they raise nothing.

    Raises
    ------
    OptionError
        An option is out of range; the message names it.
    InputError
        Positions that cannot carry the framework: not finite, or too far from the origin.
    FileError
        The file exists (and `overwrite` is false) or cannot be written.
    """
    source, state = _opened(framework, state, select)
    framework, structure, built = _built(source, structure, select, bars, lengths, pin)
    options = _options(
        replay,
        guide,
        ordering,
        steps=steps,
        every=every,
        technique=technique,
        weighting=weighting,
        mass_weighted=mass_weighted,
        tolerance=tolerance,
        tolerance_length=0.0 if tolerance_length is None else tolerance_length,
        tolerance_limit=tolerance_limit,
        tolerance_overlap=tolerance_overlap,
        max_sweeps=max_sweeps,
        perturb=perturb,
        force=force,
        timestep=timestep,
        damping=damping,
        displacement=displacement,
        seed=seed,
        walker=walker,
    )
    recording = recording_of(single, compress, precision, save)
    start = _start(state, structure)
    refuse_to_overwrite(structure, output, topology, record_forces)
    made_of = (structure, start, built)
    forces = force_recorder(record_forces, framework, options, overwrite, guide, made_of)
    write_topology(topology, structure, start, save, overwrite)
    if output is None or is_pdb_name(output):
        refuse_options_of_h5md(output, save, precision)
        steps_to = partial(_core.run_steps, framework, start, options, most_kept=MOST_KEPT)
        return without_h5md(steps_to, output, structure, overwrite, observers, forces)
    known = parameters_of(framework, structure, options, recording) | built
    recorder = _core.H5mdRecorder(
        output,
        framework,
        structure=structure,
        parameters=known | dict(parameters or {}),
        overwrite=overwrite,
        **recording,
        flush_seconds=flush_seconds,
        durable=durable,
        run=options,
    )
    with recorder:
        made = _core.run_steps(framework, start, options, [recorder, *observers], forces)
    return RunResult(made, structure, output)


@checked()
def continue_run(
    path: str | os.PathLike[str],
    steps: int | None = None,
    *,
    observers: Iterable[Observer] = (),
    flush_seconds: float = 1.0,
    durable: bool = False,
) -> RunResult:
    """Go on with the run of an H5MD file, as if it had never stopped.

    The file holds the framework, every option and where the run was, after its end, Ctrl-C or a
    crash. Frames are added to it. Together they have the bits of one run without an end between. A
    last frame that is none of every N-th was only the end of the run, and makes way.

    Parameters
    ----------
    path : str or path
        A file that `run` or the command has written.
    steps : int, optional
        How many steps the run is to have in all, those in the file included. Default: as many as
        it was asked for.
    observers : callables
        As for `run`. They see each frame from the last checkpoint on, about a second before the
        end of a run that was killed.
    flush_seconds, durable
        As for `H5mdRecorder`.

    Returns
    -------
    RunResult
        A RunSummary of the steps that were done now; its frames are all of the file.

    Raises
    ------
    InputError
        The file has no checkpoint, or the technique is a function.
    OptionError
        The file has more steps than `steps`.
    FileError
        The file cannot be written, or is being written.
    """
    checkpoint = _core.read_checkpoint(path, steps)
    options = checkpoint.options
    with checkpoint.recorder(flush_seconds, durable) as recorder:
        made = _core.run_steps(
            checkpoint.framework, checkpoint.state, options, [recorder, *observers], None
        )
    return RunResult(made, None, path)


def _opened(
    source: _core.Framework | _core.Structure | Molecule,
    state: _core.State | npt.ArrayLike | None,
    select: str,
) -> tuple[_core.Framework | _core.Structure, _core.State | npt.ArrayLike | None]:
    """What is in a file, if it is one: a structure, or a framework and where it starts."""
    graph = source if isinstance(source, (str, os.PathLike)) else ""
    is_graph = Path(graph).suffix == ".xml"
    if select and (is_graph or isinstance(source, _core.Framework)):
        raise TypeError("run: select is for a structure, or a file of one")
    if isinstance(source, _core.Framework):
        return source, state
    if is_graph:
        read = _core.read_graph_xml(graph)
        return read.framework, read.positions if state is None else state
    return structure_of(source), state


def _built(
    source: _core.Framework | _core.Structure,
    structure: _core.Structure | None,
    select: str,
    bars: str | os.PathLike[str],
    lengths: str,
    pin: str,
) -> tuple[_core.Framework, _core.Structure | None, dict[str, Value]]:
    """The framework, the structure it is of, and how it is recorded that it was built so."""
    if not isinstance(source, _core.Structure):
        given = {"bars": bars != "bonds", "lengths": lengths != "geometry", "pin": bool(pin)}
        for name in (name for name, is_given in given.items() if is_given):
            raise TypeError(f"run: {name} is for a structure, or a file of one")
        return source, structure, {}
    if structure is not None:
        raise TypeError("run: structure is given twice")
    chosen = source.select(select) if select else source
    values: dict[str, Value] = {
        "input/select": select,
        "input/bars": Path(bars).name,
        "input/lengths": lengths,
        "input/pin": pin,
    }
    return chosen.framework(bars, lengths, pin), chosen, values


def _options(
    replay: Sequence[JointForce] | None,
    guide: _core.Guide | None,
    ordering: Ordering | None,
    **values: Value | Sweep,
) -> _core.RunOptions:
    options = _core.RunOptions()
    if guide is not None:
        options.guide = guide
    options.ordering = ordering
    for name, value in values.items():
        setattr(options, name, value)
    if replay is not None:
        if len(replay) == 0:
            raise _core.InputError("replay: holds no push")
        options.replay = replay
    options.check()
    return options


def _start(
    state: _core.State | npt.ArrayLike | None, structure: _core.Structure | None
) -> _core.State:
    if isinstance(state, _core.State):
        return state
    if state is not None:
        return _core.State(np.asarray(state))
    if structure is None:
        raise TypeError("run: a framework has no positions: give state")
    return _core.State(structure.positions)
