// SPDX-License-Identifier: MIT
#include "pliant/jobs/replayed_header.hpp"

#include <algorithm>
#include <filesystem>

#include "pliant/base/choices.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/framework/fingerprint.hpp"
#include "pliant/model/model.hpp"
#include "pliant/molecule/stated_bars.hpp"

namespace pliant {
namespace {

std::string compared(std::string_view text, bool is_file) {
  return is_file ? path_text(path_of(text).filename()) : std::string(text);
}

/// "--model protein", "--keep-waters".
std::string spelled(const std::string& option, std::string_view value) {
  if (value == "true" || value == "false") return option;
  return option + " " + printable_name(value);
}

/// The model and the bars are taken by themselves.
bool is_of_header(const OptionFacts& facts) {
  return facts.users.file && facts.name != "model" && facts.name != "bars";
}

class HeaderTaking {
 public:
  HeaderTaking(Job& job, ReplayedForces& replayed)
      : job_(job), replayed_(replayed), options_(job.molecule) {}

  void take() {
    const auto& input = replayed_.header->input;
    for (const ForceSetting& one : input) at_line(one, [&] { check_name(one); });
    take_model();
    for (const OptionRow<MoleculeOptions>& row : molecule_rows())
      if (is_of_header(*row.facts)) take(row);
  }

 private:
  const ForceSetting* find(std::string_view name) const {
    const auto& input = replayed_.header->input;
    const auto found = std::ranges::find(input, name, &ForceSetting::name);
    return found == input.end() ? nullptr : &*found;
  }

  template <class Work>
  void at_line(const ForceSetting& one, Work work) const {
    try {
      work();
    } catch (const OptionError& error) {
      fail({job_.walkers.forces, one.line}, std::string("input: ") + error.what());
    }
  }

  static void check_name(const ForceSetting& one) {
    if (one.name == "model") {
      choose(models(), "model", one.value);
    } else if (one.name != "bars") {
      std::vector<std::string_view> known;
      for (const OptionRow<MoleculeOptions>& row : molecule_rows())
        if (is_of_header(*row.facts)) known.push_back(row.facts->name);
      if (std::ranges::find(known, one.name) == known.end())
        throw OptionError(unknown_choice("option", one.name, known));
    }
  }

  void note(const ForceSetting& one) { replayed_.taken.emplace_back(one.name, one.value); }

  /// The model and the bars exclude each other.
  void take_model() {
    const ForceSetting* named = find("model") ? find("model") : find("bars");
    if (named == nullptr) return;
    const bool is_model = named->name == "model";
    const bool is_given = !options_.model.model.empty() || !options_.bars.bars.empty();
    if (!is_given) {
      (is_model ? options_.model.model : options_.bars.bars) = named->value;
      return note(*named);
    }
    const std::string option = options_.model.model.empty() ? "--bars" : "--model";
    const bool is_same =
        option == "--" + named->name && compared(bars_of(options_), is_bars_file(named->value)) ==
                                            compared(named->value, is_bars_file(named->value));
    if (!is_same)
      refuse_contradiction(job_, spelled(option, bars_of(options_)),
                           "with " + spelled("--" + named->name, named->value));
  }

  void take(const OptionRow<MoleculeOptions>& row) {
    const OptionFacts& facts = *row.facts;
    const std::string option = option_name(facts);
    const ForceSetting* named = find(facts.name);
    if (!job_.was_given(facts.name)) {
      if (named == nullptr) return;
      at_line(*named, [&] { set_option(facts, row.place(options_), named->value); });
      at_line(*named, [&] { check_option(facts, row.place(options_)); });
      return note(*named);
    }
    MoleculeOptions usual;
    const std::string given = option_text(row.place(options_));
    const std::string made = named ? named->value : option_text(row.place(usual));
    if (compared(given, facts.is_file) == compared(made, facts.is_file)) return;
    refuse_contradiction(job_, spelled(option, given),
                         named ? "with " + spelled(option, made) : "without " + option);
  }

  Job& job_;
  ReplayedForces& replayed_;
  MoleculeOptions& options_;
};

/// Nobody can say whether what holds the molecule is what it was made for.
void warn_of_unknown_model(const Job& job, const ForceHeader& header, const RunSubject& subject,
                           const Log& log) {
  const bool is_said = !job.molecule.model.model.empty() || !job.molecule.bars.bars.empty();
  const bool is_known = header.joints.has_value() || !header.input.empty();
  if (is_said || is_known || subject.is_graph()) return;
  log.warn(printable_name(job.walkers.forces) +
           ": does not say for which structure, model and hydrogens it was made: " +
           std::to_string(subject.framework.joint_count()) +
           " joints and --bars bonds are a guess; give its --model or --bars");
}

}  // namespace

void refuse_contradiction(const Job& job, const std::string& given, const std::string& made) {
  throw OptionError(given + ": " + printable_name(job.walkers.forces) + " was made " + made +
                    "; leave the option out");
}

void take_force_header(Job& job, ReplayedForces& replayed) {
  if (job.walkers.forces.empty()) return;
  replayed.text = read_bytes(path_of(job.walkers.forces));
  replayed.header = read_force_header(without_byte_order_mark(replayed.text), job.walkers.forces);
  if (!replayed.header->input.empty()) HeaderTaking(job, replayed).take();
}

void check_force_header(const Job& job, const ReplayedForces& replayed, const RunSubject& subject,
                        const Log& log) {
  if (!replayed.header) return;
  const ForceHeader& header = *replayed.header;
  warn_of_unknown_model(job, header, subject, log);
  std::string what = misfit(header, subject.framework);
  if (!what.empty()) what = "framework: of " + what;
  if (header.structure && subject.fingerprint && *header.structure != *subject.fingerprint)
    what = "structure: with fingerprint " + fingerprint_text(*header.structure) + ", not " +
           fingerprint_text(*subject.fingerprint) + " as of " +
           printable_name(job.molecule.input.file);
  if (!what.empty())
    throw InputError(printable_name(job.walkers.forces) + ": was made for another " + what);
}

}  // namespace pliant
