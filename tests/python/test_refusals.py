# SPDX-License-Identifier: MIT
"""What calls say of arguments that they cannot take: the name, the value, and what it must be."""

import math

import numpy as np
import pytest

import pliant

LINE = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]
ETHANE = pliant.read("data/molecules/ethane.xyz")


def framework():
    return pliant.Framework([(0, 1), (1, 2)], [1.0, 1.0], 3)


CALLS = {
    "run": lambda **given: pliant.run(framework(), np.array(LINE), **{"steps": 1, **given}),
    "resolve": lambda **given: pliant.resolve(framework(), np.array(LINE), **given),
    "Motion": lambda **given: pliant.Motion(framework(), np.array(LINE), **given),
    "Resolver": lambda **given: pliant.Resolver(framework(), **given),
    "sample": lambda **given: pliant.sample(ETHANE, **given),
    "build_model": lambda **given: pliant.build_model(ETHANE, **given),
    "rigidity": lambda **given: pliant.rigidity(ETHANE, **given),
    "prepare": lambda **given: pliant.prepare(ETHANE, **given),
    "contacts": lambda **given: pliant.contacts(ETHANE, **given),
    "read": lambda **given: pliant.read("data/molecules/ethane.xyz", **given),
}

#: by kind of argument, what it cannot be
UNFIT = {
    "whole": (2.5, "x", None, math.nan),
    "unsigned": (2.5, "x", None, math.nan, -1),
    "real": ("x", None),
    "truth": (2.5, "x", None, math.nan),
    "text": (2.5, None, math.nan),
}

ARGUMENTS = {
    "run": {"steps": "whole", "every": "whole", "max_sweeps": "whole", "seed": "unsigned",
            "walker": "unsigned", "force": "real", "weighting": "real", "mass_weighted": "truth",
            "perturb": "text"},
    "resolve": {"max_sweeps": "whole", "root": "whole", "seed": "unsigned", "walker": "unsigned",
                "weighting": "real", "tolerance": "real", "mass_weighted": "truth"},
    "Motion": {"max_sweeps": "whole", "seed": "unsigned", "walker": "unsigned", "force": "real"},
    "sample": {"frames": "whole", "first_frame": "whole", "threads": "whole", "seed": "unsigned",
               "contact_energy": "real", "overwrite": "truth", "sampler": "text"},
    "build_model": {"hbond_cutoff": "real", "keep_waters": "truth", "model": "text", "pin": "text"},
    "rigidity": {"hbond_bars": "whole", "hbond_cutoff": "real", "ends_turn": "truth"},
    "prepare": {"keep_waters": "truth", "floppy_below": "real"},
    "contacts": {"hbond_cutoff": "real"},
    "read": {"model": "whole", "perceive_bonds": "truth"},
}  # fmt: skip  # some pairs a line

ROWS = [
    (call, name, value)
    for call, names in ARGUMENTS.items()
    for name, kind in names.items()
    for value in UNFIT[kind]
    # the defaults, which sample chooses
    if not (call == "sample" and name in ("frames", "threads") and value is None)
]


@pytest.mark.parametrize(("call", "name", "value"), ROWS)
def test_an_unfit_argument_is_named_with_its_value(call, name, value):
    with pytest.raises((TypeError, pliant.OptionError)) as error:
        CALLS[call](**{name: value})
    assert str(error.value).startswith(f"{name} = {value!r}: must be ")
    assert "std::" not in str(error.value)
    assert len(str(error.value)) < 100


@pytest.mark.parametrize(
    ("call", "name", "most"),
    [
        ("run", "steps", 2**63 - 1),
        ("resolve", "max_sweeps", 2**63 - 1),
        ("run", "seed", 2**64 - 1),
        ("sample", "frames", 2**63 - 1),
    ],
)
def test_a_number_of_more_than_64_bits(call, name, most):
    with pytest.raises(pliant.OptionError) as error:
        CALLS[call](**{name: most + 1})
    assert str(error.value).startswith(f"{name} = {most + 1}: must be a whole number from ")


def test_a_number_below_a_range_of_no_sign():
    with pytest.raises(pliant.OptionError) as error:
        pliant.sample(ETHANE, seed=-1)
    assert str(error.value) == ("seed = -1: must be a whole number from 0 to 18446744073709551615")


def test_what_is_no_argument_at_all():
    with pytest.raises(TypeError) as error:
        pliant.sample(ETHANE, frame=3)
    assert str(error.value) == "sample: has no argument 'frame' (did you mean 'frames'?)"
    with pytest.raises(TypeError) as error:
        pliant.sample(ETHANE, colour=3)
    assert str(error.value) == "sample: has no argument 'colour'; help(pliant.sample) lists them"
    with pytest.raises(TypeError) as error:
        pliant.contacts(ETHANE, colour=3)
    known = "structure, hbond_cutoff, more_contacts"
    assert str(error.value) == f"contacts: has no argument 'colour'; known: {known}"
    with pytest.raises(TypeError) as error:
        pliant.resolve(7, np.array(LINE))
    assert str(error.value) == "framework = 7: must be a Framework"
