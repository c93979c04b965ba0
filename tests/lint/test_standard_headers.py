# SPDX-License-Identifier: MIT
"""Files include what they use of the standard library, themselves or by headers of ours.

Precompiled headers hide what is missing, and `test_headers_compile_alone` takes a minute.
"""

import re
from functools import cache
from pathlib import Path

from sources import CPP, ROOT, files, refuse

# Header: the names of it that are looked for.
NAMES = {
    "algorithm": "all_of any_of binary_search clamp copy count_if equal fill find find_if "
    "lower_bound max_element min_element none_of nth_element partition remove_if reverse rotate "
    "sort stable_sort transform unique upper_bound",
    "array": "array",
    "charconv": "from_chars to_chars",
    "cmath": "abs acos atan2 cbrt ceil cos exp floor fma hypot isfinite log pow sin sqrt",
    "filesystem": "filesystem",
    "functional": "function",
    "limits": "numeric_limits",
    "map": "map",
    "memory": "make_shared make_unique shared_ptr unique_ptr",
    "numbers": "numbers",
    "numeric": "accumulate inner_product iota partial_sum",
    "optional": "nullopt optional",
    "set": "set",
    "span": "span",
    "string": "string to_string",
    "string_view": "string_view",
    "unordered_map": "unordered_map",
    "vector": "vector",
}
USES = {
    header: re.compile(rf"\bstd::(?:{names.replace(' ', '|')})\b")
    for header, names in NAMES.items()
}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
COMMENT = re.compile(r"//.*")


def ours(name: str, beside: Path) -> Path | None:
    """The file that a quoted include means, if it is one of ours."""
    candidates = (ROOT / "src" / name, ROOT / "apps" / name, beside.parent / name)
    return next((path for path in candidates if path.exists()), None)


@cache
def standard_headers(path: Path) -> frozenset[str]:
    """What a file includes in angle brackets, with what headers of ours include for it."""
    found = set()
    for quote, name in INCLUDE.findall(path.read_text()):
        if quote == "<":
            found.add(name)
        elif header := ours(name, path):
            found |= standard_headers(header)
    return frozenset(found)


def missing(text: str, included: frozenset[str]) -> list[str]:
    """The headers that a text uses names of and does not include."""
    code = COMMENT.sub("", text)
    return [header for header, use in USES.items() if header not in included and use.search(code)]


def test_what_is_used_is_included():
    refuse(
        [
            f"{path.relative_to(ROOT)}: uses names of <{header}>, which it does not include"
            for path in files(*CPP, folders=("src", "apps"))
            for header in missing(path.read_text(), standard_headers(path))
        ]
    )


def test_what_is_missing_is_found():
    text = "std::vector<int> a; std::sort(a.begin(), a.end());  // std::span"
    assert missing(text, frozenset({"vector"})) == ["algorithm"]
    assert missing(text, frozenset({"algorithm", "vector"})) == []
