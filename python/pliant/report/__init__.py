# SPDX-License-Identifier: MIT
"""Reports: a trajectory, a comparison, a study, rigidity or shards as figures, tables and pages."""
