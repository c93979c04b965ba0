# SPDX-License-Identifier: MIT
"""retarget_wheel.py WHEEL TARGET EXTENSION FOLDER: the wheel of another system, into FOLDER.

Wheels of one version of Python differ in the extension alone, so all else is taken from WHEEL,
which was built for this machine. On Windows, where no script can be a command, pip makes one of an
entry point.
"""

import base64
import hashlib
import sys
from pathlib import Path
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

sys.path.insert(0, str(Path(__file__).parent))
from targets import Target, targets

MODULE = "pliant_command.py"  # command.py, where it is called and not run
ENTRY = "pliant = pliant_command:main\n"
# The extension as each system's Python looks for it: of the stable ABI, or of one version.
STABLE = {"linux": "_core.abi3.so", "macos": "_core.abi3.so", "windows": "_core.pyd"}
OF_VERSION = {
    "linux": "_core.cpython-{version}-{processor}-linux-gnu.so",
    "macos": "_core.cpython-{version}-darwin.so",
    "windows": "_core.cp{version}-win_amd64.pyd",
}


def extension_name(target: Target, python: str, abi: str) -> str:
    """PYTHON and ABI are tags of the wheel, such as cp312 and abi3."""
    if abi == "abi3":
        return STABLE[target.system]
    version = python.removeprefix("cp")
    return OF_VERSION[target.system].format(version=version, processor=target.processor)


def _is_extension(name: str) -> bool:
    return name.startswith("pliant/_core.") and name.endswith((".so", ".pyd"))


def _retagged(text: str, target: Target) -> str:
    """The file WHEEL with the platform of the target in each tag."""
    lines = text.splitlines()
    for number, line in enumerate(lines):
        if line.startswith("Tag: "):
            lines[number] = f"{line.rpartition('-')[0]}-{target.platform}"
    return "\n".join(lines) + "\n"


def _with_command(points: str) -> str:
    heading = "[console_scripts]\n"
    if heading not in points:
        raise ValueError("entry_points.txt has no [console_scripts]")
    return points.replace(heading, heading + ENTRY)


def _contents(
    wheel: Path, target: Target, extension: bytes, name: str
) -> dict[str, tuple[bytes, int]]:
    """Bytes and permissions of each file by its name, without the record of them."""
    files: dict[str, tuple[bytes, int]] = {}
    with ZipFile(wheel) as source:
        for entry in source.infolist():
            data, mode = source.read(entry), entry.external_attr
            path = entry.filename
            if path.endswith((".dist-info/RECORD", "/")):
                continue
            if _is_extension(path):
                path, data = f"pliant/{name}", extension
            elif path.endswith(".dist-info/WHEEL"):
                data = _retagged(data.decode(), target).encode()
            elif target.system == "windows" and path.endswith(".data/scripts/pliant"):
                path = MODULE
            elif target.system == "windows" and path.endswith(".dist-info/entry_points.txt"):
                data = _with_command(data.decode()).encode()
            files[path] = (data, mode)
    return files


def _record(files: dict[str, tuple[bytes, int]], record: str) -> bytes:
    lines = []
    for path, (data, _) in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        lines.append(f"{path},sha256={digest},{len(data)}\n")
    return "".join([*lines, f"{record},,\n"]).encode()


def retarget(wheel: Path, target: Target, extension: Path, folder: Path) -> Path:
    """Writes the wheel; its path."""
    package, version, python, abi, _ = wheel.stem.split("-")
    name = extension_name(target, python, abi)
    files = _contents(wheel, target, extension.read_bytes(), name)
    if f"pliant/{name}" not in files:
        raise ValueError(f"{wheel.name}: has no extension to replace")
    record = f"{package}-{version}.dist-info/RECORD"
    files[record] = (_record(files, record), 0o644 << 16)
    made = folder / f"{package}-{version}-{python}-{abi}-{target.platform}.whl"
    folder.mkdir(parents=True, exist_ok=True)
    with ZipFile(made, "w", ZIP_DEFLATED) as packed:
        for path, (data, mode) in files.items():
            entry = ZipInfo(path)  # of 1980: the same files give the same wheel
            entry.external_attr, entry.compress_type = mode, ZIP_DEFLATED
            packed.writestr(entry, data)
    return made


if __name__ == "__main__":
    print(retarget(Path(sys.argv[1]), targets()[sys.argv[2]], Path(sys.argv[3]), Path(sys.argv[4])))
