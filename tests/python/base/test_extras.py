# SPDX-License-Identifier: MIT
"""NumPy and h5py are enough; of what else is needed one line says how to install it."""

import json
import re

import pytest
from forked import ended_code
from real_files import CAFFEINE, PEPTIDE, ROOT

import pliant

try:
    import tomllib
except ModuleNotFoundError:  # Python 3.10
    from pip._vendor import tomli as tomllib

EXTRAS = tuple(
    "MDAnalysis anywidget dask distributed matplotlib openmm rdkit rich scipy websockets".split()
)

NEEDED = ("h5py", "inspect", "numpy")

# Modules of these names are not found, as if they were not installed.
HIDE = """
import sys, warnings
warnings.simplefilter("error")
class Hidden:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in {names!r}:
            raise ModuleNotFoundError(f"No module named {{name!r}}", name=name)
sys.meta_path.insert(0, Hidden())
"""


def run_without(code, *names, folder=None):
    """Runs Python code where the packages of these names are missing, all extras by default."""
    text = HIDE.format(names=names or EXTRAS) + code
    return ended_code(text, *NEEDED, cwd=folder)


def message_without(code, *names, folder=None):
    """The last line of what Python says of an exception."""
    ended = run_without(code, *names, folder=folder)
    assert ended.returncode == 1
    return ended.stderr.splitlines()[-1]


@pytest.fixture(scope="module")
def trajectory(tmp_path_factory):
    path = tmp_path_factory.mktemp("extras") / "caffeine.h5md"
    pliant.run(pliant.read(CAFFEINE), output=path, steps=5)
    return path


def test_reading_running_and_recording_need_none(tmp_path):
    code = f"""
import pliant
structure = pliant.read({str(CAFFEINE)!r})
summary = pliant.run(structure, output="out.h5md", topology="out.pdb", steps=20)
print(summary.steps, len(pliant.H5mdReader("out.h5md")))
assert not set(sys.modules) & set({EXTRAS!r})
"""
    ended = run_without(code, folder=tmp_path)
    assert ended.stderr == ""
    assert ended.stdout.split() == ["20", "21"]


@pytest.mark.parametrize(
    ("code", "missing", "said"),
    [
        ("pliant.check('x')", "openmm", 'pliant.check needs OpenMM: pip install "pliant[openmm]"'),
        ("pliant.check('x', picture='x')", "matplotlib",
         'a picture of pliant.check needs matplotlib: pip install "pliant[plot]"'),
        ("pliant.compare('x', 'y')", "MDAnalysis",
         'pliant.compare needs MDAnalysis: pip install "pliant[analysis]"'),
        ("pliant.compare('x', 'y', pictures='.')", "matplotlib",
         'a picture of pliant.compare needs matplotlib: pip install "pliant[plot]"'),
        ("pliant.analyse('x')", "MDAnalysis",
         'pliant.analyse needs MDAnalysis: pip install "pliant[analysis]"'),
        ("pliant.analyse('x')", "matplotlib",
         'pliant.analyse needs matplotlib: pip install "pliant[plot]"'),
        ("pliant.measure.Rmsf", "MDAnalysis",
         'pliant.measure.Rmsf needs MDAnalysis: pip install "pliant[analysis]"'),
        ("pliant.to_mdanalysis(pliant.read_text('1\\n\\nO 0 0 0\\n', 'xyz'))", "MDAnalysis",
         'pliant.to_mdanalysis needs MDAnalysis: pip install "pliant[analysis]"'),
        ("pliant.view('x')", "anywidget",
         'pliant.view needs anywidget: pip install "pliant[notebook]"'),
        ("pliant.from_openmm(None, None)", "openmm",
         'pliant.from_openmm needs OpenMM: pip install "pliant[openmm]"'),
    ],
)  # fmt: skip  # a table: a row a line
def test_python_says_what_is_missing_in_one_line(code, missing, said):
    line = message_without(f"import pliant, pliant.measure\n{code}", missing)
    assert line == f"pliant.base.extras.MissingPackageError: {said}"


def test_the_error_is_an_import_error():
    code = """
import pliant
try:
    pliant.check("x")
except ImportError as error:
    print(error.name)
"""
    assert run_without(code, "openmm").stdout == "openmm\n"


