// SPDX-License-Identifier: MIT
#include "pliant/record/h5md/h5md_static_reader.hpp"

#include <limits>

#include "pliant/base/error.hpp"
#include "pliant/record/h5md/h5md_static.hpp"
#include "pliant/record/hdf5/hdf5_dataset.hpp"
#include "pliant/record/hdf5/hdf5_read.hpp"

namespace pliant {
namespace {

const std::string topology = h5md::topology;
const std::string framework_group = h5md::framework;

constexpr auto least_integer = std::numeric_limits<std::int64_t>::min();
constexpr auto most_integer = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t most_kind = std::numeric_limits<std::uint16_t>::max();
constexpr std::int64_t most_bonds_apart = std::numeric_limits<int>::max();

void check_count(const std::string& path, std::size_t found, std::size_t expected) {
  if (found != expected)
    throw InputError(path + " has " + std::to_string(found) + " values; expected " +
                     std::to_string(expected));
}

std::size_t rows_of(const Hdf5Dataset& dataset) {
  return dataset.extents().empty() ? 1 : dataset.extents()[0];
}

std::optional<Parameter> parameter_at(const Hdf5Dataset& dataset) {
  if (!dataset.extents().empty()) return std::nullopt;
  switch (dataset.value_class()) {
    case ValueClass::integer:
    case ValueClass::named:
      return dataset.integers().at(0);
    case ValueClass::real:
      return dataset.reals().at(0);
    case ValueClass::truth:
      return dataset.integers().at(0) != 0;
    case ValueClass::text:
      return dataset.texts().at(0);
    case ValueClass::other:
      break;
  }
  return std::nullopt;
}

}  // namespace

std::vector<double> StaticReader::reals(const std::string& path, std::size_t count) const {
  std::vector<double> values = Hdf5Dataset(file_, path).reals();
  check_count(path, values.size(), count);
  return values;
}

std::vector<std::int64_t> StaticReader::integers(const std::string& path, std::size_t count,
                                                 std::int64_t least, std::int64_t most) const {
  std::vector<std::int64_t> values = Hdf5Dataset(file_, path).integers();
  check_count(path, values.size(), count);
  for (std::size_t i = 0; i < count; ++i)
    if (values[i] < least || values[i] > most)
      throw InputError(path + ": value " + std::to_string(i) + " is " + std::to_string(values[i]) +
                       "; expected " + std::to_string(least) + " to " + std::to_string(most));
  return values;
}

std::vector<std::string> StaticReader::texts(const std::string& path, std::size_t count) const {
  std::vector<std::string> values = Hdf5Dataset(file_, path).texts();
  check_count(path, values.size(), count);
  return values;
}

std::vector<Bar> StaticReader::pairs(const std::string& path) const {
  if (!has_object(file_, path)) return {};
  const Hdf5Dataset dataset(file_, path);
  if (dataset.extents().size() != 2 || dataset.extents()[1] != 2)
    throw InputError(path + " has shape " + dataset.shape() + "; expected (pairs, 2)");
  const auto ends =
      integers(path, dataset.integers().size(), 0, static_cast<std::int64_t>(joint_count_) - 1);
  std::vector<Bar> pairs(ends.size() / 2);
  for (std::size_t k = 0; k < pairs.size(); ++k)
    pairs[k] = {static_cast<Joint>(ends[2 * k]), static_cast<Joint>(ends[2 * k + 1])};
  return pairs;
}

std::vector<Bar> StaticReader::bars() const { return pairs(h5md::bars); }

std::vector<double> StaticReader::rest_lengths() const {
  const std::string path = framework_group + "/rest_length";
  if (!has_object(file_, path)) return {};
  return reals(path, bars().size());
}

std::vector<double> StaticReader::masses() const {
  const std::string path = "/particles/" + group_ + "/mass";
  if (!has_object(file_, path)) return {};
  return reals(path, joint_count_);
}

std::vector<Joint> StaticReader::pinned() const {
  const std::string path = framework_group + "/pinned";
  if (!has_object(file_, path)) return {};
  const auto flags = integers(path, joint_count_, 0, 1);
  std::vector<Joint> joints;
  for (std::size_t i = 0; i < flags.size(); ++i)
    if (flags[i] != 0) joints.push_back(static_cast<Joint>(i));
  return joints;
}

std::size_t StaticReader::joints_of_whole() const {
  const std::string path = "/particles/" + group_ + "/id";
  if (!has_object(file_, path)) return 0;
  const double count =
      number_attribute(open_object(file_, path), h5md::joints_of_whole).value_or(0);
  return count > 0 ? static_cast<std::size_t>(count) : 0;
}

bool StaticReader::planar() const {
  const std::string path = framework_group + "/planar";
  return has_object(file_, path) && integers(path, 1, 0, 1)[0] != 0;
}

std::vector<Limit> StaticReader::limits() const {
  const std::vector<Bar> ends = pairs(h5md::limits);
  if (ends.empty()) return {};
  const std::string group = h5md::limit;
  const auto least = reals(group + "/least", ends.size());
  const auto most = reals(group + "/most", ends.size());
  const auto energies = reals(group + "/energy", ends.size());
  const auto last_kind = static_cast<std::int64_t>(limit_kinds().size()) - 1;
  const auto kinds = integers(group + "/kind", ends.size(), 0, last_kind);
  const auto groups = integers(group + "/group", ends.size(), -1, no_limit_group - 1);
  std::vector<Limit> limits;
  for (std::size_t k = 0; k < ends.size(); ++k)
    limits.push_back({ends[k].a, ends[k].b, least[k], most[k], static_cast<LimitKind>(kinds[k]),
                      energies[k], static_cast<std::uint32_t>(groups[k])});
  return limits;
}

std::shared_ptr<const Sterics> StaticReader::sterics() const {
  const std::string group = h5md::sterics;
  if (!has_object(file_, group + "/kind")) return nullptr;
  auto sterics = std::make_shared<Sterics>();
  sterics->least = Hdf5Dataset(file_, group + "/least").reals();
  while (sterics->kind_count * sterics->kind_count < sterics->least.size()) ++sterics->kind_count;
  for (const auto kind : integers(group + "/kind", joint_count_, 0, most_kind))
    sterics->kinds.push_back(static_cast<std::uint16_t>(kind));
  const std::vector<Bar> own = pairs(group + "/own");
  const auto own_least = reals(group + "/own_least", own.size());
  for (std::size_t k = 0; k < own.size(); ++k)
    sterics->own.push_back({own[k].a, own[k].b, own_least[k]});
  if (has_object(file_, group + "/unit"))
    for (const auto unit : integers(group + "/unit", joint_count_, 0, no_unit))
      sterics->units.push_back(static_cast<std::uint32_t>(unit));
  for (const Bar bond : pairs(group + "/bonds")) sterics->bonds.emplace_back(bond.a, bond.b);
  sterics->excluded_bonds =
      static_cast<int>(integers(group + "/bonds_apart", 1, 0, most_bonds_apart)[0]);
  return sterics;
}

std::vector<std::uint32_t> StaticReader::joints(const std::string& path,
                                                std::size_t columns) const {
  const Hdf5Dataset dataset(file_, path);
  if (dataset.extents().size() != 2 || dataset.extents()[1] != columns)
    throw InputError(path + " has shape " + dataset.shape() + "; expected (torsions, " +
                     std::to_string(columns) + ")");
  const auto all =
      integers(path, dataset.integers().size(), 0, static_cast<std::int64_t>(joint_count_) - 1);
  return {all.begin(), all.end()};
}

std::shared_ptr<const TorsionPreferences> StaticReader::torsion_preferences() const {
  const std::string group = h5md::torsion_preferences;
  if (!has_object(file_, group + "/staggered")) return nullptr;
  TorsionColumns columns;
  columns.staggered = joints(group + "/staggered", 4);
  columns.free = reals(group + "/free", columns.staggered.size() / 4);
  columns.backbone = joints(group + "/backbone", 5);
  columns.reach = reals(group + "/reach", columns.backbone.size() / 5);
  return std::make_shared<const TorsionPreferences>(torsion_preferences_of(columns));
}

/// Files of other programs have none either: they are read as the first.
int StaticReader::schema() const {
  if (!has_object(file_, "/h5md/creator")) return 1;
  return static_cast<int>(
      number_attribute(open_object(file_, "/h5md/creator"), "schema").value_or(1.0));
}

std::vector<RecordedBond> StaticReader::bonds() const {
  const std::vector<Bar> ends = pairs(h5md::bonds);
  std::vector<RecordedBond> bonds;
  for (const Bar pair : ends) bonds.push_back({pair.a, pair.b});
  if (has_object(file_, topology + "/bond_origin")) {
    const auto origins = integers(topology + "/bond_origin", bonds.size(), 0, 255);
    for (std::size_t k = 0; k < bonds.size(); ++k)
      bonds[k].origin = static_cast<std::uint8_t>(origins[k]);
  }
  if (has_object(file_, topology + "/bond_order")) {
    const auto orders = integers(topology + "/bond_order", bonds.size(), 0, 255);
    for (std::size_t k = 0; k < bonds.size(); ++k)
      bonds[k].order = static_cast<std::uint8_t>(orders[k]);
  }
  return bonds;
}

std::vector<std::string> StaticReader::bond_origin_names() const {
  const std::string path = topology + "/bond_origin";
  return has_object(file_, path) ? Hdf5Dataset(file_, path).value_names()
                                 : std::vector<std::string>{};
}

std::vector<Residue> StaticReader::residues() const {
  const std::size_t count = rows_of(Hdf5Dataset(file_, topology + "/residue_name"));
  const auto names = texts(topology + "/residue_name", count);
  const auto numbers = integers(topology + "/residue_number", count, least_integer, most_integer);
  const auto insertion_codes = texts(topology + "/insertion_code", count);
  const auto chains = texts(topology + "/chain", count);
  std::vector<Residue> residues;
  for (std::size_t r = 0; r < count; ++r)
    residues.push_back({names[r], numbers[r],
                        insertion_codes[r].empty() ? ' ' : insertion_codes[r][0], chains[r]});
  return residues;
}

std::shared_ptr<const AtomTable> StaticReader::atoms() const {
  if (!has_object(file_, topology + "/atom_name")) return nullptr;
  auto atoms = std::make_shared<AtomTable>();
  atoms->names = texts(topology + "/atom_name", joint_count_);
  atoms->serials = integers(topology + "/atom_serial", joint_count_, least_integer, most_integer);
  atoms->residues = residues();
  for (const auto number : integers(topology + "/atomic_number", joint_count_, 0, 255))
    atoms->elements.push_back(static_cast<std::uint8_t>(number));
  const auto last = static_cast<std::int64_t>(atoms->residues.size()) - 1;
  for (const auto residue : integers(topology + "/residue_of", joint_count_, 0, last))
    atoms->residue_of.push_back(static_cast<std::uint32_t>(residue));
  return atoms;
}

std::vector<NamedParameter> StaticReader::parameters() const {
  std::vector<NamedParameter> parameters;
  for (const std::string& path : datasets_below(file_, "/parameters")) {
    if (is_own_parameter(path)) continue;
    if (auto value = parameter_at(Hdf5Dataset(file_, "/parameters/" + path)))
      parameters.emplace_back(path, std::move(*value));
  }
  return parameters;
}

Framework StaticReader::framework() const {
  if (!has_object(file_, h5md::bars) || !has_object(file_, framework_group + "/rest_length"))
    throw InputError("no bars with rest lengths: " + std::string(h5md::bars) + " or " +
                     framework_group + "/rest_length is missing");
  return Framework({.joint_count = joint_count_,
                    .bars = bars(),
                    .rest_lengths = rest_lengths(),
                    .masses = masses(),
                    .pinned = pinned(),
                    .atoms = atoms(),
                    .planar = planar(),
                    .limits = limits(),
                    .sterics = sterics(),
                    .torsion_preferences = torsion_preferences()});
}

}  // namespace pliant
