# SPDX-License-Identifier: MIT
"""Warnings that a test meets on its way: expected by their words, and only where they are due."""

from contextlib import nullcontext

import pytest

import pliant


def read_without_elements(path):
    """The structure of a PDB file whose columns of elements are empty."""
    with pytest.warns(pliant.PliantWarning, match="no element in columns 77-78: taken from"):
        return pliant.read(path)


def read_written(path):
    """The structure of a PDB file of ours; atoms of no known element have blank columns there."""
    atoms = [line for line in path.read_text().splitlines() if line[:6] in ("ATOM  ", "HETATM")]
    if all(line[76:78].strip() for line in atoms):
        return pliant.read(path)
    return read_without_elements(path)


def of_fit(framework, technique="auto", **options):
    """A context that expects the warning of a technique that is doubtful for the framework."""
    fits = {name: rest for name, *rest in pliant.techniques_for(framework, **options)}
    fit, why = fits[technique]
    if fit != "doubtful":
        return nullcontext()
    return pytest.warns(pliant.PliantWarning, match=why.partition(":")[0] + ": goes from bar to")
