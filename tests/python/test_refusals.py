# SPDX-License-Identifier: MIT
"""Every public call, each of its plain arguments: what cannot be it is named, with its value."""

import inspect
import math
from types import SimpleNamespace

import numpy as np
import pytest
from pliant.base.refusals import kinds_of
from pliant.measure.compared.paths import compare_paths
from pliant.report.representatives import representatives
from pliant.trajectory.recover.recover import recover

import pliant

LINE = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]])
ETHANE = pliant.read("data/molecules/ethane.xyz")
CHAIN = pliant.Framework([(0, 1), (1, 2)], [1.0, 1.0], 3)
NOWHERE = "no folder/of this name.h5md"

#: what each call needs; whatever it is given besides is refused before anything is read or made
NEEDED = {
    pliant.run: {"framework": CHAIN, "state": LINE, "steps": 1},
    pliant.continue_run: {"path": NOWHERE},
    pliant.run_ensemble: {"framework": CHAIN, "state": LINE, "steps": 1},
    pliant.path: {"start": ETHANE, "end": ETHANE},
    pliant.analyse: {"path": NOWHERE},
    representatives: {"path": NOWHERE, "count": 2},
    pliant.compare: {"ours": NOWHERE, "theirs": NOWHERE},
    compare_paths: {"ours": NOWHERE, "theirs": NOWHERE},
    pliant.check: {"path": NOWHERE},
    pliant.view: {"source": NOWHERE},
    recover: {"broken": NOWHERE, "good": NOWHERE},
    pliant.from_rdkit: {"molecule": SimpleNamespace(GetConformers=list)},
    pliant.from_mdanalysis: {"atoms": SimpleNamespace(atoms=[])},
    pliant.from_openmm: {"topology": SimpleNamespace(atoms=list), "positions": []},
    pliant.to_mdanalysis: {"source": ETHANE},
    pliant.read: {"path": NOWHERE},
    pliant.read_text: {"text": ""},
    pliant.build_model: {"structure": ETHANE},
    pliant.prepare: {"structure": ETHANE},
    pliant.contacts: {"structure": ETHANE},
    pliant.rigidity: {"structure": ETHANE},
    pliant.sample: {"structure": ETHANE},
    pliant.continue_sample: {"path": NOWHERE},
    pliant.network_modes: {"structure": ETHANE},
    pliant.mode_field: {"structure": ETHANE, "mode": 1},
    pliant.choose_technique: {"framework": CHAIN},
    pliant.order: {"framework": CHAIN},
    pliant.measure_bars: {"framework": CHAIN, "positions": LINE},
    pliant.resolve: {"framework": CHAIN, "positions": LINE},
    pliant.generate: {"kind": "tree"},
    pliant.make_force_file: {"framework": CHAIN},
    pliant.write_test_set: {"directory": NOWHERE},
    pliant.write_topology_pdb: {"path": NOWHERE, "structure": ETHANE},
    pliant.Frame: {"step": 1, "time": 0.0, "positions": LINE},
    pliant.Guide: {},
    pliant.H5mdReader: {"path": NOWHERE},
    pliant.H5mdRecorder: {"path": NOWHERE, "framework": CHAIN},
    pliant.PdbRecorder: {"path": NOWHERE, "structure": ETHANE},
    pliant.Motion: {"framework": CHAIN, "state": LINE},
    pliant.Resolver: {"framework": CHAIN},
    pliant.WalkerResolver: {"framework": CHAIN},
}

#: values, and the types of which each may be one
VALUES = [
    (2.5, {"float"}),
    (math.nan, {"float"}),
    ("x", {"str", "PathLike"}),
    (None, {"None"}),
    (object, set()),
]
PLAIN = {"int", "float", "bool", "str", "PathLike", "None"}


def annotations_of(call):
    made = call.__init__ if inspect.isclass(call) else call
    every = inspect.signature(made).parameters.items()
    return {name: str(one.annotation) for name, one in every if name != "self"}


def rows():
    for call in NEEDED:
        for name, annotation in annotations_of(call).items():
            kinds = set(kinds_of(annotation)) - {"Any", "object"}
            for value, of in VALUES:
                if kinds and kinds <= PLAIN and not kinds & of:
                    yield pytest.param(call, name, value, id=f"{call.__name__} {name} {value}")


@pytest.mark.parametrize(("call", "name", "value"), list(rows()))
def test_what_is_not_of_its_type_is_named(call, name, value):
    with pytest.raises(TypeError) as error:
        call(**{**NEEDED[call], name: value})
    assert str(error.value).startswith(f"{name} = {value!r}: must be ")
    assert len(str(error.value)) < 120


