// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/pdb/pdb_models.hpp"

#include <algorithm>
#include <string>

#include "pliant/base/number.hpp"

namespace pliant {
namespace {

std::string atoms_text(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " atom" : " atoms");
}

}  // namespace

bool PdbModels::on_atom(std::size_t line) {
  if (!open_) {
    open_ = true;
    ++count_;
    atoms_ = 0;
    first_line_ = line;
  }
  ++atoms_;
  if (count_ == 1) first_atoms_ = atoms_;
  return count_ == wanted_;
}

void PdbModels::close(Border border) {
  if (open_ && atoms_ != first_atoms_ && unequal_.model == 0)
    unequal_ = {count_, atoms_, first_line_, border_ == Border::end};
  open_ = false;
  border_ = border;
}

void PdbModels::on_model(const PdbLine& line, Remarks& remarks) {
  if (open_)
    remarks.warn("model not ended", line.number, [&] {
      return "MODEL begins where the model before has no ENDMDL: taken as ended";
    });
  close(Border::model);
  const auto number = parse_integer(columns(line.text, 7, 80));
  if (number && !numbers_.insert(*number).second)
    remarks.warn("model number twice", line.number, [&] {
      return "model number " + std::to_string(*number) +
             " is given twice: models are counted in their order";
    });
}

void PdbModels::on_conect(const PdbLine& line) { conects_.push_back({line, open_ ? count_ : 0}); }

std::vector<PdbLine> PdbModels::conect_of_wanted() const {
  std::vector<PdbLine> lines;
  for (const Conect& conect : conects_)
    if (conect.model == 0 || conect.model == wanted_) lines.push_back(conect.line);
  if (!lines.empty() || conects_.empty()) return lines;
  for (const Conect& conect : conects_)
    if (conect.model == conects_.front().model) lines.push_back(conect.line);
  return lines;
}

void PdbModels::tell_of_unequal(Remarks& remarks) const {
  Unequal unequal = unequal_;
  if (unequal.model == 0 && open_ && atoms_ != first_atoms_)
    unequal = {count_, atoms_, first_line_, border_ == Border::end};
  if (unequal.model == 0) return;
  const std::string model = "model " + std::to_string(unequal.model);
  if (unequal.after_end && wanted_ != unequal.model) {
    remarks.warn("after end", unequal.line, [&] {
      return atoms_text(unequal.atoms) + " after END left out (as " + model + "; model 1 has " +
             std::to_string(first_atoms_) + ")";
    });
  } else {
    remarks.note(model + " has " + atoms_text(unequal.atoms) + ", model 1 has " +
                 std::to_string(first_atoms_));
  }
}

}  // namespace pliant
