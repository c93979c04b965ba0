# SPDX-License-Identifier: MIT
"""Files as small as they can be of other systems: Mach-O of macOS, DLL of Windows, ELF of Linux."""

import struct

SYSTEM = "/usr/lib/libSystem.B.dylib"
PROCESSORS = {"arm64": 0x0100000C, "x86_64": 0x01000007}
WHOEVER = 0xFE  # in place of a library's number


def _command(kind, body):
    body += b"\0" * (-len(body) % 8)
    return struct.pack("<II", kind, 8 + len(body)) + body


def macho(processor, oldest, exported, needed, libraries=(SYSTEM,), *, signed=True):
    """`needed`: pairs of a name and the number of its library, from 1."""
    major, minor = oldest
    commands = [_command(0x32, struct.pack("<IIII", 1, major << 16 | minor << 8, 0, 0))]
    for library in libraries:
        commands.append(_command(0xC, struct.pack("<IIII", 24, 0, 0, 0) + library.encode() + b"\0"))
    if signed:
        commands.append(_command(0x1D, struct.pack("<II", 0, 0)))
    names, entries = b"\0", b""
    for name, kind, about in [(n, 0x0F, 0) for n in exported] + [
        (n, 0x01, number << 8) for n, number in needed
    ]:
        entries += struct.pack("<IBBHQ", len(names), kind, 0, about, 0)
        names += b"_" + name.encode() + b"\0"
    end = 32 + sum(map(len, commands)) + 24
    count = len(exported) + len(needed)
    table = struct.pack("<IIII", end, count, end + len(entries), len(names))
    commands.append(_command(0x2, table))
    head = struct.pack(
        "<8I", 0xFEEDFACF, PROCESSORS[processor], 0, 6, len(commands), end - 32, 0, 0
    )
    return head + b"".join(commands) + entries + names


def dll(exported, needed, machine=0x8664):
    """`needed`: names by library."""
    start, section, texts = 0x1000, bytearray(4096), []

    def put(data):
        at = sum(map(len, texts))
        texts.append(data + b"\0" * (-len(data) % 8))
        return start + 1024 + at

    names = [put(name.encode() + b"\0") for name in exported]
    addresses = put(struct.pack(f"<{len(names)}I", *names))
    exports = put(struct.pack("<IIIIIIIIII", 0, 0, 0, 0, 0, 0, len(names), 0, addresses, 0))
    rows = b""
    for library, wanted in needed.items():
        entries = [put(b"\0\0" + name.encode() + b"\0") for name in wanted]
        lookup = put(struct.pack(f"<{len(entries) + 1}Q", *entries, 0))
        rows += struct.pack("<5I", lookup, 0, 0, put(library.encode() + b"\0"), lookup)
    imports = put(rows + bytes(20))
    body = b"".join(texts)
    section[1024 : 1024 + len(body)] = body
    optional = struct.pack("<H", 0x20B) + bytes(110)
    optional += struct.pack("<4I", exports, 40, imports, len(rows)) + bytes(8 * 14)
    coff = struct.pack("<HHIIIHH", machine, 1, 0, 0, 0, len(optional), 0)
    table = b".data\0\0\0" + struct.pack("<IIII", 4096, start, 4096, 512) + bytes(16)
    file = b"MZ" + bytes(58) + struct.pack("<I", 64) + b"PE\0\0" + coff + optional + table
    return file + bytes(512 - len(file)) + bytes(section)


def elf(machine):
    """Its first 64 bytes."""
    return b"\x7fELF\x02\x01\x01" + bytes(9) + struct.pack("<HH", 3, machine) + bytes(44)
