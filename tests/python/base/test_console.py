# SPDX-License-Identifier: MIT
"""What the subcommands written in Python share."""

import argparse
import csv
import importlib
import io
import json
import os
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from pliant.base.csv_cells import write_csv
from pliant.lab.results import write_csv as write_rows

import pliant
from pliant.base import console


def parser():
    result = console.Parser("check", "checks")
    result.add_argument("--frames", type=console.whole_number(1, "all"), default=20)
    result.add_argument("--size", type=console.positive_number, default=0.1)
    return result


def test_values_are_taken_as_written():
    assert parser().parse_args(["--frames", "7", "--size", "1e-3"]).frames == 7
    assert parser().parse_args(["--frames", "all"]).frames == "all"


@pytest.mark.parametrize(
    ("words", "error"),
    [
        (["--frames", "0"], "--frames: expected a whole number from 1 or all, found '0'"),
        (["--frames", "1.5"], "--frames: expected a whole number from 1 or all, found '1.5'"),
        (["--frames", "²"], "--frames: expected a whole number from 1 or all, found '²'"),
        (["--size", "nan"], "--size: expected a number above 0, found 'nan'"),
        (["--size", "1_0"], "--size: expected a number above 0, found '1_0'"),
        (["--fra", "3"], "unrecognized arguments: --fra 3"),
    ],
)
def test_a_bad_option_is_one_line_and_exit_code_2(words, error, capsys):
    with pytest.raises(SystemExit) as stopped:
        parser().parse_args(words)
    assert stopped.value.code == 2
    expected = f"pliant check: error: {error}\nsee pliant check --help\n"
    assert capsys.readouterr().err == expected


def test_errors_of_the_user_end_with_1_and_no_traceback(capsys):
    def work():
        raise pliant.InputError("out.h5md: no frames")

    assert console.run_command("check", work) == 1
    assert capsys.readouterr().err == "pliant check: error: out.h5md: no frames\n"


def test_a_bad_option_of_the_library_ends_with_2(capsys):
    def work():
        raise pliant.OptionError("frames = 0: must be from 1")

    assert console.run_command("check", work) == 2
    assert capsys.readouterr().err == "pliant check: error: frames = 0: must be from 1\n"


