// SPDX-License-Identifier: MIT
#include "pliant/record/h5md/h5md_frame_reader.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "pliant/base/error.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/record/h5md/h5md_static.hpp"

namespace pliant {
namespace {

struct UnitOfMeasure {
  std::string_view name;
  double factor;  // our units in one of it
};

// The names that MDAnalysis takes, and a few more. Angstrom and ps are ours.
constexpr UnitOfMeasure length_units[] = {{"Angstrom", 1.0}, {"angstrom", 1.0}, {"A", 1.0},
                                          {"nm", 10.0},      {"pm", 1e-2},      {"fm", 1e-5},
                                          {"um", 1e4},       {"m", 1e10}};
constexpr UnitOfMeasure time_units[] = {{"ps", 1.0}, {"fs", 1e-3}, {"ns", 1e3},      {"us", 1e6},
                                        {"ms", 1e9}, {"s", 1e12},  {"second", 1e12}, {"sec", 1e12}};

template <std::size_t count>
double factor_of(const std::string& name, const UnitOfMeasure (&units)[count],
                 const std::string& path) {
  for (const UnitOfMeasure& unit : units)
    if (unit.name == name) return unit.factor;
  std::string known;
  for (const UnitOfMeasure& unit : units) known.append(known.empty() ? "" : ", ").append(unit.name);
  throw InputError(path + " has the unit " + pliant::quoted(name) + "; known: " + known);
}

std::string list_of(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names)
    text.append(text.empty() ? "" : ", ").append(pliant::quoted(name));
  return text.empty() ? "none" : text;
}

bool is_number_a_frame(const Hdf5Dataset& dataset) {
  return dataset.extents().size() == 1 && dataset.value_class() < ValueClass::text;
}

std::string choose_group(std::int64_t file, const std::string& asked) {
  std::string wanted = asked.empty() ? "trajectory" : asked;
  if (has_object(file, "/particles") && has_object(file, "/particles/" + wanted)) return wanted;
  const std::vector<std::string> names = names_in(file, "/particles");
  if (!asked.empty())
    throw InputError("no group " + pliant::quoted(asked) +
                     " in /particles; there are: " + list_of(names));
  for (const std::string& name : names)
    if (has_object(file, "/particles/" + name + "/position/value")) return name;
  throw InputError("no group with positions in /particles; groups of the file: " +
                   list_of(names_in(file, "/")) + "; of /particles: " + list_of(names));
}

}  // namespace

Counter::Counter(std::int64_t file, const std::string& path) {
  if (!has_object(file, path)) return;
  dataset_.emplace(file, path);
  if (dataset_->extents().size() > 1)
    throw InputError(path + " has shape " + dataset_->shape() + "; expected one value a frame");
  if (is_explicit()) return;
  increment_ = dataset_->reals().at(0);
  offset_ = number_attribute(dataset_->id(), "offset").value_or(0.0);
}

std::uint64_t Counter::count() const {
  return is_explicit() ? dataset_->extents()[0] : std::numeric_limits<std::uint64_t>::max();
}

template <class T>
T Counter::at(std::int64_t frame) const {
  if (!exists()) return static_cast<T>(frame);
  if (!is_explicit()) return static_cast<T>(offset_ + double(frame) * increment_);
  T value{};
  dataset_->read_rows(static_cast<std::uint64_t>(frame), 1, std::span(&value, 1));
  return value;
}

template <class T>
std::vector<T> Counter::all(std::int64_t frames) const {
  std::vector<T> values(static_cast<std::size_t>(frames));
  if (is_explicit()) {
    dataset_->read_rows(0, values.size(), values);
  } else {
    for (std::int64_t k = 0; k < frames; ++k) values[static_cast<std::size_t>(k)] = at<T>(k);
  }
  return values;
}

FrameReader::FrameReader(std::int64_t file, const std::string& asked, const std::string& file_name,
                         const Log& log)
    : file_(file),
      file_name_(file_name),
      log_(log),
      group_(choose_group(file, asked)),
      position_("/particles/" + group_ + "/position") {
  open_positions();
  open_units();
  count_frames();
  check_steps();
}

