# SPDX-License-Identifier: MIT
"""What stands in a file's place: pipes, devices and folders are refused, and none is waited for."""

import json
import os
import shutil

import pytest
from ensembles import PEPTIDE, call
from pliant.base.input_files import expect_file, json_object, open_file
from pliant.measure.compared.paths import compare_paths
from pliant.play.page import read_given
from pliant.shards.queue_jobs import _settings
from pliant.shards.verify import verify
from pliant.trajectory.shards.manifest import Manifest
from pliant.trajectory.shards.plan import load_plan

import pliant
from pliant import FileError, InputError

DEEP = "[" * 100_000


@pytest.fixture
def pipe(tmp_path):
    os.mkfifo(tmp_path / "pipe.pdb")
    return tmp_path / "pipe.pdb"


def test_what_is_no_file_is_not_opened(pipe, tmp_path):
    for path, why in [
        (pipe, "is a pipe, not a file"),
        ("/dev/null", "is a device, not a file"),
        (tmp_path, "Is a directory"),
    ]:
        with pytest.raises(OSError) as error:
            open_file(str(path), os.O_RDONLY)
        assert error.value.strerror == why
    with pytest.raises(FileError, match=r"pipe.pdb: is a pipe, not a file$"):
        expect_file(pipe)
    expect_file(tmp_path)
    expect_file(tmp_path / "none")
    (tmp_path / "file").write_bytes(b"text")
    with open(tmp_path / "file", "rb", opener=open_file) as file:
        assert file.read() == b"text"


@pytest.mark.parametrize(
    "read",
    [
        pliant.read,
        pliant.Trajectory,
        read_given,
        lambda pipe: pliant.Trajectory(pipe.with_name("pipe.xtc"), topology=PEPTIDE),
        lambda pipe: pliant.analyse(pipe),
        lambda pipe: pliant.convert(pipe, pipe.with_name("out.dcd")),
        lambda pipe: compare_paths(pipe, pipe),
        lambda pipe: pliant.sample(PEPTIDE, amplitude=pipe),
        lambda pipe: _settings(str(pipe)),
    ],
)
def test_no_reader_waits_for_a_pipe(pipe, read):
    os.mkfifo(pipe.with_name("pipe.xtc"))
    with pytest.raises(pliant.Error, match=r"pipe.*: (is a pipe|not an HDF5 file)"):
        read(pipe)
    assert {path.name for path in pipe.parent.iterdir()} == {"pipe.pdb", "pipe.xtc"}


def test_a_pipe_that_somebody_writes_to_is_read():
    reading, writing = os.pipe()
    os.write(writing, b"1\n\nC 0 0 0\n")
    os.close(writing)
    assert len(pliant.read(f"/dev/fd/{reading}", format="xyz")) == 1
    os.close(reading)


@pytest.mark.parametrize("text", [DEEP, '{"a":' * 100_000, "null", "3", "[]", "{", '"x"', ""])
def test_json_that_is_no_object(text):
    with pytest.raises(ValueError):
        json_object(text)


def test_json():
    assert json_object(b'{"a": [1, null]}') == {"a": [1, None]}


def plan_of(count=24, size=4, **more):
    there = {"command": "run", "input": "x.pdb", "count": count, "shard_size": size}
    return json.dumps({"pliant_ensemble": 2, **there, **more})


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (DEEP, "nested too deeply"),
        ("null", "expected a JSON object, found null"),
        ("[1]", "expected a JSON object, found [1]"),
        (plan_of(10**18), "count: expected a whole number from 1 to 1000000000, found 10000000000"),
        (plan_of(1e3), "count: expected a whole number from 1 to 1000000000, found 1000.0"),
        (plan_of(size=True), "shard_size: expected a whole number from 1 to 1000000000, found Tr"),
        (plan_of(command="rm"), "command: expected run or sample, found 'rm'"),
        (plan_of(options=[1]), "options: expected a JSON object, found [1]"),
        (plan_of(pliant_ensemble=1), "expected version 2 of the format, found 1"),
    ],
)
def test_a_plan_that_no_command_has_written(tmp_path, text, said):
    (tmp_path / "ensemble.pliant").write_text(text)
    with pytest.raises(InputError) as error:
        load_plan(tmp_path)
    begin = f"{tmp_path}/ensemble.pliant: expected the plan of an ensemble: "
    assert str(error.value).startswith(begin + said)
    assert "\n" not in str(error.value)
    ended = call("ensemble", "--verify", tmp_path)
    assert (ended.returncode, ended.stderr.count("\n")) == (1, 1)


@pytest.mark.parametrize("text", [DEEP, "null", "[]", "3"])
def test_a_manifest_that_no_command_has_written(tmp_path, text):
    (tmp_path / "ensemble.pliant").write_text(plan_of())
    (tmp_path / "shards.jsonl").write_text(text + "\n")
    with pytest.raises(InputError, match=r"shards.jsonl:1: expected the record of a shard"):
        Manifest(tmp_path, load_plan(tmp_path))


def test_pipes_in_the_folder_of_an_ensemble(ensemble, tmp_path):
    folder = shutil.copytree(ensemble, tmp_path / "copy")
    shard = sorted(folder.glob("shards/*"))[2]
    shard.unlink()
    os.mkfifo(shard)
    assert verify(folder).problems == [f"{shard}: is a pipe, not a file"]
    for name in ("shards.jsonl", "ensemble.pliant"):
        (folder / name).unlink()
        os.mkfifo(folder / name)
        ended = call("ensemble", "--verify", folder)
        assert ended.returncode == 1
        said = f"pliant ensemble: error: {folder / name}: is a pipe, not a file"
        assert ended.stderr.startswith(said) and ended.stderr.count("\n") == 1


def test_a_plan_of_more_shards_than_there_can_be(ensemble, tmp_path):
    """Shards that are not there cost nothing; those that are there are all looked at."""
    folder = shutil.copytree(ensemble, tmp_path / "copy")
    plan = json.loads((folder / "ensemble.pliant").read_text())
    (folder / "ensemble.pliant").write_text(json.dumps({**plan, "count": 10**9}))
    found = verify(folder)
    assert (found.shards, len(found.problems)) == (6, 1001)
    assert found.problems[-1] == f"{folder}: not there either: {250_000_000 - 1006} more shards"


def test_a_cluster_file_that_is_nested_too_deeply(tmp_path):
    pytest.importorskip("yaml")
    (tmp_path / "c.yaml").write_text(DEEP)
    with pytest.raises(InputError, match=r"c.yaml: expected YAML: nested too deeply"):
        _settings(str(tmp_path / "c.yaml"))


def test_an_input_of_an_ensemble(pipe, tmp_path):
    ended = call("ensemble", pipe, "-o", tmp_path / "many", "--frames", 4)
    said = f"pliant ensemble: error: {pipe}: is a pipe, not a file\n"
    assert (ended.returncode, ended.stderr) == (1, said)
    assert not (tmp_path / "many").exists()
