// SPDX-License-Identifier: MIT
#include "option_fields.hpp"

#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/variant.h>

#include <cctype>
#include <cmath>
#include <filesystem>
#include <optional>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/base/system/path_text.hpp"
#include "refusals.hpp"

namespace pliant::python {

namespace {

constexpr const char* names_type = "collections.abc.Sequence[str]";

/// The text of what a script may give where it is no text: a number, a path, nothing. Whichever of
/// these the types name.
std::optional<std::string> text_from(nb::handle value, std::string_view types) {
  const auto may_be = [&](std::string_view type) { return types.find(type) != types.npos; };
  if (value.is_none() && may_be("None")) return "";
  if (nb::isinstance<nb::float_>(value) && may_be("float"))
    return shortest_text(nb::cast<double>(value));
  if (nb::isinstance<nb::int_>(value) && !nb::isinstance<nb::bool_>(value) &&
      (may_be("int") || may_be("float")))
    return nb::cast<std::string>(nb::str(value));
  if (nb::hasattr(value, "__fspath__") && may_be("PathLike"))
    return path_text(nb::cast<std::filesystem::path>(value));
  return std::nullopt;
}

/// "int | str | None", or the type of the place.
std::string type_of(const OptionFacts& facts, OptionPlace place) {
  return facts.type_in_python.empty() ? python_type(place) : std::string(facts.type_in_python);
}

/// The default, as Python writes it.
std::string usual_text(const OptionFacts& facts, OptionPlace place) {
  if (facts.type_in_python.ends_with("None")) return "None";
  if (const auto* names = std::get_if<OptionNames*>(&place)) {
    std::string text;
    for (const std::string& name : **names) text += (text.empty() ? "'" : ", '") + name + "'";
    return "(" + text + ((*names)->size() == 1 ? ",)" : ")");
  }
  return nb::cast<std::string>(nb::repr(value_of(place)));
}

/// True and False are integers to Python, so they come first.
Parameter parameter_from(const std::string& path, nb::handle value) {
  const auto fail = [&](const std::string& why) {
    return OptionError("parameters[\"" + path + "\"]: " + why);
  };
  try {
    if (nb::isinstance<nb::bool_>(value)) return nb::cast<bool>(value);
    if (nb::isinstance<nb::int_>(value)) return nb::cast<std::int64_t>(value);
    if (nb::isinstance<nb::str>(value)) return nb::cast<std::string>(value);
  } catch (const std::bad_cast&) {
    throw fail("does not fit into 64 bits, or is no Unicode text");
  }
  if (!nb::isinstance<nb::float_>(value)) throw fail("expected a bool, int, float or str");
  const auto real = nb::cast<double>(value);
  if (!std::isfinite(real)) throw fail("is not finite");
  return real;
}

}  // namespace

const char* python_type(OptionPlace place) {
  constexpr const char* types[] = {"bool",
                                   "int",
                                   "int",
                                   "float",
                                   "str",
                                   names_type,
                                   "collections.abc.Sequence[collections.abc.Sequence[str]]"};
  return types[place.index()];
}

std::string docstring(std::string_view summary) {
  std::string text(summary);
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  if (!text.ends_with('.')) text += ".";
  return text;
}

nb::object value_of(OptionPlace place) {
  return std::visit([](const auto* value) { return nb::cast(*value); }, place);
}

void take_value(const OptionFacts& facts, OptionPlace place, nb::handle value) {
  std::visit(
      [&](auto* to) {
        using Value = std::remove_pointer_t<decltype(to)>;
        const std::string types = type_of(facts, place);
        const char* type = types.c_str();
        if constexpr (std::is_same_v<Value, std::string>)
          if (!facts.type_in_python.empty())
            if (const auto text = text_from(value, types)) return void(*to = *text);
        if constexpr (std::is_same_v<Value, std::int64_t>)
          *to = argument_as<Value>(facts.name, value, type, facts.range == Range::positive ? 1 : 0);
        else
          *to = argument_as<Value>(facts.name, value, type);
      },
      place);
}

bool may_be_none(const OptionFacts& facts, OptionPlace place) {
  const bool is_text = std::holds_alternative<std::string*>(place);
  return !facts.unset_means.empty() || (!is_text && facts.type_in_python.ends_with("None"));
}

std::string literal_type(const std::vector<std::string_view>& names) {
  std::string text;
  for (const std::string_view name : names)
    text += (text.empty() ? "'" : ", '") + std::string(name) + "'";
  return "typing.Literal[" + text + "]";
}

std::string argument_text(const OptionFacts& facts, OptionPlace place) {
  const std::string name(facts.name);
  if (!facts.unset_means.empty()) return name + ": " + python_type(place) + " | None = None";
  std::string type = type_of(facts, place);
  if (facts.choices != nullptr) {
    std::vector<std::string_view> names = facts.choices();
    if (!facts.automatic.empty()) names.insert(names.begin(), facts.automatic);
    type = literal_type(names) + (type.ends_with(" | None") ? " | None" : "");
  }
  return name + ": " + type + " = " + usual_text(facts, place);
}

std::string argument_doc(const OptionFacts& facts, OptionPlace place) {
  const bool is_same = facts.in_python.empty();
  std::string text = docstring(is_same ? facts.summary : facts.in_python);
  if (is_same && !facts.unset_means.empty())
    text += "\nDefault: " + std::string(facts.unset_means) + ".";
  for (std::size_t at = text.find('\n'); at != text.npos; at = text.find('\n', at + 1))
    text.insert(at + 1, "    ");
  std::string type = type_of(facts, place) + (facts.unset_means.empty() ? "" : " | None");
  if (type == names_type) type = "sequence of str";
  if (const auto at = type.find("str | os.PathLike[str]"); at != type.npos)
    type.replace(at, 22, "str or path");
  if (type.ends_with(" | None")) type = type.substr(0, type.size() - 7) + ", optional";
  return std::string(facts.name) + " : " + type + "\n    " + text + "\n";
}

nb::dict row_of(const OptionFacts& facts, OptionPlace place) {
  nb::dict row;
  row["name"] = facts.name;
  row["help"] = facts.summary;
  row["type"] = python_type(place);
  row["default"] = value_of(place);
  row["group"] = facts.group;
  row["kind"] = facts.kind;
  if (facts.letter != 0) row["letter"] = std::string(1, facts.letter);
  if (!facts.opposite.empty()) row["opposite"] = facts.opposite;
  if (!facts.unset_means.empty()) row["unset_means"] = facts.unset_means;
  if (facts.words > 0) row["words"] = facts.words;
  if (facts.is_file) row["is_file"] = true;
  if (facts.choices != nullptr) {
    std::vector<std::string_view> names = facts.choices();
    if (!facts.automatic.empty()) names.insert(names.begin(), facts.automatic);
    row["choices"] = nb::cast(names);
  }
  if (std::holds_alternative<std::int64_t*>(place)) {
    row["least"] = least_taken(facts);
    row["most"] = largest_taken(facts);
  }
  return row;
}

nb::dict parameters_to_python(const std::vector<NamedParameter>& parameters) {
  nb::dict values;
  for (const auto& [path, value] : parameters) values[path.c_str()] = nb::cast(value);
  return values;
}

std::vector<NamedParameter> parameters_from(const nb::dict& values) {
  std::vector<NamedParameter> parameters;
  for (const auto& [key, value] : values) {
    if (!nb::isinstance<nb::str>(key)) throw OptionError("parameters: a path is no str");
    const auto path = nb::cast<std::string>(key);
    parameters.emplace_back(path, parameter_from(path, value));
  }
  return parameters;
}

void refuse_unknown(nb::handle function, nb::tuple positional, nb::dict left) {
  if (left.size() == 0) return;
  nb::module_::import_("pliant.base.refusals").attr("refuse_call")(function, positional, left);
  throw nb::type_error("an argument does not fit");  // refuse_call() raises for a name unknown
}

}  // namespace pliant::python
