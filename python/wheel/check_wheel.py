# SPDX-License-Identifier: MIT
"""check_wheel.py WHEEL...: whether the extension in each needs only what its system has.

Of macOS and Windows: processor, oldest system, libraries, and that nothing but Python is left to be
found. Of Linux auditwheel looks at that (finish_wheels.sh), and here the processor alone. abi3audit
looks at the names that are taken from Python. The first that fails is told, and the exit code is 1.
"""

import re
import sys
from pathlib import Path
from zipfile import ZipFile

import lief

sys.path.insert(0, str(Path(__file__).parent))
from targets import Target, target_of

EXPORTED = {"PyInit__core", "pliant_command"}
PROCESSORS = {"X86_64": "x86_64", "AMD64": "x86_64", "AARCH64": "aarch64", "ARM64": "arm64"}
MACOS_LIBRARY = "/usr/lib/libSystem.B.dylib"
# What every Windows 10 has: the C library (UCRT) by its parts, and these.
WINDOWS_C = re.compile(r"api-ms-win-crt-[a-z]+-l1-1-0\.dll")
WINDOWS_LIBRARIES = {"advapi32.dll", "kernel32.dll", "ntdll.dll", "shell32.dll", "ws2_32.dll"}
PYTHON_NAME = re.compile(r"_?Py[A-Z_]")


class UnfitError(Exception):
    """Why a wheel would not run where its name says."""


def expect(what: str, found: object, expected: object) -> None:
    """Raises UnfitError where they differ."""
    if found != expected:
        raise UnfitError(f"{what}: {found!r}, expected {expected!r}")


def expect_none(what: str, names: set[str]) -> None:
    """Raises UnfitError where there are any."""
    if names:
        raise UnfitError(f"{what}: {', '.join(sorted(names))}")


def processor(kind: object) -> str:
    """The word of targets.txt for what lief calls a processor."""
    word = str(kind).rpartition(".")[2]
    return PROCESSORS.get(word, word)


def check_linux(file: lief.ELF.Binary, target: Target, python: str) -> None:
    """Its processor."""
    expect("the processor", processor(file.header.machine_type), target.processor)


def check_macos(file: lief.MachO.Binary, target: Target, python: str) -> None:
    """Load commands and symbols."""
    expect("the processor", processor(file.header.cpu_type), target.processor)
    oldest = file.build_version.minos if file.has_build_version else file.version_min.version
    expect("the oldest system", f"macOS-{oldest[0]}.{oldest[1]}", target.oldest)
    itself = lief.MachO.LoadCommand.TYPE.ID_DYLIB
    libraries = [str(one.name) for one in file.libraries if one.command != itself]
    expect("the libraries", libraries, [MACOS_LIBRARY])
    expect("the paths where libraries are looked for", [one.path for one in file.rpaths], [])
    # On arm64 the system runs nothing that is not signed; a signature without a name is enough.
    expect("signed", file.has_code_signature or target.processor != "arm64", True)
    expect_none("not shown", EXPORTED - {str(one.name)[1:] for one in file.exported_symbols})
    # A symbol of no library is looked for in whoever has it.
    loose = {str(s.name)[1:] for s in file.imported_symbols if s.library_ordinal != 1}
    expect_none("of no library", {name for name in loose if not PYTHON_NAME.match(name)})


def check_windows(file: lief.PE.Binary, target: Target, python: str) -> None:
    """Tables of imports and exports."""
    expect("the processor", processor(file.header.machine), target.processor)
    expect("imports when called", file.has_delay_imports, False)
    expect_none("not shown", EXPORTED - {str(one.name) for one in file.exported_functions})
    own = f"python{python}.dll"
    needed = {str(library.name) for library in file.imports} - {own}
    there = {n for n in needed if n.lower() in WINDOWS_LIBRARIES or WINDOWS_C.fullmatch(n.lower())}
    expect_none("libraries that Windows has not", needed - there)


CHECKS = {"linux": check_linux, "macos": check_macos, "windows": check_windows}
FORMATS = {"linux": lief.ELF.Binary, "macos": lief.MachO.Binary, "windows": lief.PE.Binary}


def check(wheel: Path) -> str:
    """Raises UnfitError or ValueError; else a line about it."""
    target = target_of(wheel)
    _, _, python, abi, _ = wheel.stem.split("-")
    with ZipFile(wheel) as packed:
        expect("what is damaged", packed.testzip(), None)
        files = [n for n in packed.namelist() if re.fullmatch(r"pliant/_core\.[^/]*(so|pyd)", n)]
        expect("the number of extensions", len(files), 1)
        file = lief.parse(packed.read(files[0]))
    expect("the format", type(file), FORMATS[target.system])
    CHECKS[target.system](file, target, "3" if abi == "abi3" else python.removeprefix("cp"))
    return f"{wheel.name}: {files[0]} fits {target.oldest} on {target.processor}"


def main(wheels: list[str]) -> int:
    """The exit code."""
    for name in wheels:
        try:
            print(check(Path(name)))
        except (UnfitError, ValueError) as error:
            print(f"{Path(name).name}: {error}", file=sys.stderr)
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
