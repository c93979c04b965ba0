# SPDX-License-Identifier: MIT
"""Disks of the machine that makes a shard, and file systems without locks."""

import errno
import os
import subprocess
import sys

import pytest
from ensembles import PEPTIDE, call, made, same_files
from pliant.shards import folder_lock, scratch
from pliant.shards.folder_lock import alone_in, mount_of

from pliant import FileError

WORDS = ("--walkers", 24, "--shard-size", 4, "--steps", 40, "--every", 10)


def test_shards_come_from_a_scratch_disk(ensemble, tmp_path):
    disk = tmp_path / "disk"
    disk.mkdir()
    env = {**os.environ, "TMPDIR": str(disk)}
    words = (*WORDS, "--workers", 1, "--scratch")
    made(PEPTIDE, "-o", tmp_path / "many", *words, env=env)
    assert same_files(tmp_path / "many", ensemble)
    assert not list(disk.glob("*.h5md")) and not list((tmp_path / "many" / "making").iterdir())


def test_what_is_left_is_known_by_its_name_and_by_its_lock(tmp_path):
    disk, folder, other = tmp_path / "disk", tmp_path / "many", tmp_path / "other"
    for one in (disk, folder, other):
        one.mkdir()
    (disk / "0123456789abcdef.h5md").touch()  # whoever it is of
    with (
        scratch.unfinished(disk, folder, "a") as made,
        scratch.unfinished(disk, other, "a") as of_another,
    ):
        for one in (made, of_another):
            one.path.touch()
        (disk / f".{made.path.name}.partial").touch()
        before = sorted(disk.iterdir())
        scratch.remove_left(disk, folder)
        assert sorted(disk.iterdir()) == before  # their locks are held
        made.lock.close()
        of_another.lock.close()
        scratch.remove_left(disk, folder)
        named = of_another.path.name
        kept = {"0123456789abcdef.h5md", named, f"{named}.lock"}
        assert {path.name for path in disk.iterdir()} == kept
    assert [path.name for path in disk.iterdir()] == ["0123456789abcdef.h5md"]


def test_the_lock_is_held_as_long_as_the_command_lives(tmp_path):
    with scratch.unfinished(tmp_path, tmp_path, "a") as made:
        made.path.touch()
        words = [sys.executable, "-c", "input()"]
        pipes = {"stdin": subprocess.PIPE, "pass_fds": [made.lock.fileno()]}
        with subprocess.Popen(words, **pipes) as command:
            made.lock.close()
            scratch.remove_left(tmp_path, tmp_path)
            assert made.path.exists()
            command.communicate(b"\n")
        scratch.remove_left(tmp_path, tmp_path)
        assert not any(tmp_path.iterdir())


def test_without_locks_what_is_left_stays(tmp_path, monkeypatch):
    def refuse(file):
        raise OSError(errno.ENOLCK, os.strerror(errno.ENOLCK))

    monkeypatch.setattr(scratch, "take_lock", refuse)
    with scratch.unfinished(tmp_path, tmp_path, "a") as made:
        made.path.touch()
        scratch.remove_left(tmp_path, tmp_path)
        assert made.path.exists()
    assert not any(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("where", "message"),
    [
        ("$NO_SUCH_DISK/x", "--scratch $NO_SUCH_DISK/x: NO_SUCH_DISK is not set"),
        ("/no/such/disk", "--scratch /no/such/disk: /no/such/disk: expected a folder"),
    ],
)
def test_a_scratch_disk_that_is_not_there(tmp_path, where, message, there):
    words = (*WORDS, *there, "--scratch", where)
    ended = call("ensemble", PEPTIDE, "-o", tmp_path / "many", *words)
    assert ended.returncode == 2
    assert f"{message}" in ended.stderr


def test_a_shard_is_moved_as_a_whole(tmp_path):
    (tmp_path / "making").mkdir()
    (tmp_path / "shards").mkdir()
    disk = tmp_path / "disk"
    disk.mkdir()
    (disk / "a.h5md").write_bytes(b"shard")
    target = tmp_path / "shards" / "s.h5md"
    assert scratch.publish(disk / "a.h5md", tmp_path, target, False)
    (disk / "a.h5md").write_bytes(b"other")
    assert not scratch.publish(disk / "a.h5md", tmp_path, target, False)
    assert target.read_bytes() == b"shard"
    assert scratch.publish(disk / "a.h5md", tmp_path, target, True)
    assert target.read_bytes() == b"other"
    assert not list((tmp_path / "making").iterdir())


@pytest.mark.parametrize("number", [errno.ENOLCK, errno.ENOSYS, errno.EOPNOTSUPP])
def test_a_file_system_without_locks_is_told_once(tmp_path, monkeypatch, capfd, number):
    def refuse(file):
        raise OSError(number, os.strerror(number))

    monkeypatch.setattr(folder_lock, "take_lock", refuse)
    with alone_in(tmp_path / "many"):
        pass
    err = capfd.readouterr().err
    assert err.count("takes no lock: see to it that no other machine") == 1


def test_a_lock_that_another_holds_is_an_error(tmp_path):
    message = "another pliant ensemble is at work in it"
    with alone_in(tmp_path), pytest.raises(FileError, match=message), alone_in(tmp_path):
        pass


@pytest.mark.parametrize(
    ("line", "is_told"),
    [
        ("server:/home {} nfs rw,vers=3,nolock,addr=10.0.0.1 0 0", True),
        ("server:/home {} nfs4 rw,vers=4.2,local_lock=none 0 0", False),
        ("10.0.0.1@tcp:/lustre {} lustre rw,localflock 0 0", True),
        ("10.0.0.1@tcp:/lustre {} lustre rw,flock 0 0", False),
        ("/dev/sda1 {} ext4 rw,nolock 0 0", False),
    ],
)
def test_locks_of_one_machine_are_told(tmp_path, monkeypatch, capfd, line, is_told):
    folder = tmp_path / "with space"
    mounts = tmp_path / "mounts"
    point = str(folder).replace(" ", "\\040")
    mounts.write_text(f"/dev/root / ext4 rw 0 0\n{line.format(point)}\nx /other nfs nolock 0 0\n")
    monkeypatch.setattr(folder_lock, "_MOUNTS", mounts)
    with alone_in(folder / "many"):
        pass
    assert ("hold on this machine only" in capfd.readouterr().err) == is_told
    assert mount_of(folder / "many")[0] == line.split()[2]
    monkeypatch.setattr(folder_lock, "_MOUNTS", tmp_path / "none")
    assert mount_of(folder) == ("", set())
