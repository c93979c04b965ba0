# SPDX-License-Identifier: MIT
"""Where the library is after some steps of each technique, for tests of the page.

python native_bits.py STEPS MODEL FILE...  prints {file: {technique: SHA-1 of positions}}
"""

import hashlib
import json
import sys
from pathlib import Path

import pliant

SETTINGS = {"max_sweeps": 200, "damping": 0.5}
TECHNIQUES = [row.name for row in pliant.techniques()]


def opened(path, model):
    """Framework and start, as the library makes them of a file."""
    if path.suffix == ".xml":
        graph = pliant.read_graph_xml(str(path))
        return graph.framework, graph.positions
    structure = pliant.read(str(path))
    structure.perceive_bonds()
    built = pliant.build_model(structure, model)
    return built.framework, built.positions


def end_of(path, model, technique, steps):
    """Or why the library refuses the technique."""
    framework, positions = opened(path, model)
    last = []

    def keep(frame):
        last.append(frame.positions.copy())

    try:
        often = {"steps": steps, "every": steps, "observers": [keep]}
        pliant.run(framework, positions, technique=technique, **often, **SETTINGS)
    except pliant.Error as error:
        return str(error)
    return hashlib.sha1(last[-1].tobytes()).hexdigest()


def main(steps, model, *files):
    rows = {
        Path(file).name: {name: end_of(Path(file), model, name, int(steps)) for name in TECHNIQUES}
        for file in files
    }
    print(json.dumps({"settings": SETTINGS, "rows": rows}))


if __name__ == "__main__":
    main(*sys.argv[1:])
