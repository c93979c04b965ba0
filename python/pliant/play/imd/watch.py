# SPDX-License-Identifier: MIT
"""The command ``pliant watch``: a run that goes on elsewhere, followed in a terminal."""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from pliant._core import Frame, H5mdRecorder, InputError, OptionError, Structure, read
from pliant.base import console
from pliant.base.output_names import check_trajectory_name, is_pdb_name
from pliant.play.imd.address import server_address
from pliant.play.imd.client import Client, ImdFrame

GREETING, SILENCE = 10.0, 60.0  #: seconds that a server may take for its first word, and for others

EPILOG = """\
Follows any program that speaks IMD, version 2 or 3: pliant run --imd, gmx mdrun -imdwait, LAMMPS,
NAMD. Pliant sends the largest residual (how far the worst bar is off) and the number of sweeps
(visits to all bars) in the fields for total and bond energies; other programs send energies there.
Ctrl-C leaves; the run goes on.

exit codes: 0 the run has ended, or --frames have arrived, 1 no server there, or it does not speak
IMD, 2 bad option, 130 left by Ctrl-C

examples:
  pliant run protein.pdb -o out.h5md --steps 100000 --imd &
  pliant watch localhost:8888
  pliant watch localhost:8888 -o seen.h5md --topology out.pdb --frames 1000
"""


def make_parser() -> console.Parser:
    """The options of pliant watch."""
    parser = console.Parser(
        "watch", "Follows a live run over IMD: how fast it is, how exact.", EPILOG
    )
    add = parser.add_argument
    text = "address of the run; :PORT alone means this machine"
    add("server", metavar="HOST:PORT", type=server_address, help=text)
    add("-o", "--output", metavar="FILE", help="record what arrives in this H5MD trajectory")
    add("--topology", metavar="PDB", help="names and bonds of its atoms; --output needs it")
    add("--frames", metavar="N", type=console.whole_number(1), help="leave after this many frames")
    text = "ask for every N-th step (default: as the run sends them)"
    add("--every", metavar="N", type=console.whole_number(1), help=text)
    add("--overwrite", action="store_true", help="replace an existing trajectory")
    add("--json", action="store_true", help="print what was seen as one JSON object")
    return parser


def main(words: Sequence[str] | None = None) -> int:
    """Runs the command; returns its exit code."""
    arguments = make_parser().parse_args(words)
    return console.run_command("watch", lambda: _watch(arguments))


@dataclass
class Seen:
    """What there was to be seen."""

    frames: int = 0
    first_step: int | None = None
    last_step: int | None = None
    worst_residual: float = 0.0
    mean_sweeps: float = 0.0
    frames_dropped: int = 0
    seconds: float = 0.0
    _begun: float = field(default_factory=time.perf_counter, repr=False)

    def add(self, frame: ImdFrame) -> None:
        """Counts a frame."""
        energies = frame.energies or {}
        self.frames += 1
        self.first_step = frame.step if self.first_step is None else self.first_step
        self.last_step = frame.step
        if energies.get("temperature"):  # a run with energies of its own, which tell of no bars
            self.seconds = time.perf_counter() - self._begun
            return
        self.worst_residual = max(self.worst_residual, energies.get("total_energy", 0.0))
        self.mean_sweeps += (energies.get("bonds_energy", 0.0) - self.mean_sweeps) / self.frames
        self.frames_dropped = int(energies.get("improper_dihedrals_energy", 0.0))
        self.seconds = time.perf_counter() - self._begun

    def facts(self) -> dict[str, float | int | None]:
        """As they are printed as JSON."""
        return {name: value for name, value in vars(self).items() if not name.startswith("_")}


def _energies_told(energies: Mapping[str, float]) -> str:
    """Of Pliant's run, how well its bars are restored; of others, what their energies are."""
    if temperature := energies.get("temperature"):
        return f"{temperature:.0f} K, {energies.get('potential_energy', 0.0):.4g} potential energy"
    residual, sweeps = (energies.get(f"{name}_energy", 0.0) for name in ("total", "bonds"))
    return f"residual {residual:.2e}, {sweeps:.0f} sweeps"


