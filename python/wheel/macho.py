# SPDX-License-Identifier: MIT
"""What a Mach-O file of macOS needs: its processor, oldest system, libraries and symbols."""

import struct
from dataclasses import dataclass, field

MAGIC = 0xFEEDFACF  # 64 bits, low byte first
PROCESSORS = {0x0100000C: "arm64", 0x01000007: "x86_64"}
LC_SYMTAB, LC_VERSION_MIN, LC_BUILD_VERSION, LC_CODE_SIGNATURE = 0x2, 0x24, 0x32, 0x1D
LIBRARIES = {0xC, 0x80000018, 0x8000001F, 0x80000023}  # LC_LOAD_DYLIB, weak, re-exported, upward
RPATH = 0x8000001C
MACOS = 1  # platform of LC_BUILD_VERSION
# Of a symbol: kept for debuggers, its kind, seen by others; the kind "undefined".
N_STAB, N_TYPE, N_EXT, N_UNDF = 0xE0, 0x0E, 0x01, 0x00
DYNAMIC_LOOKUP = 0xFE  # in place of the number of a library: whoever has it


@dataclass
class MachO:
    """What the load commands and the table of symbols say."""

    processor: str
    oldest: str = ""
    signed: bool = False
    libraries: list[str] = field(default_factory=list)
    search_paths: list[str] = field(default_factory=list)
    exported: set[str] = field(default_factory=set)
    needed: dict[str, set[str]] = field(default_factory=dict)  # by library; "" is whoever has it


def _version(number: int) -> str:
    return f"{number >> 16}.{number >> 8 & 0xFF}"


def _text(data: bytes, start: int) -> str:
    return data[start : data.index(b"\0", start)].decode()


def _symbols(file: MachO, data: bytes, table: tuple[int, ...]) -> None:
    symbols, count, strings, _ = table
    for entry in range(symbols, symbols + 16 * count, 16):
        name_at, kind, _, about, _ = struct.unpack_from("<IBBHQ", data, entry)
        if kind & N_STAB or not kind & N_EXT:
            continue
        name = _text(data, strings + name_at).removeprefix("_")
        if kind & N_TYPE != N_UNDF:
            file.exported.add(name)
            continue
        ordinal = about >> 8
        known = 0 < ordinal <= len(file.libraries)
        library = file.libraries[ordinal - 1] if known else ""
        file.needed.setdefault(library, set()).add(name)


def read(data: bytes) -> MachO:
    """Raises ValueError where it is none for one 64-bit processor."""
    if len(data) < 32 or struct.unpack_from("<I", data)[0] != MAGIC:
        raise ValueError("is no Mach-O file of 64 bits")
    processor, _, _, commands = struct.unpack_from("<IIII", data, 4)
    file = MachO(PROCESSORS.get(processor, hex(processor)))
    at, table = 32, None
    for _ in range(commands):
        command, size = struct.unpack_from("<II", data, at)
        words = struct.unpack_from("<4I", data, at + 8) if size >= 24 else (0,) * 4
        if command in LIBRARIES:
            file.libraries.append(_text(data, at + words[0]))
        elif command == RPATH:
            file.search_paths.append(_text(data, at + struct.unpack_from("<I", data, at + 8)[0]))
        elif command == LC_BUILD_VERSION and words[0] == MACOS:
            file.oldest = _version(words[1])
        elif command == LC_VERSION_MIN:
            file.oldest = _version(struct.unpack_from("<I", data, at + 8)[0])
        elif command == LC_SYMTAB:
            table = words
        elif command == LC_CODE_SIGNATURE:
            file.signed = True
        at += size
    if table:
        _symbols(file, data, table)
    return file