def commands():
    """Each command that is written in Python, words that it takes, what is hidden and missing."""
    return [
        ("analyse", ["{file}"], "MDAnalysis", "MDAnalysis", "analysis"),
        ("analyse", ["{file}"], "matplotlib", "matplotlib", "plot"),
        ("check", ["{file}"], "openmm", "OpenMM", "openmm"),
        ("check", ["{file}", "-o", "x"], "matplotlib", "matplotlib", "plot"),
        ("compare", ["{file}", "{file}"], "MDAnalysis", "MDAnalysis", "analysis"),
        ("lab-bench", ["work-precision", str(CAFFEINE)], "scipy", "SciPy", "lab"),
        ("lab-bench", ["work-precision", str(CAFFEINE)], "openmm", "OpenMM", "lab"),
        ("lab-bench", ["work-precision", str(CAFFEINE), "-o", "x.png"], "matplotlib", "matplotlib",
         "lab"),
        ("ensemble", [str(CAFFEINE), "-o", "x", "--walkers", "2"], "distributed",
         "dask.distributed", "ensemble"),
        ("lab-bench", ["stress"], "openmm", "OpenMM", "openmm"),
        ("play", ["--connect", ":8888", str(CAFFEINE)], "websockets", "websockets", "play"),
        ("lab-experiment", ["report", "."], "matplotlib", "matplotlib", "plot"),
    ]  # fmt: skip  # a table: a row a line


def scripts():
    """Module and function of each command, by its name."""
    with open(ROOT / "pyproject.toml", "rb") as file:
        table = tomllib.load(file)["project"]["scripts"]
    return {name.removeprefix("pliant-"): text.split(":") for name, text in table.items()}


@pytest.mark.parametrize(("command", "words", "hidden", "name", "extra"), commands())
def test_commands_say_what_is_missing_in_one_line(
    command, words, hidden, name, extra, trajectory, tmp_path
):
    module, function = scripts()[command]
    words = [word.format(file=trajectory) for word in words]
    code = f"from {module} import {function}\nsys.exit({function}({words!r}))"
    ended = run_without(code, hidden, folder=tmp_path)
    assert ended.returncode == 2
    said = command.replace("-", " ")
    pattern = rf'pliant {said}.*: error: .* needs {name}: pip install "pliant\[{extra}\]"\n'
    assert re.fullmatch(pattern, ended.stderr)
    assert ended.stdout == ""
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("command", scripts())
def test_help_needs_none(command):
    module, function = scripts()[command]
    code = f"from {module} import {function}\n{function}(['--help'])"
    ended = run_without(code)
    assert ended.returncode == 0
    said = command.replace("lab-", "lab ")
    assert ended.stdout.startswith(f"usage: pliant {said}")


def test_a_check_is_reported_without_rich_and_matplotlib(trajectory, tmp_path):
    words = [str(trajectory), "--json"]
    code = f"from pliant.report.check.command import main\nsys.exit(main({words!r}))"
    ended = run_without(code, "MDAnalysis", "matplotlib", "rdkit", "rich", "scipy")
    assert ended.stderr == ""
    assert json.loads(ended.stdout)["passed"]


def test_a_path_needs_none(tmp_path):
    code = "import pliant\npath = pliant.path({0!r}, {0!r})\nprint(path.arrived, len(path.frames))"
    ended = run_without(code.format(str(PEPTIDE)))
    assert (ended.stdout, ended.stderr) == ("True 1\n", "")


@pytest.mark.parametrize("name", ["analyse", "check", "compare"])
def test_what_is_imported_late_is_a_function_that_says_what_it_does(name):
    code = (
        f"import pliant, inspect; assert inspect.isfunction(pliant.{name})"
        f"; assert inspect.getdoc(pliant.{name})[0].isupper()"
        f"; pliant.{name}('no_such_file', *(['other'] if '{name}' == 'compare' else []))"
    )
    ended = ended_code(code, *NEEDED)
    assert re.search("Error: .*no_such_file", ended.stderr.splitlines()[-1])


def test_the_package_has_its_names_and_no_others():
    assert set(dir(pliant)) == set(pliant.__all__)
    for name in pliant.__all__:
        assert getattr(pliant, name) is not None
    with pytest.raises(AttributeError, match=r"module 'pliant' has no attribute 'no'"):
        _ = pliant.no
