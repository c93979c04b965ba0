// SPDX-License-Identifier: MIT
#include "resolve/techniques.hpp"

#include <algorithm>

#include "arrays.hpp"

namespace pliant::python {
namespace {

std::string type_of(nb::handle object) {
  return nb::cast<std::string>(object.type().attr("__name__"));
}

/// Copies may be let go in any thread.
std::shared_ptr<nb::object> shared(nb::object object) {
  return {new nb::object(std::move(object)), [](nb::object* kept) {
            const nb::gil_scoped_acquire gil;
            delete kept;
          }};
}

/// Makes a sweep by calling a Python object. The array that it is given outlives no sweep: what is
/// kept of it beyond does not move the framework.
struct SweepOfPython {
  std::shared_ptr<nb::object> callable;
  const Framework* framework = nullptr;

  void operator()(std::span<Vec3> positions, std::int64_t sweep) const {
    const nb::gil_scoped_acquire gil;
    const PositionsView array = new_positions({positions.begin(), positions.end()});
    const nb::object answer =
        (*callable)(array, sweep, nb::cast(*framework, nb::rv_policy::reference));
    if (!answer.is_none())
      throw nb::type_error(
          ("technique: moves positions in place and returns None, but returned " + type_of(answer))
              .c_str());
    const auto* moved = reinterpret_cast<const Vec3*>(array.data());
    std::copy(moved, moved + positions.size(), positions.begin());
  }
};

}  // namespace

void choose(Technique& technique, const TechniqueLike& chosen) {
  if (PyUnicode_Check(chosen.object.ptr()) != 0) {
    technique.name = nb::cast<std::string>(chosen.object);
    technique.sweep = nullptr;
    return;
  }
  if (PyCallable_Check(chosen.object.ptr()) == 0)
    throw nb::type_error(("technique: expected a name in techniques(), or something to be called "
                          "with (positions, sweep, framework), got " +
                          type_of(chosen.object))
                             .c_str());
  technique.name = custom_technique;
  technique.sweep = SweepOfPython{shared(chosen.object)};
}

void show_framework(Technique& technique, const Framework& framework) {
  if (auto* sweep = technique.sweep.target<SweepOfPython>()) sweep->framework = &framework;
}

CallableOf::CallableOf(const Technique& technique) {
  if (const auto* sweep = technique.sweep.target<SweepOfPython>()) callable_ = sweep->callable;
}

int CallableOf::traverse(visitproc visit, void* argument) const {
  return callable_ && callable_->ptr() ? visit(callable_->ptr(), argument) : 0;
}

void CallableOf::clear() {
  if (callable_) callable_->reset();
}

}  // namespace pliant::python
