# SPDX-License-Identifier: MIT
"""python_headers.py INTERPRETER TARGET FOLDER: what an extension for another system is built with.

CPython's headers are the same everywhere but for pyconfig.h, which its build writes. We write one
with what the headers ask for: sizes and a few switches, which the system's ABI settles. Windows
links against a library of the names that Python's DLL has: of python3.dll the stable ABI (PEP 384),
as CPython lists it; of python310.dll and python311.dll what CPython here exports, too.
"""

import json
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any, NamedTuple

FIRST = (3, 12)  # the first version whose stable ABI is enough for nanobind
EVERYWHERE = """
SIZEOF_SHORT 2
SIZEOF_INT 4
SIZEOF_LONG_LONG 8
SIZEOF_VOID_P 8
SIZEOF_SIZE_T 8
SIZEOF_UINTPTR_T 8
SIZEOF_TIME_T 8
SIZEOF_PID_T 4
SIZEOF_FLOAT 4
SIZEOF_DOUBLE 8
SIZEOF__BOOL 1
ALIGNOF_MAX_ALIGN_T 16
HAVE_LONG_LONG 1
HAVE_SSIZE_T 1
HAVE_WCHAR_H 1
HAVE_SYS_STAT_H 1
STDC_HEADERS 1
WITH_DOC_STRINGS 1
WITH_PYMALLOC 1
"""
# LP64: Linux and macOS.
POSIX = """
SIZEOF_LONG 8
SIZEOF_WCHAR_T 4
SIZEOF_PTHREAD_T 8
HAVE_CLOCK_GETTIME 1
HAVE_FORK 1
HAVE_PTHREAD_H 1
HAVE_SYS_SELECT_H 1
HAVE_SYS_TIME_H 1
"""
# LLP64.
WINDOWS = """
SIZEOF_LONG 4
SIZEOF_WCHAR_T 2
MS_WINDOWS 1
MS_WIN32 1
MS_WIN64 1
NT_THREADS 1
HAVE_DECLSPEC_DLL 1
Py_ENABLE_SHARED 1
"""
SYSTEMS = {"linux": POSIX, "macos": POSIX, "windows": WINDOWS}


class Names(NamedTuple):
    """What a library shows."""

    functions: set[str]
    data: set[str]


def pyconfig(system: str) -> str:
    """The text of pyconfig.h."""
    lines = (EVERYWHERE + SYSTEMS[system]).split("\n")
    return "".join(f"#define {line}\n" for line in lines if line)


def asked(interpreter: str) -> dict[str, str]:
    """What the interpreter says of itself."""
    question = (
        "import json, sys, sysconfig as s; print(json.dumps({"
        "'version': '%d.%d' % sys.version_info[:2], 'include': s.get_paths()['include'],"
        "'library': s.get_config_var('LIBDIR') + '/' + s.get_config_var('LDLIBRARY'),"
        "'executable': sys.executable}))"
    )
    said = subprocess.run([interpreter, "-c", question], check=True, capture_output=True, text=True)
    answers: dict[str, str] = json.loads(said.stdout)
    return answers


def stable() -> Names:
    """Those that python3.dll has since FIRST or before."""
    from abi3info import DATAS, FUNCTIONS

    def of(table: dict[Any, Any]) -> set[str]:
        return {
            symbol.name
            for symbol, row in table.items()
            if (row.added.major, row.added.minor) <= FIRST
            and (row.ifdef is None or row.ifdef.windows is True)
        }

    return Names(of(FUNCTIONS), of(DATAS))


def exported(interpreter: dict[str, str]) -> Names:
    """Names that CPython's own library, or program, shows: functions and data."""
    names = Names(set(), set())
    for file in (interpreter["library"], interpreter["executable"]):
        said = subprocess.run(
            ["nm", "-D", "--defined-only", file], check=False, capture_output=True, text=True
        )
        for line in said.stdout.splitlines():
            kind, name = line.split()[-2:]
            if name.startswith(("Py", "_Py")):
                (names.functions if kind in "TWi" else names.data).add(name)
    return names


def import_library(interpreter: dict[str, str], folder: Path) -> None:
    """FOLDER/libpython.a, by which the linker knows what is in Python's DLL."""
    major, minor = interpreter["version"].split(".")
    if (int(major), int(minor)) >= FIRST:
        dll, names = "python3.dll", stable()
    else:
        dll, names = f"python{major}{minor}.dll", exported(interpreter)
    definition = folder / "python.def"
    definition.write_text(
        f"LIBRARY {dll}\nEXPORTS\n"
        + "".join(f"{name}\n" for name in sorted(names.functions))
        + "".join(f"{name} DATA\n" for name in sorted(names.data - names.functions))
    )
    made = folder / "libpython.a"
    zig = [sys.executable, "-m", "ziglang", "dlltool", "-m", "i386:x86-64"]
    subprocess.run([*zig, "-d", str(definition), "-l", str(made), "-D", dll], check=True)


def main(interpreter: str, target: str, folder: Path) -> None:
    """Writes the folder anew: include, and for Windows libpython.a."""
    system = target.partition("-")[0]
    itself = asked(interpreter)
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(
        itself["include"],
        folder / "include",
        ignore=lambda _, names: [
            name for name in names if name in ("internal", "pyconfig.h", "pyconfig-64.h")
        ],
    )
    (folder / "include/pyconfig.h").write_text(pyconfig(system))
    if system == "windows":
        import_library(itself, folder)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], Path(sys.argv[3]))
