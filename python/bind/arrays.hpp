// SPDX-License-Identifier: MIT
// Array arguments and results: numpy arrays as spans of Vec3 without a copy, and array-likes as
// vectors. Objects of a wrong kind raise TypeError, wrong shapes and values InputError; both say
// what was expected and what was found.
#pragma once

#include <nanobind/ndarray.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "bind.hpp"
#include "pliant/base/vec3.hpp"
#include "pliant/framework/framework.hpp"

namespace pliant::python {

/// An argument that numpy.asarray understands.
struct ArrayLike {
  nb::object object;
};

using OptionalArray = std::optional<ArrayLike>;

/// An argument whose memory is used directly, and changed.
struct PositionsInPlace {
  nb::object object;
};

using PositionsView = nb::ndarray<nb::numpy, double, nb::shape<-1, 3>, nb::c_contig>;
/// (F, N, 3)
using FramesView = nb::ndarray<nb::numpy, double, nb::shape<-1, -1, 3>, nb::c_contig>;
/// Frames that are only read, without a copy where they are float64 already.
using GivenFrames = nb::ndarray<const double, nb::shape<-1, -1, 3>, nb::c_contig, nb::device::cpu>;
using PositionsConstView = nb::ndarray<nb::numpy, const double, nb::shape<-1, 3>, nb::c_contig>;

/// Keeps the memory of an (N, 3) array alive while it is used. Made and destroyed with the GIL
/// held.
class PositionsLease {
 public:
  /// Throws TypeError unless the argument is a C-contiguous, writeable, aligned array of float64
  /// with shape (N, 3); never copies.
  explicit PositionsLease(const PositionsInPlace& argument);
  std::span<Vec3> span() const { return span_; }

 private:
  nb::ndarray<double, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu> array_;
  std::span<Vec3> span_;
};

/// The same for a (K, N, 3) array: K sets of positions.
class ConformersLease {
 public:
  explicit ConformersLease(const PositionsInPlace& argument);
  std::size_t count() const { return array_.shape(0); }
  std::span<Vec3> at(std::size_t conformer) const {
    return all_.subspan(conformer * array_.shape(1), array_.shape(1));
  }

 private:
  nb::ndarray<double, nb::shape<-1, -1, 3>, nb::c_contig, nb::device::cpu> array_;
  std::span<Vec3> all_;
};

/// A copy of an (N, 3) array-like of real numbers. `name` is the argument's name in messages.
std::vector<Vec3> positions_from(const ArrayLike& argument, const char* name = "positions");
/// The same. Throws InputError if there are not `count` rows.
std::vector<Vec3> positions_from(const ArrayLike& argument, std::size_t count);

/// A copy of a (K) array-like of real numbers.
std::vector<double> reals_from(const ArrayLike& argument, const char* name);

/// A copy of a (K) array-like of integers; other types are not converted.
std::vector<std::int64_t> integers_from(const ArrayLike& argument, const char* name);

/// A copy of a (K) array-like of truth values; numbers are not converted.
std::vector<std::int64_t> truths_from(const ArrayLike& argument, const char* name);

/// A copy of a (K, 2) array-like of integers, each from 0 to `joint_count` - 1.
/// An empty sequence of any shape is no pair.
std::vector<Bar> pairs_from(const ArrayLike& argument, const char* name, std::size_t joint_count);

/// One more than the largest integer in a (K, 2) array-like of integers.
std::size_t joints_named_in(const ArrayLike& pairs, const char* name);

/// Joints given as indices, or as a mask of `joint_count` truth values.
std::vector<Joint> joints_from(const ArrayLike& argument, const char* name,
                               std::size_t joint_count);

/// Deletes `kept` with the last array that has its memory.
template <class T>
nb::capsule owner_of(std::vector<T>* kept) {
  return {kept, [](void* p) noexcept { delete static_cast<std::vector<T>*>(p); }};
}

/// A view of memory that belongs to `owner`, which the view keeps alive.
PositionsView view_of(std::vector<Vec3>& positions, nb::handle owner);
PositionsConstView const_view_of(std::span<const Vec3> positions, nb::handle owner);

/// Moves `positions` into a new array.
PositionsView new_positions(std::vector<Vec3> positions);
/// The positions (N) of one of them.
std::span<const Vec3> frame_of(const GivenFrames& frames, std::size_t frame);
/// Moves frames of `joints` positions each, one after the other, into a new array.
FramesView new_frames(std::vector<Vec3> positions, std::size_t frames, std::size_t joints);

template <class T>
using Array1 = nb::ndarray<nb::numpy, T, nb::shape<-1>, nb::c_contig>;
template <class T>
using Array2 = nb::ndarray<nb::numpy, T, nb::shape<-1, 2>, nb::c_contig>;

/// A read-only view of memory that belongs to `owner`.
template <class T>
Array1<const T> const_view_of(std::span<const T> values, nb::handle owner) {
  return Array1<const T>(values.data(), {values.size()}, owner);
}

/// Moves `values` into a new array.
template <class T>
Array1<T> array_of(std::vector<T> values) {
  auto* kept = new std::vector<T>(std::move(values));
  return Array1<T>(kept->data(), {kept->size()}, owner_of(kept));
}

/// The same with two columns; `values` holds row after row.
template <class T>
Array2<T> pairs_array_of(std::vector<T> values) {
  auto* kept = new std::vector<T>(std::move(values));
  return Array2<T>(kept->data(), {kept->size() / 2, 2}, owner_of(kept));
}

/// An array of truth values.
Array1<bool> mask_of(const std::vector<bool>& values);

}  // namespace pliant::python

namespace nanobind::detail {

/// Accepts any object and leaves the checks to the function, whose message can say more.
template <>
struct type_caster<pliant::python::ArrayLike> {
  NB_TYPE_CASTER(pliant::python::ArrayLike, const_name("numpy.typing.ArrayLike"))
  bool from_python(handle source, uint32_t, cleanup_list*) noexcept {
    value.object = borrow(source);
    return true;
  }
};

template <>
struct type_caster<pliant::python::PositionsInPlace> {
  NB_TYPE_CASTER(pliant::python::PositionsInPlace,
                 const_name("numpy.typing.NDArray[numpy.float64]"))
  bool from_python(handle source, uint32_t, cleanup_list*) noexcept {
    value.object = borrow(source);
    return true;
  }
};

}  // namespace nanobind::detail
