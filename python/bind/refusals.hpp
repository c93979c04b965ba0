// SPDX-License-Identifier: MIT
// Errors for arguments of a wrong type.
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>
#include <type_traits>

#include "bind.hpp"

namespace pliant::python {

/// Calls `refuse` of pliant.base.refusals, which raises TypeError or OptionError "steps = 2.5: must
/// be a whole number".
[[noreturn]] void refuse_argument(std::string_view name, nb::handle value, const char* type,
                                  nb::object least, nb::object most);

/// `value` as a T of at least `least`. Throws as refuse_argument() if it is not one.
template <class T>
T argument_as(std::string_view name, nb::handle value, const char* type,
              T least = std::numeric_limits<T>::min()) {
  T taken{};
  const bool is_taken =
      !(std::is_same_v<T, double> && nb::isinstance<nb::str>(value)) && nb::try_cast(value, taken);
  if (is_taken) return taken;
  if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>)
    refuse_argument(name, value, type, nb::cast(least), nb::cast(std::numeric_limits<T>::max()));
  refuse_argument(name, value, type, nb::none(), nb::none());
}

/// Makes every function of the module and of its classes name the argument that does not fit, in
/// place of its whole signature.
void name_unfit_arguments(nb::module_& module);

}  // namespace pliant::python
