# SPDX-License-Identifier: MIT
"""H5MD files that are small and would take much memory: zeros, packed a thousandfold."""

from __future__ import annotations

import math
import zlib

import numpy as np

VALUE = "particles/trajectory/position/value"
#: of one chunk, or of all values, once they are unpacked
LARGE = 1_200_000_000

_MIB = 1 << 20


def packed_zeros(size):
    """So many zero bytes, deflated: the same stretch again and again, so that it takes no time."""
    packer = zlib.compressobj(9, zlib.DEFLATED, -15)
    stretch = packer.compress(bytes(_MIB)) + packer.flush(zlib.Z_FULL_FLUSH)
    end = zlib.compressobj(9, zlib.DEFLATED, -15)
    rest = end.compress(bytes(size % _MIB)) + end.flush(zlib.Z_FINISH)
    checksum = (size % 65521 << 16) | 1  # Adler's, of zeros
    return b"\x78\xda" + stretch * (size // _MIB) + rest + checksum.to_bytes(4, "big")


def put_zeros(file, name, shape, chunk, kind="f8"):
    """Puts zeros in the place of a dataset."""
    attributes = dict(file[name].attrs) if name in file else {}
    if name in file:
        del file[name]
    found = file.create_dataset(
        name, shape, kind, chunks=chunk, compression="gzip", maxshape=(None, *shape[1:])
    )
    packed = packed_zeros(math.prod(chunk) * found.dtype.itemsize)
    places = [range(0, extent, step) for extent, step in zip(shape, chunk, strict=True)]
    for place in np.stack(np.meshgrid(*places, indexing="ij"), axis=-1).reshape(-1, len(shape)):
        found.id.write_direct_chunk(tuple(map(int, place)), packed)
    found.attrs.update(attributes)


def chunk_of_positions(file):
    """A chunk that is larger than all frames."""
    frames, atoms, _ = file[VALUE].shape
    put_zeros(file, VALUE, (frames, atoms, 3), (LARGE // (24 * atoms), atoms, 3))


def one_frame(file):
    """A chunk of one frame, of as many atoms."""
    put_zeros(file, VALUE, (1, LARGE // 24, 3), (1, LARGE // 24, 3))


def many_chunks(file):
    """A frame of many chunks, each of which is small."""
    put_zeros(file, VALUE, (1, LARGE // 24, 3), (1, LARGE // 2400, 3))


def bars(file):
    """Bars between the first joint and itself."""
    put_zeros(file, "connectivity/bars", (LARGE // 8, 2), (LARGE // 800, 2), "u4")
    put_zeros(file, "parameters/framework/rest_length", (LARGE // 8,), (LARGE // 800,))


def chunk_of_bars(file):
    """A chunk that is larger than the list of bars."""
    rows = len(file["connectivity/bars"])
    put_zeros(file, "connectivity/bars", (rows, 2), (LARGE // 8, 2), "u4")


def chunk_of_sweeps(file):
    """A chunk of an observable."""
    name = "observables/sweeps/value"
    put_zeros(file, name, file[name].shape, (LARGE // 8,), "i8")


def chunk_of_masses(file):
    """A chunk of masses, one an atom."""
    name = "particles/trajectory/mass"
    put_zeros(file, name, file[name].shape, (LARGE // 8,))


#: by name; which of their datasets the commands name
EXPANDING = {
    "chunk_of_positions": (chunk_of_positions, VALUE),
    "one_frame": (one_frame, VALUE),
    "many_chunks": (many_chunks, VALUE),
    "bars": (bars, "connectivity/bars"),
    "chunk_of_bars": (chunk_of_bars, "connectivity/bars"),
    "chunk_of_sweeps": (chunk_of_sweeps, "observables/sweeps/value"),
    "chunk_of_masses": (chunk_of_masses, "particles/trajectory/mass"),
}
