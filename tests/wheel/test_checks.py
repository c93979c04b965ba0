# SPDX-License-Identifier: MIT
"""Each check refuses a wheel that would not run there; a wheel becomes another system's."""

import importlib
import subprocess
import sys
import zipfile

import pytest
from emulated import PORTABLE, ROOT, targets

FOLDER = ROOT / "python" / "wheel"
#: an extension as small as it can be; what is defined says what is wrong with it
SOURCE = """
#include <stdlib.h>
#ifdef _WIN32
#define SHOWN __declspec(dllexport)
__declspec(dllimport)
#else
#define SHOWN __attribute__((visibility("default")))
#endif
extern void* PyLong_FromLong(long);
SHOWN void* PyInit__core(void) { return PyLong_FromLong(malloc(3) != 0); }
#ifndef WITHOUT_COMMAND
SHOWN int pliant_command(void) { return 0; }
#endif
#ifdef LOOSE
extern void of_nobody(void);
SHOWN void loose(void) { of_nobody(); }
#endif
"""


@pytest.fixture(scope="module")
def wheel():
    """The scripts as modules; skips where what they need is not installed."""
    for name in ("lief", "wheel"):
        pytest.importorskip(name, reason=f"{name} is not installed: ./dev wheel --all does it")
    sys.path.insert(0, str(FOLDER))
    yield {name: importlib.import_module(name) for name in ("check_wheel", "retarget_wheel")}
    sys.path.remove(str(FOLDER))


def import_library(folder, dll):
    """By which the linker knows what is in Python's DLL."""
    definition, made = folder / "python.def", folder / "libpython.a"
    definition.write_text(f"LIBRARY {dll}\nEXPORTS\nPyLong_FromLong\n")
    words = ["-m", "i386:x86-64", "-d", definition, "-l", made, "-D", dll]
    subprocess.run([sys.executable, "-m", "ziglang", "dlltool", *map(str, words)], check=True)
    return made


@pytest.fixture
def check(wheel, tmp_path):
    """What the check says, in one line, of a wheel with this platform and an extension that the
    compiler of a target makes."""

    def checked(platform, target, *flags, python="cp312-abi3", dll=""):
        compiler = PORTABLE / target / "bin/cc"
        if not compiler.exists():
            pytest.skip(f"build/portable has no compiler of {target}: ./dev wheel --all makes it")
        source, made = tmp_path / "it.c", tmp_path / "it.so"
        source.write_text(SOURCE)
        libraries = [import_library(tmp_path, dll)] if dll else []
        flags = [*flags, *(["-undefined", "dynamic_lookup"] if "macos" in target else [])]
        subprocess.run(
            [compiler, "-O2", "-shared", *flags, source, *libraries, "-o", made], check=True
        )
        path = tmp_path / f"pliant-1.0-{python}-{platform}.whl"
        with zipfile.ZipFile(path, "w") as packed:
            packed.write(made, f"pliant/_core.{'pyd' if dll else 'so'}")
        try:
            return wheel["check_wheel"].check(path)
        except (wheel["check_wheel"].UnfitError, ValueError) as error:
            return str(error)

    return checked


@pytest.mark.parametrize(
    ("platform", "target", "flags", "said"),
    [
        ("macosx_11_0_arm64", "macos-arm64", [], "fits macOS-11.0 on arm64"),
        ("macosx_10_15_x86_64", "macos-x86_64", [], "fits macOS-10.15 on x86_64"),
        ("macosx_11_0_arm64", "macos-x86_64", [], "the processor: 'x86_64'"),
        ("macosx_11_0_arm64", "macos-arm64", ["-DWITHOUT_COMMAND"], "not shown: pliant_command"),
        ("macosx_11_0_arm64", "macos-arm64", ["-DLOOSE"], "of no library: of_nobody"),
        ("macosx_11_0_arm64", "linux-aarch64", [], "the format: "),
        ("manylinux_2_28_aarch64", "linux-aarch64", [], "fits glibc-2.28 on aarch64"),
        ("manylinux_2_28_x86_64", "linux-aarch64", [], "the processor: 'aarch64'"),
        ("musllinux_1_2_aarch64", "linux-aarch64", [], "of no platform in targets.txt"),
    ],
)
def test_macos_and_linux(check, platform, target, flags, said):
    assert said in check(platform, target, *flags)


