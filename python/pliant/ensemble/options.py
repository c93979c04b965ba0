# SPDX-License-Identifier: MIT
"""The options of ``pliant run`` and ``pliant sample`` that an ensemble passes on to its shards."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from pliant._core import OptionError

#: What the ensemble decides for each shard, or what no ensemble can do, with what to do instead.
_REFUSED = {
    "--walkers": "",
    "--shard": "the ensemble numbers its walkers itself",
    "--first-frame": "the ensemble numbers its frames itself",
    "--one-file": "each shard is one file in any case",
    "--threads": "--workers says how many processes share the shards",
    "--output": "",
    "--topology": "each shard holds its topology",
    "--overwrite": "give another folder, or remove this one",
    "--continue": "the same command again goes on",
    "--record-forces": "use it with pliant run itself",
    "--imd": "use it with pliant run itself",
    "--dry-run": "try the options with that command itself",
    "--help": "",
}

#: Options whose value may be a file: shards read it by its absolute path, and its bytes count.
_FILES = ("--bars", "--contacts", "--ordering", "--forces", "--amplitude")

_AN_OPTION = re.compile(r"--[a-z]|-[A-Za-z]")

#: The words after each option, once for each time that it was given.
Options = dict[str, list[list[str]]]


def parse_options(words: Sequence[str], command: str) -> Options:
    """The options among `words`. Raises OptionError for those that an ensemble cannot take."""
    found: Options = {}
    values: list[str] | None = None
    for word in words:
        if _AN_OPTION.match(word):
            name, _, value = word.partition("=")
            _refuse(name, command)
            values = [value] if "=" in word else []
            found.setdefault(name, []).append(values)
        elif values is None:
            raise OptionError(f'unexpected argument "{word}": expected one input and options')
        else:
            values.append(word)
    return found


def _refuse(name: str, command: str) -> None:
    if name not in _REFUSED:
        return
    why = _REFUSED[name]
    raise OptionError(f"{name}: is not passed on to pliant {command}" + (why and f": {why}"))


def file_options(options: Options) -> Iterable[tuple[str, list[str], int]]:
    """Each place where a file's name may stand: the option, its words and the index in them."""
    for name in _FILES:
        for words in options.get(name, []):
            for k in range(len(words)):
                yield name, words, k


def words_of(options: Options) -> list[str]:
    """The options as a command line has them."""
    return [word for name, times in options.items() for words in times for word in (name, *words)]


def text_of(name: str, options: Options) -> str:
    """An option as a message shows it: "--steps 1000", "no --steps"."""
    if name not in options:
        return f"no {name}"
    return " ".join(word for words in options[name] for word in (name, *words))
