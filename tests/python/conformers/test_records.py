# SPDX-License-Identifier: MIT
"""Records of files, of which no more is kept than a molecule has, and the processes that work on
them: they may end at any time, and what they worked on is named."""

import gzip
import multiprocessing
import time
import tracemalloc

import pytest

pytest.importorskip("rdkit")
from libraries import library
from pliant.jobs.conformers import records
from pliant.jobs.conformers.options import ConformerOptions
from pliant.jobs.conformers.records import TOO_LONG, Record, read_records
from pliant.jobs.conformers.workers import outcomes

import pliant

AFTER = Record(2, "water\n", "water", source="x.sdf.gz")


@pytest.mark.parametrize(("line", "length"), [(b"C", 60), (999 * b"C" + b"\n", 60), (b"C\n", 2)])
def test_a_record_without_end_fills_no_memory(tmp_path, monkeypatch, line, length):
    monkeypatch.setattr(records, "MOST_TEXT", 10**5)
    monkeypatch.setattr(records, "MOST_LINES", 10**3)
    path = tmp_path / "x.sdf.gz"
    many = length * gzip.compress(10**5 // len(line) * line)
    path.write_bytes(gzip.compress(b"endless\n") + many + gzip.compress(b"\n$$$$\nwater\n$$$$\n"))
    tracemalloc.start()
    found = list(read_records(path))
    assert tracemalloc.get_traced_memory()[1] < 1e6
    tracemalloc.stop()
    assert found == [Record(1, "", "endless", source="x.sdf.gz", fault=TOO_LONG), AFTER]


def test_what_is_too_long_is_said_and_the_rest_goes_on(tmp_path, monkeypatch):
    monkeypatch.setattr(records, "MOST_TEXT", 50)
    path = tmp_path / "x.sdf"
    path.write_text(f"long\n{60 * 'a'}\n$$$$\nshort\n$$$$\n{50 * ' '}x")
    first, second, third = pliant.conformers(path)
    assert (first.number, first.name) == (1, "long")
    assert first.reason == (
        "x.sdf record 1: expected a record of at most 20 MB and 200000 lines, found more"
    )
    assert second.name == "short"
    assert (third.number, third.name) == (3, "")


def test_a_line_without_end_in_smiles_ends_the_file(tmp_path, monkeypatch):
    monkeypatch.setattr(records, "MOST_TEXT", 50)
    path = tmp_path / "x.smi"
    path.write_text(f"CCO ethanol\n{60 * 'C'}\n")
    read = read_records(path)
    assert next(read).text == "CCO"
    with pytest.raises(pliant.InputError) as caught:
        next(read)
    assert str(caught.value) == (
        "x.smi record 2: expected a record of at most 20 MB and 200000 lines, found more"
    )


@pytest.mark.parametrize("name", ["x.sdf", "x.sdf.gz"])
def test_python_has_the_limit_too(tmp_path, name):
    path, text = tmp_path / name, b"water" + 10**6 * b" " + b"\n$$$$\n"
    path.write_bytes(gzip.compress(text) if name.endswith("gz") else text)
    assert len(list(pliant.conformers(path, max_input=2))) == 1
    with pytest.raises(pliant.InputError) as caught:
        list(pliant.conformers(path, max_input=1))
    assert str(caught.value) == (
        f"{path}: holds more than 1 MB, the most that is read; max_input allows more"
    )
    with pytest.raises(pliant.OptionError, match=r"^max_input = 0: must be from 1$"):
        pliant.conformers(path, max_input=0)


OPTIONS = ConformerOptions(frames=20, starts=1, max=2, energy="none")


@pytest.fixture
def some_records(tmp_path):
    (tmp_path / "library.sdf").write_text(library(12))
    return list(read_records(tmp_path / "library.sdf"))


def test_a_process_that_ends_costs_one_molecule(some_records):
    found = outcomes(some_records, OPTIONS, 2, False)
    all_of_them = [next(found)]
    for child in multiprocessing.active_children():
        child.kill()
    all_of_them += found
    assert [one.number for one in all_of_them] == list(range(1, 13))
    failed = [one for one in all_of_them if one.reason]
    assert len(failed) <= 2
    for one in failed:
        assert one.reason == "the process that worked on it ended with code -9"
    assert sum(one.conformers > 0 for one in all_of_them) >= 10


def test_there_are_no_more_processes_than_records(some_records):
    found = outcomes(some_records[:2], OPTIONS, 8, False)
    next(found)
    assert len(multiprocessing.active_children()) <= 2
    assert next(found).conformers > 0


def test_no_process_is_left_behind(some_records):
    found = outcomes(some_records, OPTIONS, 2, False)
    next(found)
    found.close()
    while multiprocessing.active_children():
        time.sleep(0.05)


def test_columns_of_smiles_are_data_items_by_the_words_of_the_header(tmp_path):
    pytest.importorskip("rdkit")
    (tmp_path / "x.smi").write_text(
        "SMILES\tName\tpIC50\nCCO\tan ethanol\t7.1\nCCN\t\t\tmore\nCCS a thiol, named\n"
    )
    found = list(pliant.conformers(tmp_path / "x.smi", 1))
    assert [one.name for one in found] == ["an ethanol", "CCN", "a thiol, named"]
    texts = [one.sdf for one in found]
    assert "> <pIC50>\n7.1\n\n" in texts[0]
    assert "> <column 4>\nmore\n\n" in texts[1] and "pIC50" not in texts[2]
