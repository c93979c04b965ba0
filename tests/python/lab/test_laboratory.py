# SPDX-License-Identifier: MIT
"""Orderings and forces as files: between Python, the text and the resolver."""

import json
import re

import numpy as np
import pytest
from pliant.checks.weightings import WEIGHTINGS

import pliant

FIGURE = next(row for row in pliant.examples() if row.name == "thesis_figure_5_2")


def broken():
    positions = FIGURE.positions.copy()
    positions[3] += [0.4, -0.2, 0.3]
    return positions


def test_an_ordering_resolves_as_the_technique_it_was_taken_from():
    one, two, three = broken(), broken(), broken()
    ordering = pliant.order(FIGURE.framework, "dfs_cycle", root=3)
    by_name = pliant.resolve(FIGURE.framework, one, "dfs_cycle", 0.75, root=3)
    given = pliant.resolve(FIGURE.framework, two, "input", 0.75, ordering=ordering)
    kept = pliant.Resolver(FIGURE.framework, "input", 0.75, ordering=ordering).resolve(three)
    assert by_name.sweeps == given.sweeps == kept.sweeps > 1
    np.testing.assert_array_equal(one, two)
    np.testing.assert_array_equal(one, three)


def test_ordering_text_is_read_back(tmp_path):
    ordering = pliant.order(FIGURE.framework, "dfs_cycle", root=2)
    path = tmp_path / "ordering.txt"
    path.write_text(pliant.ordering_text(FIGURE.framework, ordering))
    for column, back in zip(
        ordering, pliant.read_ordering_file(path, FIGURE.framework), strict=True
    ):
        np.testing.assert_array_equal(column, back)


def test_lists_are_an_ordering_too():
    pair = pliant.Framework([[0, 1], [1, 2]], [1.0, 1.0])
    text = pliant.ordering_text(pair, ([1, 0], [2, 1], [True, False]))
    assert text == "pliant-ordering 1\nbar 2 1 tree\nbar 1 0 non_tree\n"


@pytest.mark.parametrize(
    ("ordering", "error", "message"),
    [
        (([0], [0], [True]), pliant.OptionError, "ordering: bar 1 - 2 is missing"),
        (([0, 1], [0], [True]), pliant.InputError,
         "ordering: expected three columns of one length, found 2, 1 and 1"),
        (([0, 1], [0, 0], [True, True]), pliant.OptionError,
         "ordering: bar 1 - 2 has a near joint that is not its end"),
        (([0, 0], [0, 0], [True, True]), pliant.OptionError, "ordering: bar 0 - 1 appears twice"),
        (([0, 1], [0, 1], [1, 1]), TypeError,
         "is_tree: expected an array of truth values, found an array of int64 with shape (2,)"),
        (([0, -1], [0, 1], [True, True]), IndexError, "bar -1 of 4294967295 does not exist"),
    ],
)  # fmt: skip  # a table: a row a line
def test_what_is_no_ordering_is_refused(ordering, error, message):
    pair = pliant.Framework([[0, 1], [1, 2]], [1.0, 1.0])
    with pytest.raises(error) as caught:
        pliant.resolve(pair, np.zeros((3, 3)), "input", ordering=ordering)
    assert str(caught.value) == message


def test_the_weightings_of_the_thesis_are_those_of_a_test_set():
    default = re.search(r"weightings: .*? = (\[[^]]*\])", pliant.write_test_set.__doc__)
    assert tuple(json.loads(default[1])) == WEIGHTINGS
