# SPDX-License-Identifier: MIT
"""What editors, `inspect` and type checkers see."""

import inspect
import subprocess
import sys

import pytest

import pliant


def test_dir_shows_public_names_only():
    assert dir(pliant) == sorted(pliant.__all__)


def test_every_function_has_a_signature():
    for name in pliant.__all__:
        thing = getattr(pliant, name)
        if callable(thing) and not isinstance(thing, type):
            assert inspect.signature(thing).parameters is not None, name
    assert str(inspect.signature(pliant.sample)).startswith(
        "(structure: 'MolecularModel | Structure | Molecule', frames: 'int | None' = None, *, "
    )


def test_methods_have_signatures():
    assert list(inspect.signature(pliant.Structure.select).parameters) == ["self", "selection"]
    structure = pliant.Structure([[0, 0, 0]])
    assert list(inspect.signature(structure.select).parameters) == ["selection"]
    read = inspect.signature(pliant.read).parameters
    assert read["model"].default == 1
    assert read["assembly"].default is None


def test_packages_that_are_called():
    for name in ("analyse", "check", "compare", "convert", "path", "representatives"):
        assert callable(getattr(pliant, name)), name


TYPED = """
import pliant

ensemble = pliant.sample("x.pdb", 5)
reveal_type(len(ensemble))
reveal_type(ensemble[0])
reveal_type(ensemble[1:])
reveal_type(pliant.run("x.pdb")[1:])
pliant.sample("x.pdb", sampler="mode")
pliant.sample(3)
pliant.path("x.pdb", "y.pdb", atoms="CB")
pliant.sample("x.pdb", n_frames=4)
"""

REVEALED = [
    'note: Revealed type is "int"',
    'note: Revealed type is "numpy.ndarray[tuple[Any, ...], numpy.dtype[',
    'note: Revealed type is "pliant.trajectory.trajectory.Trajectory"',
    'note: Revealed type is "pliant.trajectory.trajectory.Trajectory"',
    'error: Argument "sampler" to "sample" has incompatible type "Literal[\'mode\']"',
    'error: Argument 1 to "sample" has incompatible type "int"',
    'error: Argument "atoms" to "path" has incompatible type "Literal[\'CB\']"',
    'error: Unexpected keyword argument "n_frames" for "sample"',
]


@pytest.mark.long
def test_mypy_sees_what_is_wrong(tmp_path):
    pytest.importorskip("mypy")
    (tmp_path / "typed.py").write_text(TYPED)
    words = [sys.executable, "-m", "mypy", "--no-error-summary", "--cache-dir", "cache", "typed.py"]
    lines = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True).stdout.splitlines()
    said = [line.split(": ", 1)[1].replace("builtins.", "") for line in lines]
    main = [line for line in said if line.startswith(("error: ", "note: Revealed"))]
    for found, expected in zip(main, REVEALED, strict=True):
        assert found.startswith(expected)
