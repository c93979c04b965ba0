# SPDX-License-Identifier: MIT
"""The table of systems that wheels are made for, how a wheel is made another system's, and that
each check refuses a wheel that would not run there."""

import importlib
import re
import subprocess
import sys
import zipfile

import pytest
from foreign_files import SYSTEM, WHOEVER, dll, elf, macho
from sources import ROOT

FOLDER = ROOT / "python" / "wheel"
EXPORTED = ["PyInit__core", "pliant_command"]
STABLE = "PyLong_FromLong"


@pytest.fixture(scope="module")
def wheel():
    """The scripts as modules."""
    sys.path.insert(0, str(FOLDER))
    names = ("targets", "check_wheel", "retarget_wheel", "stable_abi", "python_headers")
    yield {name: importlib.import_module(name) for name in names}
    sys.path.remove(str(FOLDER))


@pytest.fixture
def check(wheel, tmp_path, monkeypatch):
    """What the check says of a wheel with this platform and extension, in one line."""
    stable = wheel["stable_abi"].Names({STABLE}, {"PyExc_ValueError"})
    monkeypatch.setattr(wheel["stable_abi"], "names", lambda version: stable)

    def checked(platform, extension, python="cp312-abi3", name="_core.abi3.so"):
        path = tmp_path / f"pliant-1.0-{python}-{platform}.whl"
        with zipfile.ZipFile(path, "w") as packed:
            packed.writestr(f"pliant/{name}", extension)
        try:
            return wheel["check_wheel"].check(path)
        except (wheel["check_wheel"].UnfitError, ValueError) as error:
            return str(error)

    return checked


def test_every_row_is_whole(wheel):
    rows = wheel["targets"].targets()
    assert len(rows) == len({row.platform for row in rows.values()}) == 5
    for name, row in rows.items():
        assert name == f"{row.system}-{row.processor}"
        assert row.tried in ("python", "qemu", "wine", "no")
        number = re.search(r"[0-9][0-9.]*", row.oldest)[0]
        if row.system == "macos":
            assert row.zig.endswith(f"-macos.{number}")
            assert row.platform == f"macosx_{number.replace('.', '_')}_{row.processor}"
        if row.system == "linux":
            assert row.zig == f"{row.processor}-linux-gnu.{number}"
            assert row.platform == f"manylinux_{number.replace('.', '_')}_{row.processor}"


def test_the_shell_reads_the_same_table(wheel):
    script = """. python/wheel/targets.sh; fields="zig platform oldest tried"
      for name in $(target_names); do
        echo $name $(for field in $fields; do target_field $name $field; done)
      done"""
    said = subprocess.run(["bash", "-c", script], cwd=ROOT, capture_output=True, text=True)
    rows = wheel["targets"].targets().values()
    assert said.stdout.splitlines() == [" ".join(row) for row in rows]
    missing = "set -e; . python/wheel/targets.sh; target_field beos-x86 zig"
    said = subprocess.run(["bash", "-c", missing], cwd=ROOT, capture_output=True, text=True)
    assert (said.returncode, said.stderr) == (1, "targets.txt: no target beos-x86\n")


def test_the_readme_has_every_system(wheel):
    text = (FOLDER / "README.md").read_text(encoding="utf-8")
    for row in wheel["targets"].targets().values():
        assert f"`{row.platform}`" in text


GOOD_MAC = [("malloc", 1), (STABLE, WHOEVER)]


@pytest.mark.parametrize(
    ("file", "said"),
    [
        (macho("arm64", (11, 0), EXPORTED, GOOD_MAC), "fits macOS-11.0 on arm64"),
        (macho("x86_64", (11, 0), EXPORTED, GOOD_MAC), "the processor is 'x86_64'"),
        (macho("arm64", (13, 0), EXPORTED, GOOD_MAC), "the oldest system is 'macOS-13.0'"),
        (macho("arm64", (11, 0), EXPORTED[:1], GOOD_MAC), "not shown: pliant_command"),
        (
            macho("arm64", (11, 0), EXPORTED, GOOD_MAC, (SYSTEM, "/opt/lib/libc++.1.dylib")),
            "the libraries is ['/usr/lib/libSystem.B.dylib', '/opt/lib/libc++.1.dylib']",
        ),
        (
            macho("arm64", (11, 0), EXPORTED, [*GOOD_MAC, ("__cxa_throw", WHOEVER)]),
            "of no library: __cxa_throw",
        ),
        (
            macho("arm64", (11, 0), EXPORTED, [("PyUnicode_AsUTF8", WHOEVER)]),
            "not in the stable ABI of Python 3.12: PyUnicode_AsUTF8",
        ),
        (macho("arm64", (11, 0), EXPORTED, GOOD_MAC, signed=False), "signed is False"),
        (elf(183), "is no Mach-O file of 64 bits"),
    ],
)
def test_macos(check, file, said):
    assert said in check("macosx_11_0_arm64", file)


