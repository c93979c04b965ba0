# SPDX-License-Identifier: MIT
"""Copies of a file with something wrong, and reading them in processes of their own."""

import os
import random
import resource
from collections.abc import Callable, Iterator

MOST_SECONDS = 10  # of the processor
MOST_BYTES = 4 << 30


def flipped(whole: bytes, number: int) -> bytes:
    """The bytes with one bit turned over; the same for the same number."""
    numbers = random.Random(number)
    damaged = bytearray(whole)
    damaged[numbers.randrange(len(whole))] ^= 1 << numbers.randrange(8)
    return bytes(damaged)


def broken(whole: bytes, number: int) -> bytes:
    """The bytes with a piece overwritten by another, zeros, ones or a number, or cut off."""
    numbers = random.Random(-1 - number)
    damaged = bytearray(whole)
    length = 1 << numbers.randrange(10)
    place, other = (numbers.randrange(len(whole)) // 8 * 8 for _ in range(2))
    pieces = [
        (length, whole[other : other + length]),
        (length, bytes(length)),
        (length, b"\xff" * length),
        (8, (numbers.getrandbits(64) >> numbers.randrange(64)).to_bytes(8, "little")),
        (8, other.to_bytes(8, "little")),  # an address or a length that can be
    ]
    kind = numbers.randrange(len(pieces) + 1)
    if kind == len(pieces):
        return whole[:other]
    size, piece = pieces[kind]
    damaged[place : place + size] = piece
    return bytes(damaged[: len(whole)])


def damages(whole: bytes, flips: int, breaks: int) -> Iterator[tuple[str, bytes]]:
    """What was done, and the damaged bytes."""
    for k in range(flips):
        yield f"flip {k}", flipped(whole, k)
    for k in range(breaks):
        yield f"break {k}", broken(whole, k)


def death_of(read: Callable[[], object]) -> str:
    """How calling `read` in a forked process ended: "" well, else what killed it."""
    child = os.fork()
    if child == 0:
        code = 1
        try:
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            resource.setrlimit(resource.RLIMIT_AS, (MOST_BYTES, MOST_BYTES))
            resource.setrlimit(resource.RLIMIT_CPU, (MOST_SECONDS, MOST_SECONDS))
            read()
            code = 0
        finally:
            os._exit(code)
    _, status = os.waitpid(child, 0)
    if os.WIFSIGNALED(status):
        return f"signal {os.WTERMSIG(status)}"
    return f"exit {os.WEXITSTATUS(status)}" if status else ""
