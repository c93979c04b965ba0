# SPDX-License-Identifier: MIT
"""What the subcommands written in Python share."""

import argparse
import io
import json

import numpy as np
import pytest

import pliant
from pliant import console


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
    expected = f"pliant check: error: {error}\npliant check --help tells more\n"
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


@pytest.mark.parametrize("text", ["1025", "10" * 30, "0", "-1", "٣"])
def test_no_command_begins_thousands_of_processes(text, capsys):
    parse = console.whole_number(1, most=console.MOST_PROCESSES)
    with pytest.raises(argparse.ArgumentTypeError) as refused:
        parse(text)
    assert str(refused.value) == f"expected a whole number from 1 to 1024, found '{text}'"
    assert parse("1024") == 1024
