# SPDX-License-Identifier: MIT
"""Files for other programs: B factors, normal modes, and an ensemble with scripts that show it."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Sequence
from io import StringIO
from pathlib import Path

import numpy as np

from pliant.base import style
from pliant.base.new_file import new_text, write_text
from pliant.measure.shapes.other_shapes import OtherShapes
from pliant.measure.stages.analysis import Analysis
from pliant.measure.stages.parts import ReferenceStructure, Units
from pliant.report.multi_model import write_models
from pliant.report.page.scene import units_of_atoms
from pliant.report.sections.domains import domains_of_units, split_stretches
from pliant.report.sections.flexible import UnitFlexibility
from pliant.report.sections.measured import Measured
from pliant.report.sections.motions import Components
from pliant.report.sections.pocket_scripts import chimerax_lines, pymol_lines
from pliant.trajectory.chosen_frames import choose_frames
from pliant.trajectory.frame_store import FrameStore
from pliant.trajectory.kind import ENSEMBLE
from pliant.trajectory.superposition import superpose_frames

#: frames of ensemble.pdb at most
MODELS = 25
#: the scenes of other models, after those of flexibility and domains, and their models in ChimeraX
FIRST_MODELS, FIRST_IN_CHIMERAX = 3, 2
#: components in modes.nmd
MODES = 10
LIGANDS_IN_PYMOL = ("show sticks, ensemble and organic", "show spheres, ensemble and inorganic")
LIGANDS_IN_CHIMERAX = ("show ligand | ions atoms", "style ligand stick")


def b_factors(rmsf: np.ndarray) -> np.ndarray:
    """8 pi^2 / 3 RMSF^2, Angstrom^2: the isotropic B factor of that fluctuation."""
    return np.asarray(8.0 * np.pi**2 / 3.0 * np.asarray(rmsf) ** 2)


def ensemble_files(others: Sequence[str] = ()) -> Measured:
    """The frames coloured by flexibility, with scripts that load them, the other shapes, and
    `others`: names of PDB files in the folder, without .pdb, whose models are a scene each."""

    def write(analysis: Analysis, folder: Path) -> list[Path]:
        shapes = analysis.get(OtherShapes)
        models = [*(["shapes"] if shapes and shapes.shapes else []), *others]
        scripts = {"show.pml": pymol_script, "show.cxc": chimerax_script}
        for name, script in scripts.items():
            write_text(folder / name, script(analysis, models), overwrite=True)
        return [*_write_ensemble(analysis, folder), *(folder / name for name in scripts)]

    return Measured(
        applies=lambda analysis: (
            UnitFlexibility in analysis and hasattr(analysis.universe.atoms, "names")
        ),
        files=write,
    )


def _write_ensemble(analysis: Analysis, folder: Path) -> list[Path]:
    found, units = analysis[UnitFlexibility].found, analysis[Units]
    atoms = analysis.atoms
    own = units_of_atoms(analysis, atoms)
    values = np.where(own >= 0, b_factors(found.rmsf)[own], 0.0)
    frames = _shown_frames(analysis)
    fitted = np.flatnonzero(np.isin(atoms.ix, analysis.fitted.ix))
    reference = analysis[ReferenceStructure]
    start = reference.positions[atoms.ix][None]
    moved = FrameStore(1 + len(frames), len(atoms))
    moved.put(0, start)
    for place, k in enumerate(frames, 1):
        moved.put(place, analysis.positions(k)[None, atoms.ix])
    superpose_frames(moved, fitted if len(fitted) >= 3 else None)
    remark = f"B = 8 pi^2 / 3 RMSF^2 of its {units.what}"
    bfactors, ensemble = folder / "bfactors.pdb", folder / "ensemble.pdb"
    first, others = np.arange(1), np.arange(1, len(moved))
    start = moved.take(first)
    write_models(bfactors, atoms, start, values, [remark, reference.name])
    numbers = ", ".join(str(analysis.frames[k]) for k in frames)
    remarks = [remark, *textwrap.wrap(f"frames {numbers}", 68)]
    write_models(ensemble, atoms, moved, values, remarks, others)
    return [bfactors, ensemble]


def _shown_frames(analysis: Analysis) -> np.ndarray:
    """At most MODELS frames spread over all; independent ones in the order of the first motion."""
    frames = choose_frames(len(analysis.frames), MODELS)
    components = analysis.get(Components)
    if analysis.kind == ENSEMBLE and components and components.stride == 1:
        along = components.found.projections[frames, 0]
        return np.asarray(frames[np.argsort(along, kind="stable")])
    return frames


def nmd(analysis: Analysis) -> Iterator[str]:
    """Lines: the principal components as ProDy and VMD's NMWiz read them (.nmd)."""
    found, atoms = analysis[Components].found, analysis.fitted
    residues = atoms.residues if len(atoms.residues) == len(atoms) else None
    rows: dict[str, list[str]] = {"atomnames": [str(n).strip() or "X" for n in atoms.names]}
    if hasattr(atoms, "resnames"):
        rows["resnames"] = [str(n).strip() or "UNK" for n in atoms.resnames]
    if hasattr(atoms, "resids"):
        rows["resids"] = [str(n) for n in atoms.resids]
    chains = [str(s)[:1].strip() for s in getattr(atoms, "segids", [])]
    if chains and all(chains) and "SYSTEM" not in set(atoms.segids):
        rows["chainids"] = chains
    if residues is not None and UnitFlexibility in analysis:
        factors = b_factors(analysis[UnitFlexibility].found.rmsf)
        rows["bfactors"] = [f"{b:.2f}" for b in factors[units_of_atoms(analysis, atoms)]]
    yield f"nmwiz_load modes.nmd\nname {Path(analysis.options.path).stem.replace(' ', '_')}"
    yield from (f"{name} {' '.join(values)}" for name, values in rows.items())
    yield f"coordinates {_numbers(found.average.ravel(), 3)}"
    for k, vector in enumerate(found.components[:MODES]):
        yield f"mode {k + 1} {np.sqrt(found.eigenvalues[k]):.4f} {_numbers(vector, 5)}"


