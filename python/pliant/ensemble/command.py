# SPDX-License-Identifier: MIT
"""The subcommand ``pliant ensemble``: an ensemble in shards, on the cores of many machines."""

from __future__ import annotations

import argparse
import contextlib
import sys
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

from pliant._core import Error, OptionError
from pliant._extras import need
from pliant._processes import ended_by_sigterm
from pliant.console import (
    EXIT_FAILED,
    EXIT_OK,
    Parser,
    counted,
    note,
    print_json,
    printable,
    printable_name,
    progress,
    run_command,
    whole_number,
)
from pliant.ensemble.cluster import Place, dashboard_of, open_place
from pliant.ensemble.drive import Outcome, alone_in, complete
from pliant.ensemble.make_shard import check_options, make_shard
from pliant.ensemble.options import parse_options
from pliant.ensemble.plan import (
    PLAN,
    EnsemblePlan,
    load_plan,
    make_plan,
    settled,
    withdraw,
    write_plan,
    write_whole,
)
from pliant.ensemble.slurm_script import slurm_script
from pliant.ensemble.verify import verify

EXIT_UNCONVERGED = 3
MOST = 10**9

DESCRIPTION = """\
Runs many walkers (pliant run), or samples many frames (pliant sample), in shards that share the
cores of this machine, or of many. A shard is a file with some of the walkers or frames; its bits
depend only on the input, the options, the seed and the numbers of these walkers or frames, not on
where or how often it was made. Finished shards are kept: after a crash, a lost worker or Ctrl-C,
the same command goes on from there.

Options that are not listed here are those of pliant run, or with --frames of pliant sample."""

EPILOG = """\
examples:
  pliant ensemble protein.pdb -o many --walkers 10000 --model protein --every 100
  pliant ensemble protein.pdb -o many --frames 100000 --amplitude 2 --workers 8
  pliant ensemble protein.pdb -o many --walkers 10000 --scheduler tcp://head:8786
  pliant ensemble protein.pdb -o many --walkers 10000 --cluster slurm.yaml
  pliant ensemble protein.pdb -o many --walkers 10000 --slurm-script jobs.sh    without Dask
  pliant ensemble --verify many
  pliant analyse many

slurm.yaml holds queue_system: slurm (pbs, lsf, sge, oar, moab, htcondor), jobs: N, and arguments of
dask-jobqueue's class for that queue, such as cores: 1, memory: 2GB, walltime: "12:00:00".

In Python, MDAnalysis.Universe("many/ensemble.pliant") is all shards as one trajectory.

Exit code: 0 all shards are complete, 1 bad input or file, 2 bad option, 3 some frames are not
whole or were left out, 130 ended by Ctrl-C: the same command goes on from there."""

#: options that --help shows
COMMON = ("--output", "--frames", "--walkers", "--workers", "--verify")


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs the subcommand with a list of arguments (default: sys.argv); returns the exit code."""
    words = list(sys.argv[1:] if arguments is None else arguments)
    # What an option is followed by is only known once the input is out of the way.
    file = words[0] if words and not words[0].startswith("-") else None
    options, passed_on = _parser().parse_known_args(words[1:] if file else words)
    return run_command("ensemble", lambda: _ensemble(file, options, passed_on, words))


def _parser() -> Parser:
    parser = Parser("ensemble", DESCRIPTION, EPILOG, COMMON)
    parser.usage = "pliant ensemble INPUT -o DIR (--walkers N | --frames N) [OPTIONS]"
    _add_ensemble(parser.add_argument)
    _add_places(parser.add_argument_group("where").add_argument)
    _add_output(parser.add_argument_group("output").add_argument)
    return parser


def _add_ensemble(add: Callable[..., object]) -> None:
    add("-o", "--output", metavar="DIR", help="folder of the ensemble")
    number = whole_number(1, most=MOST)
    add("--walkers", type=number, metavar="N", help="walkers of pliant run in all")
    add("--frames", type=number, metavar="N", help="frames of pliant sample in all")
    text = "walkers (default: 128) or frames (default: 1024) a shard"
    add("--shard-size", type=number, metavar="N", help=text)
    add("--verify", metavar="DIR", help="check every byte of an ensemble, and make no shards")
    text = "make shard K of the ensemble in DIR, without Dask"
    add("--only", type=whole_number(0), metavar="K", help=text)


def _add_places(add: Callable[..., object]) -> None:
    number = whole_number(1, most=100_000)
    add(
        "--workers",
        type=number,
        metavar="N",
        help="processes (default: one per core), or jobs of --cluster (default: as in its FILE); "
        "never more than shards",
    )
    add("--scheduler", metavar="ADDRESS", help="a Dask scheduler that is already running")
    add("--cluster", metavar="FILE", help="run as jobs of a queue, which this YAML file describes")
    add(
        "--slurm-script",
        metavar="FILE",
        help="write a script for a Slurm job array, and make no shards",
    )
    text = "further attempts at a shard that fails (default: 3)"
    add("--retries", type=whole_number(0, most=1000), default=3, metavar="N", help=text)


def _add_output(add: Callable[..., object]) -> None:
    add("--json", action="store_true", help="print the result as one JSON object")
    add("--quiet", action="store_true", help="print nothing but errors")


def _ensemble(
    file: str | None, options: argparse.Namespace, passed_on: list[str], words: list[str]
) -> int:
    if options.verify is not None:
        _expect_no_more(file, passed_on, "--verify")
        return _verify(options)
    if options.output is None:
        raise OptionError("-o DIR: expected the folder of the ensemble")
    folder = Path(options.output)
    if options.only is not None:
        _expect_no_more(file, passed_on, "--only")
        return _make_one(folder, options)
    if options.slurm_script is None and not (folder / PLAN).exists():
        need("pliant ensemble", "dask", "distributed")  # before anything is made
    _expect_one_place(options)
    plan = _plan(file, options, passed_on)
    with alone_in(folder), ended_by_sigterm("ensemble"):
        if options.slurm_script is not None:
            return _write_script(plan, folder, options, words)
        return _make_all(plan, folder, options)


def _expect_one_place(options: argparse.Namespace) -> None:
    given = [
        name
        for name in ("--scheduler", "--cluster", "--slurm-script")
        if getattr(options, name[2:].replace("-", "_")) is not None
    ]
    if len(given) > 1:
        raise OptionError(f"{given[0]}: does not go with {given[1]}: expected one place")


def _expect_no_more(file: str | None, passed_on: list[str], name: str) -> None:
    for word in [file, *passed_on]:
        if word is not None:
            raise OptionError(f'unexpected argument "{word}": does not go with {name}')


def _plan(file: str | None, options: argparse.Namespace, passed_on: list[str]) -> EnsemblePlan:
    if file is None:
        raise OptionError("INPUT: expected a file before all options")
    if (options.walkers is None) == (options.frames is None):
        raise OptionError("expected --walkers N (of pliant run) or --frames N (of pliant sample)")
    command = "run" if options.frames is None else "sample"
    count = options.walkers or options.frames
    return make_plan(command, file, count, options.shard_size, parse_options(passed_on, command))


def _make_all(plan: EnsemblePlan, folder: Path, options: argparse.Namespace) -> int:
    @contextlib.contextmanager
    def place(shards: int) -> Iterator[Place]:
        where = (options.workers, options.scheduler, options.cluster)
        with open_place(*where, shards) as opened:
            if not options.quiet and (link := dashboard_of(opened.client)):
                note(f"Dask's dashboard: {link}")
            yield opened

    with _planned(plan, folder, options) as agreed, progress("shards", options.quiet) as show:
        outcome = complete(agreed, folder, place, show, options.retries)
    if options.json:
        print_json(outcome.as_json())
    elif not options.quiet:
        _print_outcome(outcome)
    return EXIT_UNCONVERGED if _is_incomplete(outcome) else EXIT_OK


@contextlib.contextmanager
def _planned(
    plan: EnsemblePlan, folder: Path, options: argparse.Namespace
) -> Iterator[EnsemblePlan]:
    """The folder's plan. One that is new goes again if an error comes before its first shard."""
    there = settled(folder, plan, options.shard_size)
    if there is not None:
        yield there
        return
    write_plan(folder, plan)
    try:
        yield plan
    except (Error, OSError, KeyboardInterrupt, SystemExit):
        withdraw(folder)
        raise