def test_there_are_rows_of_what_measures_and_draws():
    """The rows are made of annotations: none may be lost because they are written otherwise."""
    found = [(row.values[0].__name__, row.values[1]) for row in rows()]
    assert len(found) > 900
    names = "analyse dpi", "check md_steps", "path step", "view height", "generate box"
    for row in map(tuple, map(str.split, [*names, "H5mdRecorder flush_seconds"])):
        assert row in found


OUT_OF_RANGE = [
    (pliant.path, "step", 0.0),
    (pliant.path, "step", math.nan),
    (pliant.path, "backtrack", -1),
    (pliant.path, "backtrack", 2**63),
    (pliant.path, "seed", -1),
    (pliant.path, "seed", 2**64),
    (pliant.analyse, "step", 0),
    (pliant.analyse, "workers", 0),
    (pliant.analyse, "workers", 2**63),
    (pliant.analyse, "dpi", -1),
    (pliant.analyse, "distances", [("name CA",)]),
    (pliant.analyse, "distances", ["ab"]),
    (representatives, "count", 0),
    (pliant.compare, "frames", 1),
    (pliant.compare, "frames", "every"),
    (compare_paths, "frames", -1),
    (pliant.check, "frames", 0),
    (pliant.check, "frames", "every"),
    (pliant.check, "displacements", ()),
    (pliant.check, "displacements", (0.1, -1.0)),
    (pliant.check, "displacements", ("x",)),
    (pliant.check, "seed", -1),
    (pliant.check, "time_limit", math.nan),
    (pliant.check, "starts", 0),
    (pliant.check, "long_starts", -1),
    (pliant.check, "md_steps", -1),
    (pliant.check, "total_limit", 0),
    (pliant.view, "height", 0),
    (pliant.to_mdanalysis, "timestep", -1.0),
    (pliant.run_ensemble, "shard", (0, -1)),
    (pliant.run_ensemble, "shard", (0, 2.5)),
    (pliant.run_ensemble, "threads", 0),
]


@pytest.mark.parametrize(("call", "name", "value"), OUT_OF_RANGE)
def test_what_is_out_of_its_range_is_named(call, name, value):
    with pytest.raises(pliant.OptionError) as error:
        call(**{**NEEDED[call], name: value})
    text = str(error.value)
    if text.startswith(f"{name}: expected "):  # of options that files hold as well
        assert text.endswith(f", found {value:g}")
    else:
        texts = [repr(value)] + ([f"{value:g}"] if isinstance(value, float) else [])
        assert text.startswith(tuple(f"{name} = {text}: must be " for text in texts))


@pytest.mark.parametrize("call", NEEDED, ids=lambda call: call.__name__)
def test_a_name_that_there_is_not_brings_the_one_that_is_near(call):
    names = [name for name in annotations_of(call) if name not in NEEDED[call]]
    for name in names:
        with pytest.raises(TypeError) as error:
            call(**NEEDED[call], **{name + "_x": 1})
        assert str(error.value) == (
            f"{call.__name__}: has no argument '{name}_x' (did you mean '{name}'?)"
        )


def test_objects_of_other_packages():
    for call, name in [
        (pliant.from_rdkit, "molecule"),
        (pliant.from_mdanalysis, "atoms"),
        (pliant.from_openmm, "topology"),
    ]:
        with pytest.raises(TypeError, match=f"^{name} = 3: must be an? "):
            call(**{**NEEDED[call], name: 3})


def test_truth_as_numpy_has_it_is_truth():
    with pytest.raises(pliant.InputError, match="no such file"):
        recover(NOWHERE, NOWHERE, overwrite=np.True_)


@pytest.mark.parametrize(
    ("call", "name", "most"),
    [
        (pliant.run, "steps", 2**63 - 1),
        (pliant.resolve, "max_sweeps", 2**63 - 1),
        (pliant.run, "seed", 2**64 - 1),
        (pliant.sample, "frames", 2**63 - 1),
    ],
)
def test_a_number_of_more_than_64_bits(call, name, most):
    with pytest.raises(pliant.OptionError) as error:
        call(**{**NEEDED[call], name: most + 1})
    assert str(error.value).startswith(f"{name} = {most + 1}: must be a whole number from ")


def test_what_is_no_argument_at_all():
    with pytest.raises(TypeError) as error:
        pliant.contacts(ETHANE, colour=3)
    known = "structure, hbond_cutoff, more_contacts"
    assert str(error.value) == f"contacts: has no argument 'colour'; known: {known}"
    with pytest.raises(TypeError) as error:
        pliant.resolve(7, LINE)
    assert str(error.value) == "framework = 7: must be a Framework"
