// SPDX-License-Identifier: MIT
#include "pliant/record/h5md/h5md_frames.hpp"

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "pliant/record/h5md/h5md_static.hpp"
#include "pliant/record/hdf5/hdf5_read.hpp"
#include "pliant/record/hdf5/hdf5_write.hpp"

namespace pliant {
namespace {

/// Number types of a series of numbers.
enum class NumberKind { integer, real, truth, stop, drawn_by };

/// A frame, and how many contacts hold in it.
struct CountedFrame : Frame {
  LimitCounts contacts;
};

/// Which files have an observable.
using O = FrameOrigin;
bool always(const Framework&, O) { return true; }
bool of_limits_or_sterics(const Framework&, O origin) { return origin.has_limits_or_sterics; }
bool of_limits(const Framework& framework, O) { return !framework.limits().empty(); }
bool of_samples(const Framework&, O origin) { return origin.is_sample; }
bool of_walkers(const Framework&, O origin) { return origin.several_walkers; }

/// One row for each observable. MDAnalysis takes numbers with one value for each frame only, no
/// vectors.
struct Observable {
  const char* name;
  const char* unit;  // "" for none
  NumberKind kind;
  bool (*is_of)(const Framework& framework, FrameOrigin origin);
  void (*add)(const CountedFrame& frame, Series& series);
};

constexpr char force_unit[] = "kJ mol-1 Angstrom-1";
using enum NumberKind;
using F = CountedFrame;

constexpr Observable observables[] = {
    {"sweeps", "", integer, always, [](const F& f, Series& s) { s.add(f.sweeps); }},
    {"projections", "", integer, always, [](const F& f, Series& s) { s.add(f.projections); }},
    {"max_residual", "", real, always, [](const F& f, Series& s) { s.add(f.max_residual); }},
    {"rms_residual", "", real, always, [](const F& f, Series& s) { s.add(f.rms_residual); }},
    {"converged", "", truth, always,
     [](const F& f, Series& s) { s.add(std::uint8_t{f.stop == Stop::converged}); }},
    {"stop", "", stop, always,
     [](const F& f, Series& s) { s.add(static_cast<std::uint8_t>(f.stop)); }},
    {"root_joint", "", integer, always, [](const F& f, Series& s) { s.add(f.root_joint); }},
    {"force_x", force_unit, real, always, [](const F& f, Series& s) { s.add(f.force.x); }},
    {"force_y", force_unit, real, always, [](const F& f, Series& s) { s.add(f.force.y); }},
    {"force_z", force_unit, real, always, [](const F& f, Series& s) { s.add(f.force.z); }},
    {"max_limit", "Angstrom", real, of_limits_or_sterics,
     [](const F& f, Series& s) { s.add(f.max_limit); }},
    {"max_overlap", "Angstrom", real, of_limits_or_sterics,
     [](const F& f, Series& s) { s.add(f.max_overlap); }},
    {"contacts_held", "", integer, of_limits,
     [](const F& f, Series& s) { s.add(f.contacts.held); }},
    {"contacts_broken", "", integer, of_limits,
     [](const F& f, Series& s) { s.add(f.contacts.broken); }},
    {"contacts_off", "", integer, of_limits, [](const F& f, Series& s) { s.add(f.contacts.off); }},
    {"redraws", "", integer, of_samples, [](const F& f, Series& s) { s.add(f.redraws); }},
    {"sampler", "", drawn_by, of_samples,
     [](const F& f, Series& s) { s.add(static_cast<std::uint8_t>(f.drawn_by)); }},
    {"walker", "", integer, of_walkers, [](const F& f, Series& s) { s.add(f.walker); }},
};

std::string group_of(const Observable& observable) {
  return std::string(h5md::observables) + "/" + observable.name;
}

template <class Has>
std::vector<std::size_t> rows_that(Has has) {
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < std::size(observables); ++k)
    if (has(observables[k])) rows.push_back(k);
  return rows;
}

std::vector<std::string> stop_names() {
  std::vector<std::string> names;
  for (const Stop stop :
       {Stop::converged, Stop::max_sweeps, Stop::not_finite, Stop::stopped_by_caller})
    names.emplace_back(name(stop));
  return names;
}

std::vector<std::string> drawn_by_names() {
  std::vector<std::string> names;
  for (const DrawnByEntry& row : drawn_by_table()) names.emplace_back(row.name);
  return names;
}

const std::vector<std::string> state_names{"held", "broken", "off"};  // of ContactState

Hid memory_type(NumberKind kind) {
  switch (kind) {
    case integer:
      return owned(H5Tcopy(H5T_NATIVE_INT64), H5Tclose, "copy a type");
    case real:
      return owned(H5Tcopy(H5T_NATIVE_DOUBLE), H5Tclose, "copy a type");
    case truth:
      return boolean_type();
    case drawn_by:
      return named_number_type(drawn_by_names());
    default:
      return named_number_type(stop_names());
  }
}

Series make_series(std::int64_t file, const std::string& path, NumberKind kind) {
  const Hid type = memory_type(kind);
  const std::int64_t little_endian = kind == integer ? H5T_STD_I64LE : H5T_IEEE_F64LE;
  return {file, path, kind == integer || kind == real ? little_endian : std::int64_t{type}, type};
}

/// 0 where positions are as they were.
double recorded_unit(std::int64_t file, const std::string& path) {
  const Hid dataset = owned(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose, "open " + path);
  return number_attribute(dataset, h5md::rounded_to).value_or(0.0);
}

// A chunk of positions holds one frame, which is what readers ask for. Small frames share one:
// every chunk costs its way through a tree.
std::uint64_t frames_per_chunk(std::size_t frame_bytes, bool compress) {
  constexpr std::size_t chunk_bytes = std::size_t{32} << 10;
  // A shared chunk would be compressed anew with each commit and change its place.
  if (compress) return 1;
  return std::clamp<std::uint64_t>(chunk_bytes / frame_bytes, 1, 256);
}

/// The largest power of two that is not above `precision`: multiples of it are exact in binary, and
/// end in zeros.
double rounding_unit(double precision) {
  if (!(precision > 0.0)) return 0.0;
  int exponent = 0;
  std::frexp(precision, &exponent);
  return std::ldexp(0.5, exponent);
}

constexpr const char* position_parts[] = {"/value", "/time", "/step"};

/// A series of its own has the steps and times of the positions.
void link_steps(std::int64_t file, const std::string& group) {
  for (const char* part : {"/time", "/step"})
    checked(H5Lcreate_hard(file, (std::string(h5md::position) + part).c_str(), file,
                           (group + part).c_str(), H5P_DEFAULT, H5P_DEFAULT),
            "link " + group + part);
}

std::string states_path() { return std::string(h5md::contact_states) + "/value"; }

}  // namespace

