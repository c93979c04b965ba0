# SPDX-License-Identifier: MIT
"""What ``pliant bench validity`` measures: sampled ensembles beside experiment, MD and peers."""
