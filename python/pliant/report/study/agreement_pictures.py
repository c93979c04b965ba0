# SPDX-License-Identifier: MIT
"""Pictures of a structure that was fitted to data: over START, and residue by residue."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure

from pliant.base import style
from pliant.report.figures.profile import draw_profile
from pliant.report.page.map_surface import MapSurface
from pliant.report.sections.shape_pictures import draw_shape, seen
from pliant.report.study.data_fit import DataFit
from pliant.trajectory.superposition import Superposition

SIZE = (4.4, 2.9)  #: inches
SHADES = 6  #: of a map: few, for a small file


def fitted_picture(fit: DataFit) -> Figure:
    """The fitted structure over START, with the distances, in the map."""
    pair = seen(fit.start[fit.atoms], fit.turns)
    figure, axes = style.new_figure(SIZE)
    axes.set_axis_off()
    draw_shape(axes, pair, fit.turns)
    if fit.surface is not None:
        onto, fitted = Superposition(pair[1], np.ones(len(fit.atoms))), fit.found.positions[0]
        places = onto.apply(fit.surface.vertices, fitted[fit.atoms])
        draw_surface(axes, MapSurface(places, fit.surface.triangles))
    ends = pair[1][fit.pairs][..., :2]
    colours = np.where(fit.off, style.VERMILION, style.SKY)
    axes.add_collection(LineCollection(ends, colors=colours, lw=1.8, linestyles="--", zorder=4))
    axes.set_aspect("equal", adjustable="datalim")
    axes.autoscale_view()
    return figure


def draw_surface(axes: Axes, surface: MapSurface) -> None:
    """Behind all else, seen along z: the darker the more it is seen from the side."""
    corners = surface.vertices[surface.triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    facing = normals[:, 2] / np.maximum(np.linalg.norm(normals, axis=1), 1e-12)
    shown = np.flatnonzero(facing > 0)
    shown = shown[np.argsort(corners[shown, :, 2].mean(axis=1), kind="stable")]
    share = 0.12 + 0.55 * np.round(SHADES * (1.0 - facing[shown, None]) ** 2) / SHADES
    colours = 1.0 - share * (1.0 - np.array(to_rgb(style.GREY)))
    flat = PolyCollection(corners[shown, :, :2], facecolors=colours, linewidths=0.3, zorder=0)
    flat.set_edgecolor("face")
    axes.add_collection(flat)


def residues_picture(fit: DataFit) -> Figure:
    """Along the chain: correlation with the map, and what is determined."""
    density = fit.found.density
    figure, axes = style.new_figure(
        (style.WIDE[0], style.WIDE[1] * (1.6 if density else 1)),
        rows=1 if density is None else 2,
        squeeze=False,
        sharex=True,
    )
    *above, below = axes[:, 0]
    if density is not None:
        names = ("fitted", "START")
        both = density.by_residue, [density.by_residue_at_start]
        draw_profile(above[0], fit.chains, both[0], halves=both[1], names=names)
        above[0].set_ylabel("correlation")
        style.legend_above(above[0])
    draw_profile(below, fit.chains, fit.found.spread)
    below.set_ylim(bottom=0)
    below.set_ylabel("spread of fits (Å)")
    style.chain_axis(below, fit.numbers, fit.found.structure.chains[fit.atoms])
    return figure
