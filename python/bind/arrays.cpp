// SPDX-License-Identifier: MIT
#include "arrays.hpp"

#include <algorithm>
#include <string>

#include "pliant/base/error.hpp"

namespace pliant::python {
namespace {

bool is_true(nb::handle object) { return nb::cast<bool>(object); }

std::string text_of(nb::handle object) { return nb::cast<std::string>(nb::str(object)); }

std::string class_name(nb::handle object) {
  return nb::cast<std::string>(object.type().attr("__name__"));
}

nb::object numpy(const char* name) { return nb::module_::import_("numpy").attr(name); }

bool is_numpy_array(nb::handle object) { return nb::isinstance(object, numpy("ndarray")); }

/// "a read-only float32 array with shape (5, 2)".
std::string description(nb::handle object) {
  if (!is_numpy_array(object)) return "an object of type " + class_name(object);
  const nb::object flags = object.attr("flags");
  std::string text = is_true(flags.attr("writeable")) ? "an" : "a read-only";
  text +=
      " array of " + text_of(object.attr("dtype")) + " with shape " + text_of(object.attr("shape"));
  if (!is_true(flags.attr("c_contiguous"))) text += " that is not C-contiguous";
  if (!is_true(flags.attr("aligned"))) text += " that is not aligned";
  return text;
}

[[noreturn]] void raise_type(const std::string& message) { throw nb::type_error(message.c_str()); }

bool is_aligned(const void* address) {
  return reinterpret_cast<std::uintptr_t>(address) % alignof(Vec3) == 0;
}

/// Lets `array` be the argument's memory as it is.
template <class Array>
void take_in_place(const PositionsInPlace& argument, const char* shape, Array& array) {
  const bool fits = nb::try_cast(argument.object, array, false);
  if (!fits || !is_aligned(array.data()))
    raise_type("positions: expected a C-contiguous writeable numpy array of float64 with shape " +
               std::string(shape) + ", found " + description(argument.object));
}

/// numpy.asarray(argument), or TypeError if that makes objects or strings of it.
nb::object array_from(const ArrayLike& argument, const char* name, const char* kinds,
                      const char* expected) {
  nb::object array;
  try {
    array = numpy("asarray")(argument.object);
  } catch (nb::python_error&) {
    raise_type(std::string(name) + ": expected an array of " + expected + ", found " +
               description(argument.object));
  }
  const auto kind = nb::cast<std::string>(array.attr("dtype").attr("kind"));
  if (nb::cast<std::size_t>(array.attr("size")) == 0) return array;
  if (std::string_view(kinds).find(kind) == std::string_view::npos)
    raise_type(std::string(name) + ": expected an array of " + expected + ", found " +
               description(array));
  return array;
}

[[noreturn]] void fail_shape(const char* name, const std::string& expected, nb::handle array) {
  throw InputError(std::string(name) + ": expected shape " + expected + ", found " +
                   text_of(array.attr("shape")));
}

std::size_t dimensions(nb::handle array) { return nb::cast<std::size_t>(array.attr("ndim")); }

/// The array with another type of elements, one after another in memory.
template <class T>
nb::ndarray<T, nb::c_contig, nb::device::cpu> packed(nb::handle array, const char* type) {
  const nb::object converted = numpy("ascontiguousarray")(array, nb::arg("dtype") = type);
  return nb::cast<nb::ndarray<T, nb::c_contig, nb::device::cpu>>(converted);
}

template <class T>
std::vector<T> vector_from(nb::handle array, const char* type) {
  const auto values = packed<const T>(array, type);
  return std::vector<T>(values.data(), values.data() + values.size());
}

/// The values row after row.
std::vector<std::int64_t> pair_values(const ArrayLike& argument, const char* name) {
  const nb::object array = array_from(argument, name, "iu", "integers");
  if (nb::cast<std::size_t>(array.attr("size")) == 0) return {};
  if (dimensions(array) != 2 || nb::cast<std::size_t>(array.attr("shape")[nb::int_(1)]) != 2)
    fail_shape(name, "(K, 2)", array);
  return vector_from<std::int64_t>(array, "int64");
}

}  // namespace

ConformersLease::ConformersLease(const PositionsInPlace& argument) {
  take_in_place(argument, "(K, N, 3)", array_);
  all_ = {reinterpret_cast<Vec3*>(array_.data()), array_.shape(0) * array_.shape(1)};
}

PositionsLease::PositionsLease(const PositionsInPlace& argument) {
  take_in_place(argument, "(N, 3)", array_);
  span_ = {reinterpret_cast<Vec3*>(array_.data()), array_.shape(0)};
}

std::vector<Vec3> positions_from(const ArrayLike& argument, const char* name) {
  const nb::object array = array_from(argument, name, "fiu", "real numbers");
  if (dimensions(array) != 2 || nb::cast<std::size_t>(array.attr("shape")[nb::int_(1)]) != 3)
    fail_shape(name, "(N, 3)", array);
  const auto values = packed<const double>(array, "float64");
  std::vector<Vec3> positions(values.shape(0));
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const double* x = values.data() + 3 * i;
    positions[i] = {x[0], x[1], x[2]};
  }
  return positions;
}

