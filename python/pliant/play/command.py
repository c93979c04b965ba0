# SPDX-License-Identifier: MIT
"""The command ``pliant play``."""

from __future__ import annotations

import argparse
import webbrowser
from collections.abc import Sequence
from pathlib import Path

from pliant import console
from pliant.play import page
from pliant.play.server import PageServer

EPILOG = """\
The page is a single file with the solver inside, as WebAssembly. It never uses the network, and
what you open does not leave your machine. FILE is handed to the browser once, over a local address
(127.0.0.1) that cannot be guessed; the command keeps running until Ctrl-C. Without FILE the page
is opened as a file, and you can drop files on it.

In the page: drag an atom to pull it, drag the background to rotate the view; "?" explains the
rest.

exit codes: 0 done, 1 FILE cannot be read, or the package was built without the page; 2 bad option

examples:
  pliant play
  pliant play protein.pdb
  pliant play caffeine.sdf --no-open
"""


def make_parser() -> console.Parser:
    """The options of pliant play."""
    parser = console.Parser(
        "play",
        "Opens a page in the browser in which you pull at the atoms of a molecule, watch bars\n"
        "(two atoms at a fixed distance) break and be repaired, and record, replay and save\n"
        "what you did.",
        EPILOG,
    )
    add = parser.add_argument
    add("file", metavar="FILE", nargs="?",
        help="PDB, mmCIF, XYZ, SDF, graph XML or H5MD file to open in it")  # fmt: skip
    add(
        "--no-open",
        action="store_true",
        help="print the address of the page, do not open a browser",
    )
    return parser


def main(words: Sequence[str] | None = None) -> int:
    """Runs the command; returns its exit code."""
    arguments = make_parser().parse_args(words)
    return console.run_command("play", lambda: _play(arguments))


def _play(arguments: argparse.Namespace) -> int:
    file = page.page_file()
    if arguments.file is None:
        _show(file.as_uri(), arguments.no_open)
        return console.EXIT_OK
    given, bare = Path(arguments.file), file.read_bytes()
    name = console.printable(given.name)
    full = page.with_file(bare, name, page.read_given(given))
    with PageServer(full, page.without_file(bare, name)) as server:
        _show(server.address, arguments.no_open)
        _serve(server)
    return console.EXIT_OK


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
