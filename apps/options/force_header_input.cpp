// SPDX-License-Identifier: MIT
#include "options/force_header_input.hpp"

#include <algorithm>
#include <filesystem>

#include "options/molecule_fields.hpp"
#include "pliant/base/choices.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/framework/fingerprint.hpp"
#include "pliant/model/model.hpp"
#include "pliant/molecule/stated_bars.hpp"

namespace pliant::app {
namespace {

std::string compared(std::string_view text, bool is_file) {
  return is_file ? path_text(path_of(text).filename()) : std::string(text);
}

/// "--model protein", "--keep-waters".
std::string spelled(const std::string& option, std::string_view value) {
  if (value == "true" || value == "false") return option;
  return option + " " + printable_name(value);
}

class HeaderTaking {
 public:
  HeaderTaking(const CommandLine& line, RunSettings& settings)
      : line_(line), settings_(settings), options_(settings.molecule) {}

  void take() {
    const auto& input = settings_.force_header->input;
    for (const ForceSetting& one : input) at_line(one, [&] { check_name(one); });
    take_model();
    for (const MoleculeField& field : molecule_fields()) take(field);
  }

 private:
  const ForceSetting* find(std::string_view name) const {
    const auto& input = settings_.force_header->input;
    const auto found = std::ranges::find(input, name, &ForceSetting::name);
    return found == input.end() ? nullptr : &*found;
  }

  template <class Work>
  void at_line(const ForceSetting& one, Work work) const {
    try {
      work();
    } catch (const OptionError& error) {
      fail({settings_.forces, one.line}, std::string("input: ") + error.what());
    }
  }

  static void check_name(const ForceSetting& one) {
    if (one.name == "model") {
      choose(models(), "model", one.value);
    } else if (one.name != "bars") {
      choose(molecule_fields(), "option", one.name);
    }
  }

  void note(const ForceSetting& one) {
    settings_.taken_from_forces.emplace_back(one.name, one.value);
  }

  /// The model and the bars exclude each other.
  void take_model() {
    const ForceSetting* named = find("model") ? find("model") : find("bars");
    if (named == nullptr) return;
    const bool is_model = named->name == "model";
    const bool is_given = !options_.kind.name.empty() || !options_.bars.empty();
    if (!is_given) {
      (is_model ? options_.kind.name : options_.bars) = named->value;
      return note(*named);
    }
    const std::string option = options_.kind.name.empty() ? "--bars" : "--model";
    const bool is_same =
        option == "--" + named->name && compared(bars_of(options_), is_bars_file(named->value)) ==
                                            compared(named->value, is_bars_file(named->value));
    if (!is_same)
      overrides_forces(settings_, spelled(option, bars_of(options_)),
                       "with " + spelled("--" + named->name, named->value));
  }

  bool was_given(const MoleculeField& field) const {
    const bool is_number_of_model =
        field.name == "frame" && line_.was_given("--model") && options_.kind.name.empty();
    return line_.was_given(field.option) || is_number_of_model;
  }

  void take(const MoleculeField& field) {
    const ForceSetting* named = find(field.name);
    if (!was_given(field)) {
      if (named == nullptr) return;
      at_line(*named, [&] { set_molecule_field(options_, field, named->value); });
      return note(*named);
    }
    const std::string given = molecule_field_text(options_, field);
    const std::string made = named ? named->value : molecule_field_text({}, field);
    if (compared(given, field.is_file) == compared(made, field.is_file)) return;
    overrides_forces(
        settings_, spelled(field.option, given),
        named ? "with " + spelled(field.option, made) : std::string("without ") + field.option);
  }

  const CommandLine& line_;
  RunSettings& settings_;
  MoleculeOptions& options_;
};

/// Nobody can say whether what holds the molecule is what it was made for.
void warn_of_unknown_model(const RunSettings& settings, const Molecule& molecule, const Log& log) {
  const ForceHeader& header = *settings.force_header;
  const bool is_said = !settings.molecule.kind.name.empty() || !settings.molecule.bars.empty();
  const bool is_known = header.joints.has_value() || !header.input.empty();
  if (is_said || is_known || molecule.structure.format == "graph") return;
  log.warn(printable_name(settings.forces) +
           ": does not say for which structure, model and hydrogens it was made: " +
           std::to_string(molecule.framework.joint_count()) +
           " joints and --bars bonds are a guess; give its --model or --bars");
}

}  // namespace

bool overrides_forces(const RunSettings& settings, const std::string& given,
                      const std::string& made) {
  if (settings.override_forces) return true;
  throw OptionError(given + ": " + printable_name(settings.forces) + " was made " + made +
                    "; leave the option out, or give --override-forces to go by the command line");
}

void take_force_header(const CommandLine& line, RunSettings& settings) {
  if (settings.forces.empty()) {
    if (settings.override_forces) throw OptionError("--override-forces: goes with --forces");
    return;
  }
  settings.force_text = read_bytes(path_of(settings.forces));
  settings.force_header =
      read_force_header(without_byte_order_mark(settings.force_text), settings.forces);
  if (!settings.force_header->input.empty()) HeaderTaking(line, settings).take();
}

void check_force_header(const RunSettings& settings, const Molecule& molecule, const Log& log) {
  if (!settings.force_header) return;
  const ForceHeader& header = *settings.force_header;
  warn_of_unknown_model(settings, molecule, log);
  std::string what = misfit(header, molecule.framework);
  if (!what.empty()) what = "framework: of " + what;
  if (header.structure && *header.structure != molecule.fingerprint)
    what = "structure: with fingerprint " + fingerprint_text(*header.structure) + ", not " +
           fingerprint_text(molecule.fingerprint) + " as of " +
           printable_name(settings.molecule.file);
  if (what.empty()) return;
  what = printable_name(settings.forces) + ": was made for another " + what;
  if (!settings.override_forces)
    throw InputError(what + "; --override-forces replays it all the same");
  log.warn(what);
}

}  // namespace pliant::app
