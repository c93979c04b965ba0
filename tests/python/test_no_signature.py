# SPDX-License-Identifier: MIT
"""Every public call and every method, given what it cannot take: one line, and no signature.

What it was given, and how often, is of no matter: a message of nanobind lists all types that a
function takes, over many lines, and does not say which argument was wrong.
"""

import inspect
import math

import numpy as np
import pytest

import pliant

LINE = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]])
ETHANE = pliant.read("data/molecules/ethane.xyz")
CHAIN = pliant.Framework([(0, 1), (1, 2)], [1.0, 1.0], 3)

#: objects whose methods are called and whose properties are set
OBJECTS = [
    ETHANE,
    CHAIN,
    pliant.State(LINE),
    pliant.Graph(CHAIN, LINE),
    pliant.Guide(),
    pliant.Motion(CHAIN, LINE),
    pliant.Resolver(CHAIN),
    pliant.WalkerResolver(CHAIN),
    pliant.build_model(ETHANE),
    pliant.prepare(ETHANE),
    pliant.rigidity(ETHANE),
]

BAD = [None, "", "x", -1, 2**70, math.nan, 2.5, [], {}, object(), b"x", 1j, np.zeros(0), [[1, 2]]]
SETS = ("__getitem__", "__setstate__", "__contains__")  #: of those of Python, what takes anything

#: what is wrong with what was given; ImportError: of a package that is not installed
REFUSALS = (TypeError, ValueError, IndexError, OverflowError, pliant.Error, ImportError)


def calls():
    compiled = {name for name in vars(pliant._core) if not name.startswith("_")}
    for name in sorted({*pliant.__all__, *compiled}):
        call = getattr(pliant, name)
        is_result = inspect.isclass(call) and name not in compiled  # made by functions alone
        is_error = inspect.isclass(call) and issubclass(call, BaseException)
        if callable(call) and not is_error and not is_result:
            yield name, call
    for thing in OBJECTS:
        kind = type(thing)
        for name in dir(kind):
            if not name.startswith("__") or name in SETS:
                yield f"{kind.__name__}.{name}", call_of(thing, name)


def call_of(thing, name):
    """The method; for a property, what sets it."""
    if not isinstance(inspect.getattr_static(type(thing), name), property):
        return getattr(thing, name)

    def set_it(*values, **named):
        if len(values) == 1 and not named:
            setattr(thing, name, values[0])

    return set_it


def given():
    yield (), {}
    for value in BAD:
        for times in (1, 2, 3):
            yield (value,) * times, {}
        yield (), {"no_such_name": value}


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize(("name", "call"), [pytest.param(*row, id=row[0]) for row in calls()])
def test_a_call_that_is_refused_says_so_in_a_line(name, call, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)  # some of these are names of files to be written
    for values, named in given():
        try:
            call(*values, **named)
        except AttributeError as error:  # Python's own, of a property
            assert "has no setter" in str(error), f"{name}{values}"
        except REFUSALS as error:
            text = str(error)
            assert "incompatible function arguments" not in text, f"{name}{values} {named}"
            assert "\n" not in text, f"{name}{values} {named}: {text}"


def test_there_are_rows():
    names = [name for name, _ in calls()]
    assert len(names) > 200
    assert {"Framework", "node_b_factors", "State.step", "Guide.has_arrived"} <= set(names)


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: pliant.Framework(None), "bars = None: must be an array (B, 2) integers"),
        (lambda: pliant.Framework(), "Framework: missing a required argument: 'bars'"),
        (lambda: pliant.State(None), "positions = None: must be an array"),
        (lambda: pliant.Structure(None), "positions = None: must be an array (N, 3) Angstrom"),
        (lambda: pliant.Guide(None), "Guide: too many positional arguments"),
        (lambda: pliant.Sterics(None, 3), "kinds = None: must be an array (N,) integers"),
        (lambda: pliant.node_b_factors(None), "positions = None: must be an array (M, 3)"),
        (lambda: pliant.contacts("x", structure=1), "contacts: multiple values for argument"),
        (
            lambda: pliant.Guide(pulls=[(1, 2)]),
            "pulls = [(1, 2)]: must be sequence of (joints, (x, y, z))",
        ),
        (lambda: pliant.Framework([], names=[1]), "names = [1]: must be N strings"),
        (lambda: setattr(pliant.State(LINE), "step", "x"), "step = 'x': must be a whole number"),
        (lambda: pliant.read_text("\udc80"), "read_text: cannot take text = '\\udc80'"),
        (lambda: pliant.from_mdanalysis(None), "atoms = None: must be a Universe"),
        (lambda: pliant.estimate_b_factors(3), "molecule = 3: must be a Structure, a path"),
    ],
)
def test_what_is_said(call, text):
    with pytest.raises(TypeError) as error:
        call()
    assert str(error.value).startswith(text)
