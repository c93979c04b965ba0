# SPDX-License-Identifier: MIT
"""What of memory is freed goes back to the system at once, where the C library is glibc."""

from __future__ import annotations

import contextlib
import ctypes

#: M_MMAP_THRESHOLD and M_TRIM_THRESHOLD of mallopt(3)
_MMAP_THRESHOLD, _TRIM_THRESHOLD = -3, -1
#: Arrays of so many bytes are mapped by themselves, and unmapped when they are freed. Of an eighth
#: of that, the system would take a tenth of the time of a study to clear pages.
LEAST_MAPPED = 1 << 21
#: More than so many free bytes at the end of the heap go back.
MOST_KEPT = 1 << 22


def give_back_freed_memory() -> None:
    """For a whole process: others would find their allocations slower. Elsewhere it does nothing.

    By itself glibc raises the size from which it maps with what is freed, up to 32 MB: arrays of a
    frame then come from a heap in which the holes between them stay.
    """
    with contextlib.suppress(OSError, AttributeError):
        library = ctypes.CDLL(None)
        library.mallopt(_MMAP_THRESHOLD, LEAST_MAPPED)
        library.mallopt(_TRIM_THRESHOLD, MOST_KEPT)
