// SPDX-License-Identifier: MIT
#include "corpus/structure_text.hpp"

#include <cstdio>
#include <sstream>

#include "pliant/base/elements.hpp"
#include "pliant/base/error.hpp"

namespace pliant {
namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

void write_atom(const Structure& s, std::size_t i, std::ostream& out) {
  const Residue& residue = s.atoms.residues[s.atoms.residue_of[i]];
  out << s.atoms.serials[i] << ' ' << (residue.chain.empty() ? "-" : residue.chain) << ' '
      << residue.name << residue.number;
  if (residue.insertion_code != ' ') out << residue.insertion_code;
  out << ' ' << s.atoms.names[i] << ' ' << element_symbol(s.atoms.elements[i]) << ' '
      << number(s.positions[i].x) << ' ' << number(s.positions[i].y) << ' '
      << number(s.positions[i].z);
  if (!s.charges.empty()) out << " charge " << int(s.charges[i]);
  out << '\n';
}

void write_structure(const Structure& s, std::ostream& out) {
  if (!s.title.empty()) out << "title: " << s.title << '\n';
  if (s.model_count > 1) out << "model " << s.model << " of " << s.model_count << '\n';
  for (std::size_t i = 0; i < s.size(); ++i) write_atom(s, i, out);
  for (std::size_t r = 0; r < s.chain_end.size(); ++r)
    if (s.chain_end[r]) out << "chain ends after residue " << r + 1 << '\n';
  for (const Bond& bond : s.bonds)
    out << "bond " << bond.a + 1 << '-' << bond.b + 1 << ' ' << int(bond.order) << ' '
        << bond_origin_names[static_cast<std::size_t>(bond.origin)] << '\n';
}

}  // namespace

std::string reading_as_text(const SourceText& source, const ReadOptions& options) {
  std::ostringstream out;
  ReadOptions logged = options;
  logged.log.function = [&](Severity severity, std::string_view text) {
    out << (severity == Severity::warning ? "warning: " : "note: ") << text << '\n';
  };
  try {
    write_structure(read_structure(source, logged), out);
  } catch (const Error& error) {
    out << "error: " << error.what() << '\n';
  }
  return out.str();
}

}  // namespace pliant
