// SPDX-License-Identifier: MIT
// Texts of files in Python: one as a string, a column of them as an array.
#pragma once

#include <string>
#include <string_view>

#include "bind.hpp"

namespace pliant::python {

/// Text of a file as a Python string: bytes that are not UTF-8 become U+FFFD.
inline nb::object text_object(std::string_view text) {
  return nb::steal(
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace"));
}

/// An array of the strings in a list.
inline nb::object text_array(const nb::list& texts) {
  const nb::object numpy = nb::module_::import_("numpy");
  return numpy.attr("array")(texts, nb::arg("dtype") = numpy.attr("str_"));
}

/// An array of `count` strings.
template <class TextOf>
nb::object text_array(std::size_t count, TextOf text_of) {
  nb::list texts;
  for (std::size_t i = 0; i < count; ++i) texts.append(text_object(text_of(i)));
  return text_array(texts);
}

/// The insertion code of a residue; "" for none.
inline std::string_view insertion_text(const char& code) {
  return {&code, code == ' ' ? std::size_t{0} : std::size_t{1}};
}

/// Adds a property that is such an array.
template <class Class, class Getter>
void def_text(nb::class_<Class>& to, const char* name, Getter getter, const char* doc) {
  const std::string signature =
      std::string("def ") + name + "(self) -> numpy.typing.NDArray[numpy.str_]";
  to.def_prop_ro(name, getter, nb::sig(signature.c_str()), doc);
}

}  // namespace pliant::python
