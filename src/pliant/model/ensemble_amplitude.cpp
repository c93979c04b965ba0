// SPDX-License-Identifier: MIT
#include "pliant/model/ensemble_amplitude.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

#include "pliant/base/error.hpp"
#include "pliant/base/math/superposition.hpp"
#include "pliant/base/number.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/model/atoms/residue_nodes.hpp"
#include "pliant/molecule/read/read.hpp"
#include "pliant/text/file_text.hpp"

namespace pliant {
namespace {

constexpr std::int64_t not_there = -1;
constexpr std::size_t few_frames = 20;

std::size_t found_in(std::span<const std::int64_t> places) {
  return places.size() -
         static_cast<std::size_t>(std::count(places.begin(), places.end(), not_there));
}

std::string of(std::size_t part, std::size_t all) {
  return std::to_string(part) + " of " + std::to_string(all);
}

}  // namespace

EnsembleFluctuation::EnsembleFluctuation(const Structure& ours) {
  const ResidueNodes nodes = residue_nodes(ours);
  for (std::size_t k = 0; k < nodes.atom.size(); ++k) {
    if (!nodes.is_residue[k]) continue;
    residues_.push_back(ours.atoms.residues[ours.atoms.residue_of[nodes.atom[k]]]);
    atom_names_.push_back(ours.atoms.names[nodes.atom[k]]);
    has_one_chain_ = has_one_chain_ && residues_.back().chain == residues_.front().chain;
  }
  if (residues_.size() < 2)
    throw OptionError("amplitude: a file of models is compared by residues, of which " +
                      ours.source + " has " + std::to_string(residues_.size()));
  is_everywhere_.assign(residues_.size(), true);
}

EnsembleFluctuation::Key EnsembleFluctuation::key_of(const Residue& residue, bool with_chain) {
  return {with_chain ? residue.chain : "", residue.number, residue.insertion_code};
}

/// (K) the atom at which the node of each of our residues is; of residues of one key the first.
std::vector<std::int64_t> EnsembleFluctuation::places_in(const AtomTable& atoms,
                                                         bool with_chain) const {
  std::map<std::pair<Key, std::string>, std::int64_t> found;
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    const Residue& residue = atoms.residues[atoms.residue_of[i]];
    const std::string& name = atoms.names[i];
    if (name == "CA" || name == "P" || name == "C4'")
      found.emplace(std::pair{key_of(residue, with_chain), name}, std::int64_t(i));
  }
  std::vector<std::int64_t> out;
  for (std::size_t k = 0; k < residues_.size(); ++k) {
    const auto place = found.find({key_of(residues_[k], with_chain), atom_names_[k]});
    out.push_back(place == found.end() ? not_there : place->second);
  }
  return out;
}

void EnsembleFluctuation::refuse_strangers(const AtomTable& atoms,
                                           std::span<const std::int64_t> places,
                                           const std::string& source) const {
  const std::size_t found = found_in(places);
  if (2 * found < residues_.size())
    fail({source}, "has " + of(found, residues_.size()) +
                       " residues of the sampled molecule, by chain and number: number both alike");
  std::size_t same = 0;
  for (std::size_t k = 0; k < places.size(); ++k)
    if (places[k] != not_there)
      same += atoms.residues[atoms.residue_of[static_cast<std::size_t>(places[k])]].name ==
                      residues_[k].name
                  ? 1
                  : 0;
  if (2 * same < found)
    fail({source}, "only " + of(same, found) +
                       " residues have the names of the sampled molecule: number both alike");
}

void EnsembleFluctuation::add(const AtomTable& atoms, std::span<const Vec3> positions,
                              const std::string& source) {
  std::vector<std::int64_t> places = places_in(atoms, true);
  if (has_one_chain_) {
    std::vector<std::int64_t> others = places_in(atoms, false);
    if (found_in(others) > found_in(places)) places = std::move(others);
  }
  refuse_strangers(atoms, places, source);
  frames_.emplace_back(places.size());
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (places[k] == not_there)
      is_everywhere_[k] = false;
    else
      frames_.back()[k] = positions[static_cast<std::size_t>(places[k])];
  }
}

AmplitudeChoice EnsembleFluctuation::choice(const std::string& source, const Log& log) const {
  if (frames_.size() < 2)
    fail({source}, "amplitude: expected at least 2 models, found " +
                       std::to_string(frames_.size()) + ": one structure does not fluctuate");
  std::vector<std::vector<Vec3>> shared(frames_.size());
  for (std::size_t f = 0; f < frames_.size(); ++f)
    for (std::size_t k = 0; k < residues_.size(); ++k)
      if (is_everywhere_[k]) shared[f].push_back(frames_[f][k]);
  const std::size_t count = shared.front().size();
  if (2 * count < residues_.size())
    fail({source}, "only " + of(count, residues_.size()) +
                       " residues of the sampled molecule are in all models");
  double mean = 0.0;
  for (double value : superposed_fluctuations(std::move(shared))) mean += value / double(count);
  if (!(mean > 0.0)) fail({source}, "amplitude: all models are the same");
  if (frames_.size() < few_frames)
    log.warn("the amplitude is from " + std::to_string(frames_.size()) + " models: few");
  return {mean, source,
          std::to_string(frames_.size()) + " models of " + source + ", mean RMSF of " +
              of(count, residues_.size()) + " residues, superposed"};
}

AmplitudeChoice ensemble_amplitude(const std::filesystem::path& path, const Structure& structure,
                                   const Log& log) {
  const std::string name = path_text(path);
  const std::string bytes = read_bytes(path);
  EnsembleFluctuation found(structure);
  std::size_t count = 1;
  for (std::size_t model = 1; model <= count; ++model) {
    ReadOptions reading;
    reading.model = model;
    const Structure one = read_structure(SourceText{name, bytes}, reading);
    count = one.model_count;
    found.add(one.atoms, one.positions, name);
  }
  return found.choice(name, log);
}

}  // namespace pliant
