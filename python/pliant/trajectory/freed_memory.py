# SPDX-License-Identifier: MIT
"""What of memory is freed goes back to the system at once, where the C library is glibc."""

from __future__ import annotations

import contextlib
import ctypes

#: M_MMAP_THRESHOLD of mallopt(3)
_MMAP_THRESHOLD = -3
#: Arrays of so many bytes are mapped by themselves, and unmapped when they are freed.
LEAST_MAPPED = 1 << 18


def give_back_freed_memory() -> None:
    """For a whole process: others would find their allocations slower. Elsewhere it does nothing.

    By itself glibc raises the size from which it maps with what is freed, up to 32 MB: arrays of a
    frame then come from a heap in which the holes between them stay.
    """
    with contextlib.suppress(OSError, AttributeError):
        ctypes.CDLL(None).mallopt(_MMAP_THRESHOLD, LEAST_MAPPED)
