# SPDX-License-Identifier: MIT
"""What the subcommands written in Python share: options, errors, tables, JSON, exit codes."""

from __future__ import annotations

import argparse
import atexit
import difflib
import errno
import gc
import json
import math
import os
import shutil
import sys
from collections.abc import Callable, Container, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NoReturn, TextIO

import numpy as np

from pliant._core import Error, FileError, OptionError
from pliant.base import progress as _progress
from pliant.base.extras import MissingPackageError, is_there, late, needed_by
from pliant.base.progress import progress as progress
from pliant.base.progress import stages as stages
from pliant.base.said import warnings_shown_by

rich_box, rich_console, rich_table, rich_text = map(
    late, ("rich.box", "rich.console", "rich.table", "rich.text")
)

EXIT_OK = 0
EXIT_FAILED = 1  #: bad input, a file that cannot be read or written, a check that failed
EXIT_USAGE = 2  #: bad option or argument
EXIT_INTERRUPTED = 130

#: what a system says where there is no room: disk, quota, limit of sizes
NO_ROOM = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)

MOST_PROCESSES = 1024  #: of ``--workers``
MOST_DIGITS = 18  #: of a whole number: it fits into 64 bits


def command_path() -> str:
    """Path of the command ``pliant``. Raises FileError where it is not installed."""
    beside = Path(sys.executable).with_name("pliant")
    found = str(beside) if beside.exists() else shutil.which("pliant")
    if found is None:
        raise FileError("the command pliant is neither beside Python nor on the path")
    return found


class _HelpOfAll(argparse.Action):
    """Prints the help with every option."""

    def __call__(self, parser: argparse.ArgumentParser, *_: object) -> NoReturn:
        assert isinstance(parser, Parser)
        parser.common = ()
        parser.print_help()
        parser.exit()


class Parser(argparse.ArgumentParser):
    """An argument parser that reads as the subcommands in C++ do: errors in one line, exit 2.

    Of the options, --help shows those in `common` alone, if any are; --help-all shows all.
    """

    def __init__(
        self, command: str, description: str, epilog: str = "", common: Sequence[str] = ()
    ) -> None:
        self.common: Sequence[str] = ()  # until its own --help is there
        super().__init__(
            prog=f"pliant {command}",
            description=description,
            epilog=epilog,
            formatter_class=argparse.RawDescriptionHelpFormatter,
            allow_abbrev=False,
        )
        self.common = common
        text = "show all options and exit" if common else argparse.SUPPRESS
        self.add_argument("--help-all", action=_HelpOfAll, nargs=0, help=text)

    def format_help(self) -> str:
        """The text, of the common options alone where there are some."""
        shown = {"--help", "--help-all", *self.common}
        rest = [one for one in self._actions if not shown.intersection(one.option_strings)]
        rest = [one for one in rest if self.common and one.option_strings]
        texts, usage = [one.help for one in rest], self.usage
        for one in rest:
            one.help = argparse.SUPPRESS
        if rest and usage is None:
            self.usage = self._short_usage()
        try:
            text = super().format_help()
        finally:
            self.usage = usage
            for one, help_text in zip(rest, texts, strict=True):
                one.help = help_text
        return text

    def _short_usage(self) -> str:
        """With the places and the options that must be given."""
        words = [self.prog]
        for one in self._actions:
            if not one.option_strings:
                name = str(one.metavar or one.dest)
                words.append(f"[{name}]" if one.nargs == "?" else name)
        needed = [one for one in self._actions if one.option_strings and one.required]
        words += [f"{one.option_strings[0]} {one.metavar or one.dest.upper()}" for one in needed]
        return " ".join([*words, "[OPTIONS]"]).replace("%", "%%")

    def expect_no_more(self, rest: Sequence[str]) -> None:
        """Raises OptionError for the first of the words that are no options here."""
        for word in rest:
            like = difflib.get_close_matches(word, self._option_string_actions, 1)
            hint = f" (did you mean {like[0]}?)" if like else ""
            raise OptionError(f'unexpected argument "{word}"{hint}')

    def given_besides(self, arguments: argparse.Namespace, those: Container[str]) -> str:
        """The first option, or place, that is not as usual and not among `those`; "" if none is."""
        for one in self._actions:
            value = getattr(arguments, one.dest, one.default)
            if one.dest not in those and value != one.default:
                return one.option_strings[-1] if one.option_strings else str(value)
        return ""

    def error(self, message: str) -> NoReturn:
        """Prints the one-line error and ends with exit code 2."""
        message = message.removeprefix("argument ")
        text = f"{self.prog}: error: {printable(message)}\nsee {self.prog} --help\n"
        self.exit(EXIT_USAGE, text)


def _is_foreign_byte(letter: str) -> bool:
    """Whether it stands for a byte of a file name that is no UTF-8 (PEP 383)."""
    return "\udc80" <= letter <= "\udcff"


