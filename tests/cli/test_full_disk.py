# SPDX-License-Identifier: MIT
"""Each output of each command on a full disk: the old file is whole, or the new one is."""

import io
import json
import re
import resource
import shutil
import signal
import subprocess

import forked
import h5py
import pytest
from real_files import DIPEPTIDE, PEPTIDE

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

#: the name of a file, and what is the matter
NAMED = re.compile(r"error: \S*/?[\w.-]+\.\w+: cannot write: (File too large|not all frames)")
PARTS = "out/parts/"  #: of an experiment, which goes on with them

#: the commands: what they are told, and what they write; {} is a trajectory of 21 frames
IN_PYTHON = [
    *((f"convert {{}} -o o.{ending} --overwrite", [f"o.{ending}"]) for ending in CONVERTED),
    ("convert {} -k 20 -o o.pdb --overwrite", ["o.pdb"]),
    ("convert {} --recover -o o.h5md --overwrite", ["o.h5md"]),
]
#: of each library one
CHEAP = (".sdf", ".dcd", ".xyz", ".cif", "-k 20", "--recover")

LONG_IN_PYTHON = [
    ("analyse {} -o out", ["out/report.html", "out/frames.csv", "out/ensemble.pdb"]),
    ("convert {} -o o.zarr --overwrite", ["o.zarr"]),
    (f"path {PEPTIDE} {{folder}}/end.pdb -o o.h5md --csv o.csv --overwrite", ["o.h5md", "o.csv"]),
    ("compare {folder}/helix.h5md {folder}/models.pdb -o out", ["out/helix.compare.png"]),
    ("check {folder}/helix.h5md --frames 2 -o out", ["out/helix.check.png"]),
    (
        "lab bench step --sizes 1e2 --steps 10 --repeats 1 --kinds zigzag --technique bfs_cycle "
        "--csv o.csv",
        ["o.csv"],
    ),
    ("lab experiment -o out --graphs 1 --class tree --forces 2", ["out/table.csv", "out/table.h5"]),
    (f"study {PEPTIDE} -o out --overwrite", ["out/report.html", "out/representatives.pdb"]),
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
    (f"lab order {DIPEPTIDE} -o o.txt --overwrite", ["o.txt"]),
    (f"lab forcegen {DIPEPTIDE} --steps 500 -o o.txt --overwrite", ["o.txt"]),
    ("lab structgen tree -o o.xml --overwrite", ["o.xml"]),
    (f"rigidity {PEPTIDE} -o out --overwrite", ["out/residues.csv", "out/show.pml"]),
]


@pytest.fixture(scope="module")
def trajectory(command, tmp_path_factory):
    path = tmp_path_factory.mktemp("recorded") / "run.h5md"
    words = [command, "run", DIPEPTIDE, "--steps", "20", "-o", path, "--overwrite"]
    subprocess.run(words, check=True, capture_output=True)
    return path


@pytest.fixture
def others(command, trajectory):
    """What some commands need besides: in the trajectory's folder, made once."""
    folder = trajectory.parent
    if not (folder / "models.pdb").exists():
        shutil.copy(PEPTIDE, folder / "end.pdb")
        words = [command, "sample", PEPTIDE, "--frames", "20", "-o"]
        for name in ("helix.h5md", "models.pdb"):
            subprocess.run([*words, folder / name], check=True, capture_output=True)
    return folder


def in_python(words, folder, limit):
    """Exit code, and what is said, of a command whose files are limited."""
    name, rest = forked.called(words)
    job = (*forked.commands()[name], rest, limit)
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


def is_whole(data, made):
    """Whether it ends as what was made on an empty disk; times in it may differ."""
    if data.startswith(b"\x89HDF"):
        with h5py.File(io.BytesIO(data)) as file:  # of a trajectory the first frames, perhaps
            return len(file) > 0
    if data.endswith(b"END\n") and made.endswith(b"END\n"):
        return True  # of a study: the report's models take the place of the start
    return data.count(b"\n") == made.count(b"\n") and data[-1:] == made[-1:]


def check_outputs(run, outputs, folder):
    """Without a file and with an older one, where room is for little, a half, nine tenths."""
    whole, said = folder / "whole", ""
    whole.mkdir()
    assert run(whole, resource.RLIM_INFINITY)[0] == 0
    made = contents(whole)
    assert set(outputs) <= {*made, *(name.split("/")[0] for name in made)}
    largest = max(map(len, made.values()))
    for limit in sorted({100, largest // 2, largest * 9 // 10}):
        for old in (None, b"old"):
            place = folder / f"{limit}-{old}"
            place.mkdir()
            is_begun = "out/settings.json" in made  # an experiment goes on with what is there
            for name in made if old and not is_begun else ():
                (place / name).parent.mkdir(parents=True, exist_ok=True)
                (place / name).write_bytes(old)
            code, said = run(place, limit)
            left = {name: data for name, data in contents(place).items() if PARTS not in name}
            assert code == 1, said
            assert set(left) <= set(made), "something is left beside the outputs"
            for name in left:
                assert left[name] == old or is_whole(left[name], made[name]), name
            errors = [line for line in said.splitlines() if ": error: " in line]
            assert len(errors) == 1 and "Traceback" not in said, said
            assert NAMED.search(errors[0]), said
            assert "[Errno" not in said, said
            shutil.rmtree(place)


def parameters(rows, cheap):
    for words, outputs in rows:
        is_long = not any(one in words for one in cheap)
        yield pytest.param(words, outputs, id=words[:40], marks=[pytest.mark.long] * is_long)


@pytest.mark.parametrize(("words", "outputs"), [*parameters(IN_PYTHON, CHEAP)])
def test_outputs_of_commands_in_python(trajectory, tmp_path, words, outputs):
    given = words.format(trajectory).split()
    check_outputs(lambda folder, limit: in_python(given, folder, limit), outputs, tmp_path)


@pytest.mark.parametrize(("words", "outputs"), [*parameters(LONG_IN_PYTHON, ())])
def test_all_outputs_of_commands_in_python(trajectory, others, tmp_path, words, outputs):
    given = words.format(trajectory, folder=others).split()
    check_outputs(lambda folder, limit: in_python(given, folder, limit), outputs, tmp_path)


@pytest.mark.parametrize(("words", "outputs"), [*parameters(IN_CPP, ("order", "o.h5md --over"))])
def test_outputs_of_commands_in_cpp(command, tmp_path, words, outputs):
    given = words.split()
    check_outputs(lambda folder, limit: in_cpp(command, given, folder, limit), outputs, tmp_path)


@pytest.mark.parametrize("words", ["lab techniques", "convert {} -o {}.xyz"])
def test_standard_output_is_named(command, trajectory, words):
    words = [command, *words.format(trajectory, trajectory).split()]
    with open("/dev/full", "w") as full:
        ended = subprocess.run(words, stdout=full, stderr=subprocess.PIPE, text=True)
    assert ended.returncode == 1
    assert ended.stderr.endswith("error: standard output: No space left on device\n")
    assert len(ended.stderr.splitlines()) == 1
