// SPDX-License-Identifier: MIT
#include "arrays.hpp"
#include "path/trace.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/path/matching.hpp"
#include "pliant/path/sequence.hpp"
#include "texts.hpp"

namespace pliant::python {
namespace {

using Texts = std::vector<std::string>;

PolymerKind kind_from(const std::string& atom) {
  for (PolymerKind kind : {PolymerKind::amino, PolymerKind::nucleic})
    if (atom == trace_atom(kind)) return kind;
  throw InputError("kinds: expected \"CA\" or \"P\", found " + pliant::quoted(atom));
}

char code_from(const std::string& code) {
  const std::string_view found = trimmed(code);
  if (found.size() > 1)
    throw InputError("codes: expected one character or none, found " + pliant::quoted(code));
  return found.empty() ? ' ' : found[0];
}

void make_trace(Trace* self, const ArrayLike& atoms, const Texts& kinds, const Texts& names,
                const Texts& chains, const ArrayLike& numbers, const Texts& codes) {
  const std::vector<std::int64_t> of_atoms = integers_from(atoms, "atoms");
  const std::vector<std::int64_t> of_numbers = integers_from(numbers, "numbers");
  for (std::size_t length :
       {kinds.size(), names.size(), chains.size(), of_numbers.size(), codes.size()})
    if (length != of_atoms.size())
      throw InputError("columns of a trace: " + std::to_string(length) + " and " +
                       std::to_string(of_atoms.size()) + " rows");
  Trace made;
  for (std::size_t k = 0; k < of_atoms.size(); ++k)
    made.add(static_cast<std::uint32_t>(of_atoms[k]),
             {names[k], of_numbers[k], code_from(codes[k]), chains[k]}, kind_from(kinds[k]));
  new (self) Trace(std::move(made));
}

std::size_t checked(const Trace& self, std::int64_t residue) {
  if (residue < 0 || std::size_t(residue) >= self.size())
    throw nb::index_error("a trace has no such residue");
  return std::size_t(residue);
}

std::vector<std::uint32_t> residues_from(const Trace& self, const ArrayLike& residues) {
  std::vector<std::uint32_t> found;
  for (std::int64_t residue : integers_from(residues, "residues"))
    found.push_back(static_cast<std::uint32_t>(checked(self, residue)));
  return found;
}

/// One number of each residue.
template <class Get>
Array1<std::int64_t> numbers_of(const Trace& self, Get get) {
  std::vector<std::int64_t> numbers;
  for (const TracedResidue& one : self.residues()) numbers.push_back(get(one));
  return array_of(std::move(numbers));
}

Array1<std::int64_t> numbers_of(const std::vector<std::uint32_t>& residues) {
  return array_of(std::vector<std::int64_t>(residues.begin(), residues.end()));
}

/// One text of each residue.
template <class Get>
auto texts_of(Get get) {
  return [get](const Trace& self) {
    return text_array(self.size(), [&](std::size_t k) { return get(self[k]); });
  };
}

std::string letters_of(const Trace& self) {
  std::string letters;
  for (const TracedResidue& one : self.residues()) letters += one.letter;
  return letters;
}

constexpr const char* trace_doc =
    R"(Residues of a polymer by one atom each, in the order of the file.

Parameters
----------
atoms : (R,) int
    Index in the structure of the atom that represents each residue.
kinds : sequence of str
    ``CA`` of amino acids, ``P`` of nucleotides. Unknown names with ``P`` are left out, since they
    can be phosphates.
names, chains : sequence of str
    Of residues and chains; ``""`` where the file names no chain.
numbers : (R,) int
codes : sequence of str
    Insertion codes; ``""`` or a blank for none.

Raises
------
InputError
    Columns of different lengths, or an unknown kind.
)";

void bind_trace_columns(nb::class_<Trace>& trace) {
  trace.def_prop_ro(
      "atoms",
      [](const Trace& self) { return numbers_of(self, [](const auto& r) { return r.atom; }); },
      nb::rv_policy::reference, "(R,) int64: the atom that represents each residue.");
  trace.def_prop_ro(
      "numbers",
      [](const Trace& self) {
        return numbers_of(self, [](const auto& r) { return r.residue.number; });
      },
      nb::rv_policy::reference, "(R,) int64: numbers of the file.");
  def_text(trace, "chains",
           texts_of([](const TracedResidue& r) -> std::string_view { return r.residue.chain; }),
           "(R,) chains; \"\" where the file has none.");
  def_text(trace, "names",
           texts_of([](const TracedResidue& r) -> std::string_view { return r.residue.name; }),
           "(R,) \"LYS\".");
  def_text(
      trace, "codes",
      [](const Trace& self) {
        return text_array(self.size(), [&](std::size_t k) {
          return insertion_text(self[k].residue.insertion_code);
        });
      },
      "(R,) insertion codes; \"\" for none.");
  def_text(trace, "kinds", texts_of([](const TracedResidue& r) { return trace_atom(r.kind); }),
           "(R,) \"CA\" or \"P\".");
}

void bind_trace_class(nb::module_& module) {
  nb::class_<Trace> trace(module, "Trace", trace_doc);
  trace.def("__init__", &make_trace, "atoms"_a, "kinds"_a, "names"_a, "chains"_a, "numbers"_a,
            "codes"_a);
  trace.def("__len__", &Trace::size);
  bind_trace_columns(trace);
  trace.def_prop_ro("letters", &letters_of, "R letters; X for a name that is not known.");
  trace.def(
      "label",
      [](const Trace& self, std::int64_t residue) {
        return text_object(self.label(checked(self, residue)));
      },
      "residue"_a, nb::sig("def label(self, residue: int) -> str"),
      "\"A:LYS12\", or \"LYS12\" where the file names no chain.");
  trace.def(
      "ranges",
      [](const Trace& self, const ArrayLike& residues) {
        return text_object(self.ranges(residues_from(self, residues)));
      },
      "residues"_a, nb::sig("def ranges(self, residues: numpy.typing.ArrayLike) -> str"),
      "\"A:1-3, A:74-76\": residues (k,), rising, those next to each other as one.");
  module.def("trace_of", &trace_of, "structure"_a,
             "The trace of a structure: each carbon called CA, each phosphorus called P.");
}

constexpr const char* match_doc =
    R"(Matches the residues of two structures.

Chains are matched, those that share most first, then residues within them: by chain and number where
9 of 10 residues found so are the same, else by sequence (``align``). Chains that have less than 3 of
10 in common are other molecules.

Parameters
----------
ours, theirs : Trace
source : str
    Their file, for notes and errors.

Returns
-------
ResidueMatch

Raises
------
InputError
    Less than half of our residues are in theirs, or less than 3.
)";