def _is_control(letter: str) -> bool:
    return letter < " " or "\x7f" <= letter < "\xa0"


def _escaped(text: str, kept: str) -> str:
    def one(letter: str) -> str:
        if _is_foreign_byte(letter):
            return f"\\x{ord(letter) - 0xDC00:02x}"
        if not _is_control(letter) or letter in kept:
            return letter
        return "".join(f"\\x{byte:02x}" for byte in letter.encode())

    return "".join(one(letter) for letter in text)


def printable(text: str) -> str:
    r"""`text` with control characters (but tab and line end) as \xNN: no orders to a terminal."""
    return _escaped(text, "\t\n")


def printable_name(path: str | os.PathLike[str]) -> str:
    r"""A file's name as it is, or in double quotes with \xNN for what a terminal would obey."""
    name = os.fspath(path)
    escaped = _escaped(name, "")
    if escaped == name and '"' not in name:
        return name
    return '"' + escaped.replace('"', '\\"') + '"'


def counted(count: int, what: str) -> str:
    """ "1 shard", "2 shards"."""
    return f"{count} {what}" if count == 1 else f"{count} {what}s"


def listed(names: Sequence[str], most: int) -> str:
    """ "A, B and 3 more"."""
    more = f" and {len(names) - most} more" if len(names) > most else ""
    return ", ".join(names[:most]) + more


def whole_number(least: int, *names: str, most: int | None = None) -> Callable[[str], int | str]:
    """For ``type=``: a whole number from `least` (to `most`), or one of `names` as it is."""

    def parse(text: str) -> int | str:
        if text in names:
            return text
        largest = 10**MOST_DIGITS - 1 if most is None else most
        is_short = text.isascii() and text.isdigit() and len(text) <= len(str(largest))
        if is_short and least <= int(text) <= largest:
            return int(text)
        end = "" if most is None or most >= 10**MOST_DIGITS else f" to {most}"
        wanted = " or ".join([f"a whole number from {least}{end}", *names])
        raise argparse.ArgumentTypeError(f"expected {wanted}, found '{text}'")

    return parse


def finite_number(text: str, wanted: str = "a number", above: float = -math.inf) -> float:
    """For ``type=``: a finite number."""
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not (math.isfinite(value) and value > above) or "_" in text:
        raise argparse.ArgumentTypeError(f"expected {wanted}, found '{text}'")
    return value


def positive_number(text: str) -> float:
    """For ``type=``: a finite number above 0."""
    return finite_number(text, "a number above 0", 0.0)


def _taken(row: Mapping[str, Any]) -> dict[str, Any]:
    """How the option of a row is taken."""
    if row["type"] == "bool":
        return {"action": "store_false" if "opposite" in row else "store_true"}
    if row["type"] == "int":
        most = row.get("most", 2**64 - 1)
        return {"metavar": "N", "type": whole_number(row.get("least", 0), most=most)}
    if row["type"] == "float":
        return {"metavar": "X", "type": finite_number}
    if "words" in row:
        return {"metavar": tuple(row["kind"].split()), "nargs": row["words"], "action": "append"}
    if row["type"] != "str":
        return {"metavar": "NAMES", "type": lambda text: list(words(text))}
    if "choices" in row:
        return {"choices": row["choices"]}
    return {"metavar": row["kind"] or "TEXT"}


def add_rows(
    parser: argparse.ArgumentParser,
    rows: Iterable[Mapping[str, Any]],
    without_value: Mapping[str, int] | None = None,
) -> None:
    """Adds the options of a table of the library, as `job_rows()` and `path_rows()` give them.

    Those in `without_value` need no value, and then have the one there. See `given`.
    """
    groups: dict[str, Any] = {"": parser}
    for row in rows:
        if row["group"] not in groups:
            groups[row["group"]] = parser.add_argument_group(row["group"])
        how, usual = _taken(row), row.get("unset_means", row["default"])
        hint = f"default: {usual}" if usual != "" and row["type"] in ("int", "float", "str") else ""
        if without_value and row["name"] in without_value:
            how |= {"nargs": "?", "const": without_value[row["name"]]}
            hint = f"{how['const']} if N is not given; {hint}"
        text = (row["help"] + (f" ({hint})" if hint else "")).replace("%", "%%")
        flags = ["--" + row.get("opposite", row["name"]).replace("_", "-")]
        flags[:0] = [f"-{row['letter']}"] if "letter" in row else []
        groups[row["group"]].add_argument(*flags, dest=row["name"], default=None, help=text, **how)


def given(arguments: argparse.Namespace, rows: Iterable[Mapping[str, Any]]) -> dict[str, Any]:
    """The options of these rows that were given."""
    values = {row["name"]: getattr(arguments, row["name"]) for row in rows}
    return {name: value for name, value in values.items() if value is not None}


def positive_numbers(text: str) -> tuple[float, ...]:
    """For ``type=``: numbers above 0 between commas."""
    try:
        return tuple(positive_number(word) for word in text.split(","))
    except argparse.ArgumentTypeError:
        wanted = "numbers above 0 between commas"
        raise argparse.ArgumentTypeError(f"expected {wanted}, found '{text}'") from None


