# SPDX-License-Identifier: MIT
"""What ``pliant lab bench validity`` measures: ensembles beside experiment, MD and peers."""
