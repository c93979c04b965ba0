# SPDX-License-Identifier: MIT
"""The shape of what a command prints as JSON."""


def holds(value, schema, where="$"):
    """Asserts that a JSON value has the names and types of the schema, all of them and no more."""
    if isinstance(schema, dict):
        assert isinstance(value, dict) and list(value) == list(schema), where
        for name, inner in schema.items():
            holds(value[name], inner, f"{where}.{name}")
    elif isinstance(schema, list):
        assert isinstance(value, list), where
        for k, item in enumerate(value):
            holds(item, schema[0], f"{where}[{k}]")
    else:
        assert isinstance(value, schema), f"{where}: {value!r}"