def _numbers(values: np.ndarray, digits: int) -> str:
    text = StringIO()  # a list of as many texts would be ten times as large
    for k, x in enumerate(values):
        text.write(f" {x:.{digits}f}" if k else f"{x:.{digits}f}")
    return text.getvalue()


def _domain_selections(analysis: Analysis) -> list[list[tuple[int, int]]]:
    """For each domain the stretches of residue numbers (first, last); none without domains, or of
    several chains."""
    units, of_unit = analysis[Units], domains_of_units(analysis)
    if len(set(units.chains.tolist())) > 1:
        return []
    made = []
    for k in range(of_unit.max() + 1):
        parts = split_stretches(np.flatnonzero(of_unit == k), units.chains)
        made.append([(int(units.numbers[p[0]]), int(units.numbers[p[-1]])) for p in parts])
    return made


def _usual_b(analysis: Analysis) -> float:
    """Where colours end: above nine tenths of the B factors, lest one loose end take them all."""
    factors = b_factors(analysis[UnitFlexibility].found.rmsf)
    return max(0.1, float(np.percentile(factors, 90)))


def pymol_script(analysis: Analysis, models: Sequence[str] = ()) -> str:
    """Loads the ensemble in PyMOL, colours it by flexibility, or by domain, and plays it.

    models: names of PDB files, without .pdb, whose models are a scene each, all on the start.
    """
    of_residues = analysis[Units].what == "residue"
    lines = [
        "# pymol show.pml: still is blue, flexible is red",  # PyMOL runs what follows a semicolon
        "load ensemble.pdb, ensemble",
        "hide everything",
        *(["dss ensemble", "show cartoon", *LIGANDS_IN_PYMOL] if of_residues else ["show sticks"]),
        f"spectrum b, blue_white_red, ensemble, 0, {_usual_b(analysis):.1f}",
        "bg_color white",
        "orient",
        "scene F1, store",
    ]
    domains = _domain_selections(analysis)
    if domains:
        lines.append("# scene F2: domains")
        for k, stretches in enumerate(domains):
            residues = "+".join(f"{a}-{b}" for a, b in stretches)
            lines.append(f"select domain{k + 1}, ensemble and resi {residues}")
            lines.append(f"color 0x{style.DOMAIN_COLOURS[k][1:]}, domain{k + 1}")
        lines += ["deselect", "scene F2, store"]
    if models:
        shown = "cartoon" if of_residues else "sticks"
        lines += ["load bfactors.pdb, start", "hide everything, start", f"show {shown}, start"]
        lines += ["color grey70, start"]
    for key, name in enumerate(models, FIRST_MODELS):
        lines += _pymol_models(name, f"F{key}", of_residues)
    lines += pymol_lines(analysis, FIRST_MODELS + len(models))
    lines += ["disable all", "enable ensemble", "scene F1, recall"]
    return "\n".join([*lines, "set movie_fps, 8", "mplay", ""])


