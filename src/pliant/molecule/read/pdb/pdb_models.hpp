// SPDX-License-Identifier: MIT
// Assigns the lines of a PDB file to models: with MODEL and ENDMDL as in the standard, with frames
// ended by ENDMDL or END alone, or with MODEL but no ENDMDL.
#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "pliant/molecule/read/pdb/pdb_columns.hpp"

namespace pliant {

/// Follows the records that begin and end models. Models are counted from 1 in the order of the
/// file, whatever their numbers; models without atoms do not count.
class PdbModels {
 public:
  explicit PdbModels(std::size_t wanted) : wanted_(wanted) {}

  /// Notes an atom record on `line`. Returns whether it belongs to the wanted model.
  bool on_atom(std::size_t line);
  void on_model(const PdbLine& line, Remarks& remarks);
  void on_endmdl() { close(Border::endmdl); }
  void on_end() { close(Border::end); }
  void on_conect(const PdbLine& line);

  std::size_t count() const { return count_; }

  /// Whether the last atom belongs to the wanted model, which has not ended.
  bool in_wanted() const { return open_ && count_ == wanted_; }

  /// The CONECT records inside the wanted model, and those between and after models; if there are
  /// none, those inside the first model that has any.
  std::vector<PdbLine> conect_of_wanted() const;

  /// Reports models that differ in their number of atoms: with a warning where the part after END
  /// is probably no model, otherwise with a note.
  void tell_of_unequal(Remarks& remarks) const;

 private:
  enum class Border { start, model, endmdl, end };
  struct Conect {
    PdbLine line;
    std::size_t model;  // 0 outside models
  };
  struct Unequal {
    std::size_t model = 0;  // 0: none yet
    std::size_t atoms = 0;
    std::size_t line = 0;
    bool after_end = false;
  };

  void close(Border border);

  std::size_t wanted_;
  std::size_t count_ = 0;
  bool open_ = false;
  Border border_ = Border::start;  // the record before the current model
  std::size_t atoms_ = 0;          // of the current model
  std::size_t first_line_ = 0;     // of the first atom
  std::size_t first_atoms_ = 0;    // of model 1
  Unequal unequal_;
  std::set<std::int64_t> numbers_;
  std::vector<Conect> conects_;
};

}  // namespace pliant
