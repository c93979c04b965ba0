# SPDX-License-Identifier: MIT
"""What is deprecated says so once, where it is called, and works on."""

import warnings

import pytest
from pliant.base.deprecated import warn_deprecated

import pliant


def old_name():
    warn_deprecated("old_name", "1.1", "new_name")
    return 3


def test_it_names_what_to_use_at_the_line_that_calls_it():
    with pytest.warns(pliant.PliantDeprecationWarning) as caught:
        assert old_name() == 3
    (one,) = caught
    assert str(one.message) == "old_name is deprecated since 1.1: use new_name"
    assert one.filename == __file__


def test_it_can_be_made_an_error():
    with warnings.catch_warnings():
        warnings.simplefilter("error", pliant.PliantDeprecationWarning)
        with pytest.raises(pliant.PliantDeprecationWarning):
            old_name()
