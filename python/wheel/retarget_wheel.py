# SPDX-License-Identifier: MIT
"""retarget_wheel.py WHEEL TARGET EXTENSION FOLDER: the wheel of another system, into FOLDER.

Wheels of one version of Python differ in the extension alone, so all else is taken from WHEEL,
which was built for this machine. On Windows, where no script can be a command, pip makes one of an
entry point.
"""

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from targets import Target, targets

MODULE = "pliant_command.py"  # command.py, where it is called and not run
HEADING, ENTRY = "[console_scripts]\n", "pliant = pliant_command:main\n"
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


def _call_by_entry_point(tree: Path) -> None:
    (script,) = tree.glob("*.data/scripts/pliant")
    shutil.move(script, tree / MODULE)
    shutil.rmtree(script.parents[1])
    (points,) = tree.glob("*.dist-info/entry_points.txt")
    text = points.read_text()
    if HEADING not in text:
        raise ValueError("entry_points.txt has no [console_scripts]")
    points.write_text(text.replace(HEADING, HEADING + ENTRY))


def _wheel(*words: object) -> None:
    command = [sys.executable, "-m", "wheel", *map(str, words)]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


def retarget(wheel: Path, target: Target, extension: Path, folder: Path) -> Path:
    """Writes the wheel; its path."""
    package, version, python, abi, _ = wheel.stem.split("-")
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch:
        _wheel("unpack", wheel, "--dest", scratch)
        (tree,) = Path(scratch).iterdir()
        (ours,) = (path for path in tree.glob("pliant/_core.*") if path.suffix != ".pyi")
        ours.unlink()
        shutil.copy(extension, tree / "pliant" / extension_name(target, python, abi))
        if target.system == "windows":
            _call_by_entry_point(tree)
        _wheel("pack", tree, "--dest-dir", folder)
    _wheel("tags", "--remove", "--platform-tag", target.platform, folder / wheel.name)
    return folder / f"{package}-{version}-{python}-{abi}-{target.platform}.whl"


if __name__ == "__main__":
    print(retarget(Path(sys.argv[1]), targets()[sys.argv[2]], Path(sys.argv[3]), Path(sys.argv[4])))
