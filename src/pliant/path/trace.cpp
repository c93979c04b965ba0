// SPDX-License-Identifier: MIT
#include "pliant/path/trace.hpp"

#include <optional>
#include <utility>

#include "pliant/path/sequence.hpp"

namespace pliant {
namespace {

constexpr std::uint8_t carbon = 6, phosphorus = 15;

std::optional<PolymerKind> kind_of(const AtomTable& atoms, std::size_t atom) {
  const std::string& name = atoms.names[atom];
  if (name == "CA" && atoms.elements[atom] == carbon) return PolymerKind::amino;
  if (name == "P" && atoms.elements[atom] == phosphorus) return PolymerKind::nucleic;
  return std::nullopt;
}

std::string with_chain(const Residue& residue, const std::string& text) {
  return residue.chain.empty() ? text : residue.chain + ":" + text;
}

/// "12", or "12A" with an insertion code.
std::string number_of(const Residue& residue) {
  std::string text = std::to_string(residue.number);
  if (residue.insertion_code != ' ') text += residue.insertion_code;
  return text;
}

}  // namespace

std::string_view trace_atom(PolymerKind kind) { return kind == PolymerKind::amino ? "CA" : "P"; }

void Trace::add(std::uint32_t atom, Residue residue, PolymerKind kind) {
  const bool is_amino = kind == PolymerKind::amino;
  const char letter =
      letter_of(residue.name, is_amino ? amino_acid_letters() : nucleotide_letters());
  if (is_amino || letter != unknown_letter)
    residues_.push_back({atom, std::move(residue), kind, letter});
}

std::string Trace::label(std::size_t residue) const {
  const Residue& one = residues_[residue].residue;
  return with_chain(one, one.name + number_of(one));
}

std::string Trace::ranges(std::span<const std::uint32_t> residues) const {
  std::string text;
  for (std::size_t first = 0, next = 0; first < residues.size(); first = next) {
    const Residue& begin = residues_[residues[first]].residue;
    for (next = first + 1; next < residues.size(); ++next)
      if (residues[next] > residues[next - 1] + 1 ||
          residues_[residues[next]].residue.chain != begin.chain)
        break;
    std::string range = number_of(begin);
    if (next - first > 1) range += "-" + number_of(residues_[residues[next - 1]].residue);
    text += (first == 0 ? "" : ", ") + with_chain(begin, range);
  }
  return text;
}

Trace trace_of(const Structure& structure) {
  const AtomTable& atoms = structure.atoms;
  Trace trace;
  for (std::uint32_t atom = 0; atom < atoms.size(); ++atom)
    if (const auto kind = kind_of(atoms, atom))
      trace.add(atom, atoms.residues[atoms.residue_of[atom]], *kind);
  return trace;
}

}  // namespace pliant
