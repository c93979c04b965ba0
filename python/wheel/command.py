#!python
# SPDX-License-Identifier: MIT
"""The command of a wheel, installed as `pliant`: calls the one that lies in the extension.

So a wheel has the library once. The package itself is not imported: NumPy would take longer than
many a command. On Windows this is a module, which the program that pip makes calls.
"""

import signal

# As a program in C begins: Ctrl-C ends it, unless whoever started it has that ignored.
if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
    signal.signal(signal.SIGINT, signal.SIG_DFL)

import ctypes
import os
import sys
from importlib.machinery import PathFinder


def _extension() -> str:
    package = PathFinder.find_spec("pliant")
    found = package and PathFinder.find_spec("pliant._core", package.submodule_search_locations)
    if not found or not found.origin:
        sys.exit("pliant: error: the Python package pliant is not installed beside this command")
    return found.origin


def main() -> int:
    """The exit code."""
    words = [os.path.realpath(sys.argv[0]), *sys.argv[1:]]
    arguments = (ctypes.c_char_p * len(words))(*map(os.fsencode, words))
    return ctypes.CDLL(_extension()).pliant_command(len(words), arguments)


if __name__ == "__main__":
    sys.exit(main())
