# SPDX-License-Identifier: MIT
"""H5MD topology parser for MDAnalysis: names, residues and bonds from the trajectory file itself.

With it `MDAnalysis.Universe("out.h5md")` needs no second file. Importing this module registers
it; `import pliant` does so too, as soon as MDAnalysis is there.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import h5py
import numpy as np

from pliant._core import InputError
from pliant.base.extras import needed_by
from pliant.trajectory import hdf5 as _hdf5
from pliant.trajectory.chains import NO_CHAIN

with needed_by("pliant.trajectory.h5md_parser"):
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
        InputError
            The atom table does not fit the positions: the file is damaged.
        """
        with _hdf5.open_file(self.filename) as file:
            if _hdf5.item(file, f"{_TOPOLOGY}/atom_name") is not None:
                return _named_topology(file)
            if _hdf5.item(file, f"{_TOPOLOGY}/bond_order") is not None:
                return _nameless_topology(file)
            if "n_atoms" not in kwargs and (count := _particle_count(file)) is not None:
                kwargs["n_atoms"] = count
        return MinimalParser(self.filename).parse(**kwargs)


def _particle_count(file: h5py.File) -> int | None:
    """Particles of the first group, which is the one that MDAnalysis reads."""
    group = _hdf5.first_in(file, "particles")
    for name in ("position", "velocity", "force") if group is not None else ():
        value = _hdf5.item(group, f"{name}/value")
        if isinstance(value, h5py.Dataset) and value.ndim == 3:
            return int(value.shape[1])
    return None


def _values(
    file: h5py.File, path: str, kinds: str, shape: tuple[int | None, ...]
) -> npt.NDArray[Any]:
    """The values of a dataset. Raises InputError if there are none of these kinds and shape."""
    found = _hdf5.item(file, path)
    wanted = "x".join("n" if extent is None else str(extent) for extent in shape)
    if not _hdf5.is_array(found, kinds, shape):
        raise InputError(f"{file.filename}: /{path}: expected {wanted} values, found other ones")
    return np.asarray(_hdf5.read(found))


def _texts(file: h5py.File, name: str, count: int | None) -> npt.NDArray[np.object_]:
    found = _values(file, f"{_TOPOLOGY}/{name}", "OS", (count,))
    return np.array([str(_hdf5.plain(one)) for one in found], dtype=object)


def _atom_count(file: h5py.File) -> int:
    value = _hdf5.item(file, f"{_TRAJECTORY}/position/value")
    if not _hdf5.is_array(value, "fiu", (None, None, 3)):
        raise InputError(f"{file.filename}: /{_TOPOLOGY}: there are no positions for it")
    return int(value.shape[1])


def _named_topology(file: h5py.File) -> Topology:
    count = _atom_count(file)
    residue_of = _values(file, f"{_TOPOLOGY}/residue_of", "iu", (count,)).astype(np.intp)
    chains = _texts(file, "chain", None)
    inside = count == 0 or (residue_of.min() >= 0 and residue_of.max() < len(chains))
    _check(file, bool(inside), "residue_of names no residue")
    segments, segment_of = _segments(chains)
    return Topology(
        count,
        len(chains),
        len(segments),
        atom_resindex=residue_of,
        residue_segindex=segment_of,
        attrs=[
            *_atom_attributes(file, count, chains[residue_of]),
            *_residue_attributes(file, len(chains)),
            attributes.Segids(segments),
            *_bonds(file, count),
        ],
    )


def _nameless_topology(file: h5py.File) -> Topology:
    count = _atom_count(file)
    return Topology(count, 1, 1, attrs=[_masses(file, count), *_bonds(file, count)])


def _masses(file: h5py.File, count: int) -> attributes.Masses:
    return attributes.Masses(_values(file, f"{_TRAJECTORY}/mass", "fiu", (count,)))


def _check(file: h5py.File, condition: bool, what: str) -> None:
    if not condition:
        raise InputError(f"{file.filename}: /{_TOPOLOGY}: {what}")


def _atom_attributes(
    file: h5py.File, count: int, chain_of_atom: npt.NDArray[np.object_]
) -> list[attributes.AtomAttr]:
    elements = _texts(file, "element", count)
    return [
        attributes.Atomnames(_texts(file, "atom_name", count)),
        attributes.Elements(elements),
        attributes.Atomtypes(elements.copy()),
        _masses(file, count),
        attributes.Atomids(_values(file, f"{_TOPOLOGY}/atom_serial", "iu", (count,))),
        attributes.ChainIDs(chain_of_atom),
    ]


def _residue_attributes(file: h5py.File, count: int) -> list[attributes.ResidueAttr]:
    numbers = _values(file, f"{_TOPOLOGY}/residue_number", "iu", (count,))
    return [
        attributes.Resids(numbers),
        attributes.Resnums(numbers.copy()),
        attributes.Resnames(_texts(file, "residue_name", count)),
        attributes.ICodes(_texts(file, "insertion_code", count)),
    ]


def _segments(
    chains: npt.NDArray[np.object_],
) -> tuple[npt.NDArray[np.object_], npt.NDArray[np.intp]]:
    """Names of the segments, one a chain in order of appearance, and each residue's segment."""
    order = {chain: index for index, chain in enumerate(dict.fromkeys(chains))}
    segment_of = np.array([order[chain] for chain in chains], dtype=np.intp)
    names = [NO_CHAIN] if list(order) == [""] else list(order)
    return np.array(names, dtype=object), segment_of


def _bonds(file: h5py.File, count: int) -> list[attributes.Bonds]:
    if _hdf5.item(file, "connectivity/bonds") is None:
        return []
    pairs = _values(file, "connectivity/bonds", "iu", (None, 2))
    if len(pairs) == 0:
        return []
    _check(file, pairs.min() >= 0 and pairs.max() < count, "connectivity/bonds names no particle")
    orders = _values(file, f"{_TOPOLOGY}/bond_order", "iu", (len(pairs),)).tolist()
    return [
        attributes.Bonds(
            [tuple(pair) for pair in pairs.tolist()],
            guessed=_guessed(file, len(pairs)),
            # 4 is aromatic, 0 not known.
            order=[{0: None, 4: 1.5}.get(order, order) for order in orders],
        )
    ]


def _guessed(file: h5py.File, count: int) -> list[bool]:
    path = f"{_TOPOLOGY}/bond_origin"
    origins = _values(file, path, "iu", (count,))
    names = h5py.check_enum_dtype(origins.dtype) or {}
    return [bool(origin == names.get("distance", -1)) for origin in origins]
