# SPDX-License-Identifier: MIT
"""An H5MD file of 1.4 MB that would unpack to 1.2 GB: one line, and no memory, whoever reads it."""

import shutil
import subprocess

import h5py
import pytest
from expanding_files import EXPANDING, LARGE
from memory_of import measured

#: MB that a command may take, and far below what the files unpack to
MOST = 300

#: BAD stands for the file; the first words decide which option names the output.
COMMANDS = {
    "analyse": ["analyse", "BAD", "-o", "report"],
    "convert": ["convert", "BAD", "-o", "out.pdb"],
    "check": ["check", "BAD"],
    "compare ours": ["compare", "BAD", "good.h5md"],
    "compare theirs": ["compare", "good.h5md", "BAD"],
    "representatives": ["convert", "BAD", "-k", "2", "-o", "few.pdb"],
    "continue": ["run", "--continue", "BAD", "--steps", "9"],
    "recover": ["convert", "BAD", "-o", "saved.h5md", "--recover"],
}


@pytest.fixture(scope="module")
def good(command, tmp_path_factory):
    path = tmp_path_factory.mktemp("good") / "good.h5md"
    (path.parent / "water.xyz").write_text("3\nwater\nO 0 0 0\nH 0.96 0 0\nH -0.24 0.93 0\n")
    words = [command, "run", "water.xyz", "-o", path, "--steps", "5"]
    subprocess.run(words, cwd=path.parent, check=True, capture_output=True)
    return path


def expanding(good, folder, name):
    shutil.copy(good, folder / "good.h5md")
    shutil.copy(good, folder / "bad.h5md")
    with h5py.File(folder / "bad.h5md", "a") as file:
        EXPANDING[name][0](file)
    assert (folder / "bad.h5md").stat().st_size < 3e6 < LARGE / 100


def of_bad(command, folder, words):
    """Code, what was said, and MB."""
    return measured([command, *("bad.h5md" if word == "BAD" else word for word in words)], folder)


#: which read as another does
LIKE_ANOTHER = ("compare theirs", "representatives")


@pytest.mark.parametrize(
    "words",
    [
        pytest.param(words, id=name, marks=pytest.mark.long if name in LIKE_ANOTHER else [])
        for name, words in COMMANDS.items()
    ],
)
def test_positions_that_unpack_to_a_gigabyte(command, good, tmp_path, words):
    expanding(good, tmp_path, "chunk_of_positions")
    before = sorted(tmp_path.iterdir())
    code, said, memory = of_bad(command, tmp_path, words)
    assert code == 1, said
    assert "error: bad.h5md: " in said.splitlines()[-1]
    assert "/particles/trajectory/position/value" in said
    assert "has chunks that unpack to 1199999952 bytes, of which the file has 11" in said
    assert said.endswith(" are allowed")
    assert memory < MOST
    assert sorted(tmp_path.iterdir()) == before


@pytest.mark.parametrize(
    "name",
    [
        "bars",
        "chunk_of_bars",
        *(pytest.param(f"chunk_of_{of}", marks=pytest.mark.long) for of in ("sweeps", "masses")),
    ],
)
def test_frames_are_saved_where_something_else_expands(command, good, tmp_path, name):
    expanding(good, tmp_path, name)
    code, said, memory = of_bad(command, tmp_path, COMMANDS["recover"])
    assert (code, said) == (0, "")
    assert memory < MOST
    with h5py.File(tmp_path / "saved.h5md") as saved, h5py.File(good) as whole:
        value = "particles/trajectory/position/value"
        assert (saved[value][:] == whole[value][:]).all()
        assert EXPANDING[name][1] not in saved
        assert len(saved["connectivity/bonds"]) == 2
