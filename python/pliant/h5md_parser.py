# SPDX-License-Identifier: MIT
"""H5MD topology parser for MDAnalysis: names, residues and bonds from the trajectory file itself.

With it `MDAnalysis.Universe("out.h5md")` needs no second file. Importing this module registers
it; `import pliant` does so too, as soon as MDAnalysis is there.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import h5py
import numpy as np

from pliant._extras import needed_by

with needed_by("pliant.h5md_parser"):
    from MDAnalysis.core import topologyattrs as attributes
    from MDAnalysis.core.topology import Topology
    from MDAnalysis.topology.base import TopologyReaderBase
    from MDAnalysis.topology.MinimalParser import MinimalParser

if TYPE_CHECKING:
    import numpy.typing as npt

#: Where our files keep the atom table; other programs' files have none.
_TOPOLOGY = "parameters/topology"
_TRAJECTORY = "particles/trajectory"


class H5MDParser(TopologyReaderBase):  # type: ignore[misc]  # MDAnalysis has no types
    """Read the topology of an H5MD file.

    A file with our atom table gives names, elements (as types, too), masses, serials (`ids`),
    residues, chains (as segments, too) and bonds with order, whose `is_guessed` tells the bonds
    that were found by distance. A file that we recorded without names gives masses and bonds.
    Any other H5MD file gives what MDAnalysis makes of it without a parser: atoms without names;
    but its group need not be called `trajectory`.
    """

    format = "H5MD"

    def parse(self, **kwargs: object) -> Topology:
        """Return the topology of the file.

        Raises
        ------
        ValueError
            The atom table does not fit the positions: the file is damaged.
        """
        with h5py.File(self.filename, "r") as file:
            if f"{_TOPOLOGY}/atom_name" in file:
                return _named_topology(file)
            if f"{_TOPOLOGY}/bond_order" in file:
                return _nameless_topology(file)
            if "n_atoms" not in kwargs and (count := _particle_count(file)) is not None:
                kwargs["n_atoms"] = count
        return MinimalParser(self.filename).parse(**kwargs)


def _particle_count(file: h5py.File) -> int | None:
    """Particles of the first group, which is the one that MDAnalysis reads."""
    for group in list(file.get("particles", {}).values())[:1]:
        for name in ("position", "velocity", "force"):
            value = group.get(f"{name}/value")
            if isinstance(value, h5py.Dataset) and value.ndim == 3:
                return int(value.shape[1])
    return None


def _texts(dataset: h5py.Dataset) -> npt.NDArray[np.object_]:
    return np.asarray(dataset.asstr()[()], dtype=object)


def _named_topology(file: h5py.File) -> Topology:
    table = file[_TOPOLOGY]
    count = file[f"{_TRAJECTORY}/position/value"].shape[1]
    residue_of = table["residue_of"][()].astype(np.intp)
    residues = len(table["residue_name"])
    _check(file, len(residue_of) == count, "residue_of does not have a residue for each particle")
    _check(file, count == 0 or residue_of.max() < residues, "residue_of names no residue")
    chains = _texts(table["chain"])
    segments, segment_of = _segments(chains)
    return Topology(
        count,
        residues,
        len(segments),
        atom_resindex=residue_of,
        residue_segindex=segment_of,
        attrs=[
            *_atom_attributes(file, chains[residue_of]),
            *_residue_attributes(table),
            attributes.Segids(segments),
            *_bonds(file, count),
        ],
    )


def _nameless_topology(file: h5py.File) -> Topology:
    count = file[f"{_TRAJECTORY}/position/value"].shape[1]
    masses = attributes.Masses(file[f"{_TRAJECTORY}/mass"][()])
    return Topology(count, 1, 1, attrs=[masses, *_bonds(file, count)])


def _check(file: h5py.File, condition: bool, what: str) -> None:
    if not condition:
        raise ValueError(f"{file.filename}: /{_TOPOLOGY}: {what}")


def _atom_attributes(
    file: h5py.File, chain_of_atom: npt.NDArray[np.object_]
) -> list[attributes.AtomAttr]:
    table = file[_TOPOLOGY]
    elements = _texts(table["element"])
    return [
        attributes.Atomnames(_texts(table["atom_name"])),
        attributes.Elements(elements),
        attributes.Atomtypes(elements.copy()),
        attributes.Masses(file[f"{_TRAJECTORY}/mass"][()]),
        attributes.Atomids(table["atom_serial"][()]),
        attributes.ChainIDs(chain_of_atom),
    ]


def _residue_attributes(table: h5py.Group) -> list[attributes.ResidueAttr]:
    numbers = table["residue_number"][()]
    return [
        attributes.Resids(numbers),
        attributes.Resnums(numbers.copy()),
        attributes.Resnames(_texts(table["residue_name"])),
        attributes.ICodes(_texts(table["insertion_code"])),
    ]


def _segments(
    chains: npt.NDArray[np.object_],
) -> tuple[npt.NDArray[np.object_], npt.NDArray[np.intp]]:
    """Names of the segments, one a chain in order of appearance, and each residue's segment."""
    order = {chain: index for index, chain in enumerate(dict.fromkeys(chains))}
    segment_of = np.array([order[chain] for chain in chains], dtype=np.intp)
    # MDAnalysis' word for a system without chains.
    names = ["SYSTEM"] if list(order) == [""] else list(order)
    return np.array(names, dtype=object), segment_of


def _bonds(file: h5py.File, count: int) -> list[attributes.Bonds]:
    pairs = file["connectivity/bonds"][()] if "connectivity/bonds" in file else np.empty((0, 2))
    if len(pairs) == 0:
        return []
    _check(file, pairs.min() >= 0 and pairs.max() < count, "connectivity/bonds names no particle")
    orders = file[f"{_TOPOLOGY}/bond_order"][()].tolist()
    return [
        attributes.Bonds(
            [tuple(pair) for pair in pairs.tolist()],
            guessed=_guessed(file[f"{_TOPOLOGY}/bond_origin"]),
            # 4 is aromatic, 0 not known.
            order=[{0: None, 4: 1.5}.get(order, order) for order in orders],
        )
    ]


def _guessed(origins: h5py.Dataset) -> list[bool]:
    names = h5py.check_enum_dtype(origins.dtype) or {}
    return [bool(origin == names.get("distance", -1)) for origin in origins[()]]