def _is_incomplete(outcome: Outcome) -> bool:
    return outcome.total("unconverged") > 0 or outcome.total("left_out") > 0


def _print_outcome(outcome: Outcome) -> None:
    plan = outcome.plan
    print(f"{plan.what:<16}{plan.count}, in {counted(plan.shard_count, 'shard')}")
    print(f"shards          {outcome.made} made, {outcome.found} there already")
    frames, size = outcome.total("frames"), outcome.total("bytes")
    print(f"frames          {frames}, {size / 1e6:.1f} MB, {size / max(frames, 1):.0f} bytes each")
    if outcome.total("unconverged"):
        print(f"not converged   {outcome.total('unconverged')} frames, which say so")
    if outcome.total("left_out"):
        print(f"left out        {outcome.total('left_out')} frames, which could not be resolved")
    print(f"time            {outcome.seconds:.2f} s")
    print(f"ensemble        {printable_name(outcome.folder)}")


def _make_one(folder: Path, options: argparse.Namespace) -> int:
    plan = load_plan(folder)
    if options.only >= plan.shard_count:
        raise OptionError(
            f"--only {options.only}: expected a shard from 0 to {plan.shard_count - 1}"
        )
    record = make_shard(plan, plan.shard(options.only), str(folder))
    if options.json:
        print_json(record.as_json())
    elif not options.quiet:
        print(f"shard           {printable_name(folder / record.file)}")
    return EXIT_OK


def _write_script(
    plan: EnsemblePlan, folder: Path, options: argparse.Namespace, words: list[str]
) -> int:
    path = Path(options.slurm_script)
    with _planned(plan, folder, options) as agreed:
        check_options(agreed, str(folder))  # the jobs would all fail, later
        write_whole(path, slurm_script(agreed, folder, _without_script(words)))
    if not options.quiet:
        print(f"script          {printable_name(path)}: sbatch {printable_name(path)}")
    return EXIT_OK


def _without_script(words: list[str]) -> list[str]:
    """The command that counts the shards once all jobs have ended."""
    kept = [word for word in words if not word.startswith("--slurm-script=")]
    if "--slurm-script" in kept:
        place = kept.index("--slurm-script")
        del kept[place : place + 2]
    return kept


def _verify(options: argparse.Namespace) -> int:
    with progress("verify", options.quiet) as show:
        result = verify(Path(options.verify), show)
    if options.json:
        print_json(result.as_json())
    elif not options.quiet:
        whole = f"{result.shards} of {result.plan.shard_count}"
        print(f"shards          {whole} are whole and match the manifest")
        print(f"frames          {result.frames}, each once, {result.bytes / 1e6:.1f} MB")
    for problem in result.problems:
        print(f"pliant ensemble: error: {printable(problem)}", file=sys.stderr)
    return EXIT_FAILED if result.problems else EXIT_OK


if __name__ == "__main__":
    sys.exit(main())
