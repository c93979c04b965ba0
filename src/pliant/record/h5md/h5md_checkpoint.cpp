// SPDX-License-Identifier: MIT
#include "pliant/record/h5md/h5md_checkpoint.hpp"

#include <hdf5.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "pliant/base/word_digest.hpp"
#include "pliant/record/h5md/h5md_static.hpp"
#include "pliant/record/hdf5/hdf5_write.hpp"

namespace pliant {

std::size_t checkpoint::columns_of(const Framework& framework) {
  return checkpoint::head_columns + 6 * framework.joint_count() + framework.limits().size();
}

std::array<double, 2> checkpoint::digest_of(std::span<const double> row) {
  WordDigest digest;
  const auto add = [&](double value) { digest.add(std::bit_cast<std::uint64_t>(value)); };
  for (const double value : row.first(checkpoint::digest_column)) add(value);
  for (const double value : row.subspan(checkpoint::head_columns)) add(value);
  return {double(digest.value() >> 32), double(digest.value() & 0xffffffff)};
}

namespace {

/// A mass whose inverse is this one bit by bit: one of those next to the inverse of the inverse.
double mass_of(double inverse) {
  if (inverse == 0.0) return 1.0;
  const double mass = 1.0 / inverse;
  for (const double towards : {0.0, HUGE_VAL}) {
    double next = mass;
    for (int k = 0; k < 3; ++k, next = std::nextafter(next, towards))
      if (1.0 / next == inverse) return next;
  }
  return mass;
}

bool says_masses(const Framework& framework, std::span<const double> masses) {
  const auto inverse = framework.inverse_masses();
  if (masses.empty()) return false;
  for (std::size_t i = 0; i < inverse.size(); ++i)
    if (inverse[i] != 0.0 && 1.0 / masses[i] != inverse[i]) return false;
  return true;
}

std::span<const double> numbers_of(std::span<const Vec3> vectors) {
  return {vectors.empty() ? nullptr : &vectors[0].x, 3 * vectors.size()};
}
static_assert(sizeof(Vec3) == 3 * sizeof(double));

Hid write_vectors(std::int64_t file, const std::string& path, std::span<const Vec3> vectors) {
  return write_table(file, path, vectors.size(), 3, numbers_of(vectors));
}

bool is_same(std::span<const Vec3> a, std::span<const Vec3> b) {
  return std::ranges::equal(numbers_of(a), numbers_of(b));
}

/// Where the file has drawn positions and no start, the start is where it was drawn.
void write_start(std::int64_t file, const Framework& framework, const RunInputs& inputs) {
  if (inputs.start.empty() || is_same(inputs.start, framework.drawn())) return;
  write_text_attribute(write_vectors(file, checkpoint::group + "/start", inputs.start), "unit",
                       "Angstrom");
}

void write_inputs_of_steps(std::int64_t file, const RunInputs& inputs) {
  if (!inputs.replay_joints.empty()) {
    write_numbers(file, checkpoint::group + "/replay_joint", inputs.replay_joints);
    write_text_attribute(
        write_vectors(file, checkpoint::group + "/replay_force", inputs.replay_forces), "unit",
        "kJ mol-1 Angstrom-1");
  }
  if (!inputs.replay_counts.empty())
    write_numbers(file, checkpoint::group + "/replay_count", inputs.replay_counts);
  if (!inputs.ordering_bars.empty()) {
    write_numbers(file, checkpoint::group + "/ordering_bar", inputs.ordering_bars);
    write_numbers(file, checkpoint::group + "/ordering_near", inputs.ordering_near);
    write_numbers(file, checkpoint::group + "/ordering_is_tree", inputs.ordering_is_tree);
  }
}

void write_guide(std::int64_t file, const RunInputs& inputs) {
  if (inputs.guide_period == 0) return;
  const auto with_unit = [](const Hid& dataset) {
    write_text_attribute(dataset, "unit", "Angstrom");
  };
  const auto name = [](const char* end) { return checkpoint::group + end; };
  write_numbers(file, name("/guide_period"), std::vector<std::int64_t>{inputs.guide_period});
  if (!inputs.guide_rock.empty()) with_unit(write_vectors(file, name("/rock"), inputs.guide_rock));
  if (!inputs.pull_to.empty()) {
    write_numbers(file, name("/pull_joint"), inputs.pull_joints);
    write_numbers(file, name("/pull_group"), inputs.pull_groups);
    with_unit(write_vectors(file, name("/pull_to"), inputs.pull_to));
  }
  if (inputs.pair_least.empty()) return;
  write_numbers(file, name("/pair_joint"), inputs.pair_joints);
  write_numbers(file, name("/pair_group"), inputs.pair_groups);
  with_unit(write_numbers(file, name("/pair_least"), inputs.pair_least));
  with_unit(write_numbers(file, name("/pair_most"), inputs.pair_most));
}

void write_nodes(std::int64_t file, const RunInputs& inputs) {
  if (!inputs.is_sample()) return;
  write_text_attribute(write_vectors(file, checkpoint::nodes, inputs.node_positions), "unit",
                       "Angstrom");
  write_numbers(file, checkpoint::group + "/node_chain", inputs.node_chains);
  write_numbers(file, checkpoint::group + "/node_of_joint", inputs.node_of_joint);
}

void write_framework_bits(std::int64_t file, const Framework& framework, const H5mdHeader& header) {
  if (!says_masses(framework, header.masses)) {
    std::vector<double> masses;
    for (const double inverse : framework.inverse_masses()) masses.push_back(mass_of(inverse));
    write_text_attribute(write_numbers(file, checkpoint::group + "/mass", masses), "unit", "u");
  }
  if (!framework.drawn().empty())
    write_text_attribute(write_vectors(file, checkpoint::group + "/drawn", framework.drawn()),
                         "unit", "Angstrom");
}

}  // namespace

void write_inputs(std::int64_t file, const Framework& framework, const H5mdHeader& header) {
  make_group(file, checkpoint::group);
  write_framework_bits(file, framework, header);
  write_start(file, framework, *header.inputs);
  write_inputs_of_steps(file, *header.inputs);
  write_guide(file, *header.inputs);
  write_nodes(file, *header.inputs);
}

CheckpointWriter::CheckpointWriter(std::int64_t file, const Framework& framework)
    : joint_count_(framework.joint_count()) {
  row_.resize(checkpoint::columns_of(framework));
  dataset_ = write_table(file, checkpoint::state, checkpoint::state_count, row_.size(),
                         std::vector<double>(checkpoint::state_count * row_.size()));
}

CheckpointWriter::CheckpointWriter(std::int64_t file, const Framework& framework,
                                   std::int64_t number)
    : dataset_(owned(H5Dopen2(file, checkpoint::state.c_str(), H5P_DEFAULT), H5Dclose,
                     "open a checkpoint")),
      joint_count_(framework.joint_count()),
      number_(number),
      row_(checkpoint::columns_of(framework)) {}

void CheckpointWriter::write(const Frame& frame) {
  ++number_;
  row_[checkpoint::number_column] = double(number_);
  row_[checkpoint::step_column] = double(frame.step);
  row_[checkpoint::time_column] = frame.time;
  auto at = std::copy_n(numbers_of(frame.positions).begin(), 3 * joint_count_,
                        row_.begin() + checkpoint::head_columns);
  at = std::copy_n(numbers_of(frame.previous).begin(), 3 * joint_count_, at);
  std::fill(at, row_.end(), 0.0);
  std::copy(frame.limits_off.begin(), frame.limits_off.end(), at);
  const auto digest = checkpoint::digest_of(row_);
  std::copy(digest.begin(), digest.end(), row_.begin() + checkpoint::digest_column);
  const hsize_t start[] = {static_cast<hsize_t>(number_) % checkpoint::state_count, 0};
  const hsize_t count[] = {1, row_.size()};
  const Hid space = owned(H5Dget_space(dataset_), H5Sclose, "look at a checkpoint");
  checked(H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, count, nullptr),
          "choose a checkpoint");
  const Hid memory = owned(H5Screate_simple(2, count, nullptr), H5Sclose, "make a dataspace");
  checked(H5Dwrite(dataset_, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, row_.data()),
          "write a checkpoint");
}

}  // namespace pliant
