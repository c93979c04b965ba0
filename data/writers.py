# SPDX-License-Identifier: MIT
"""Texts of molecule files: XYZ, SDF (V2000), MOL (V3000), PDB and mmCIF."""

from sketch import Sketch


def number(value: float, width: int, decimals: int) -> str:
    """Fixed decimals; never a negative zero."""
    text = f"{value:.{decimals}f}"
    if float(text) == 0:
        text = text.replace("-", "")
    return text.rjust(width)


def write_xyz(sketch: Sketch, title: str) -> str:
    """Elements and positions alone."""
    lines = [str(len(sketch.elements)), title]
    for element, position in zip(sketch.elements, sketch.positions, strict=True):
        lines.append(f"{element:<2}" + "".join(number(x, 14, 8) for x in position))
    return "\n".join(lines) + "\n"


def write_sdf(sketch: Sketch, title: str) -> str:
    """V2000: bonds with their orders."""
    atoms, bonds = len(sketch.elements), len(sketch.bonds)
    lines = [title, "  Pliant", "", f"{atoms:3}{bonds:3}  0  0  0  0  0  0  0  0999 V2000"]
    for element, position in zip(sketch.elements, sketch.positions, strict=True):
        lines.append("".join(number(x, 10, 4) for x in position) + f" {element:<3} 0" + "  0" * 11)
    lines += [f"{a + 1:3}{b + 1:3}{kind:3}  0" for a, b, kind in sketch.bonds]
    return "\n".join([*lines, "M  END", "$$$$"]) + "\n"


def write_v3000(sketch: Sketch, title: str) -> str:
    """MOL V3000."""
    lines = [title, "  Pliant", "", "  0  0  0     0  0            999 V3000", "M  V30 BEGIN CTAB"]
    lines.append(f"M  V30 COUNTS {len(sketch.elements)} {len(sketch.bonds)} 0 0 0")
    lines.append("M  V30 BEGIN ATOM")
    for k, (element, position) in enumerate(zip(sketch.elements, sketch.positions, strict=True), 1):
        x, y, z = (number(x, 0, 4) for x in position)
        lines.append(f"M  V30 {k} {element} {x} {y} {z} 0")
    lines += ["M  V30 END ATOM", "M  V30 BEGIN BOND"]
    for k, (a, b, kind) in enumerate(sketch.bonds, 1):
        lines.append(f"M  V30 {k} {kind} {a + 1} {b + 1}")
    return "\n".join([*lines, "M  V30 END BOND", "M  V30 END CTAB", "M  END"]) + "\n"


def write_pdb(sketch: Sketch, title: str) -> str:
    """ATOM records of chain A, TER, and CONECT for the bonds that no template knows."""
    lines = [f"TITLE     {title.upper()}"]
    for k, element in enumerate(sketch.elements):
        residue, serial = sketch.residues[k], k + 1
        name = sketch.names[k] if len(sketch.names[k]) == 4 else f" {sketch.names[k]:<3}"
        place = "".join(number(x, 8, 3) for x in sketch.positions[k])
        lines.append(
            f"ATOM  {serial:5} {name} {residue[0]:>3} A{residue[1]:4}    {place}"
            f"  1.00  0.00          {element:>2}  "
        )
    last = sketch.residues[-1]
    lines.append(f"TER   {len(sketch.elements) + 1:5}      {last[0]:>3} A{last[1]:4}")
    for a, b in sketch.stated_bonds:
        lines += [f"CONECT{a + 1:5}{b + 1:5}", f"CONECT{b + 1:5}{a + 1:5}"]
    return "\n".join([*lines, "END"]) + "\n"


def write_mmcif(sketch: Sketch, title: str, bonds: bool = True) -> str:
    """An atom_site loop; and, if wanted, the bonds of the one residue as chem_comp_bond."""
    residue = sketch.residues[0][0]
    lines = [f"data_{title.replace(' ', '_')}", "#", f"_struct.title '{title}'", "#", "loop_"]
    columns = "group_PDB id type_symbol label_atom_id label_alt_id label_comp_id label_asym_id"
    columns += " label_entity_id label_seq_id Cartn_x Cartn_y Cartn_z occupancy auth_seq_id"
    columns += " auth_asym_id pdbx_PDB_model_num"
    lines += [f"_atom_site.{column}" for column in columns.split()]
    for k, (element, name) in enumerate(zip(sketch.elements, sketch.names, strict=True)):
        place = " ".join(number(x, 8, 4) for x in sketch.positions[k])
        lines.append(
            f"HETATM {k + 1:<3} {element:<2} {name:<4} . {residue} A 1 . {place} 1.00 1 A 1"
        )
    lines.append("#")
    if bonds:
        kinds = {1: "SING", 2: "DOUB", 3: "TRIP", 4: "AROM"}
        lines.append("loop_")
        lines += [f"_chem_comp_bond.{c}" for c in ("comp_id", "atom_id_1", "atom_id_2")]
        lines.append("_chem_comp_bond.value_order")
        for a, b, kind in sketch.bonds:
            lines.append(f"{residue} {sketch.names[a]:<4} {sketch.names[b]:<4} {kinds[kind]}")
        lines.append("#")
    return "\n".join(lines) + "\n"
