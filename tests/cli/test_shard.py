# SPDX-License-Identifier: MIT
"""Shards: an ensemble in parts, which may run on several machines."""

import pytest


def test_two_shards_are_the_whole(pliant, ethanol, tmp_path):
    words = ("run", ethanol, "--perturb", "displacement", "--steps", 12, "--every", 5,
             "--technique", "shake")  # fmt: skip
    for folder, shards in (("whole", ["0..11"]), ("parts", ["0..4", "5..11"])):
        (tmp_path / folder).mkdir()
        for shard in shards:
            ended = pliant(*words, "-o", f"{folder}/o.h5md", "--shard", shard)
            assert ended.code == 0, ended.err
    names = sorted(path.name for path in (tmp_path / "whole").iterdir())
    assert names == sorted([f"o-{walker}.h5md" for walker in range(12)] + ["o.pdb"])
    for name in names:
        whole, part = (tmp_path / folder / name for folder in ("whole", "parts"))
        assert whole.read_bytes() == part.read_bytes(), name


def test_a_shard_names_its_files_by_the_numbers_of_its_walkers(pliant, ethanol, tmp_path):
    ended = pliant("run", ethanol, "-o", "o.h5md", "--shard", "800..801", "--steps", 2, "--json")
    assert ended.code == 0
    assert sorted(path.name for path in tmp_path.glob("o*")) == ["o-800.h5md", "o-801.h5md"]
    assert '"o-800.h5md"' in ended.out
    ended = pliant("run", ethanol, "-o", "p.h5md", "--shard", "7..7", "--topology", "p.pdb",
                   "--steps", 2)  # fmt: skip
    assert ended.code == 0
    assert sorted(path.name for path in tmp_path.glob("p*")) == ["p-7.h5md", "p.pdb"]


@pytest.mark.parametrize("shard", ["8", "8..", "..8", "9..8", "-1..3", "a..b", "0..1000000"])
def test_what_is_no_shard_is_refused(pliant, ethanol, shard):
    ended = pliant("run", ethanol, f"--shard={shard}", "--steps", 1)
    assert ended.code == 2
    assert "--shard: expected FIRST..LAST" in ended.err


def test_a_shard_and_walkers_exclude_each_other(pliant, ethanol):
    ended = pliant("run", ethanol, "--shard", "0..3", "--walkers", 4, "--steps", 1)
    assert ended.code == 2
    assert "--shard: is given in place of --walkers" in ended.err
