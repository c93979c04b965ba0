// SPDX-License-Identifier: MIT
#include "pliant/sample/sample_fields.hpp"

#include <algorithm>
#include <string>

#include "pliant/base/choices.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/sample/pocket/held_contacts.hpp"
#include "pliant/sample/pocket/pocket.hpp"
#include "pliant/sample/samplers.hpp"

namespace pliant {
namespace {

constexpr std::string_view group = "Sampling";
constexpr std::int64_t most_frames = 100'000'000;

// Texts of rows that samplers say.
const std::string frames_text = usual_frames_text();
const std::string frames_in_python = "How many, from 1. Default: " + usual_frames_text("``") + ".";
const std::string sampler_text = "way to move; auto: " + usual_sampler_text();
const std::string sampler_in_python =
    "A name in ``samplers()``, or ``auto``: " + usual_sampler_text("``") +
    ",\nwhich have no amplitude.";

const std::string amplitude_text =
    "how far frames go: r.m.s. fluctuation, averaged over residues. An input:\nX: in Angstrom "
    "(default " +
    number_text(usual_amplitude) +
    ", which is that of ubiquitin by NMR, 2K39)\n"
    "bfactors: from the B factors in the file, sqrt(3 B / 8 pi^2)\n"
    "FILE: from your own ensemble: models (PDB, mmCIF) or frames (H5MD) of the\n"
    "same residues, with the same numbers";
const std::string amplitude_in_python =
    "Mean r.m.s. fluctuation of residues (Angstrom), ``\"bfactors\"``, or a file of models or\n"
    "frames; " +
    number_text(usual_amplitude) + " if none is given. Samplers ``torsions`` take none.";

const std::string near_text =
    "(a ligand), those within " + number_text(place_distance) + " Angstrom";
const std::string around_text =
    "open or close the site around these atoms (--sampler pocket): the protein\n"
    "residues selected, or, if none is " +
    near_text +
    ";\nthe ligand itself gets other torsions; with a small --amplitude mostly side chains move";
const std::string around_in_python =
    "Selection of atoms: frames open or close the site around them (sampler ``pocket``): the\n"
    "protein residues selected, or, if none is " +
    near_text + ".\nThe ligand itself gets other torsions.";

const std::string hold_text =
    "contacts that the ligand of --around keeps in all frames (default\nmetal,salt_bridge): " +
    hold_names() + ";\nothers are let go where its torsions tear them";
const std::string hold_in_python =
    "Contacts that the ligand of ``around`` keeps in all frames: " + hold_names("``") +
    ".\nOthers are let go where its torsions tear them.";

template <auto... Members>
constexpr auto at = place_at<SampleOptions, Members...>;

const SampleField table[] = {
    {{.name = "frames",
      .group = group,
      .summary = "frames to write",
      .range = Range::positive,
      .in_python = frames_in_python,
      .most = most_frames,
      .unset_means = frames_text},
     at<&SampleOptions::frames>},
    {{.name = "first_frame",
      .group = group,
      .summary = "number of the first frame, if an ensemble is made in pieces",
      .range = Range::zero_or_more,
      .in_python = "Number of the first frame: a run may be made in pieces.",
      .most = most_frames,
      .users = {.command = false}},
     at<&SampleOptions::first_frame>},
    {{.name = "amplitude",
      .group = group,
      .summary = amplitude_text,
      .kind = "X, NAME or FILE",
      .in_python = amplitude_in_python,
      .users = {.page = false},
      .recorded = "sample/amplitude_from",
      .type_in_python = "float | str | os.PathLike[str] | None"},
     at<&SampleOptions::amplitude_from>},
    // What was found, in Angstrom.
    {{.name = "amplitude",
      .group = group,
      .summary = "how far frames go: r.m.s. fluctuation, averaged over residues",
      .range = Range::positive,
      .unit = "Angstrom",
      .users = {.command = false, .job = false, .python = false}},
     at<&SampleOptions::amplitude>},
    {{.name = "seed",
      .group = group,
      .summary = "seed of all random numbers",
      .in_python = "Of all random numbers. Frames are a function of the model, the seed and their\n"
                   "number."},
     at<&SampleOptions::seed>},
    {{.name = "threads",
      .group = group,
      .summary = "threads that share the frames",
      .range = Range::positive,
      .in_python = "From 1; changes no result. Default: all cores.",
      .most = 4096,
      .unset_means = "all cores",
      .users = {.page = false, .file = false}},
     at<&SampleOptions::threads>},
    {{.name = "sampler",
      .group = group,
      .summary = sampler_text,
      .choices = [] { return names_of(samplers()); },
      .kind = "sampler",
      .in_python = sampler_in_python,
      .automatic = automatic_sampler},
     at<&SampleOptions::sampler>},
    {{.name = "near_frames",
      .group = group,
      .summary = "of sampler reach: how many frames come first, made as by sampler modes",
      .range = Range::zero_or_more,
      .is_optional = true,
      .in_python =
          "Of sampler ``reach``: frames below this number are those of ``modes``. 0: half of\n"
          "the frames, in whole hundreds.",
      .most = most_frames,
      .users = {.command = false}},
     at<&SampleOptions::near_frames>},
    {{.name = "around",
      .group = group,
      .summary = around_text,
      .kind = "SELECTION",
      .in_python = around_in_python,
      .users = {.page = false}},
     at<&SampleOptions::around>},
    {{.name = "hold",
      .group = group,
      .summary = hold_text,
      .in_python = hold_in_python,
      .users = {.page = false}},
     at<&SampleOptions::hold>},
    {{.name = "contact_energy",
      .group = group,
      .summary = "of --sampler dilute, kcal/mol: a contact of energy E is off with\n"
                 "probability exp(-|E| / X)",
      .range = Range::positive,
      .unit = "kcal/mol",
      .in_python =
          "Of sampler ``dilute`` (kcal/mol): a contact of energy E is off with probability\n"
          "exp(-abs(E) / contact_energy)."},
     at<&SampleOptions::contact_energy>},
    {{.name = "amides",
      .group = group,
      .summary = "of --sampler torsions: secondary amides, ureas and carbamates are also drawn\n"
                 "as cis and trans, as tertiary amides always are",
      .in_python =
          "Of sampler ``torsions``: secondary amides, ureas and carbamates turn from cis to\n"
          "trans, too, as tertiary amides do anyway.",
      .users = {.page = false}},
     at<&SampleOptions::amides>},
};

}  // namespace

std::span<const SampleField> sample_fields() { return table; }

void check(const SampleOptions& options) {
  if (options.frames < 1)
    throw OptionError(
        "frames = " + std::to_string(options.frames) +
        ": must be a whole number from 1, such as frames=" + std::to_string(usual_frames));
  if (options.first_frame < 0)
    throw OptionError("first_frame = " + std::to_string(options.first_frame) +
                      ": must be a whole number from 0");
  for (const SampleField& field : sample_fields())
    check_option(field, field.place(places_of(options)));
  check_hold(options.hold);
}

std::int64_t near_frames_of(const SampleOptions& options) {
  if (options.near_frames > 0) return options.near_frames;
  if (options.first_frame > 0)
    throw OptionError(
        "sampler " + options.sampler + ": frames that begin at " +
        std::to_string(options.first_frame) +
        " are a piece of an ensemble; give each piece the same number of near frames");
  return std::max(options.frames / (2 * near_block) * near_block, near_block);
}

SampleOptions unset_sample_options() {
  SampleOptions options;
  leave_open(sample_fields(), options);
  options.frames = open_frames;
  return options;
}

std::vector<NamedParameter> parameters_of(const SampleOptions& options) {
  return option_parameters("sample", sample_fields(), options);
}

SampleOptions sample_options_from(const std::vector<NamedParameter>& parameters) {
  SampleOptions options;
  restore_options("sample", sample_fields(), parameters, options);
  return options;
}

}  // namespace pliant
