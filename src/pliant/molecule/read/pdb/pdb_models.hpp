// SPDX-License-Identifier: MIT
// Which lines of a PDB file belong to which model: MODEL and ENDMDL as the standard has them,
// frames ended by ENDMDL or END alone, and MODEL without ENDMDL.
#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "pliant/molecule/read/pdb/pdb_columns.hpp"

namespace pliant {

/// Follows the records that begin and end models. Models are counted by their order in the file
/// from 1, whatever numbers they have; one without atoms does not count.
class PdbModels {
 public:
  explicit PdbModels(std::size_t wanted) : wanted_(wanted) {}

  /// An atom record stands on `line`. True if it belongs to the wanted model.
  bool on_atom(std::size_t line);
  void on_model(const PdbLine& line, Remarks& remarks);
  void on_endmdl() { close(Border::endmdl); }
  void on_end() { close(Border::end); }
  void on_conect(const PdbLine& line);

  std::size_t count() const { return count_; }

  /// Whether the last atom belongs to the wanted model, and that has not ended.
  bool in_wanted() const { return open_ && count_ == wanted_; }

  /// The CONECT records inside the wanted model, with those between and after models; where there
  /// are none, those inside the first model that has any.
  std::vector<PdbLine> conect_of_wanted() const;

  /// Says where models differ in their number of atoms: a warning where what follows END is hardly
  /// a model, else a note.
  void tell_of_unequal(Remarks& remarks) const;

 private:
  enum class Border { start, model, endmdl, end };
  struct Conect {
    PdbLine line;
    std::size_t model;  // 0 outside
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
  Border border_ = Border::start;  // what came before the current model
  std::size_t atoms_ = 0;          // of the current model
  std::size_t first_line_ = 0;     // of its atoms
  std::size_t first_atoms_ = 0;    // of model 1
  Unequal unequal_;
  std::set<std::int64_t> numbers_;
  std::vector<Conect> conects_;
};

}  // namespace pliant
