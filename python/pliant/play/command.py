# SPDX-License-Identifier: MIT
"""The command ``pliant play``."""

from __future__ import annotations

import argparse
import webbrowser
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from pliant._core import OptionError
from pliant.base import console
from pliant.play import page
from pliant.play.connect import connect
from pliant.play.imd.address import server_address
from pliant.play.server import PageServer

EPILOG = """\
The page is a single file with the solver inside, as WebAssembly. It never uses the network, and
what you open does not leave your machine. FILE is handed to the browser once, from a secret
address on this machine (127.0.0.1); the command keeps running until Ctrl-C. Without FILE the page
is opened as a file, and you can drop files on it.

An ensemble (pliant sample, pliant ensemble) or a path in H5MD is shown moving, with its domains,
the axes about which they turn, and small pictures of its shapes; you can pull from any frame. Of
an ensemble larger than 96 MB, evenly spaced frames are shown, and the page says how many.

In the page: drag an atom to pull it, drag the background to rotate the view; "?" explains the
rest.

With --distances (CSV, as pliant fit takes it) lines join the alpha carbons of each measured
distance: blue where it holds within 1 A, red where it is off. How many hold, and how far off all
are (r.m.s.), is shown while you drag. With --map its surface is shown, where it holds the volume of
the molecule, and how many residues are inside.

With --connect the page shows a live run (pliant run --imd): its atoms as they move, its residual
(how far the worst bar is off) and sweeps; a drag pulls on the atoms of the run. FILE is the
molecule that the run reads, or the PDB file that it writes. A slow page skips frames and never
slows the run down. The command ends when the run has ended, whether or not a page is open.

exit codes: 0 done, 1 FILE cannot be read or does not match the run, no run answers, the connection
is lost, or the package was built without the page; 2 bad option

examples:
  pliant play
  pliant play protein.pdb
  pliant play caffeine.sdf --no-open
  pliant play ensemble.h5md
  pliant play open.pdb --distances measured.csv
  pliant play open.pdb --map map.mrc --resolution 8
  pliant run protein.pdb --steps 1000000 --imd &
  pliant play --connect localhost:8888 protein.pdb
"""


def make_parser() -> console.Parser:
    """The options of pliant play."""
    parser = console.Parser(
        "play",
        "Opens a page in the browser in which you pull on the atoms of a molecule, watch bars\n"
        "(two atoms at a fixed distance) break and be repaired, and record, replay and save\n"
        "what you did.",
        EPILOG,
    )
    add = parser.add_argument
    text = "PDB, mmCIF, XYZ, SDF, graph XML or H5MD file to open in it"
    add("file", metavar="FILE", nargs="?", help=text)
    text = "start structure, if FILE is an ensemble and\nits start is not beside it"
    add("structure", metavar="STRUCTURE", nargs="?", help=text)
    add(
        "--connect",
        metavar="HOST:PORT",
        type=server_address,
        help="show a live run (pliant run --imd) and pull on it;\n:PORT alone means this machine",
    )
    add("--distances", metavar="CSV", help="show measured distances, and which of them hold")
    add("--map", metavar="FILE", help="show a density map (MRC, CCP4) that FILE is in")
    add("--resolution", metavar="A", type=float, help="of the map, Angstrom")
    add("--no-open", action="store_true", help="print the address of the page, open no browser")
    return parser


def main(words: Sequence[str] | None = None) -> int:
    """Runs the command; returns its exit code."""
    arguments = make_parser().parse_args(words)
    return console.run_command("play", lambda: _play(arguments))


def _play(arguments: argparse.Namespace) -> int:
    if arguments.connect:
        return _connect(arguments)
    file = page.page_file()
    has_data = arguments.distances is not None or arguments.map is not None
    if arguments.file is None and has_data:
        raise OptionError("--distances, --map: expected FILE too")
    if arguments.file is None:
        _show(file.as_uri(), arguments.no_open)
        return console.EXIT_OK
    given, bare = Path(arguments.file), file.read_bytes()
    name = console.printable(given.name)
    data, facts = _read(given, arguments)
    full = page.with_file(bare, name, data, **facts)
    with PageServer(full, page.without_file(bare, name)) as server:
        _show(server.address, arguments.no_open)
        _serve(server)
    return console.EXIT_OK


def _read(given: Path, arguments: argparse.Namespace) -> tuple[bytes, dict[str, Any]]:
    """The file, and what else a page is told of it: data; domains and shapes of frames."""
    from pliant.play.ensemble.many_frames import is_many_frames

    structure = arguments.structure
    if not is_many_frames(given):
        if structure is not None:
            raise OptionError("STRUCTURE: goes with an ensemble in H5MD, which FILE is not")
        return page.read_given(given), _measured(given, arguments)
    if arguments.distances is not None or arguments.map is not None:
        raise OptionError("--distances, --map: go with a structure, and FILE has many frames")
    from pliant.play.ensemble.facts import ensemble_for_page

    console.note("looking for domains and shapes in the frames")
    found = ensemble_for_page(given, None if structure is None else Path(structure))
    return found.data, {"known": {"ensemble": found.facts}}


def _measured(given: Path, arguments: argparse.Namespace) -> dict[str, Any]:
    data = (arguments.distances, arguments.map, arguments.resolution)
    if data == (None, None, None):
        return {}
    from pliant.play.measured import measured_for_page

    return measured_for_page(given, *data)


def _connect(arguments: argparse.Namespace) -> int:
    if arguments.file is None:
        raise OptionError("--connect: expected FILE too, the one that the run reads")
    (host, port), given = arguments.connect, Path(arguments.file)
    facts = _measured(given, arguments)
    return connect(host, port, given, lambda at: _show(at, arguments.no_open), facts)


def _show(address: str, no_open: bool) -> None:
    if no_open or not webbrowser.open(address):
        print(address, flush=True)
    else:
        print(f"opened {address}", flush=True)


def _serve(server: PageServer) -> None:
    """Until Ctrl-C, which is the way out and no error."""
    try:
        server.serve_forever(poll_interval=0.2)
    except KeyboardInterrupt:
        console.note("stopped")