def test_a_later_macos_is_found(check, monkeypatch):
    row = targets()["macos-arm64"]._replace(oldest="macOS-10.0")
    monkeypatch.setattr(sys.modules["check_wheel"], "target_of", lambda _: row)
    said = check(row.platform, row.name)
    assert said == "the oldest system: 'macOS-11.0', expected 'macOS-10.0'"


@pytest.mark.parametrize(
    ("python", "dll", "said"),
    [
        ("cp312-abi3", "python3.dll", "fits Windows-10 on x86_64"),
        ("cp310-cp310", "python310.dll", "fits Windows-10 on x86_64"),
        ("cp312-abi3", "python312.dll", "libraries that Windows has not: python312.dll"),
        ("cp311-cp311", "python310.dll", "libraries that Windows has not: python310.dll"),
    ],
)
def test_windows(check, python, dll, said):
    assert said in check("win_amd64", "windows-x86_64", python=python, dll=dll)


@pytest.fixture
def linux_wheel(tmp_path):
    info, tag = "pliant-1.0.dist-info", "cp312-abi3-linux_x86_64"
    files = {
        "pliant/__init__.py": "",
        "pliant/_core.abi3.so": "ours",
        "pliant/_core.pyi": "",
        "pliant-1.0.data/scripts/pliant": "#!python\n",
        f"{info}/METADATA": "Metadata-Version: 2.1\nName: pliant\nVersion: 1.0\n",
        f"{info}/WHEEL": f"Wheel-Version: 1.0\nRoot-Is-Purelib: false\nTag: {tag}\n",
        f"{info}/entry_points.txt": "[console_scripts]\npliant-demo = demo:main\n",
    }
    tree = tmp_path / "tree"
    for name, text in files.items():
        (tree / name).parent.mkdir(parents=True, exist_ok=True)
        (tree / name).write_text(text)
    words = ["pack", str(tree), "--dest-dir", str(tmp_path)]
    subprocess.run([sys.executable, "-m", "wheel", *words], check=True)
    return tmp_path / f"pliant-1.0-{tag}.whl"


@pytest.mark.parametrize(
    ("target", "extension", "command"),
    [
        ("macos-arm64", "pliant/_core.abi3.so", "pliant-1.0.data/scripts/pliant"),
        ("windows-x86_64", "pliant/_core.pyd", "pliant_command.py"),
    ],
)
def test_all_but_extension_and_command_stays(
    wheel, linux_wheel, tmp_path, target, extension, command
):
    row = targets()[target]
    theirs = tmp_path / "_core.so"
    theirs.write_bytes(b"theirs")
    made = wheel["retarget_wheel"].retarget(linux_wheel, row, theirs, tmp_path / "out")
    assert made.name == f"pliant-1.0-cp312-abi3-{row.platform}.whl"
    with zipfile.ZipFile(made) as packed:
        texts = {name: packed.read(name).decode() for name in packed.namelist()}
    assert texts[extension] == "theirs"
    assert texts[command] == "#!python\n"
    assert len(texts) == 8
    info = "pliant-1.0.dist-info"
    assert f"Tag: cp312-abi3-{row.platform}\n" in texts[f"{info}/WHEEL"]
    has_entry = "pliant = pliant_command:main\n" in texts[f"{info}/entry_points.txt"]
    assert has_entry == (row.system == "windows")


def test_an_extension_is_named_as_its_python_looks_for_it(wheel):
    row, named = targets(), wheel["retarget_wheel"].extension_name
    assert named(row["windows-x86_64"], "cp310", "cp310") == "_core.cp310-win_amd64.pyd"
    assert named(row["macos-arm64"], "cp311", "cp311") == "_core.cpython-311-darwin.so"
    linux = named(row["linux-aarch64"], "cp310", "cp310")
    assert linux == "_core.cpython-310-aarch64-linux-gnu.so"
