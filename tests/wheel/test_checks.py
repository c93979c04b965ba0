# SPDX-License-Identifier: MIT
"""Each check refuses a wheel that would not run there; a wheel becomes another system's."""

import importlib
import subprocess
import sys
import zipfile

import pytest
from emulated import ROOT, targets

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
    for name in ("lief", "wheel", "ziglang"):
        pytest.importorskip(name, reason=f"{name} is not installed: ./dev wheel --all does it")
    sys.path.insert(0, str(FOLDER))
    yield {name: importlib.import_module(name) for name in ("check_wheel", "retarget_wheel")}
    sys.path.remove(str(FOLDER))


def zig(*words):
    subprocess.run([sys.executable, "-m", "ziglang", *map(str, words)], check=True)


def import_library(folder, dll):
    """By which the linker knows what is in Python's DLL."""
    (folder / "python.def").write_text(f"LIBRARY {dll}\nEXPORTS\nPyLong_FromLong\n")
    made = folder / "libpython.a"
    zig("dlltool", "-m", "i386:x86-64", "-d", folder / "python.def", "-l", made, "-D", dll)
    return made


@pytest.fixture
def check(wheel, tmp_path):
    """What the check says of a wheel with this platform and an extension of these flags."""

    def checked(platform, *flags, python="cp312-abi3", dll=""):
        source, made = tmp_path / "it.c", tmp_path / "it.so"
        source.write_text(SOURCE)
        libraries = [import_library(tmp_path, dll)] if dll else []
        zig("cc", "-shared", *flags, source, *libraries, "-o", made)
        path = tmp_path / f"pliant-1.0-{python}-{platform}.whl"
        with zipfile.ZipFile(path, "w") as packed:
            packed.write(made, f"pliant/_core.{'pyd' if dll else 'so'}")
        try:
            return wheel["check_wheel"].check(path)
        except (wheel["check_wheel"].UnfitError, ValueError) as error:
            return str(error)

    return checked


ARM = ("-target", "aarch64-macos.11.0", "-undefined", "dynamic_lookup")
INTEL = ("-target", "x86_64-macos.10.15", "-undefined", "dynamic_lookup")
LATER = ("-target", "aarch64-macos.13.0", "-undefined", "dynamic_lookup")
LINUX = ("-target", "aarch64-linux-gnu.2.28")


@pytest.mark.parametrize(
    ("platform", "flags", "said"),
    [
        ("macosx_11_0_arm64", ARM, "fits macOS-11.0 on arm64"),
        ("macosx_10_15_x86_64", INTEL, "fits macOS-10.15 on x86_64"),
        ("macosx_11_0_arm64", INTEL, "the processor: 'x86_64'"),
        ("macosx_11_0_arm64", LATER, "the oldest system: 'macOS-13.0'"),
        ("macosx_11_0_arm64", [*ARM, "-DWITHOUT_COMMAND"], "not shown: pliant_command"),
        ("macosx_11_0_arm64", [*ARM, "-DLOOSE"], "of no library: of_nobody"),
        ("macosx_11_0_arm64", LINUX, "the format: "),
        ("manylinux_2_28_aarch64", LINUX, "fits glibc-2.28 on aarch64"),
        ("manylinux_2_28_x86_64", LINUX, "the processor: 'aarch64'"),
        ("musllinux_1_2_aarch64", LINUX, "of no platform in targets.txt"),
    ],
)
def test_macos_and_linux(check, platform, flags, said):
    assert said in check(platform, *flags)


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
    assert said in check("win_amd64", "-target", "x86_64-windows-gnu", python=python, dll=dll)


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