FrameSeries::FrameSeries(std::int64_t file, const Framework& framework, const H5mdOptions& options,
                         const FrameOrigin& origin)
    : unit_(rounding_unit(options.precision)),
      rows_(rows_that([&](const Observable& one) { return one.is_of(framework, origin); })),
      contacts_(framework.limits()) {
  make_positions(file, framework.joint_count());
  make_observables(file);
  make_contact_states(file);
}

/// A file of an earlier version may have fewer observables.
FrameSeries::FrameSeries(std::int64_t file, const Framework& framework, std::uint64_t frames)
    : rows_(rows_that([&](const Observable& one) { return has_object(file, group_of(one)); })),
      contacts_(framework.limits()) {
  const std::string group = h5md::position;
  unit_ = recorded_unit(file, group + "/value");
  positions_.emplace_back(file, group + "/value", H5T_NATIVE_DOUBLE, frames);
  positions_.emplace_back(file, group + "/time", H5T_NATIVE_DOUBLE, frames);
  positions_.emplace_back(file, group + "/step", H5T_NATIVE_INT64, frames);
  for (const std::size_t row : rows_) {
    const Hid type = memory_type(observables[row].kind);
    observables_.emplace_back(file, group_of(observables[row]) + "/value", type, frames);
  }
  if (contacts_.size() > 0 && has_object(file, h5md::contact_states))
    states_.emplace(file, states_path(), named_number_type(state_names), frames);
  count_bytes(framework.joint_count());
}

