#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the files of data/mechanisms (graph XML) and their table in data/README.md.

    python data/make_mechanisms.py [FOLDER]

Lengths are in Angstrom as everywhere, whatever the size of the real machine. Planar linkages have
dimension="2" and pinned joints for the ground. A hinge in space is a pair of joints that two rigid
units share. A slider is the output of a Peaucellier cell, since bars alone cannot make a slot.
"""

import re
import sys
from dataclasses import dataclass, field
from math import acos, atan, atan2, cos, dist, pi, radians, sin, sqrt
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
ZERO = 1e-9  # singular values of the normalized rigidity matrix below this count as zero


@dataclass
class Mechanism:
    """Joints by name, bars between them, and the joints of the ground."""

    places: dict[str, tuple[float, ...]] = field(default_factory=dict)  # Angstrom
    bars: list[tuple[str, str]] = field(default_factory=list)
    pinned: set[str] = field(default_factory=set)

    def add(self, pinned: bool = False, **places: tuple[float, ...]) -> None:
        """Joints, with two or three coordinates each."""
        for name, place in places.items():
            self.places[name] = tuple(float(x) for x in place)
            if pinned:
                self.pinned.add(name)

    def join(self, pairs: str) -> None:
        """Bars, spelled "A-B B-C"; one that is there already is not added again."""
        for pair in pairs.split():
            one, other = pair.split("-")
            if (one, other) not in self.bars and (other, one) not in self.bars:
                self.bars.append((one, other))

    @property
    def dimension(self) -> int:
        """2 or 3."""
        return len(next(iter(self.places.values())))

    def length(self, bar: tuple[str, str]) -> float:
        """Distance of its joints, Angstrom."""
        return dist(self.places[bar[0]], self.places[bar[1]])

    def rank(self) -> int:
        """Rank of the normalized rigidity matrix, without the columns of pinned joints."""
        free = [name for name in self.places if name not in self.pinned]
        rows = np.zeros((len(self.bars), len(free), self.dimension))
        for row, (one, other) in zip(rows, self.bars, strict=True):
            unit = np.subtract(self.places[other], self.places[one]) / self.length((one, other))
            for name, sign in ((one, -1), (other, 1)):
                if name not in self.pinned:
                    row[free.index(name)] = sign * unit
        return int((np.linalg.svd(rows.reshape(len(self.bars), -1), compute_uv=False) > ZERO).sum())

    def degrees_of_freedom(self) -> int:
        """To first order: on its ground, or modulo the six rigid motions where it has none."""
        free = len(self.places) - len(self.pinned)
        return self.dimension * free - self.rank() - (0 if self.pinned else 6)

    def xml(self) -> str:
        """The graph XML text."""
        lines = ['<?xml version="1.0" encoding="UTF-8"?>', f'<graph dimension="{self.dimension}">']
        for name, place in self.places.items():
            places = " ".join(f'{axis}="{x:.17g}"' for axis, x in zip("xyz", place, strict=False))
            pin = ' pinned="true"' if name in self.pinned else ""
            lines.append(f'  <joint id="{name}" {places}{pin}/>')
        for bar in self.bars:
            length = f"{self.length(bar):.17g}"
            lines.append(f'  <bar a="{bar[0]}" b="{bar[1]}" length="{length}"/>')
        return "\n".join([*lines, "</graph>", ""])


def third_corner(one, other, to_one: float, to_other: float) -> tuple[float, float]:
    """The point to the left of the way from one to the other, at these distances from them."""
    base = dist(one, other)
    angle = acos((to_one**2 + base**2 - to_other**2) / (2 * to_one * base))
    angle += atan2(other[1] - one[1], other[0] - one[0])
    return one[0] + to_one * cos(angle), one[1] + to_one * sin(angle)


ARM, SIDE, CRANK = 5.0, 3.0, 1.6  # of a Peaucellier cell
REACH = (ARM**2 - SIDE**2) / (2 * CRANK)  # from its fixed joint to the straight line


def add_straight_line(it: Mechanism, mark: str, origin, towards: float, output: str) -> None:
    """A Peaucellier cell; the joint `output` is there already, on the line.

    The line lies at REACH from the origin, across the direction `towards` (radians).
    """
    x, y = it.places[output][0] - origin[0], it.places[output][1] - origin[1]
    bearing, far = atan2(y, x), dist((x, y), (0, 0))
    turn = bearing - towards
    near = 2 * CRANK * cos(turn)
    half = (far + near) / 2
    side = sqrt(ARM**2 - half**2)

    def at(along: float, across: float) -> tuple[float, float]:
        return (
            origin[0] + along * cos(bearing) - across * sin(bearing),
            origin[1] + along * sin(bearing) + across * cos(bearing),
        )

    o, q, left, right, p = (letter + mark for letter in "OQLRP")
    centre = origin[0] + CRANK * cos(towards), origin[1] + CRANK * sin(towards)
    it.add(pinned=True, **{o: origin, q: centre})
    it.add(**{left: at(half, side), right: at(half, -side), p: at(near, 0.0)})
    it.join(f"{o}-{left} {o}-{right} {q}-{p} {left}-{p} {p}-{right} {right}-{output}")
    it.join(f"{output}-{left}")


def four_bar() -> Mechanism:
    """Crank 1.5, coupler 3.5, rocker 3, ground 4: the crank turns round (Grashof)."""
    it = Mechanism()
    it.add(pinned=True, O=(0, 0), Q=(4, 0))
    it.add(A=(1.5 * cos(pi / 3), 1.5 * sin(pi / 3)))
    it.add(B=third_corner(it.places["A"], it.places["Q"], 3.5, 3.0))
    it.add(C=third_corner(it.places["A"], it.places["B"], 2.5, 2.0))
    it.join("O-A A-B B-Q A-C C-B")
    return it


def slider_crank() -> Mechanism:
    """Crank 1.5 and rod 4; the slider S stays on the line y = 0."""
    it = Mechanism()
    it.add(pinned=True, M=(0, 0))
    angle = radians(50)
    it.add(A=(1.5 * cos(angle), 1.5 * sin(angle)))
    it.add(S=(1.5 * cos(angle) + sqrt(16 - (1.5 * sin(angle)) ** 2), 0))
    it.join("M-A A-S")
    add_straight_line(it, "", (4.0, -REACH), pi / 2, "S")
    return it


def peaucellier() -> Mechanism:
    """The output S stays on the line x = REACH."""
    it = Mechanism()
    it.add(S=(REACH, 1.5))
    add_straight_line(it, "", (0.0, 0.0), 0.0, "S")
    return it


def elliptical_trammel() -> Mechanism:
    """A slides along x, B along y, T draws (x/2)^2 + (y/6)^2 = 1."""
    it = Mechanism()
    angle = radians(35)
    it.add(A=(4 * cos(angle), 0), B=(0, 4 * sin(angle)), T=(-2 * cos(angle), 6 * sin(angle)))
    it.add(C=third_corner(it.places["B"], it.places["A"], 2.5, 2.5))
    it.join("A-B B-C C-A B-T T-C")
    add_straight_line(it, "1", (0.0, -REACH), pi / 2, "A")
    add_straight_line(it, "2", (-REACH, 0.0), 0.0, "B")
    return it


def puma() -> Mechanism:
    """PUMA 560: six hinges; axes 1 and 2 meet in S, axes 4, 5 and 6 in W. 1 Angstrom is 0.1 m."""
    upper, forearm, offset, shift, height = 4.318, 4.318, 0.203, 1.5005, 6.718
    it = Mechanism()
    it.add(pinned=True, base=(0, 0, 0), S=(0, 0, height))
    it.add(S2=(0, 1, height))  # axis 2
    elbow = upper * cos(radians(40)), upper * sin(radians(40)) + height
    it.add(E=(elbow[0], shift, elbow[1]), E2=(elbow[0], shift - 1, elbow[1]))  # axis 3
    it.add(U=(elbow[0] / 2, 0.5, height + 3))  # keeps the upper arm from being flat
    it.add(F=(elbow[0] + 1, shift - 0.5, elbow[1] + offset))  # axis 4
    it.add(W=(elbow[0] + forearm, shift - 0.5, elbow[1] + offset))
    x, y, z = it.places["W"]
    it.add(V=(x, y + 0.8, z), T=(x + 0.4, y, z - 0.7), tool=(x + 1.0, y + 0.3, z - 0.5))
    it.join("base-S2 S-S2")
    it.join("S-E S2-E S2-E2 E-E2 U-S U-S2 U-E U-E2")
    it.join("E-F E-W E2-F E2-W F-W")
    it.join("F-V W-V V-T W-T W-tool T-tool")
    return it


def chain_7r() -> Mechanism:
    """Seven hinges, each across the one before; the first one stands on the ground."""
    it = Mechanism()
    for k in range(7):
        along, up = ((0.8, 0), (0, 0.8))[k % 2], 1.2 * k
        ends = {f"H{k + 1}": (*along, up), f"G{k + 1}": (-along[0], -along[1], up)}
        it.add(pinned=k == 0, **ends)
    it.add(tool=(0.3, 0.5, 8.6))
    for k in range(1, 7):
        it.join(f"H{k + 1}-G{k + 1} H{k}-H{k + 1} H{k}-G{k + 1} G{k}-H{k + 1} G{k}-G{k + 1}")
    it.join("H7-tool G7-tool")
    return it


def ring_of(radius: float, degrees, height: float) -> list[tuple[float, float, float]]:
    """Points on a circle around z."""
    return [(radius * cos(radians(a)), radius * sin(radians(a)), height) for a in degrees]


def octahedral_platform() -> Mechanism:
    """Base A, platform B, a pair of legs from each joint: an octahedron."""
    it = Mechanism()
    it.add(**{f"A{k + 1}": p for k, p in enumerate(ring_of(4, (0, 120, 240), 0))})
    it.add(**{f"B{k + 1}": p for k, p in enumerate(ring_of(2.5, (60, 180, 300), 4))})
    it.join("A1-A2 A2-A3 A3-A1 B1-B2 B2-B3 B3-B1")
    it.join("A1-B1 A2-B1 A2-B2 A3-B2 A3-B3 A1-B3")
    return it


def platform_6_6() -> Mechanism:
    """Two hexagons, each braced and coned to a rigid body, and six legs."""
    it = Mechanism()
    base = ring_of(5, (-14, 74, 106, 194, 226, 314), 0)
    platform = ring_of(2.5, (8, 112, 128, 232, 248, 352), 3.75)
    it.add(**{f"A{k + 1}": p for k, p in enumerate(base)})
    it.add(**{f"B{k + 1}": p for k, p in enumerate(platform)})
    it.add(A0=(0, 0, -2.5), B0=(0, 0, 6.25))
    for body in "AB":
        it.join(" ".join(f"{body}{k + 1}-{body}{(k + 1) % 6 + 1}" for k in range(6)))
        it.join(f"{body}1-{body}3 {body}3-{body}5 {body}5-{body}1")
        it.join(" ".join(f"{body}0-{body}{k + 1}" for k in range(6)))
    it.join(" ".join(f"A{k + 1}-B{k + 1}" for k in range(6)))
    return it


def double_banana() -> Mechanism:
    """Two bipyramids that share their tips N and S, which no bar joins."""
    it = Mechanism()
    it.add(N=(0, 0, 3), S=(0, 0, -3))
    it.add(a=(1.2, 0.9, 0.3), b=(1.0, -1.1, -0.2), c=(2.6, 0.1, 0.1))
    it.add(d=(-1.1, 1.0, -0.3), e=(-0.9, -1.2, 0.2), f=(-2.7, -0.2, -0.1))
    for banana in ("abc", "def"):
        it.join(" ".join(f"{tip}-{joint}" for joint in banana for tip in "NS"))
        it.join(f"{banana[0]}-{banana[1]} {banana[1]}-{banana[2]} {banana[2]}-{banana[0]}")
    return it


def bricard_octahedron() -> Mechanism:
    """Opposite joints change places by half a turn around z."""
    it = Mechanism()
    it.add(A=(1, 0, 0), a=(-1, 0, 0), B=(1, 2, 1), b=(-1, -2, 1), C=(2, -1, -1), c=(-2, 1, -1))
    it.join("A-B A-b A-C A-c a-B a-b a-C a-c B-C B-c b-C b-c")
    return it


def kaleidocycle(apart: float = 2.5, half_edge: float = 1.8, ratio: float = 0.8) -> Mechanism:
    """Six tetrahedra in a ring; hinge k in the upright plane at 60 k degrees.

    Neighbouring hinges are `apart`, and at right angles to one another and to the line that joins
    their middles. The ratio of the distances of odd and even hinges from the axis (1/2 to 2) tells
    how far the ring is turned inside out.
    """
    it = Mechanism()
    inner = apart / sqrt(1.5 * ratio)
    outer = ratio * inner
    rise = inner * sqrt(2 * (1 - ratio / 2) * (ratio - 1 / 2))
    tilts = atan((inner - outer / 2) / rise), atan((inner / 2 - outer) / rise)
    for k in range(6):
        radius, height, tilt = (inner, outer)[k % 2], (-rise, rise)[k % 2] / 2, tilts[k % 2]
        for name, sign in ((f"H{k + 1}", 1), (f"G{k + 1}", -1)):
            out = radius + sign * half_edge * cos(tilt)
            up = height + sign * half_edge * sin(tilt)
            it.add(**{name: ring_of(out, [60 * k], up)[0]})
    for k in range(1, 7):
        after = k % 6 + 1
        it.join(f"H{k}-G{k} H{k}-H{after} H{k}-G{after} G{k}-H{after} G{k}-G{after}")
    return it


THESIS = "the thesis"

# File, how it is made, true degrees of freedom, why it is here, and the source.
MECHANISMS = [
    ("four_bar", four_bar, 1, "crank and rocker with a coupler point; one cycle closed by the "
     "ground", "Grashof 1883"),
    ("slider_crank", slider_crank, 1, "a slider by a Peaucellier cell", "closed form"),
    ("peaucellier", peaucellier, 1, "an exact straight line from turning joints alone",
     "Peaucellier 1864"),
    ("elliptical_trammel", elliptical_trammel, 1, "two sliders at right angles; T draws an ellipse",
     f"{THESIS}, figure 1.9"),
    ("puma", puma, 6, "an arm of six hinges, the last three through one joint",
     f"{THESIS}, figure 3.1; lengths of the PUMA 560: Corke, Armstrong 1994"),
    ("chain_7r", chain_7r, 7, "an open chain of seven hinges: one more than a pose needs",
     f"{THESIS}, figure 1.10"),
    ("stewart_gough_octahedral", octahedral_platform, 0,
     "the platform with its legs locked: rigid, no redundant bar", f"{THESIS}, figure 3.2"),
    ("stewart_gough_6_6", platform_6_6, 0, "the same with twelve feet; without its six legs the "
     "platform has 6 degrees of freedom", "coned hexagons, 36 = 3 * 14 - 6 bars"),
    ("double_banana", double_banana, 1, "rigid by the count of its bars; turns about its tips",
     "PyRigi, DoubleBanana"),
    ("bricard_octahedron", bricard_octahedron, 1, "rigid by the count of its bars; moves because "
     "it is symmetric", "Bricard 1897; PyRigi, Octahedron('Bricard_line')"),
    ("kaleidocycle", kaleidocycle, 1, "an over-constrained ring of six hinges (6R) that turns "
     "inside out without end", "Schattschneider, Walker 1977; Bricard 1927"),
]  # fmt: skip  # a table: a row a line


def row(name: str, it: Mechanism, freedom: int, why: str, source: str) -> str:
    """One row of the table."""
    assert it.degrees_of_freedom() == freedom, (name, it.degrees_of_freedom())
    joints = f"{len(it.places)} ({len(it.pinned)})" if it.pinned else str(len(it.places))
    stresses = len(it.bars) - it.rank()
    cells = [f"{name}.xml", why, it.dimension, joints, len(it.bars), stresses, freedom, source]
    return "| " + " | ".join(map(str, cells)) + " |"


def write_table(rows: list[str]) -> None:
    """Puts the rows between the marks in README.md."""
    readme = HERE / "README.md"
    head = [
        "| file | why it is here | in | joints (pinned) | bars | stresses | freedom | source |",
        "|---|---|---:|---:|---:|---:|---:|---|",
    ]
    marks = r"(<!-- made by make_mechanisms.py -->\n).*?(\n<!-- end -->)"
    table = "\n".join([*head, *rows]).replace("\\", r"\\")
    text = re.sub(marks, rf"\g<1>{table}\g<2>", readme.read_text(), flags=re.DOTALL)
    readme.write_text(text)


def main(folder: Path) -> None:
    """Writes every mechanism; and the table, when the folder is the project's."""
    rows = []
    for name, make, freedom, why, source in MECHANISMS:
        it = make()
        (folder / f"{name}.xml").write_text(it.xml())
        rows.append(row(name, it, freedom, why, source))
    if folder == HERE / "mechanisms":
        write_table(rows)


if __name__ == "__main__":
    main(Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else HERE / "mechanisms")
