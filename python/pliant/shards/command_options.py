# SPDX-License-Identifier: MIT
"""The options of ``pliant ensemble``, and the texts of its help."""

from __future__ import annotations

from collections.abc import Callable

from pliant.base.console import Parser, positive_number, whole_number
from pliant.shards.scratch import USUAL
from pliant.trajectory.shards.plan import MOST

DESCRIPTION = """\
Samples very many frames in shards, which share the cores of one machine or of many. A shard is a
file with some of the frames; its bits depend only on the input, the options, the seed and the
numbers of these frames, not on where or in how many attempts it was made. Finished shards are kept:
after a crash, a lost worker or Ctrl-C, the same command goes on from there.

The frames are, bit for bit, those of one pliant sample with the same --frames, whose other options
it takes, too. With --walkers it makes walkers of pliant run, and takes the options of that."""

EPILOG = """\
examples:
  pliant ensemble protein.pdb -o many --frames 100000 --amplitude 2 --workers 8
  pliant ensemble protein.pdb -o many --frames 100000 --scheduler tcp://head:8786
  pliant ensemble protein.pdb -o many --frames 100000 --cluster slurm.yaml
  pliant ensemble protein.pdb -o many --frames 100000 --slurm-script jobs.sh    without Dask
  pliant ensemble protein.pdb -o many --frames 100000 --slurm-script jobs.sh --walltime 12:00:00
  pliant ensemble protein.pdb -o many --walkers 10000 --model protein --every 100
  pliant ensemble --verify many
  pliant analyse many

slurm.yaml holds queue_system: slurm (pbs, lsf, sge, oar, moab, htcondor), jobs: N, and arguments of
dask-jobqueue's class for that queue, such as cores: 1, memory: 2GB, walltime: "12:00:00".

In Python, MDAnalysis.Universe("many/ensemble.pliant") is all shards as one trajectory.

Exit code: 0 all shards are complete, 1 bad input or file, 2 bad option, 3 some frames are not
complete or were left out. Ended early, with finished work saved: 75 by --walltime or SIGUSR1, 130
by Ctrl-C, 143 by SIGTERM. The same command goes on from there."""

#: options that --help shows
COMMON = ("--output", "--frames", "--walkers", "--workers", "--verify")


def ensemble_parser() -> Parser:
    """What takes the words of the command line apart."""
    parser = Parser("ensemble", DESCRIPTION, EPILOG, COMMON)
    parser.usage = "pliant ensemble INPUT -o DIR (--frames N | --walkers N) [OPTIONS]"
    _add_ensemble(parser.add_argument)
    _add_places(parser.add_argument_group("where").add_argument)
    _add_times(parser.add_argument_group("time and place").add_argument)
    _add_output(parser.add_argument_group("output").add_argument)
    return parser


def _add_ensemble(add: Callable[..., object]) -> None:
    add(
        "input",
        metavar="INPUT",
        nargs="?",
        help="molecule, as pliant run or pliant sample takes it",
    )
    add("-o", "--output", metavar="DIR", help="folder of the ensemble")
    number = whole_number(1, most=MOST)
    add("--frames", type=number, metavar="N", help="frames of pliant sample in all")
    add("--walkers", type=number, metavar="N", help="walkers of pliant run in all")
    text = "frames (default: 1024) or walkers (default: 128) a shard"
    add("--shard-size", type=number, metavar="N", help=text)
    add("--verify", metavar="DIR", help="check every byte of an ensemble, and make no shards")
    text = "make shard K of the ensemble in DIR, without Dask"
    add("--shard", type=whole_number(0), metavar="K", help=text)


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
    text = "further attempts at a shard that ends with an error (default: 3)"
    add("--retries", type=whole_number(0, most=1000), default=3, metavar="N", help=text)


def _add_times(add: Callable[..., object]) -> None:
    add(
        "--walltime",
        metavar="TIME",
        help="commit and end (exit code 75) a minute before TIME is over; "
        "as Slurm takes it: 90, 12:00:00, 1-12 (minutes, hours, days and hours)",
    )
    add(
        "--scratch",
        metavar="DIR",
        nargs="?",
        const=USUAL,
        help="write shards on a disk of the machine that makes them, and move them when complete; "
        "variables in DIR are those of that machine (without DIR: $TMPDIR)",
    )
    text = "interval between commits of a shard (default: 10)"
    add("--commit-seconds", type=positive_number, metavar="S", help=text)


def _add_output(add: Callable[..., object]) -> None:
    add("--json", action="store_true", help="print the result as one JSON object")
    add("--quiet", action="store_true", help="print nothing but errors")