void FrameSeries::count_bytes(std::size_t joint_count) {
  frame_bytes_ = (joint_count * 3 + 2 + rows_.size()) * sizeof(double) + contacts_.size();
}

/// In the order value, time, step: HDF5 itself then also writes them in this order.
void FrameSeries::make_positions(std::int64_t file, std::size_t joint_count) {
  count_bytes(joint_count);
  const bool compress = unit_ > 0.0;
  const SeriesLayout layout{.row = {joint_count, 3},
                            .chunk_rows = frames_per_chunk(joint_count * sizeof(Vec3), compress),
                            .compress = compress,
                            .fill_with_nan = true};
  const std::string group = h5md::position;
  make_group(file, group);
  positions_.emplace_back(file, group + "/value", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, layout);
  positions_.push_back(make_series(file, group + "/time", real));
  positions_.push_back(make_series(file, group + "/step", integer));
  write_text_attribute(positions_[0].dataset(), "unit", "Angstrom");
  if (unit_ > 0.0) write_real_attribute(positions_[0].dataset(), h5md::rounded_to, unit_);
  write_text_attribute(positions_[1].dataset(), "unit", "ps");
}

void FrameSeries::make_observables(std::int64_t file) {
  for (const std::size_t row : rows_) {
    const Observable& observable = observables[row];
    const std::string group = group_of(observable);
    make_group(file, group);
    observables_.push_back(make_series(file, group + "/value", observable.kind));
    if (*observable.unit != '\0')
      write_text_attribute(observables_.back().dataset(), "unit", observable.unit);
    link_steps(file, group);
  }
}

void FrameSeries::make_contact_states(std::int64_t file) {
  if (contacts_.size() == 0) return;
  make_group(file, h5md::contact_states);
  const Hid type = named_number_type(state_names);
  const SeriesLayout layout{.row = {contacts_.size()},
                            .chunk_rows = frames_per_chunk(contacts_.size(), false)};
  states_.emplace(file, states_path(), type, type, layout);
  link_steps(file, h5md::contact_states);
}

std::vector<std::uint64_t> FrameSeries::addresses(std::int64_t file) const {
  std::vector<std::uint64_t> addresses;
  for (const std::size_t row : rows_)
    addresses.push_back(object_address(file, group_of(observables[row]) + "/value"));
  if (states_) addresses.push_back(object_address(file, states_path()));
  for (const char* part : position_parts)
    addresses.push_back(object_address(file, std::string(h5md::position) + part));
  return addresses;
}

void FrameSeries::add(const Frame& frame) {
  add_positions(frame.positions);
  positions_[1].add(frame.time);
  positions_[2].add(frame.step);
  const CountedFrame counted{frame,
                             contacts_.count(frame.positions, frame.limits_off, held_within)};
  for (std::size_t k = 0; k < rows_.size(); ++k)
    observables[rows_[k]].add(counted, observables_[k]);
  if (states_) states_->add_bytes(std::as_bytes(contacts_.states()));
  ++waiting_frames_;
}

void FrameSeries::add_positions(std::span<const Vec3> positions) {
  if (unit_ == 0.0) return positions_[0].add_bytes(std::as_bytes(positions));
  for (const Vec3 p : positions)
    for (const double x : {p.x, p.y, p.z}) positions_[0].add(as_recorded(x));
}

/// What a reader finds in its place.
double FrameSeries::as_recorded(double coordinate) const {
  return unit_ > 0.0 ? unit_ * std::nearbyint(coordinate / unit_) : coordinate;
}

bool FrameSeries::last_is(std::span<const Vec3> positions) const {
  const std::vector<double> there = positions_[0].last_row();
  if (there.size() != 3 * positions.size()) return false;
  for (std::size_t i = 0; i < there.size(); ++i) {
    const Vec3 p = positions[i / 3];
    const double x = i % 3 == 0 ? p.x : i % 3 == 1 ? p.y : p.z;
    if (there[i] != as_recorded(x)) return false;
  }
  return true;
}

void FrameSeries::write() {
  for (Series& series : observables_) series.write(waiting_frames_);
  if (states_) states_->write(waiting_frames_);
  for (Series& series : positions_) series.write(waiting_frames_);
  waiting_frames_ = 0;
}

}  // namespace pliant
