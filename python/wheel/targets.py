# SPDX-License-Identifier: MIT
"""The table targets.txt."""

from pathlib import Path
from typing import NamedTuple

TABLE = Path(__file__).with_name("targets.txt")


class Target(NamedTuple):
    """A system that wheels are made for; targets.txt says what the words are."""

    name: str
    zig: str
    platform: str
    oldest: str
    tried: str

    @property
    def system(self) -> str:
        """Such as linux."""
        return self.name.partition("-")[0]

    @property
    def processor(self) -> str:
        """Such as x86_64."""
        return self.name.partition("-")[2]


def targets() -> dict[str, Target]:
    """All rows, by name."""
    lines = TABLE.read_text(encoding="utf-8").splitlines()
    rows = [Target(*line.split()) for line in lines if not line.startswith("#")]
    return {row.name: row for row in rows}


def target_of(wheel: Path) -> Target:
    """The one whose platform stands in the name of the wheel."""
    tags = wheel.stem.split("-")[-1].split(".")
    for row in targets().values():
        if row.platform in tags:
            return row
    raise ValueError(f"{wheel.name}: of no platform in {TABLE.name}")
