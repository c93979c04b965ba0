// SPDX-License-Identifier: MIT
// The amplitude of another ensemble: the mean RMSF of the residues that it shares with a structure.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "pliant/base/error.hpp"
#include "pliant/base/log.hpp"
#include "pliant/model/amplitude.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// Gathers frames from another program or an experiment. Residues are matched by chain, number and
/// insertion code; the chain is ignored if that finds more and our structure has a single chain.
class EnsembleFluctuation {
 public:
  /// Takes the structure that is to be sampled.
  explicit EnsembleFluctuation(const Structure& ours);

  /// Adds a frame (N); frames may have different atoms. `source` is for messages. Throws InputError
  /// if the frame has fewer than half of our residues, or different names for more than half of
  /// those.
  void add(const AtomTable& atoms, std::span<const Vec3> positions, const std::string& source);

  /// Mean RMSF of the residues that all frames have, superposed on their mean. Throws InputError if
  /// there are fewer than two frames.
  AmplitudeChoice choice(const std::string& source, const Log& log) const;

 private:
  struct Key {
    std::string chain;
    std::int64_t number = 0;
    char insertion_code = ' ';
    friend auto operator<=>(const Key&, const Key&) = default;
  };
  static Key key_of(const Residue& residue, bool with_chain);
  std::vector<std::int64_t> places_in(const AtomTable& atoms, bool with_chain) const;
  void refuse_strangers(const AtomTable& atoms, std::span<const std::int64_t> places,
                        const std::string& source) const;

  std::vector<Residue> residues_;        ///< (K) of our structure
  std::vector<std::string> atom_names_;  ///< (K) names of the atoms of their nodes
  bool has_one_chain_ = true;
  std::vector<std::vector<Vec3>> frames_;  ///< (F, K)
  std::vector<bool> is_everywhere_;        ///< (K) residues that all frames have
};

/// Amplitude of the models of a PDB or mmCIF file. Throws as EnsembleFluctuation and
/// read_structure() do.
AmplitudeChoice ensemble_amplitude(const std::filesystem::path& path, const Structure& structure,
                                   const Log& log);

/// Amplitude of the frames of a trajectory. `Reader` has frames(), atoms() and positions(frame) as
/// H5mdReader has. Throws InputError if it has no atom names, and as EnsembleFluctuation.
template <class Reader>
AmplitudeChoice trajectory_amplitude(const Reader& reader, const std::string& source,
                                     const Structure& structure, const Log& log) {
  const auto atoms = reader.atoms();
  if (!atoms) fail({source}, "names no atoms: residues cannot be found in it");
  EnsembleFluctuation found(structure);
  for (std::int64_t frame = 0; frame < reader.frames(); ++frame)
    found.add(*atoms, reader.positions(frame), source);
  return found.choice(source, log);
}

}  // namespace pliant
