// SPDX-License-Identifier: MIT
#include "pliant/record/pdb_recorder.hpp"

#include <optional>
#include <string>

#include "pliant/base/error.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/record/pdb_text.hpp"
#include "pliant/text/output_file.hpp"

namespace pliant {

class PdbRecorder::Writer {
 public:
  Writer(const std::filesystem::path& path, std::shared_ptr<const AtomTable> atoms,
         std::vector<RecordedBond> bonds, const TopologyPdbOptions& options)
      : atoms_(std::move(atoms)),
        bonds_(std::move(bonds)),
        options_(options),
        pdb_(*atoms_, options.hybrid36_bonds),
        file_(path, options.overwrite) {
    pdb_.add_title(options_.title);
  }

  void record(std::span<const Vec3> positions) {
    const std::string name = path_text(path()) + ": ";
    if (is_closed_) throw FileError(name + "is closed: no frame can be recorded");
    if (positions.size() != atoms_->size())
      throw InputError(name + std::to_string(positions.size()) + " positions for " +
                       std::to_string(atoms_->size()) + " atoms");
    try {
      pdb_.add_model(models_ + 1, positions);
    } catch (const InputError& error) {
      throw InputError(name + "model " + std::to_string(models_ + 1) + ": " + error.what());
    }
    write_out();
    if (++models_ == 1) cuts_ = pdb_.cuts();  // the others have the same names
  }

  void close() {
    if (is_closed_) return;
    is_closed_ = true;
    if (models_ > 0) {
      pdb_.add_bonds(bonds_);
      pdb_.add_end();
      write_out();
      file_.publish();
      cuts_.bonds = pdb_.cuts().bonds;
      cuts_.tell(path_text(path()), options_.log);
    }
    file_.close();
  }

  std::int64_t models() const { return models_; }
  const std::filesystem::path& path() const { return file_.target(); }

 private:
  void write_out() {
    file_.write(pdb_.text());
    pdb_.clear();
  }

  std::shared_ptr<const AtomTable> atoms_;
  std::vector<RecordedBond> bonds_;
  TopologyPdbOptions options_;
  PdbText pdb_;
  OutputFile file_;
  PdbCuts cuts_;
  std::int64_t models_ = 0;
  bool is_closed_ = false;
};

namespace {

std::shared_ptr<const AtomTable> checked_atoms(std::shared_ptr<const AtomTable> atoms) {
  if (!atoms || atoms->size() == 0)
    throw InputError("a framework without names of atoms cannot be written as PDB");
  return atoms;
}

}  // namespace

PdbRecorder::PdbRecorder(const std::filesystem::path& path, std::shared_ptr<const AtomTable> atoms,
                         std::vector<RecordedBond> bonds, const TopologyPdbOptions& options)
    : writer_(std::make_unique<Writer>(path, checked_atoms(std::move(atoms)), std::move(bonds),
                                       options)) {}
PdbRecorder::~PdbRecorder() = default;
PdbRecorder::PdbRecorder(PdbRecorder&&) noexcept = default;
PdbRecorder& PdbRecorder::operator=(PdbRecorder&&) noexcept = default;

void PdbRecorder::record(std::span<const Vec3> positions) { writer_->record(positions); }
void PdbRecorder::close() { writer_->close(); }
std::int64_t PdbRecorder::models() const { return writer_->models(); }
const std::filesystem::path& PdbRecorder::path() const { return writer_->path(); }

}  // namespace pliant