std::vector<Vec3> positions_from(const ArrayLike& argument, std::size_t count) {
  std::vector<Vec3> positions = positions_from(argument);
  if (positions.size() != count)
    throw InputError("positions: " + std::to_string(positions.size()) + " for " +
                     std::to_string(count) + " joints");
  return positions;
}

std::vector<double> reals_from(const ArrayLike& argument, const char* name) {
  const nb::object array = array_from(argument, name, "fiu", "real numbers");
  if (dimensions(array) != 1) fail_shape(name, "(K,)", array);
  return vector_from<double>(array, "float64");
}

std::vector<std::int64_t> integers_from(const ArrayLike& argument, const char* name) {
  const nb::object array = array_from(argument, name, "iu", "integers");
  if (dimensions(array) != 1) fail_shape(name, "(K,)", array);
  return vector_from<std::int64_t>(array, "int64");
}

std::vector<std::int64_t> truths_from(const ArrayLike& argument, const char* name) {
  const nb::object array = array_from(argument, name, "b", "truth values");
  if (dimensions(array) != 1) fail_shape(name, "(K,)", array);
  return vector_from<std::int64_t>(array, "int64");
}

std::vector<Bar> pairs_from(const ArrayLike& argument, const char* name, std::size_t joint_count) {
  const std::vector<std::int64_t> values = pair_values(argument, name);
  const auto exists = [&](std::int64_t joint) {
    return joint >= 0 && static_cast<std::uint64_t>(joint) < joint_count;
  };
  std::vector<Bar> pairs(values.size() / 2);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const std::int64_t a = values[2 * k], b = values[2 * k + 1];
    if (!exists(a) || !exists(b))
      throw InputError(std::string(name) + "[" + std::to_string(k) + "] joins joints " +
                       std::to_string(a) + " and " + std::to_string(b) + " but there are " +
                       std::to_string(joint_count) + " joints");
    pairs[k] = {static_cast<Joint>(a), static_cast<Joint>(b)};
  }
  return pairs;
}

std::size_t joints_named_in(const ArrayLike& pairs, const char* name) {
  const std::vector<std::int64_t> values = pair_values(pairs, name);
  const auto largest = std::max_element(values.begin(), values.end());
  return largest == values.end() || *largest < 0 ? 0 : static_cast<std::size_t>(*largest) + 1;
}

std::vector<Joint> joints_from(const ArrayLike& argument, const char* name,
                               std::size_t joint_count) {
  const nb::object array = array_from(argument, name, "iub", "integers or truth values");
  if (dimensions(array) != 1) fail_shape(name, "(K,)", array);
  const bool is_mask = nb::cast<std::string>(array.attr("dtype").attr("kind")) == "b";
  if (is_mask && nb::cast<std::size_t>(array.attr("size")) != joint_count)
    fail_shape(name, "(" + std::to_string(joint_count) + ",)", array);
  const auto indices =
      vector_from<std::int64_t>(is_mask ? numpy("flatnonzero")(array) : array, "int64");
  std::vector<Joint> joints;
  for (std::int64_t joint : indices) {
    if (joint < 0 || static_cast<std::uint64_t>(joint) >= joint_count)
      throw InputError(std::string(name) + ": joint " + std::to_string(joint) + " of " +
                       std::to_string(joint_count) + " does not exist");
    joints.push_back(static_cast<Joint>(joint));
  }
  return joints;
}

PositionsView view_of(std::vector<Vec3>& positions, nb::handle owner) {
  return PositionsView(reinterpret_cast<double*>(positions.data()), {positions.size(), 3}, owner);
}

PositionsView new_positions(std::vector<Vec3> positions) {
  auto* kept = new std::vector<Vec3>(std::move(positions));
  return view_of(*kept, owner_of(kept));
}

std::span<const Vec3> frame_of(const GivenFrames& frames, std::size_t frame) {
  const auto* all = reinterpret_cast<const Vec3*>(frames.data());
  return {all + frame * frames.shape(1), frames.shape(1)};
}

FramesView new_frames(std::vector<Vec3> positions, std::size_t frames, std::size_t joints) {
  auto* kept = new std::vector<Vec3>(std::move(positions));
  return FramesView(reinterpret_cast<double*>(kept->data()), {frames, joints, 3}, owner_of(kept));
}

PositionsConstView const_view_of(std::span<const Vec3> positions, nb::handle owner) {
  return PositionsConstView(reinterpret_cast<const double*>(positions.data()),
                            {positions.size(), 3}, owner);
}

Array1<bool> mask_of(const std::vector<bool>& values) {
  auto* kept = new bool[values.size()];
  nb::capsule owner(kept, [](void* p) noexcept { delete[] static_cast<bool*>(p); });
  std::copy(values.begin(), values.end(), kept);
  return Array1<bool>(kept, {values.size()}, owner);
}

}  // namespace pliant::python