WINDOWS = {"KERNEL32.dll": ["ReadFile"], "api-ms-win-crt-heap-l1-1-0.dll": ["malloc"]}


@pytest.mark.parametrize(
    ("file", "said"),
    [
        (dll(EXPORTED, {**WINDOWS, "python3.dll": [STABLE]}), "fits Windows-10 on x86_64"),
        (dll(EXPORTED, WINDOWS, machine=0xAA64), "the processor is 'arm64'"),
        (dll(EXPORTED[1:], WINDOWS), "not shown: PyInit__core"),
        (
            dll(EXPORTED, {**WINDOWS, "libstdc++-6.dll": ["a"]}),
            "libraries that Windows has not: libstdc++-6.dll",
        ),
        (
            dll(EXPORTED, {"python312.dll": [STABLE]}),
            "libraries that Windows has not: python312.dll",
        ),
        (
            dll(EXPORTED, {"python3.dll": [STABLE, "_PyErr_Print"]}),
            "not in the stable ABI of Python 3.12: _PyErr_Print",
        ),
        (elf(62), "is no file of Windows"),
    ],
)
def test_windows(check, file, said):
    assert said in check("win_amd64", file, name="_core.pyd")


def test_windows_of_one_version_needs_its_own_dll(check):
    file = dll(EXPORTED, {"python310.dll": ["_PyAnything"]})
    name = "_core.cp310-win_amd64.pyd"
    assert "fits Windows-10" in check("win_amd64", file, "cp310-cp310", name)
    assert "has not: python310.dll" in check("win_amd64", file, "cp311-cp311", name)


def test_linux(check):
    assert "fits glibc-2.28 on aarch64" in check("manylinux_2_28_aarch64", elf(183))
    assert "the processor is 'x86_64'" in check("manylinux_2_28_aarch64", elf(62))
    assert "of no platform in targets.txt" in check("musllinux_1_2_x86_64", elf(62))


@pytest.fixture
def linux_wheel(tmp_path):
    path = tmp_path / "pliant-1.0-cp312-abi3-linux_x86_64.whl"
    files = {
        "pliant/__init__.py": "",
        "pliant/_core.abi3.so": "ours",
        "pliant-1.0.data/scripts/pliant": "#!python\n",
        "pliant-1.0.dist-info/WHEEL": "Root-Is-Purelib: false\nTag: cp312-abi3-linux_x86_64\n",
        "pliant-1.0.dist-info/entry_points.txt": "[console_scripts]\npliant-demo = demo:main\n",
        "pliant-1.0.dist-info/RECORD": "",
    }
    with zipfile.ZipFile(path, "w") as packed:
        for name, text in files.items():
            packed.writestr(name, text)
    return path


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
    row = wheel["targets"].targets()[target]
    theirs = tmp_path / "_core.so"
    theirs.write_bytes(b"theirs")
    made = wheel["retarget_wheel"].retarget(linux_wheel, row, theirs, tmp_path / "out")
    assert made.name == f"pliant-1.0-cp312-abi3-{row.platform}.whl"
    with zipfile.ZipFile(made) as packed:
        texts = {name: packed.read(name).decode() for name in packed.namelist()}
    assert texts[extension] == "theirs"
    assert texts[command] == "#!python\n"
    info = "pliant-1.0.dist-info"
    assert f"Tag: cp312-abi3-{row.platform}\n" in texts[f"{info}/WHEEL"]
    has_entry = "pliant = pliant_command:main\n" in texts[f"{info}/entry_points.txt"]
    assert has_entry == (row.system == "windows")
    recorded = [line.split(",")[0] for line in texts[f"{info}/RECORD"].splitlines()]
    assert sorted(recorded) == sorted(texts)


def test_an_extension_is_named_as_its_python_looks_for_it(wheel):
    row, named = wheel["targets"].targets(), wheel["retarget_wheel"].extension_name
    assert named(row["windows-x86_64"], "cp310", "cp310") == "_core.cp310-win_amd64.pyd"
    assert named(row["macos-arm64"], "cp311", "cp311") == "_core.cpython-311-darwin.so"
    linux = named(row["linux-aarch64"], "cp310", "cp310")
    assert linux == "_core.cpython-310-aarch64-linux-gnu.so"


def test_sizes_that_python_is_told(wheel):
    told = wheel["python_headers"].pyconfig
    for system, size_of_long in (("linux", 8), ("macos", 8), ("windows", 4)):
        assert f"#define SIZEOF_LONG {size_of_long}\n" in told(system)
    assert "MS_WINDOWS" not in told("macos")
