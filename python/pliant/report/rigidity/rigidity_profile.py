# SPDX-License-Identifier: MIT
"""Flexibility and clusters along the chain, as an SVG picture."""

from __future__ import annotations

from collections.abc import Iterator

from pliant.report.rigidity.rigidity_facts import COLOURS, RigidityFacts

WIDTH, LEFT, TOP, TALL = 1000.0, 46.0, 16.0, 110.0  #: pixels
STRIP = 12.0
HIGHEST, LOWEST = 1.0, -0.5  #: of flexibility; what is lower is drawn there


def profile_svg(facts: RigidityFacts) -> str:
    """A curve, and below it a strip of clusters."""
    height = TOP + TALL + STRIP + 36
    return "\n".join(
        [
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{LEFT + WIDTH + 10:.0f}" '
            f'height="{height:.0f}" font-family="sans-serif" font-size="11" role="img" '
            'aria-label="flexibility of residues along the chain">',
            *_axis(),
            *_curves(facts),
            *_strip(facts),
            *_labels(facts),
            "</svg>",
        ]
    )


def _x(facts: RigidityFacts, place: float) -> float:
    return LEFT + WIDTH * place / len(facts.chains)


def _y(value: float) -> float:
    inside = min(HIGHEST, max(LOWEST, value))
    return TOP + TALL * (HIGHEST - inside) / (HIGHEST - LOWEST)


def _axis() -> Iterator[str]:
    for value in (1.0, 0.5, 0.0, -0.5):
        y = _y(value)
        colour = "#8a929b" if value == 0 else "#e2e6ea"
        yield f'<path d="M{LEFT:.0f} {y:.1f}h{WIDTH:.0f}" stroke="{colour}"/>'
        label = f"{value:g}".replace("-", "−")
        yield f'<text x="{LEFT - 6:.0f}" y="{y + 4:.1f}" text-anchor="end">{label}</text>'


def _curves(facts: RigidityFacts) -> Iterator[str]:
    """One curve a chain."""
    starts = [k for k in range(len(facts.chains)) if k == 0 or _begins(facts, k)]
    for first, end in zip(starts, [*starts[1:], len(facts.chains)], strict=True):
        points = " ".join(
            f"{_x(facts, k + 0.5):.1f},{_y(float(facts.flexibility[k])):.1f}"
            for k in range(first, end)
        )
        yield f'<polyline points="{points}" fill="none" stroke="#222a31" stroke-width="1.3"/>'


def _begins(facts: RigidityFacts, k: int) -> bool:
    return facts.chains[k] != facts.chains[k - 1]


def _strip(facts: RigidityFacts) -> Iterator[str]:
    y = TOP + TALL + 6
    for first, last, cluster in facts.segments():
        left, right = _x(facts, first), _x(facts, last + 1)
        tall, colour = (STRIP, COLOURS[cluster]) if cluster >= 0 else (2.0, "#c3cad1")
        yield (
            f'<rect x="{left:.1f}" y="{y + (STRIP - tall) / 2:.1f}" width="{right - left:.1f}" '
            f'height="{tall:.0f}" fill="{colour}"/>'
        )


def _labels(facts: RigidityFacts) -> Iterator[str]:
    """About twenty numbers of residues."""
    y = TOP + TALL + STRIP + 24
    every = next((n for n in (10, 20, 50, 100, 200, 500) if n * 20 >= len(facts.chains)), 1000)
    for k, number in enumerate(facts.numbers):
        if number.lstrip("-").isdigit() and int(number) % every == 0:
            x = _x(facts, k + 0.5)
            yield f'<text x="{x:.1f}" y="{y:.0f}" text-anchor="middle">{number}</text>'