def _pymol_models(name: str, key: str, of_residues: bool) -> list[str]:
    """A scene of all models of a file at once, each superposed on the start, which is grey."""
    each = f"{name}_*"
    fitted = [f"extra_fit {each} and name CA+P, start, align, cycles=0"] if of_residues else []
    return [
        f"# scene {key}: {name}.pdb, a colour for each model, and the start in grey",
        f"load {name}.pdb, {name}",
        f"split_states {name}, prefix={name}_",
        f"delete {name}",
        *fitted,
        "disable all",
        f"enable {each}",
        "enable start",
        f"hide everything, {each}",
        f"show {'cartoon' if of_residues else 'sticks'}, {each}",
        *([f"show sticks, {each} and organic"] if of_residues else []),
        f'util.color_objs("{each}")',
        f"zoom {each}",
        f"scene {key}, store",
    ]


def chimerax_script(analysis: Analysis, models: Sequence[str] = ()) -> str:
    """The same for ChimeraX."""
    of_residues = analysis[Units].what == "residue"
    lines = [
        "# ChimeraX: open show.cxc",
        "open ensemble.pdb coordsets true",
        "hide atoms",
        *(["show cartoons", *LIGANDS_IN_CHIMERAX] if of_residues else ["show atoms"]),
        f"color byattribute bfactor palette blue:white:red range 0,{_usual_b(analysis):.1f}",
    ]
    for k, stretches in enumerate(_domain_selections(analysis)):
        residues = ",".join(f"{a}-{b}" for a, b in stretches)
        lines.append(f"name domain{k + 1} #1:{residues}")
        lines.append(f"# color domain{k + 1} {style.DOMAIN_COLOURS[k]}")
    others = [
        line
        for model, name in enumerate(models, FIRST_IN_CHIMERAX)
        for line in _chimerax_models(name, f"#{model}", of_residues)
    ]
    return "\n".join(
        [
            *lines,
            *others,
            *chimerax_lines(analysis, FIRST_IN_CHIMERAX + len(models)),
            "set bgColor white",
            "view",
            "coordset #1 1,-1 pauseFrames 4 loop 100",
            "",
        ]
    )


def _chimerax_models(name: str, model: str, of_residues: bool) -> list[str]:
    """All models of a file at once, hidden until they are asked for."""
    return [
        f"# show {model} models: {name}.pdb",
        f"open {name}.pdb id {model[1:]}",
        *([f"hide {model} atoms", f"show {model} cartoons"] if of_residues else []),
        f"rainbow {model} structures",
        f"hide {model} models",
    ]


def _write_modes(analysis: Analysis, folder: Path) -> list[Path]:
    path = folder / "modes.nmd"
    with new_text(path, overwrite=True) as file:
        file.writelines(f"{line}\n" for line in nmd(analysis))
    return [path]


MODES_FILE = Measured(
    applies=lambda analysis: Components in analysis and hasattr(analysis.fitted, "names"),
    files=_write_modes,
)
