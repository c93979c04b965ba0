# SPDX-License-Identifier: MIT
"""Biological assemblies: gemmi makes the same ones."""

import gzip
from pathlib import Path

import numpy as np
import pytest

import pliant

gemmi = pytest.importorskip("gemmi")
DATA = Path(pytest.importorskip("MDAnalysisTests").__file__).parent / "data"


def by_gemmi(path, name):
    """(N, 3) positions of the first conformers, one chain after another."""
    structure = gemmi.read_structure(str(path))
    structure.remove_alternative_conformations()
    chosen = next(one for one in structure.assemblies if one.name == name)
    how = gemmi.HowToNameCopiedChain.Short
    model = gemmi.make_assembly(chosen, structure[0], how)
    return np.array([atom.pos.tolist() for chain in model for res in chain for atom in res])


def assert_same_places(found, expected):
    """As sets: the order of copies is free."""
    assert found.shape == expected.shape
    order = [np.lexsort(np.round(one, 2).T) for one in (found, expected)]
    from_both = np.sort(np.linalg.norm(found, axis=1)) - np.sort(np.linalg.norm(expected, axis=1))
    assert np.abs(from_both).max() < 1e-3
    nearest = np.abs(found[order[0]] - expected[order[1]]).max(axis=1)
    assert np.mean(nearest < 1e-3) > 0.99  # but for ties of rounding


@pytest.mark.parametrize("name", ["1hvr.pdb", "mmcif/1BD2.pdb.gz", "mmcif/3KPR.cif.gz"])
def test_files_as_they_come(name):
    path = DATA / name
    for assembly in pliant.read(path).assemblies:
        made = pliant.read(path, assembly=assembly)
        assert_same_places(made.positions, by_gemmi(path, assembly))
        assert len(made.bonds) >= made.positions.shape[0] - len(set(made.chains))


TURNED = """\
REMARK 350 BIOMOLECULE: 1
REMARK 350 APPLY THE FOLLOWING TO CHAINS: {chains}
REMARK 350   BIOMT1   1  1.000000  0.000000  0.000000        0.00000
REMARK 350   BIOMT2   1  0.000000  1.000000  0.000000        0.00000
REMARK 350   BIOMT3   1  0.000000  0.000000  1.000000        0.00000
REMARK 350   BIOMT1   2 -0.500000 -0.866025  0.000000       91.50000
REMARK 350   BIOMT2   2  0.866025 -0.500000  0.000000        3.25000
REMARK 350   BIOMT3   2  0.000000  0.000000  1.000000      -17.00000
"""


def test_a_remark_that_turns_chains(tmp_path):
    atoms = [
        line for line in (DATA / "1hvr.pdb").read_text().splitlines() if "REMARK 350" not in line
    ]
    path = tmp_path / "two.pdb"
    path.write_text(TURNED.format(chains="A, B") + "\n".join(atoms) + "\n")
    made = pliant.read(path, assembly=1)
    assert_same_places(made.positions, by_gemmi(path, "1"))
    assert sorted(set(made.chains)) == ["A", "B", "C", "D"]
    half = len(made.positions) // 2
    first, second = made.positions[:half], made.positions[half:]
    turn = np.array([[-0.5, -0.866025, 0], [0.866025, -0.5, 0], [0, 0, 1]])
    np.testing.assert_allclose(second, first @ turn.T + [91.5, 3.25, -17.0], atol=1e-9)


def with_operations(path, expression, operations):
    """Writes a file of the databank with other operations: names, turns and shifts."""
    document = gemmi.cif.read_string(
        gzip.decompress((DATA / "mmcif" / "3KPR.cif.gz").read_bytes()).decode()
    )
    block = document.sole_block()
    for row in block.find("_pdbx_struct_assembly_gen.", ["oper_expression"]):
        row[0] = f"'{expression}'"
    tags = ["id", "type", *(f"matrix[{i}][{j}]" for i in (1, 2, 3) for j in (1, 2, 3))]
    tags += [f"vector[{i}]" for i in (1, 2, 3)]
    block.find_mmcif_category("_pdbx_struct_oper_list.").erase()
    loop = block.init_loop("_pdbx_struct_oper_list.", tags)
    for name, (turn, shift) in operations.items():
        loop.add_row([name, "?", *(repr(float(x)) for x in [*turn.ravel(), *shift])])
    document.write_file(str(path))
    return path


@pytest.fixture(scope="module")
def operations():
    draw = np.random.default_rng(3)
    made = {
        name: (np.linalg.qr(draw.normal(size=(3, 3)))[0], draw.uniform(-80, 80, 3))
        for name in ("1", "2", "3", "X0")
    }
    return made | {"P": (np.eye(3), np.zeros(3))}


@pytest.mark.parametrize("expression", ["1,2", "(1-3)", "(X0)", "2,X0,1"])
def test_lists_are_those_of_gemmi(tmp_path, operations, expression):
    path = with_operations(tmp_path / "many.cif", expression, operations)
    assembly = pliant.read(path).assemblies[0]
    made = pliant.read(path, assembly=assembly)
    assert_same_places(made.positions, by_gemmi(path, assembly))


@pytest.mark.parametrize(
    ("expression", "factors"),
    [("(X0)(1-3)", ["X0", "123"]), ("(1,3)(2-3)", ["13", "23"]), ("(2)(X0)", ["2", "X0"])],
)
def test_products_are_those_of_numpy(tmp_path, operations, expression, factors):
    """gemmi knows no products; the last operation acts first."""
    whole = with_operations(tmp_path / "one.cif", "P", operations)
    assembly = pliant.read(whole).assemblies[0]
    start = pliant.read(whole, assembly=assembly).positions
    path = with_operations(tmp_path / "many.cif", expression, operations)
    made = pliant.read(path, assembly=assembly).positions
    names = [[name] if name == "X0" else list(name) for name in factors]
    expected = []
    for first in names[0]:
        for second in names[1]:
            places = start @ operations[second][0].T + operations[second][1]
            expected.append(places @ operations[first][0].T + operations[first][1])
    np.testing.assert_allclose(made, np.concatenate(expected), atol=1e-9)


def test_what_is_not_stated_is_refused():
    with pytest.raises(pliant.OptionError, match=r'no assembly "7" in .*1hvr\.pdb: it states 1$'):
        pliant.read(DATA / "1hvr.pdb", assembly=7)
    with pytest.raises(pliant.OptionError, match=r'no assembly "1" in .*: it states none$'):
        pliant.read(DATA / "adk_open.pdb", assembly="1")
    with pytest.raises(TypeError, match=r"assembly = .*: must be a whole number or a text or None"):
        pliant.read(DATA / "1hvr.pdb", assembly=1.5)
