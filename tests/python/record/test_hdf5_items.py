# SPDX-License-Identifier: MIT
"""What h5py fails to tell of a damaged object is refused by name, whatever it raises (found by
turning over bits: 9 of 11 000 damaged files ended in a traceback of h5py)."""

import h5py
import numpy as np
import pytest
from pliant.trajectory import hdf5 as _hdf5

import pliant


def test_a_type_that_numpy_has_not_is_refused(tmp_path):
    """A double whose exponent is biased by 2^20: asked for its dtype, h5py raises ValueError."""
    path = tmp_path / "type.h5"
    with h5py.File(path, "w") as file:
        kind = h5py.h5t.IEEE_F64LE.copy()
        kind.set_ebias(1 << 20)
        space = h5py.h5s.create_simple((3,))
        h5py.h5d.create(file.id, b"odd", kind, space)
    with h5py.File(path) as file:
        with pytest.raises(ValueError, match="Insufficient precision"):
            _ = file["odd"].dtype
        with pytest.raises(pliant.InputError, match=r"type\.h5: /odd: cannot be read: "):
            _hdf5.item(file, "odd")


def test_a_group_that_hdf5_cannot_tell_of_is_refused(tmp_path, monkeypatch):
    path = tmp_path / "group.h5"
    with h5py.File(path, "w") as file:
        file["parameters/run/seed"] = np.int64(3)

    def fail(_):
        raise RuntimeError("Can't get deprecated info for object")

    with h5py.File(path) as file:
        assert dict(_hdf5.scalars(file["parameters"])) == {"run/seed": 3}
        monkeypatch.setattr(h5py.h5o, "get_info", fail)
        with pytest.raises(pliant.InputError, match="cannot be read: Can't get deprecated info"):
            dict(_hdf5.scalars(file["parameters"]))
