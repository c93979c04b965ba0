# SPDX-License-Identifier: MIT
"""check_wheel.py WHEEL...: whether the extension in each needs only what its system has.

Of macOS and Windows: processor, oldest system, libraries, and each name it takes from Python, which
must be of the stable ABI where the wheel says so. Of Linux auditwheel looks at that
(finish_wheels.sh); here the processor alone. The first that fails is told, and the exit code is 1.
"""

import re
import struct
import sys
from pathlib import Path
from zipfile import ZipFile

sys.path.insert(0, str(Path(__file__).parent))
import macho
import pe
import stable_abi
from targets import Target, target_of

EXPORTED = {"PyInit__core", "pliant_command"}
ELF_PROCESSORS = {62: "x86_64", 183: "aarch64"}
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
        raise UnfitError(f"{what} is {found!r}, expected {expected!r}")


def expect_none(what: str, names: set[str]) -> None:
    """Raises UnfitError where there are any."""
    if names:
        raise UnfitError(f"{what}: {', '.join(sorted(names))}")


def expect_stable(names: set[str], wheel: Path) -> None:
    """That a wheel for all later versions of Python asks for the stable ABI alone."""
    _, _, python, abi, _ = wheel.stem.split("-")
    if abi != "abi3":
        return
    version = f"{python[2]}.{python[3:]}"
    functions, data = stable_abi.names(version)
    expect_none(f"not in the stable ABI of Python {version}", names - functions - data)


def check_linux(data: bytes, target: Target, wheel: Path) -> None:
    """Its processor."""
    expect("the beginning", data[:5], b"\x7fELF\x02")
    (machine,) = struct.unpack_from("<H", data, 18)
    expect("the processor", ELF_PROCESSORS.get(machine, machine), target.processor)


def check_macos(data: bytes, target: Target, wheel: Path) -> None:
    """Load commands and symbols."""
    file = macho.read(data)
    expect("the processor", file.processor, target.processor)
    expect("the oldest system", f"macOS-{file.oldest}", target.oldest)
    expect("the libraries", file.libraries, [MACOS_LIBRARY])
    expect("the paths where libraries are looked for", file.search_paths, [])
    # On arm64 the system runs nothing that is not signed; a signature without a name is enough.
    expect("signed", file.signed or target.processor != "arm64", True)
    expect_none("not shown", EXPORTED - file.exported)
    loose = file.needed.get("", set())
    python = {name for name in loose if PYTHON_NAME.match(name)}
    expect_none("of no library", loose - python)
    expect_stable(python, wheel)


def _is_of_windows(library: str) -> bool:
    return library.lower() in WINDOWS_LIBRARIES or bool(WINDOWS_C.fullmatch(library.lower()))


def check_windows(data: bytes, target: Target, wheel: Path) -> None:
    """Tables of imports and exports."""
    file = pe.read(data)
    expect("the processor", file.processor, target.processor)
    expect("imports when called", file.delayed, False)
    expect_none("not shown", EXPORTED - file.exported)
    _, _, python, abi, _ = wheel.stem.split("-")
    own = "python3.dll" if abi == "abi3" else f"python{python.removeprefix('cp')}.dll"
    expect_none(
        "libraries that Windows has not",
        {name for name in file.needed if not _is_of_windows(name)} - {own},
    )
    expect_stable(file.needed.get(own, set()), wheel)


CHECKS = {"linux": check_linux, "macos": check_macos, "windows": check_windows}


def check(wheel: Path) -> str:
    """Raises UnfitError or ValueError; else a line about it."""
    target = target_of(wheel)
    with ZipFile(wheel) as packed:
        bad = packed.testzip()
        expect("what is damaged", bad, None)
        files = [n for n in packed.namelist() if re.fullmatch(r"pliant/_core\.[^/]*(so|pyd)", n)]
        expect("the number of extensions", len(files), 1)
        CHECKS[target.system](packed.read(files[0]), target, wheel)
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