class _Screen:
    """One line, drawn over itself on a terminal, else one a second."""

    def __init__(self, quiet: bool) -> None:
        self._quiet, self._last, self._frames = quiet, time.perf_counter(), 0

    def show(self, seen: Seen, frame: ImdFrame) -> None:
        now = time.perf_counter()
        is_terminal = sys.stderr.isatty()
        if self._quiet or now - self._last < (0.1 if is_terminal else 1.0):
            return
        rate = (seen.frames - self._frames) / (now - self._last)
        self._last, self._frames = now, seen.frames
        text = f"step {frame.step}, {rate:.0f} frames/s, {_energies_told(frame.energies or {})}"
        end = "\x1b[K" if is_terminal else "\n"
        print(("\r" if is_terminal else "") + text, end=end, file=sys.stderr, flush=True)


def _watch(arguments: argparse.Namespace) -> int:
    _check_record(arguments)
    seen = Seen()
    try:
        _follow(arguments, seen)
    finally:
        if arguments.json:
            console.print_json(seen.facts())
        elif seen.frames:
            _print(seen, arguments)
    return console.EXIT_OK


def _check_record(arguments: argparse.Namespace) -> None:
    if (arguments.output is None) != (arguments.topology is None):
        raise OptionError("--output and --topology go together")
    if arguments.output is None:
        return
    check_trajectory_name(arguments.output)
    if is_pdb_name(arguments.output):
        raise OptionError(f"--output {arguments.output}: expected a name that ends in .h5md")
    if Path(arguments.output).exists() and not arguments.overwrite:
        raise OptionError(f"--output {arguments.output}: exists; --overwrite replaces it")


def _follow(arguments: argparse.Namespace, seen: Seen) -> None:
    recorder = None
    if arguments.output:
        structure = read(arguments.topology)
        recorder = _Recorder(structure, arguments.output, arguments.overwrite)
    host, port = arguments.server
    screen = _Screen(arguments.json)
    try:
        with _reached(host, port) as client:
            if arguments.every:
                client.set_rate(arguments.every)
            for frame in client:
                seen.add(frame)
                screen.show(seen, frame)
                if recorder:
                    recorder.record(frame)
                if seen.frames == arguments.frames:
                    break
    finally:
        if recorder:
            recorder.close()


def _reached(host: str, port: int) -> Client:
    try:
        client = Client(host, port, timeout=GREETING)
    except TimeoutError:
        raise InputError(
            f"{host}:{port}: expected an IMD server that speaks first, found {GREETING:g} s of "
            "silence: it may serve one client at a time"
        ) from None
    client.set_timeout(SILENCE)
    return client


class _Recorder:
    """Frames of a server as frames of ours."""

    def __init__(self, structure: Structure, path: str, overwrite: bool) -> None:
        self._atoms = len(structure)
        self._recorder = H5mdRecorder(
            path, structure.framework(), structure=structure, overwrite=overwrite
        )
        self._count = 0

    def record(self, frame: ImdFrame) -> None:
        """Raises InputError for a frame of other atoms."""
        if frame.positions is None or len(frame.positions) != self._atoms:
            found = 0 if frame.positions is None else len(frame.positions)
            raise InputError(f"--topology: has {self._atoms} atoms, the run {found}")
        energies = frame.energies or {}
        step = self._count if frame.step is None else frame.step
        self._recorder.record(
            Frame(
                step,
                float(step if frame.time is None else frame.time),
                frame.positions,
                sweeps=int(energies.get("bonds_energy", 0.0)),
                max_residual=energies.get("total_energy", 0.0),
                rms_residual=energies.get("potential_energy", 0.0),
            )
        )
        self._count += 1

    def close(self) -> None:
        """What was recorded is whole."""
        self._recorder.close()


def _print(seen: Seen, arguments: argparse.Namespace) -> None:
    if sys.stderr.isatty():
        print("\r\x1b[K", end="", file=sys.stderr, flush=True)
    rate = seen.frames / seen.seconds if seen.seconds > 0 else 0.0
    print(f"frames          {seen.frames}, {rate:.0f} a second; {seen.frames_dropped} dropped")
    print(f"steps           {seen.first_step} to {seen.last_step}")
    print(f"residual        {seen.worst_residual:.2e} at most")
    print(f"sweeps per step {seen.mean_sweeps:.1f} on average")
    if arguments.output:
        print(f"trajectory      {console.printable_name(arguments.output)}")
