# SPDX-License-Identifier: MIT
"""A measured SAXS curve, as a file has it."""

from __future__ import annotations

import math
import os
import re
import warnings
from dataclasses import dataclass

import numpy as np

from pliant._core import InputError, PliantWarning

LEAST_POINTS = 20
MOST_Q = 0.5  #: 1/Angstrom: beyond, the solvent around each atom counts, which is not modelled
#: curves in 1/nm begin above this and go beyond that; in 1/Angstrom they do not
LEAST_NM, BEYOND_NM = 0.03, 1.0
GUINIER = 1.3  #: q Rg up to which ln I is a line in q^2

COLUMNS = ("q", "I", "sigma")
SEPARATOR = re.compile(r"[\s,;]+")


@dataclass(frozen=True)
class Curve:
    """Intensities (n) and their errors at q (n), 1/Angstrom, ascending."""

    q: np.ndarray
    intensity: np.ndarray
    sigma: np.ndarray

    def guinier(self, near: float) -> tuple[float, float] | None:
        """Radius of gyration and its error, Angstrom, from ln I up to q Rg = 1.3; None where the
        curve has too few points there. `near`: one to begin with."""
        found: tuple[float, float] | None = (near, 0.0)
        for _ in range(20):
            assert found is not None
            before, found = found, self._line(GUINIER / found[0])
            if found is None or abs(found[0] - before[0]) < 1e-4 * before[0]:
                break
        return found

    def _line(self, end: float) -> tuple[float, float] | None:
        some = (self.q <= end) & (self.intensity > 0)
        if some.sum() < 5:
            return None
        x, y = self.q[some] ** 2, np.log(self.intensity[some])
        weight = (self.intensity[some] / self.sigma[some]) ** 2
        x = x - np.average(x, weights=weight)
        curved = float(weight @ x**2)
        slope = float(weight @ (x * y)) / curved
        if slope >= 0:
            return None
        rg = math.sqrt(-3 * slope)
        return rg, 1.5 / (rg * math.sqrt(curved))


def read_curve(path: str | os.PathLike[str]) -> Curve:
    """The curve of a text file: in each line q, I and sigma, and perhaps more columns.

    Lines without a number at their beginning are a header as long as no data came; "#" begins
    comments. Warns where q is in 1/nm by its size, and of points beyond 0.5 1/Angstrom, which are
    left out. Raises InputError, which names the line, the field, what was expected and found.
    """
    name = os.fspath(path)
    try:
        with open(path, encoding="utf-8-sig") as stream:
            rows = _rows(stream.read().splitlines(), name)
    except UnicodeDecodeError as error:
        raise InputError(f"{name}: expected a text of columns q, I, sigma: {error}") from None
    table = np.array(rows).reshape(-1, len(COLUMNS))
    q = _in_angstrom(table[:, 0], name) if len(table) else table[:, 0]
    some = q <= MOST_Q
    if some.sum() < LEAST_POINTS:
        raise InputError(
            f"{name}: expected {LEAST_POINTS} points or more up to {MOST_Q:g} 1/Angstrom, found "
            f"{some.sum()}"
        )
    if not some.all():
        warnings.warn(f"{name}: {(~some).sum()} points beyond {MOST_Q:g} 1/Angstrom are left out",
                      PliantWarning, stacklevel=2)  # fmt: skip
    intensity = table[some, 1]
    if (above := int((intensity > 0).sum())) <= len(intensity) / 2:
        raise InputError(
            f"{name}: I: expected most numbers above 0, found {above} of {len(intensity)}"
        )
    return Curve(q[some], intensity, table[some, 2])


def _rows(lines: list[str], name: str) -> list[list[float]]:
    rows: list[list[float]] = []
    for number, line in enumerate(lines, 1):
        words = [word for word in SEPARATOR.split(line.split("#")[0]) if word]
        if not words or not (rows or _is_number(words[0])):
            continue
        rows.append(_row(words, f"{name}:{number}"))
        if len(rows) > 1 and rows[-1][0] <= rows[-2][0]:
            raise InputError(
                f"{name}:{number}: q: expected more than in the row before, {rows[-2][0]:g}, found "
                f"'{words[0]}'"
            )
    return rows


def _row(words: list[str], where: str) -> list[float]:
    if len(words) < len(COLUMNS):
        raise InputError(
            f"{where}: {COLUMNS[len(words)]}: expected three columns, q, I and sigma, found "
            f"{len(words)}"
        )
    found = []
    for field, word in zip(COLUMNS, words, strict=False):
        value = float(word) if _is_number(word) else math.nan
        above = field != "I"
        if not math.isfinite(value) or (above and value <= 0):
            expected = "a number above 0" if above else "a number"
            raise InputError(f"{where}: {field}: expected {expected}, found '{word}'")
        found.append(value)
    return found


def _is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return "_" not in word


def _in_angstrom(q: np.ndarray, name: str) -> np.ndarray:
    if q[0] > LEAST_NM and q[-1] > BEYOND_NM:
        warnings.warn(f"{name}: q from {q[0]:g} to {q[-1]:g}: taken as 1/nm", PliantWarning,
                      stacklevel=3)  # fmt: skip
        return np.asarray(q / 10)
    return q
