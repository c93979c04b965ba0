// SPDX-License-Identifier: MIT
#include "output/sample_lines.hpp"

#include <fmt/format.h>

#include "output/conformations.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/jobs/asked/output_options.hpp"

namespace pliant::app {
namespace {

std::string numbered(std::size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

void print_line(std::string_view label, std::string_view text) {
  fmt::print("{:<15} {}\n", label, text);
}

std::string molecule_text(const Job& job, const SampledSystem& system) {
  const AtomTable* atoms = system.framework.atoms().get();
  std::string text = fmt::format("{}: {}", printable_name(job.molecule.input.file),
                                 numbered(system.framework.joint_count(), "atom"));
  if (atoms != nullptr && atoms->residues.size() > 1)
    text += " in " + numbered(atoms->residues.size(), "residue");
  if (system.placed > 0)
    text += fmt::format(", {} of them{} placed by rule", system.placed,
                        job.molecule.model.fill_side_chains ? "" : " hydrogens");
  return text;
}

std::string moving_text(const Conformations& found) {
  std::string text = numbered(found.rotors.size(), "bond") + " can rotate";
  if (!found.rings.empty())
    text += fmt::format(", {} can flip", numbered(found.rings.size(), "ring"));
  if (!found.rigid_rings.empty())
    text += fmt::format(", {} cannot", numbered(found.rigid_rings.size(), "ring"));
  if (!found.amines.empty())
    text += fmt::format(", {} can invert", numbered(found.amines.size(), "amine"));
  if (!found.amides.empty())
    text += fmt::format(", {} can be cis or trans", numbered(found.amides.size(), "amide"));
  if (!found.atropisomers.empty())
    text += fmt::format(", {} keep their handedness",
                        numbered(found.atropisomers.size(), "biaryl bond"));
  return text;
}

/// "5 frames had to be redrawn, 1 could not be made and is left out".
std::string draws_text(const SampleSummary& summary) {
  std::string text = summary.redrawn == 0
                         ? "No frame had to be redrawn"
                         : numbered(std::size_t(summary.redrawn), "frame") + " had to be redrawn";
  if (summary.failed > 0)
    text += fmt::format("; {} could not be made and are left out",
                        numbered(std::size_t(summary.failed), "frame"));
  return text + ".";
}

std::string frames_text(const Job& job, const SampleSummary& summary) {
  std::string text = fmt::format("{}{} by sampler {}", summary.frames,
                                 job.go_on.empty() ? "" : " added", job.sample.sampler);
  if (summary.near_frames > 0 && summary.near_frames < summary.frames)
    text += fmt::format(": {} around the structure, {} that go further", summary.near_frames,
                        summary.frames - summary.near_frames);
  if (summary.near_frames > 0 && summary.amplitude_asked > 0.0)
    text += fmt::format("; amplitude {:.2f} A of {:.2f} asked (an input)",
                        summary.amplitude_reached, summary.amplitude_asked);
  if (summary.stopped_by_caller) text += "; stopped early, all complete";
  return text;
}

std::string quality_text(const SampleSummary& summary) {
  return fmt::format(
      "{} Bonds and angles are off by {:.0e} at most, contacts by {:.2f} A, overlaps {:.2f} A.",
      draws_text(summary), summary.max_residual, summary.max_limit, summary.max_overlap);
}

std::string next_text(const std::string& output) {
  if (is_pdb_name(output)) return "open it in PyMOL, ChimeraX or VMD: one model for each frame";
  if (is_sdf_name(output)) return "read it with RDKit or open it in PyMOL";
  return "pliant analyse " + printable_name(output);
}

}  // namespace

std::string ligand_text(const Job& job, const SampleSummary& summary) {
  return fmt::format("other torsions drawn in {} of {}; its contacts held: {}",
                     summary.ligand_frames, numbered(std::size_t(summary.frames), "frame"),
                     fmt::join(job.sample.hold, ", "));
}

void print_sample_lines(const Job& job, const SampledSystem& system, const SampleSummary& summary) {
  print_line("molecule", molecule_text(job, system));
  if (!system.left_out.empty())
    print_line("left out", fmt::format("{}", fmt::join(system.left_out, "; ")));
  if (const auto conformations = conformations_of(job, system))
    print_line("moves", moving_text(*conformations));
  else if (system.contacts > 0)
    print_line("contacts", fmt::format("{} held{}{}", system.contacts,
                                       system.kinds.empty() ? "" : ": ", system.kinds));
  if (const auto residues = pocket_of(job, system); !residues.empty())
    print_line("pocket", fmt::format("{}: {}", numbered(residues.size(), "residue"),
                                     fmt::join(residues, ", ")));
  if (summary.ligand_frames > 0) print_line("ligand", ligand_text(job, summary));
  print_line("frames", frames_text(job, summary));
  print_line("quality", quality_text(summary));
  const bool has_topology = job.output.topology != "none";
  print_line("written",
             fmt::format("{}{}{}, in {:.1f} s", printable_name(job.output.output),
                         has_topology ? ", " : "",
                         has_topology ? printable_name(job.output.topology) : "", summary.seconds));
  print_line("next", next_text(job.output.output));
}

}  // namespace pliant::app
