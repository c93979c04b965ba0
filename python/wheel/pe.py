# SPDX-License-Identifier: MIT
"""What a DLL of Windows needs: its processor, libraries and the names it takes from each."""

import struct
from dataclasses import dataclass, field

PROCESSORS = {0x8664: "x86_64", 0xAA64: "arm64"}
EXPORTS, IMPORTS, DELAYED = 0, 1, 13  # of the data directories
BY_NUMBER = 1 << 63  # an import without a name


@dataclass
class Dll:
    """What the headers and tables say."""

    processor: str
    delayed: bool = False  # imports that are resolved when called: not looked at
    exported: set[str] = field(default_factory=set)
    needed: dict[str, set[str]] = field(default_factory=dict)  # by library


class _Image:
    """The file by the addresses that it has in memory."""

    def __init__(self, data: bytes) -> None:
        self.data = data
        if data[:2] != b"MZ":
            raise ValueError("is no file of Windows")
        (start,) = struct.unpack_from("<I", data, 0x3C)
        if data[start : start + 4] != b"PE\0\0":
            raise ValueError("is no PE file")
        self.machine, count = struct.unpack_from("<HH", data, start + 4)
        (size,) = struct.unpack_from("<H", data, start + 20)
        optional = start + 24
        if struct.unpack_from("<H", data, optional)[0] != 0x20B:
            raise ValueError("is no PE file of 64 bits")
        self.directories = optional + 112
        self.sections = [
            struct.unpack_from("<IIII", data, optional + size + 40 * number + 8)
            for number in range(count)
        ]

    def at(self, address: int) -> int:
        for size, start, raw_size, raw in self.sections:
            if start <= address < start + max(size, raw_size):
                return int(address - start + raw)
        raise ValueError(f"address {address:#x} lies in no section")

    def words(self, layout: str, address: int) -> tuple[int, ...]:
        return struct.unpack_from(layout, self.data, self.at(address))

    def text(self, address: int) -> str:
        start = self.at(address)
        return self.data[start : self.data.index(b"\0", start)].decode()

    def directory(self, number: int) -> int:
        return int(struct.unpack_from("<I", self.data, self.directories + 8 * number)[0])


def _exported(image: _Image) -> set[str]:
    table = image.directory(EXPORTS)
    if not table:
        return set()
    count, _, names = image.words("<III", table + 24)
    return {image.text(image.words("<I", names + 4 * number)[0]) for number in range(count)}


def _names(image: _Image, table: int) -> set[str]:
    names = set()
    while entry := image.words("<Q", table)[0]:
        names.add(f"#{entry & 0xFFFF}" if entry & BY_NUMBER else image.text(entry + 2))
        table += 8
    return names


def read(data: bytes) -> Dll:
    """Raises ValueError where it is none of 64 bits."""
    image = _Image(data)
    file = Dll(PROCESSORS.get(image.machine, hex(image.machine)))
    file.delayed = image.directory(DELAYED) != 0
    file.exported = _exported(image)
    table = image.directory(IMPORTS)
    while table:
        lookup, _, _, name, addresses = image.words("<5I", table)
        if not name:
            break
        file.needed.setdefault(image.text(name), set()).update(_names(image, lookup or addresses))
        table += 20
    return file