void FrameReader::open_positions() {
  if (!has_object(file_, position_ + "/value"))
    throw InputError("no positions: " + position_ + "/value is missing");
  value_.emplace(file_, position_ + "/value");
  if (value_->value_class() >= ValueClass::text)
    throw InputError(value_->path() + " has no numbers");
  const auto& extents = value_->extents();
  if (extents.size() != 3 || extents[2] != 3)
    throw InputError(value_->path() + " has shape " + value_->shape() +
                     "; expected (frames, joints, 3)");
  if (extents[1] >= std::numeric_limits<Joint>::max() || extents[0] > (std::uint64_t{1} << 62))
    throw InputError(value_->path() + " states shape " + value_->shape());
  joint_count_ = extents[1];
  step_.emplace(file_, position_ + "/step");
  time_.emplace(file_, position_ + "/time");
}

void FrameReader::open_units() {
  if (const auto unit = text_attribute(value_->id(), "unit"))
    length_factor_ = factor_of(*unit, length_units, value_->path());
  else
    log_.warn(file_name_ + ": " + value_->path() + " has no unit; Angstrom assumed");
  if (!time_->exists()) return;
  if (const auto unit = text_attribute(time_->dataset().id(), "unit"))
    time_factor_ = factor_of(*unit, time_units, time_->dataset().path());
  else
    log_.warn(file_name_ + ": " + time_->dataset().path() + " has no unit; ps assumed");
}

void FrameReader::count_frames() {
  const std::uint64_t positions = value_->extents()[0];
  const std::uint64_t frames = std::min({positions, step_->count(), time_->count()});
  std::uint64_t most = positions;
  if (step_->is_explicit()) most = std::max(most, step_->count());
  if (time_->is_explicit()) most = std::max(most, time_->count());
  frames_ = static_cast<std::int64_t>(frames);
  frames_left_out_ = static_cast<std::int64_t>(most - frames);
  if (frames_left_out_ > 0)
    log_.note(file_name_ + ": " + std::to_string(frames_left_out_) + " of " + std::to_string(most) +
              " frames left out: they lack positions, step or time");
}

void FrameReader::check_steps() const {
  if (!step_->is_explicit() || frames_ == 0) return;
  if (has_object(file_, "/observables") && has_object(file_, "/observables/walker"))
    return;  // of several walkers, the steps of each begin anew
  step_->dataset().check_plausible(static_cast<std::uint64_t>(frames_));
  std::array<std::int64_t, 4096> steps;
  std::int64_t last = std::numeric_limits<std::int64_t>::min();
  for (std::int64_t first = 0; first < frames_; first += std::int64_t{steps.size()}) {
    const auto count = std::min<std::int64_t>(frames_ - first, steps.size());
    step_->dataset().read_rows(static_cast<std::uint64_t>(first), static_cast<std::uint64_t>(count),
                               steps);
    for (std::int64_t k = 0; k < count; last = steps[static_cast<std::size_t>(k++)]) {
      const std::int64_t step = steps[static_cast<std::size_t>(k)];
      if (first + k == 0 || step > last) continue;
      log_.warn(file_name_ + ": steps do not increase: frame " + std::to_string(first + k) +
                " has step " + std::to_string(step) + " after " + std::to_string(last));
      return;
    }
  }
}

void FrameReader::check_frame(std::int64_t frame) const {
  if (frame < 0 || frame >= frames_)
    throw InputError("no frame " + std::to_string(frame) + ": there are " +
                     std::to_string(frames_) + ", counted from 0");
}

std::vector<Vec3> FrameReader::positions(std::int64_t frame) const {
  check_frame(frame);
  value_->check_plausible(3 * joint_count_);
  std::vector<Vec3> positions(joint_count_);
  read_positions(frame, positions);
  return positions;
}

void FrameReader::read_positions(std::int64_t frame, std::span<Vec3> positions) const {
  check_frame(frame);
  if (positions.size() != joint_count_)
    throw InputError("room for " + std::to_string(positions.size()) + " positions of " +
                     std::to_string(joint_count_));
  if (positions.empty()) return;
  value_->read_rows(static_cast<std::uint64_t>(frame), 1,
                    std::span(&positions[0].x, 3 * positions.size()));
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (!is_finite(positions[i]))
      throw InputError("frame " + std::to_string(frame) + " is damaged: the position of joint " +
                       std::to_string(i) + " is not finite");
    if (length_factor_ != 1.0) positions[i] *= length_factor_;
  }
}

