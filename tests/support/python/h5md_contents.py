# SPDX-License-Identifier: MIT
"""What H5MD files hold, dataset by dataset."""

import h5py
import numpy as np


def contents(path):
    """Every dataset of a file by name."""
    found = {}

    def take(name, item):
        if isinstance(item, h5py.Dataset):
            found[name] = item[()]

    with h5py.File(path) as file:
        file.visititems(take)
    return found


def stored(path):
    """Type, shape and bytes of every dataset by name, and every attribute by NAME@KEY."""
    found = {}

    def take(name, item):
        if isinstance(item, h5py.Dataset):
            value = np.asarray(item[()])
            bits = repr(value.tolist()) if value.dtype == object else value.tobytes()
            found[name] = (str(item.dtype), item.shape, bits)
        for key, value in item.attrs.items():
            found[f"{name}@{key}"] = repr(np.asarray(value).tolist())

    with h5py.File(path) as file:
        file.visititems(take)
    return found


def assert_same_runs(one, other):
    """Two files have the same bits, but for what their runs go on from."""
    first, second = (
        {name: value for name, value in contents(path).items() if "checkpoint" not in name}
        for path in (one, other)
    )
    assert first.keys() == second.keys()
    for name, value in first.items():
        assert np.array_equal(value, second[name]), name
