# SPDX-License-Identifier: MIT
"""What a new user gives by mistake: one line that says what is wrong, whatever the command."""

import gzip
import math
import os

import pytest

ATOM = "ATOM      1  N   ALA A   1       0.000   0.000   0.000  1.00  0.00           N\n"
KNOWN = (
    "known: pdb .pdb .ent .pdbqt; mmcif .cif .mmcif .mcif; sdf .sdf .sd .mol .mdl; xyz .xyz .extxyz"
)
NOT_READ = "which is not read (pliant.from_mdanalysis in Python may)"

#: Name, content (None: none), and what the line says after "pliant: error: ".
FILES = [
    ("missing.pdb", None, "cannot read missing.pdb: No such file or directory"),
    ("letter.txt", b"hello\n", "letter.txt: neither extension nor content matches a known format; "
     + KNOWN),
    ("water.gro", b"water\n", f"water.gro: is a file of GROMACS by its extension .gro, {NOT_READ}; "
     + KNOWN),
    ("twice.pdb.gz", gzip.compress(gzip.compress(ATOM.encode())),
     "twice.pdb.gz: is compressed twice (gzip)"),
    ("a b.xyz", b"1\n\nC x 0 0\n", 'a b.xyz:3: x "x" is not a finite number'),
    ("\x1b[31mred.xyz", b"1\n\nC x 0 0\n",
     '"\\x1b[31mred.xyz":3: x "x" is not a finite number'),
    ("two\nlines.xyz", b"1\n\nC x 0 0\n", '"two\\x0alines.xyz":3: x "x" is not a finite number'),
    ("molecule.xml", b"<molecule/>\n",
     'molecule.xml:1: expected the root element graph, found "molecule"'),
]  # fmt: skip  # a table: a row a line


@pytest.mark.parametrize(("name", "content", "said"), FILES, ids=[repr(row[0]) for row in FILES])
@pytest.mark.parametrize("command", ["info", "run", "lab order"])
def test_a_file_that_is_no_molecule(pliant, tmp_path, name, content, said, command):
    if content is not None:
        (tmp_path / name).write_bytes(content)
    output = ["-o", "out.txt"] if command == "lab order" else []
    ended = pliant(*command.split(), name, *output)
    assert (ended.code, ended.out) == (1, "")
    assert ended.err == f"pliant: error: {said}\n"
    left = {path.name for path in tmp_path.iterdir()} - {name}
    assert left == set()


def test_folders_links_and_pipes_of_nothing(pliant, tmp_path):
    (tmp_path / "folder.pdb").mkdir()
    (tmp_path / "loop.pdb").symlink_to("loop.pdb")
    (tmp_path / "nowhere.pdb").symlink_to("gone.pdb")
    for name, reason in [
        ("folder.pdb", "Is a directory"),
        ("loop.pdb", "Too many levels of symbolic links"),
        ("nowhere.pdb", "No such file or directory"),
        ("/dev/null", "is a device, not a file"),
    ]:
        ended = pliant("info", name)
        assert ended.code == 1
        assert ended.err == f"pliant: error: cannot read {name}: {reason}\n"


@pytest.mark.parametrize("name", ["x.pdb", "x.h5md", "x.sdf", "x.xml"])
def test_a_pipe_that_nobody_writes_to_is_not_waited_for(pliant, tmp_path, name):
    os.mkfifo(tmp_path / name)
    ended = pliant("info", name)
    assert ended.code == 1
    assert ended.err == f"pliant: error: cannot read {name}: is a pipe that nobody writes to\n"


@pytest.mark.parametrize("option", ["--bars", "--ordering", "--forces"])
def test_nor_is_one_in_an_option(pliant, ethanol, tmp_path, option):
    os.mkfifo(tmp_path / "pipe")
    ended = pliant("run", ethanol, option, "pipe", "-o", "out.h5md")
    assert ended.code == 1
    assert ended.err == "pliant: error: cannot read pipe: is a pipe that nobody writes to\n"
    assert not (tmp_path / "out.h5md").exists()


def test_outputs_of_odd_names_are_printed_quoted(pliant, ethanol):
    ended = pliant("run", ethanol, "-o", "\x1b[2J.h5md", "--steps", 1, "--topology", "none")
    assert ended.code == 0
    assert '"\\x1b[2J.h5md"' in ended.out
    assert "\x1b" not in ended.out + ended.err
    again = pliant("run", ethanol, "-o", "\x1b[2J.h5md", "--steps", 1, "--topology", "none")
    assert again.code == 1
    assert again.err == 'pliant: error: "\\x1b[2J.h5md": exists; --overwrite replaces it\n'