def words(text: str) -> tuple[str, ...]:
    """For ``type=``: words between commas."""
    return tuple(word for word in text.split(",") if word)


def run_command(command: str, work: Callable[[], int]) -> int:
    """Calls `work` and returns its exit code; what the user did wrong becomes one line and 1.

    So does a package that is not installed, with 2: the line says how to install it.
    """
    _progress.hide()  # commands draw their own
    atexit.register(gc.freeze)  # else Python looks for circles in all that was imported, at its end
    try:
        with needed_by("this command"), warnings_shown_by(warn):
            code = work()
        sys.stdout.flush()
        return code
    except (OptionError, MissingPackageError) as error:
        print(f"pliant {command}: error: {printable(str(error))}", file=sys.stderr)
        return EXIT_USAGE
    except (Error, OSError) as error:
        lost = isinstance(error, OSError) and error.errno in (errno.EPIPE, *NO_ROOM)
        if lost and getattr(error, "filename", None) is None:  # standard output
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        if not isinstance(error, BrokenPipeError):  # the reader of our output has gone
            print(f"pliant {command}: error: {printable(_text_of(error))}", file=sys.stderr)
        return EXIT_FAILED
    except KeyboardInterrupt:
        print(f"pliant {command}: interrupted", file=sys.stderr)
        return EXIT_INTERRUPTED


def _text_of(error: Error | OSError) -> str:
    """With the name of the file: files that we write have theirs, standard output has none."""
    if not isinstance(error, OSError) or not error.strerror:
        return str(error)
    if error.filename is None:
        return f"standard output: {error.strerror}" if error.errno in NO_ROOM else str(error)
    return f"{printable_name(error.filename2 or error.filename)}: {error.strerror}"


def plain(value: Any) -> Any:
    """`value` as JSON has it: arrays are lists, not-a-number and infinities are null."""
    if isinstance(value, Mapping):
        return {str(key): plain(item) for key, item in value.items()}
    if isinstance(value, np.ndarray):
        return plain(value.tolist())
    if isinstance(value, (list, tuple)):
        return [plain(item) for item in value]
    if isinstance(value, np.generic):
        return plain(value.item())
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value


def print_json(value: Any) -> None:
    """Prints one JSON object."""
    text = json.dumps(plain(value), indent=2, allow_nan=False, ensure_ascii=False)
    if any(_is_foreign_byte(letter) for letter in text):
        text = json.dumps(plain(value), indent=2, allow_nan=False)
    print(text)


@dataclass
class Table:
    """Rows of text under a title; the first column is left-aligned, numbers are right-aligned."""

    title: str
    columns: Sequence[str]
    rows: list[Any] = field(default_factory=list)  #: sequences of text
    text_columns: Sequence[int] = (0,)  #: columns that are left-aligned

    def print(self, to: TextIO | None = None) -> None:
        """Prints with `rich`, if installed, on a terminal, as plain aligned text elsewhere."""
        to = to or sys.stdout
        if to.isatty() and is_there("rich"):
            self._print_rich(to)
        else:
            self._print_plain(to)

    def _print_rich(self, to: TextIO) -> None:
        table = rich_table.Table(
            title=self.title, title_justify="left", box=rich_box.SIMPLE_HEAD, pad_edge=False
        )
        for k, name in enumerate(self.columns):
            left = k in self.text_columns
            table.add_column(name, justify="left" if left else "right", overflow="fold")
        for row in self.rows:
            table.add_row(*(rich_text.Text(cell, style=_style(cell)) for cell in row))
        rich_console.Console(file=to, highlight=False).print(table)

    def _print_plain(self, to: TextIO) -> None:
        widths = [max(map(len, column)) for column in zip(self.columns, *self.rows, strict=True)]
        lines = [self.title] if self.title else []
        for row in [self.columns, *self.rows]:
            cells = [
                cell.ljust(width) if k in self.text_columns else cell.rjust(width)
                for k, (cell, width) in enumerate(zip(row, widths, strict=True))
            ]
            lines.append(("  " + "  ".join(cells)).rstrip())
        print("\n".join(lines), file=to)


def _style(cell: str) -> str:
    word = cell.split(":")[0].split(" ")[0]
    return {"passed": "green", "failed": "bold red", "skipped": "yellow"}.get(word, "")


def _clear() -> str:
    """Takes a progress bar off the line that is written next, on a terminal."""
    return "\r\x1b[K" if sys.stderr.isatty() else ""


def note(text: str) -> None:
    """Says something beside the result, on stderr."""
    print(f"{_clear()}note: {printable(text)}", file=sys.stderr)


def warn(text: str) -> None:
    """Says that something is not as expected, on stderr."""
    print(f"{_clear()}warning: {printable(text)}", file=sys.stderr)
