# SPDX-License-Identifier: MIT
"""Jobs of the library, as commands and functions ask for them."""
