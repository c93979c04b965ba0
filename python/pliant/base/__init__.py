# SPDX-License-Identifier: MIT
"""What every room uses: errors and refusals, files, processes, progress, the command line."""