std::vector<Vec3> FrameReader::block(std::int64_t first, std::int64_t count) const {
  if (count == 0) return {};
  check_frame(first);
  check_frame(first + count - 1);
  const auto frames = static_cast<std::uint64_t>(count);
  value_->check_plausible(3 * joint_count_ * frames);
  std::vector<Vec3> positions(joint_count_ * frames);
  if (positions.empty()) return positions;
  value_->read_rows(static_cast<std::uint64_t>(first), frames,
                    std::span(&positions[0].x, 3 * positions.size()));
  if (length_factor_ != 1.0)
    for (Vec3& position : positions) position *= length_factor_;
  return positions;
}

double FrameReader::rounded_to() const {
  const double unit = number_attribute(value_->id(), h5md::rounded_to).value_or(0.0);
  return unit > 0.0 && unit < 1.0 ? unit * length_factor_ : 0.0;
}

std::int64_t FrameReader::step(std::int64_t frame) const {
  check_frame(frame);
  return step_->at<std::int64_t>(frame);
}

double FrameReader::time(std::int64_t frame) const {
  check_frame(frame);
  if (!has_time()) throw InputError(position_ + " has no times");
  return time_->at<double>(frame) * time_factor_;
}

std::vector<std::int64_t> FrameReader::steps() const { return step_->all<std::int64_t>(frames_); }

std::vector<double> FrameReader::times() const {
  if (!has_time()) return {};
  std::vector<double> times = time_->all<double>(frames_);
  for (double& time : times) time *= time_factor_;
  return times;
}

std::vector<std::string> FrameReader::observables() const {
  constexpr std::string_view ending = "/value";
  std::vector<std::string> names;
  for (const std::string& path : datasets_below(file_, "/observables")) {
    if (!path.ends_with(ending)) continue;
    if (is_number_a_frame({file_, "/observables/" + path}))
      names.push_back(path.substr(0, path.size() - ending.size()));
  }
  return names;
}

Hdf5Dataset FrameReader::open_observable(const std::string& name) const {
  const std::string path = "/observables/" + name + "/value";
  if (has_object(file_, path)) {
    Hdf5Dataset found(file_, path);
    if (is_number_a_frame(found)) return found;
  }
  throw InputError("no observable " + pliant::quoted(name) +
                   "; there are: " + list_of(observables()));
}

SeriesKind FrameReader::kind_of(const std::string& observable) const {
  switch (open_observable(observable).value_class()) {
    case ValueClass::real:
      return SeriesKind::real;
    case ValueClass::truth:
      return SeriesKind::truth;
    default:
      return SeriesKind::whole;
  }
}

std::vector<std::uint8_t> FrameReader::contact_states() const {
  const std::string path = std::string(h5md::contact_states) + "/value";
  if (!has_object(file_, path)) return {};
  const Hdf5Dataset dataset(file_, path);
  if (dataset.extents().size() != 2)
    throw InputError(path + " has shape " + dataset.shape() + "; expected (frames, contacts)");
  constexpr std::uint64_t at_once = 256;
  const auto frames = std::min(dataset.extents()[0], static_cast<std::uint64_t>(frames_));
  dataset.check_plausible(frames * dataset.extents()[1]);
  std::vector<std::uint8_t> states;
  for (std::uint64_t first = 0; first < frames; first += at_once) {
    const std::uint64_t count = std::min(frames - first, at_once);
    std::vector<std::int64_t> rows(count * dataset.extents()[1]);
    dataset.read_rows(first, count, rows);
    states.insert(states.end(), rows.begin(), rows.end());
  }
  return states;
}

std::vector<double> FrameReader::observable(const std::string& name) const {
  const Hdf5Dataset dataset = open_observable(name);
  const auto count = std::min(dataset.extents()[0], static_cast<std::uint64_t>(frames_));
  dataset.check_plausible(count);
  std::vector<double> values(count);
  dataset.read_rows(0, count, values);
  return values;
}

}  // namespace pliant
