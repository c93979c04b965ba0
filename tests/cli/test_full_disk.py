# SPDX-License-Identifier: MIT
"""Each output of each command on a full disk: the old file is whole, or the new one is."""

import json
import resource
import shutil
import signal
import subprocess
from pathlib import Path

import forked
import pytest

ROOT = Path(__file__).parents[2]
DIPEPTIDE = ROOT / "data/molecules/alanine_dipeptide.pdb"
HELIX = ROOT / "data/molecules/peptide_20.pdb"

#: a command in Python whose files hold so many bytes: what it returns, and what it says
LIMITED = """
import contextlib, importlib, io, json, resource
module, function, words, limit = {what!r}
main = getattr(importlib.import_module(module), function)
err = io.StringIO()
before = resource.getrlimit(resource.RLIMIT_FSIZE)
resource.setrlimit(resource.RLIMIT_FSIZE, (limit, before[1]))
with contextlib.redirect_stderr(err), contextlib.redirect_stdout(io.StringIO()):
    code = main(words)
resource.setrlimit(resource.RLIMIT_FSIZE, before)
print(json.dumps([code, err.getvalue()]))
"""

CONVERTED = "h5md pdb cif sdf dcd xtc trr xyz".split()

#: the commands: what they are told, and what they write; {} is a trajectory of 21 frames
IN_PYTHON = [
    *((f"convert {{}} -o o.{ending} --overwrite", [f"o.{ending}"]) for ending in CONVERTED),
    ("representatives {} -k 20 -o o.pdb --overwrite", ["o.pdb"]),
    ("recover {} -o o.h5md --overwrite", ["o.h5md"]),
]
#: of each library one
CHEAP = (".sdf", ".dcd", ".xyz", ".cif", "representatives", "recover")

LONG_IN_PYTHON = [
    ("analyse {} -o out", ["out/report.html", "out/frames.csv", "out/ensemble.pdb"]),
    ("convert {} -o o.zarr --overwrite", ["o.zarr"]),
    (f"path {DIPEPTIDE} {DIPEPTIDE} -o o.h5md --csv o.csv --overwrite", ["o.h5md", "o.csv"]),
    ("demo -o out --frames 20 --overwrite", ["out/ensemble.h5md", "out/peptide_20.pdb"]),
    ("bench step --csv o.csv --quick", ["o.csv"]),
]

IN_CPP = [
    (f"run {DIPEPTIDE} --steps 20 -o o.h5md --overwrite", ["o.h5md", "o.pdb"]),
    (f"run {DIPEPTIDE} --steps 20 -o o.pdb --overwrite", ["o.pdb"]),
    (
        f"run {DIPEPTIDE} --steps 20 -o o.h5md --record-forces f.txt --overwrite",
        ["o.h5md", "o.pdb", "f.txt"],
    ),
    (f"sample {DIPEPTIDE} --frames 20 -o o.h5md --overwrite", ["o.h5md", "o.pdb"]),
    (f"sample {DIPEPTIDE} --frames 20 -o o.pdb --overwrite", ["o.pdb"]),
    (f"order {DIPEPTIDE} -o o.txt --overwrite", ["o.txt"]),
    (f"forcegen {DIPEPTIDE} --steps 500 -o o.txt --overwrite", ["o.txt"]),
    ("structgen tree -o o.xml --overwrite", ["o.xml"]),
    (f"rigidity {HELIX} -o out --overwrite", ["out/rigidity.json"]),
]


@pytest.fixture(scope="module")
def trajectory(command, tmp_path_factory):
    path = tmp_path_factory.mktemp("recorded") / "run.h5md"
    words = [command, "run", DIPEPTIDE, "--steps", "20", "-o", path, "--overwrite"]
    subprocess.run(words, check=True, capture_output=True)
    return path


def in_python(words, folder, limit):
    """Exit code, and what is said, of a command whose files are limited."""
    job = (*forked.commands()[words[0]], words[1:], limit)
    ended = forked.ended_code(LIMITED.format(what=job), *forked.HEAVY, cwd=folder)
    assert ended.returncode == 0, ended.stderr
    return json.loads(ended.stdout.splitlines()[-1])


def in_cpp(command, words, folder, limit):
    def limited():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    ended = subprocess.run(
        [command, *words], cwd=folder, preexec_fn=limited, capture_output=True, text=True
    )
    return ended.returncode, ended.stderr


def contents(folder):
    """All files, by their places."""
    found = (path for path in sorted(folder.rglob("*")) if path.is_file())
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in found}


def check_outputs(run, outputs, folder):
    """Without a file and with an older one, where room is for nothing, a half, all but a byte."""
    whole, said = folder / "whole", ""
    whole.mkdir()
    assert run(whole, resource.RLIM_INFINITY)[0] == 0
    made = contents(whole)
    assert set(outputs) <= {*made, *(name.split("/")[0] for name in made)}
    largest = max(map(len, made.values()))
    for limit in sorted({100, largest // 2, largest - 1}):
        for old in (None, b"old"):
            place = folder / f"{limit}-{old}"
            place.mkdir()
            for name in made if old else ():
                (place / name).parent.mkdir(parents=True, exist_ok=True)
                (place / name).write_bytes(old)
            code, said = run(place, limit)
            left = contents(place)
            assert code == 1, said
            assert set(left) <= set(made), "something is left beside the outputs"
            for name in left:
                assert left[name] == old or len(left[name]) == len(made[name]), name
            errors = [line for line in said.splitlines() if ": error: " in line]
            assert len(errors) == 1 and "Traceback" not in said, said
            assert any(Path(name).name in errors[0] for name in outputs), said
            assert "[Errno" not in said, said
            shutil.rmtree(place)


def parameters(rows, cheap):
    for words, outputs in rows:
        is_long = not any(one in words for one in cheap)
        yield pytest.param(words, outputs, id=words[:40], marks=[pytest.mark.long] * is_long)


@pytest.mark.parametrize(
    ("words", "outputs"), [*parameters(IN_PYTHON, CHEAP), *parameters(LONG_IN_PYTHON, ())]
)
def test_outputs_of_commands_in_python(trajectory, tmp_path, words, outputs):
    given = [word.format(trajectory) for word in words.split()]
    check_outputs(lambda folder, limit: in_python(given, folder, limit), outputs, tmp_path)


@pytest.mark.parametrize(("words", "outputs"), [*parameters(IN_CPP, ("order", "o.h5md --over"))])
def test_outputs_of_commands_in_cpp(command, tmp_path, words, outputs):
    given = words.split()
    check_outputs(lambda folder, limit: in_cpp(command, given, folder, limit), outputs, tmp_path)


@pytest.mark.parametrize("words", ["techniques", "convert {} -o {}.xyz"])
def test_standard_output_is_named(command, trajectory, words):
    words = [command, *words.format(trajectory, trajectory).split()]
    with open("/dev/full", "w") as full:
        ended = subprocess.run(words, stdout=full, stderr=subprocess.PIPE, text=True)
    assert ended.returncode == 1
    assert ended.stderr.endswith("error: standard output: No space left on device\n")
    assert len(ended.stderr.splitlines()) == 1
