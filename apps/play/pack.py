# SPDX-License-Identifier: MIT
"""Packs standard input by LZMA to standard output, with its length in the header.

The page unpacks it by page/lzma.mjs. node has no LZMA, Python has.
"""

import lzma
import sys

data = sys.stdin.buffer.read()
chain = [{"id": lzma.FILTER_LZMA1, "preset": 9 | lzma.PRESET_EXTREME, "lc": 4, "lp": 0, "pb": 0}]
packed = lzma.compress(data, lzma.FORMAT_ALONE, filters=chain)
sys.stdout.buffer.write(packed[:5] + len(data).to_bytes(8, "little") + packed[13:])