def test_a_fault_of_ours_is_not_hidden():
    with pytest.raises(ZeroDivisionError):
        console.run_command("check", lambda: 1 // 0)


def test_json_has_no_nan(capsys):
    console.print_json({"a": np.array([1.0, np.nan]), "b": np.int64(3), "c": (np.inf, True)})
    assert json.loads(capsys.readouterr().out) == {"a": [1.0, None], "b": 3, "c": [None, True]}


def table():
    return console.Table("methods", ["method", "time"], [["ours", "1.5 us"], ["theirs", "12 us"]])


def test_a_plain_table_is_aligned():
    out = io.StringIO()
    table().print(out)
    assert out.getvalue() == "methods\n  method    time\n  ours    1.5 us\n  theirs   12 us\n"


def test_a_terminal_gets_the_same_cells():
    class Terminal(io.StringIO):
        def isatty(self):
            return True

    out = Terminal()
    table().print(out)
    for cell in ["methods", "ours", "1.5 us", "theirs", "12 us"]:
        assert cell in out.getvalue()


def test_progress_is_a_bar_on_a_terminal_only(monkeypatch, capsys):
    with console.progress("resolving") as show:
        show(1, 2)
    assert capsys.readouterr().err == ""
    monkeypatch.setattr("sys.stderr.isatty", lambda: True)
    with console.progress("resolving") as show:
        show(1, 2)
    assert capsys.readouterr().err == (
        "\rresolving: [############............] 1 / 2\x1b[K\r\x1b[K"
    )


def test_progress_says_how_many_a_second(monkeypatch, capsys):
    monkeypatch.setattr("sys.stderr.isatty", lambda: True)
    now = iter((0.0, 10.0, 10.0, 14.0))
    monkeypatch.setattr("time.monotonic", lambda: next(now))
    with console.progress("molecules", rate=True) as show:
        show(3, 20)
        show(13, 20)
    assert " 13 / 20, 2.5 a second" in capsys.readouterr().err


@pytest.mark.parametrize("text", ["1025", "10" * 30, "0", "-1", "٣"])
def test_no_command_begins_thousands_of_processes(text, capsys):
    parse = console.whole_number(1, most=console.MOST_PROCESSES)
    with pytest.raises(argparse.ArgumentTypeError) as refused:
        parse(text)
    assert str(refused.value) == f"expected a whole number from 1 to 1024, found '{text}'"
    assert parse("1024") == 1024


@pytest.mark.parametrize(
    ("text", "printed"),
    [
        ("a b", "a b"),
        ("Müller 水", "Müller 水"),
        ("\x1b[2J\x07", "\\x1b[2J\\x07"),
        ("\x9b2J\x7f\r", "\\xc2\\x9b2J\\x7f\\x0d"),
        (os.fsdecode(b"\xff"), "\\xff"),
    ],
)
def test_names_of_files_give_terminals_no_orders(text, printed):
    assert console.printable(f"x\n{text}\t") == f"x\n{printed}\t"
    assert console.printable_name(text) == (text if text == printed else f'"{printed}"')


def test_names_with_line_ends_and_quotes_are_quoted():
    assert console.printable_name("a\nb") == '"a\\x0ab"'
    assert console.printable_name(Path('say "hi"')) == '"say \\"hi\\""'


@pytest.mark.parametrize("command", ["report.check", "report", "report.compare"])
def test_errors_name_such_a_file_safely(command, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    name = "\x1b]0;owned\x07.h5md"
    Path(name).write_bytes(b"no HDF5")
    words = [name, name] if command == "report.compare" else [name]
    assert importlib.import_module(f"pliant.{command}.command").main(words) == 1
    said = capsys.readouterr().err
    assert "\\x1b]0;owned\\x07.h5md" in said
    assert "\x1b" not in said and "\x07" not in said
    assert said.count("\n") == 1


def test_json_holds_names_that_are_no_utf8(capsys):
    console.print_json({"file": os.fsdecode(b"a\xff")})
    assert json.loads(capsys.readouterr().out) == {"file": "a\udcff"}


ROWS = [
    {"name": "frames", "type": "int", "default": 4, "group": "", "kind": "", "least": 1, "most": 9},
    {"name": "cutoff", "type": "float", "default": -1.0, "group": "Model", "kind": ""},
    {"name": "guess", "type": "bool", "default": True, "opposite": "no_guess", "kind": ""},
    {"name": "keep", "type": "collections.abc.Sequence[str]", "default": [], "kind": ""},
    {"name": "pull", "type": "list", "default": [], "words": 2, "kind": "ATOMS X,Y,Z"},
    {"name": "kind", "type": "str", "default": "a", "choices": ["a", "b"], "kind": "kind"},
    {"name": "file", "type": "str", "default": "", "kind": "FILE"},
]
ROWS = [{"help": "100 %", "group": "Model", **row} for row in ROWS]


def given(*words):
    of_rows = console.Parser("sample", "samples")
    console.add_rows(of_rows, ROWS)
    return console.given(of_rows.parse_args(words), ROWS)


def test_of_rows_what_was_given_is_taken_as_the_library_takes_it():
    assert given() == {}
    words = "--frames 4 --cutoff -0.5 --no-guess --keep GOL,SO4 --kind b --file a.csv"
    assert given(*words.split(), "--pull", "resid 3", "0,0,8") == {
        "frames": 4,
        "cutoff": -0.5,
        "guess": False,
        "keep": ["GOL", "SO4"],
        "pull": [["resid 3", "0,0,8"]],
        "kind": "b",
        "file": "a.csv",
    }


@pytest.mark.parametrize(
    ("words", "error"),
    [
        ("--frames 10", "--frames: expected a whole number from 1 to 9, found '10'"),
        ("--cutoff inf", "--cutoff: expected a number, found 'inf'"),
        ("--kind c", "--kind: invalid choice: 'c' (choose from 'a', 'b')"),
        ("--guess", "unrecognized arguments: --guess"),
    ],
)
def test_of_rows_what_cannot_be_is_refused(capsys, words, error):
    with pytest.raises(SystemExit):
        given(*words.split())
    assert capsys.readouterr().err.splitlines()[0] == f"pliant sample: error: {error}"


#: texts of a molecule or a file name, which must not become formulas in a spreadsheet
BAD = ["=1+1", "+cmd", "-x", "@SUM(A1)"]
GOOD = ["", "CA", "A-1", "-1.5", "+2", "1=1"]


@dataclass
class Row:
    name: str
    parts: tuple[str, ...]
    size: float


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.reader(file))


@pytest.mark.parametrize("text", BAD + GOOD)
def test_tables_have_no_formulas(text, tmp_path):
    expected = "'" + text if text in BAD else text
    write_csv(tmp_path / "a.csv", {"atom": [text, "CB"], "change": [-1.5, 2.0]})
    assert rows_of(tmp_path / "a.csv")[1:] == [[expected, "-1.5"], ["CB", "2.0"]]
    write_rows([Row(text, (text, "b"), -1.5)], tmp_path / "b.csv")
    (row,) = rows_of(tmp_path / "b.csv")[1:]
    assert (row[0], row[2]) == (expected, "-1.5")
    assert not row[1].startswith(("=", "+", "-", "@"))