@pytest.mark.parametrize("command", ["run", "sample"])
def test_standard_output_takes_no_trajectory(pliant, ethanol, tmp_path, command):
    before = sorted(tmp_path.iterdir())
    ended = pliant(command, ethanol, "-o", "-")
    assert ended.code == 2
    assert ended.err.startswith(
        "pliant: error: --output -: a trajectory is not written to standard output: expected a "
        "name such as out.h5md"
    )
    assert sorted(tmp_path.iterdir()) == before


FAR = "3\nfar\nO 1000000 0 0\nH 1000000.96 0 0\nH 999999.7 0.93 0\n"


def test_far_coordinates_cost_the_topology_alone(pliant, tmp_path):
    (tmp_path / "far.xyz").write_text(FAR)
    ended = pliant("run", "far.xyz", "--steps", 2)
    assert ended.code == 0
    assert ended.err.splitlines()[-1] == (
        "warning: far.pdb, the file of names and bonds, is not written: position of O(1) (1e+06, "
        "0, 0) does not fit the columns of a PDB file (-999.999 to 9999.999 Angstrom)"
    )
    assert {path.name for path in tmp_path.iterdir()} == {"far.xyz", "far.h5md"}
    assert "topology" not in ended.out


def test_a_topology_that_is_asked_for_is_refused_before_the_run(pliant, tmp_path):
    (tmp_path / "far.xyz").write_text(FAR)
    ended = pliant("run", "far.xyz", "--steps", 2, "--topology", "names.pdb")
    assert ended.code == 1
    assert ended.err.startswith("pliant: error: names.pdb: position of O(1) (1e+06, 0, 0) does")
    assert {path.name for path in tmp_path.iterdir()} == {"far.xyz"}


def test_a_residue_number_of_five_digits_that_shifts_its_line(pliant, tmp_path):
    line = ATOM.replace("   1       0.000", "10000        0.000")
    (tmp_path / "five.pdb").write_text(line)
    ended = pliant("info", "five.pdb")
    assert ended.code == 1
    assert ended.err == (
        "pliant: error: five.pdb:1: residue number (columns 23-26) runs on into column 27: "
        '"10000" has shifted the columns after it\n'
    )


#: isobutane as programs draw it: bonds of one length, all z 0
DRAWING = """
  drawn             {code}

  4  3  0  0  0  0  0  0  0  0999 V2000
    0.0000    0.0000    0.0000 C   0  0
    1.5000    0.0000    0.0000 C   0  0
   -0.7500    1.2990    0.0000 C   0  0
   -0.7500   -1.2990    0.0000 C   0  0
  1  2  1  0
  1  3  1  0
  1  4  1  0
M  END
"""


@pytest.mark.parametrize("code", ["2D", "  "])
def test_a_drawing_is_no_molecule_to_sample(pliant, tmp_path, code):
    (tmp_path / "drawn.sdf").write_text(DRAWING.format(code=code))
    ended = pliant("sample", "drawn.sdf")
    assert ended.code == 1
    assert ended.err.splitlines()[-1] == (
        "pliant: error: drawn.sdf: this is a 2-D drawing (all z are 0): make it 3-D by RDKit: "
        'molecule = Chem.AddHs(Chem.MolFromMolFile("drawn.sdf")); '
        "AllChem.EmbedMolecule(molecule, randomSeed=1); "
        'Chem.MolToMolFile(molecule, "three_d.sdf")'
    )
    assert {path.name for path in tmp_path.iterdir()} == {"drawn.sdf"}
    assert pliant("info", "drawn.sdf").code == 0
    assert pliant("run", "drawn.sdf", "--steps", 1).code == 0


@pytest.mark.parametrize("code", ["2D", "3D", "  "])
def test_benzene_is_flat_and_no_drawing(pliant, tmp_path, code):
    corners = [(math.cos(k * math.pi / 3), math.sin(k * math.pi / 3)) for k in range(6)]
    atoms = [("C", 1.39 * x, 1.39 * y) for x, y in corners]
    atoms += [("H", 2.48 * x, 2.48 * y) for x, y in corners]
    bonds = [(k, k % 6 + 1, 1 + k % 2) for k in range(1, 7)] + [(k, k + 6, 1) for k in range(1, 7)]
    text = f"\n  made              {code}\n\n 12 12  0  0  0  0  0  0  0  0999 V2000\n"
    text += "".join(f"{x:10.4f}{y:10.4f}{0:10.4f} {s}   0  0\n" for s, x, y in atoms)
    text += "".join(f"{a:3}{b:3}{order:3}  0\n" for a, b, order in bonds) + "M  END\n"
    (tmp_path / "benzene.sdf").write_text(text)
    assert pliant("sample", "benzene.sdf", "--frames", 1).code == 0