void bind_matching(nb::module_& module) {
  nb::class_<ResidueMatch>(module, "ResidueMatch", "Matched residues of two traces.")
      .def_prop_ro(
          "ours", [](const ResidueMatch& self) { return numbers_of(self.ours); },
          nb::rv_policy::reference, "(K,) int64, rising.")
      .def_prop_ro(
          "theirs", [](const ResidueMatch& self) { return numbers_of(self.theirs); },
          nb::rv_policy::reference, "(K,) int64.")
      .def_ro("notes", &ResidueMatch::notes,
              "Method, differences, and what was left out, line by line.");
  module.def("match_residues", &match_residues, "ours"_a, "theirs"_a, "source"_a, match_doc);
}

constexpr const char* align_doc =
    R"(Matches the residues of two sequences by global alignment.

Needleman and Wunsch, J. Mol. Biol. 48 (1970) 443. Match 2, mismatch -1, gap -2; of equal ways a pair
goes before a gap in theirs, and that before a gap in ours.

Parameters
----------
ours, theirs : str
    A letter for each residue.

Returns
-------
(K, 2) int64 array
    Indices in both, rising.
)";

void bind_sequence(nb::module_& module) {
  module.def(
      "align",
      [](const std::string& ours, const std::string& theirs) {
        std::vector<std::int64_t> rows;
        for (const auto& [mine, other] : align(ours, theirs)) {
          rows.push_back(mine);
          rows.push_back(other);
        }
        return pairs_array_of(std::move(rows));
      },
      "ours"_a, "theirs"_a, nb::rv_policy::reference, align_doc);
  module.def(
      "amino_acid_letters",
      [] {
        nb::dict letters;
        for (const ResidueLetter& row : amino_acid_letters())
          letters[nb::str(row.name.data(), row.name.size())] = nb::str(&row.letter, 1);
        return letters;
      },
      nb::sig("def amino_acid_letters() -> dict[str, str]"),
      "Letters of amino acids by name, those of force fields and of what stands for them in "
      "crystals\n"
      "as well.");
}

}  // namespace

void bind_trace(nb::module_& module) {
  bind_trace_class(module);
  bind_matching(module);
  bind_sequence(module);
}

}  // namespace pliant::python
