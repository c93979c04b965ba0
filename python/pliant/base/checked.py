# SPDX-License-Identifier: MIT
"""Functions in Python that say of arguments what those in C++ do: see `refusals`."""

from __future__ import annotations

import functools
import inspect
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, ParamSpec, TypeVar

import numpy as np

from pliant._core import OptionError
from pliant.base.refusals import fits, refuse, refuse_unknown, shown

P = ParamSpec("P")
R = TypeVar("R")


@dataclass(frozen=True)
class Wanted:
    """What an argument must be besides of its annotated type."""

    words: str  #: after "must be"
    holds: Callable[[Any], bool]
    error: type[Exception] = OptionError
    takes_none: bool = True  #: as what is not given


def whole(least: int, most: float = math.inf, name: str = "") -> Wanted:
    """Whole numbers from `least` to `most`; or a text, `name`."""
    end = "" if most == math.inf else f" to {most}"
    words = f"a whole number from {least}{end}" + (f' or "{name}"' if name else "")
    return Wanted(words, lambda x: x == name if isinstance(x, str) else least <= x <= most)


def _is_pair(value: Any, annotation: str) -> bool:
    return fits(value, "tuple") and len(value) == 2 and all(fits(one, annotation) for one in value)


def having(attribute: str, words: str) -> Wanted:
    """Objects of another package, known by an attribute; that package may not be there."""
    return Wanted(words, lambda x: hasattr(x, attribute), TypeError, takes_none=False)


SEED = whole(0, 2**64 - 1)
NOT_ZERO = Wanted("a whole number, not 0", lambda x: bool(x != 0))
ABOVE_0 = Wanted("a number above 0", lambda x: bool(x > 0))
POSITIVE = Wanted("positive and finite", lambda x: bool(0 < x < math.inf))
POSITIVES = Wanted(
    "numbers, positive and finite",
    lambda x: len(x) > 0 and all(fits(one, "float") and 0 < one < math.inf for one in x),
)
PAIRS_OF_TEXTS = Wanted("pairs of texts", lambda x: all(_is_pair(pair, "str") for pair in x))


def checked(**wanted: Wanted) -> Callable[[Callable[P, R]], Callable[P, R]]:
    """Refuses arguments not of their annotated type, or not what is wanted by name.

    Raises TypeError, or the error of what is wanted, before the function is called: "seed = -1:
    must be ...".
    """

    def wrap(function: Callable[P, R]) -> Callable[P, R]:
        parameters = inspect.signature(function).parameters.values()
        takes_more = any(one.kind is one.VAR_KEYWORD for one in parameters)
        named_ones = (one for one in parameters if one.kind is not one.VAR_KEYWORD)
        annotations = {one.name: str(one.annotation) for one in named_ones}

        @functools.wraps(function)
        def call(*positional: P.args, **named: P.kwargs) -> R:
            if not takes_more:  # then the function looks at these
                refuse_unknown(function.__name__, annotations, named)
            given = dict(zip(annotations, positional, strict=False)) | named
            for name in annotations.keys() & given:
                _look_at(name, given[name], annotations[name], wanted)
            return function(*positional, **named)

        return call

    return wrap


def _look_at(name: str, value: object, annotation: str, every: Mapping[str, Wanted]) -> None:
    wanted = every.get(name)
    if not fits(value, annotation) and not isinstance(value, np.bool_):
        refuse(name, value, annotation, words=wanted.words if wanted else "")
    if wanted is None or (value is None and wanted.takes_none):
        return
    if not wanted.holds(value):
        raise wanted.error(f"{name} = {shown(value)}: must be {wanted.words}")
