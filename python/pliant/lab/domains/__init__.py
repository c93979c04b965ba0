# SPDX-License-Identifier: MIT
"""Whether reported domains repeat, and are those of a known pair: ``pliant lab bench domains``."""
