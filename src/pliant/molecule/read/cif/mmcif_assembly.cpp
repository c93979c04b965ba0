// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/cif/mmcif_assembly.hpp"

#include <algorithm>
#include <map>

#include "pliant/base/number.hpp"
#include "pliant/text/text_lines.hpp"

namespace pliant {
namespace {

using Names = std::vector<std::string>;

/// Parts between commas that are outside parentheses, without spaces and line ends.
Names split(std::string_view text) {
  Names parts(1);
  int depth = 0;
  for (const char c : text) {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (c == ',' && depth == 0)
      parts.emplace_back();
    else if (c != ' ' && c != '\t' && c != '\n' && c != '\r')
      parts.back() += c;
  }
  std::erase(parts, "");
  return parts;
}

/// Reads one assembly.
class AssemblyReader {
 public:
  AssemblyReader(const CifDocument& document, const CifBlock& block, const Remarks& remarks)
      : document_(document), block_(block), remarks_(remarks) {}

  Assembly read(const std::string& name) {
    const CifTable& table = *block_.table(cif_assembly_gen);
    read_operations();
    Assembly assembly;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      if (word(table, row, "assembly_id") != name) continue;
      line_ = CifLines(document_.text)(table.at(row, 0));
      AssemblyPart& part = assembly.emplace_back();
      part.chains = split(word(table, row, "asym_id_list"));
      for (const std::string& term : split(word(table, row, "oper_expression")))
        add_term(term, part.motions);
    }
    return assembly;
  }

 private:
  std::string_view word(const CifTable& table, std::size_t row, std::string_view tag) const {
    const auto column = table.column(tag);
    if (!column)
      fail(remarks_.place(table.line),
           table.category.substr(1) + " has no column " + std::string(tag));
    return document_.word(table.at(row, *column));
  }

  void read_operations() {
    const CifTable* table = block_.table(cif_oper_list);
    if (table == nullptr)
      fail(remarks_.place(0), "expected a table pdbx_struct_oper_list, found none");
    for (std::size_t row = 0; row < table->rows(); ++row) {
      RigidMotion& motion = motions_[std::string(word(*table, row, "id"))];
      double* shift[] = {&motion.shift.x, &motion.shift.y, &motion.shift.z};
      for (std::size_t k = 0; k < 3; ++k) {
        const std::string at = "[" + std::to_string(k + 1) + "]";
        *shift[k] = number(*table, row, "vector" + at);
        for (std::size_t j = 0; j < 3; ++j)
          motion.turn[3 * k + j] =
              number(*table, row, "matrix" + at + "[" + std::to_string(j + 1) + "]");
      }
    }
  }

  double number(const CifTable& table, std::size_t row, const std::string& tag) const {
    const std::string_view text = word(table, row, tag);
    if (const auto value = parse_real(text)) return *value;
    fail(remarks_.place(CifLines(document_.text)(table.at(row, *table.column(tag)))),
         tag + ": expected a number, found " + quoted(text));
  }

  /// "1", "1-60", "(1-5,7)", "(X0)(1-60)"
  void add_term(const std::string& term, std::vector<RigidMotion>& to) const {
    std::vector<RigidMotion> made(1);
    if (term[0] != '(') made = motions_of(term);
    for (std::size_t open = 0; term[0] == '(' && open < term.size();) {
      const std::size_t close = term.find(')', open);
      if (term[open] != '(' || close == term.npos)
        refuse("oper_expression: expected lists in parentheses, found " + pliant::quoted(term));
      made = products(made, motions_of(term.substr(open + 1, close - open - 1)));
      open = close + 1;
    }
    to.insert(to.end(), made.begin(), made.end());
    check_count(to.size());
  }

  std::vector<RigidMotion> products(const std::vector<RigidMotion>& first,
                                    const std::vector<RigidMotion>& second) const {
    check_count(first.size() * second.size());
    std::vector<RigidMotion> made;
    for (const RigidMotion& a : first)
      for (const RigidMotion& b : second) made.push_back(product(a, b));
    return made;
  }

  /// The motions of a list without parentheses.
  std::vector<RigidMotion> motions_of(const std::string& list) const {
    std::vector<RigidMotion> found;
    for (const std::string& item : split(list)) {
      const std::size_t dash = item.find('-');
      const auto first = parse_integer(std::string_view(item).substr(0, dash));
      const auto last =
          dash == item.npos ? std::nullopt : parse_integer(std::string_view(item).substr(dash + 1));
      if (motions_.contains(item) || !first || !last || *last < *first) {
        found.push_back(motion(item));
        continue;
      }
      check_count(static_cast<std::size_t>(*last - *first) + found.size());
      for (std::int64_t k = *first; k <= *last; ++k) found.push_back(motion(std::to_string(k)));
    }
    return found;
  }

  const RigidMotion& motion(const std::string& name) const {
    const auto found = motions_.find(name);
    if (found == motions_.end())
      refuse("oper_expression: there is no operation " + pliant::quoted(name) +
             " in pdbx_struct_oper_list");
    return found->second;
  }

  void check_count(std::size_t count) const {
    if (count > most_motions)
      refuse("oper_expression: expected at most " + std::to_string(most_motions) + " operations");
  }

  [[noreturn]] void refuse(const std::string& what) const { fail(remarks_.place(line_), what); }

  const CifDocument& document_;
  const CifBlock& block_;
  const Remarks& remarks_;
  std::map<std::string, RigidMotion> motions_;
  std::size_t line_ = 0;
};

}  // namespace

std::vector<std::string> cif_assembly_names(const CifDocument& document, const CifBlock& block) {
  std::vector<std::string> names;
  const CifTable* table = block.table(cif_assembly_gen);
  if (table == nullptr) return names;
  const auto column = table->column("assembly_id");
  for (std::size_t row = 0; column && row < table->rows(); ++row)
    if (std::string name(document.word(table->at(row, *column)));
        std::ranges::find(names, name) == names.end())
      names.push_back(std::move(name));
  return names;
}

Assembly cif_assembly(const CifDocument& document, const CifBlock& block, const std::string& name,
                      const Remarks& remarks) {
  return AssemblyReader(document, block, remarks).read(name);
}

}  // namespace pliant
