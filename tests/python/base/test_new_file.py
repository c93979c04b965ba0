# SPDX-License-Identifier: MIT
"""The one way to write a file: whole, or not at all, whoever writes it and whatever happens."""

import errno
import os
import resource
from contextlib import contextmanager, suppress

import pytest
from pliant.base.new_file import new_file, new_text, take_name, write_text

import pliant


@contextmanager
def room(size):
    """A disk whose files hold no more bytes: Python has the signal ignored."""
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))


@contextmanager
def refused(place, why="File too large"):
    """A new file on such a disk, which does not come to be."""
    with room(5000), pytest.raises(pliant.FileError) as said, new_file(place) as file:
        yield file
    assert str(said.value) == f"{place}: cannot write: {why}"


def names(folder):
    return sorted(path.name for path in folder.iterdir())


def test_it_has_its_name_when_it_is_whole(tmp_path):
    place = tmp_path / "a.txt"
    with new_file(place) as file:
        file.write(b"first ")
        file.path.open("ab").write(b"and more")  # as a library may that wants a name
        assert names(tmp_path) == [".a.txt.partial"]
    assert place.read_bytes() == b"first and more"
    with new_text(place, overwrite=True) as text:
        text.write("Ångström\n")
    assert place.read_bytes() == "Ångström\n".encode()
    assert names(tmp_path) == ["a.txt"]


@pytest.mark.parametrize("old", [None, "old"])
def test_a_full_disk_leaves_the_old_file(tmp_path, old):
    place = tmp_path / "a.txt"
    if old:
        place.write_text(old)
    with room(5000), pytest.raises(pliant.FileError) as said:
        write_text(place, "x" * 9999, overwrite=True)
    assert str(said.value) == f"{place}: cannot write: File too large"
    assert names(tmp_path) == (["a.txt"] if old else [])
    assert not old or place.read_text() == old


def test_a_library_that_swallows_the_error_is_found_out(tmp_path):
    with refused(tmp_path / "a.txt") as file:
        for _ in range(3):
            with suppress(OSError):
                file.write(b"x" * 4000)
    assert names(tmp_path) == []


def test_a_library_that_makes_another_error_of_it_is_understood(tmp_path):
    with refused(tmp_path / "a.txt") as file:
        try:
            file.write(b"x" * 9999)
        except OSError:
            raise ValueError("I/O operation on closed file") from None


def test_a_library_that_names_no_file_gets_the_name(tmp_path):
    with refused(tmp_path / "a.txt", "No space left on device"):
        raise OSError(errno.ENOSPC, "No space left on device")


def test_other_errors_stay_what_they_are(tmp_path):
    with pytest.raises(ValueError, match="no such chain"), new_file(tmp_path / "a.txt") as file:
        file.write(b"half")
        raise ValueError("no such chain")
    with pytest.raises(FileNotFoundError), new_file(tmp_path / "a.txt"):
        (tmp_path / "gone").read_bytes()
    assert names(tmp_path) == []


def test_what_came_to_be_meanwhile_is_not_replaced(tmp_path):
    place = tmp_path / "a.txt"
    with pytest.raises(pliant.FileError) as said, new_file(place) as file:
        file.write(b"ours")
        place.write_bytes(b"theirs")
    assert str(said.value) == f"{place}: exists already; overwrite replaces it"
    assert place.read_bytes() == b"theirs" and names(tmp_path) == ["a.txt"]


@pytest.mark.parametrize("has_links", [True, False])
def test_a_name_is_taken_once(tmp_path, monkeypatch, has_links):
    made, target = tmp_path / "made", tmp_path / "target"
    if not has_links:
        monkeypatch.setattr(os, "link", lambda made, _: os.rmdir(made))  # an OSError
    made.write_text("first")
    assert take_name(made, target)
    made.write_text("second")
    assert not take_name(made, target)
    assert (made.read_text(), target.read_text()) == ("second", "first")


def test_where_it_cannot_be_is_said_before_anything_is_made(tmp_path):
    place = tmp_path / "a.txt"
    place.write_bytes(b"old")
    for path, why in [
        (place, "exists already; overwrite replaces it"),
        (tmp_path / "no" / "a.txt", f"the directory {tmp_path}/no does not exist"),
        (tmp_path, "is a directory"),
        ("/dev/full", "is not a regular file"),
    ]:
        with pytest.raises(pliant.FileError) as said, new_file(path):
            raise AssertionError
        assert str(said.value) == f"{path}: {why}"


def test_two_do_not_write_one_file(tmp_path):
    place = tmp_path / "a.txt"
    with new_file(place) as file:
        file.write(b"whole")
        with pytest.raises(pliant.FileError, match=r"a.txt: is being written by "):
            write_text(place, "other", overwrite=True)
    assert place.read_bytes() == b"whole"


def test_a_link_is_followed(tmp_path):
    real, link = tmp_path / "real.txt", tmp_path / "link.txt"
    real.write_bytes(b"old")
    link.symlink_to(real)
    write_text(link, "new", overwrite=True)
    assert link.is_symlink() and real.read_text() == "new"
