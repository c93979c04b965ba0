// SPDX-License-Identifier: MIT
// pliant rigidity: which parts of a molecule are rigid, by counting freedoms.
#include <fmt/format.h>

#include <filesystem>

#include "command.hpp"
#include "external.hpp"
#include "messages.hpp"
#include "options/job_options.hpp"
#include "options/option_fields.hpp"
#include "output/graph_rigidity.hpp"
#include "output/rigidity_files.hpp"
#include "output/rigidity_json.hpp"
#include "output/rigidity_report.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/jobs/asked/output_options.hpp"
#include "pliant/model/rigidity/rings_of_six.hpp"

namespace pliant::app {
namespace {

struct RigiditySettings {
  MoleculeOptions molecule;
  RigidityAsked counting;
  std::string output, page;
  bool dilution = false, overwrite = false, as_csv = false, as_json = false, verbose = false;
};

/// "hydrogen bond 5", one kind a line.
std::string bars_of_contacts() {
  std::string text;
  for (const MolecularContactKindEntry& row : molecular_contact_kinds())
    text += fmt::format("\n  {} {}", row.singular, row.bars);
  return text;
}

constexpr const char* summary =
    "Counts degrees of freedom (body-bar pebble game, as FIRST does): which atoms move as\n"
    "one (rigid clusters), which bonds can still rotate, and where there are more\n"
    "constraints than needed.\n"
    "\n"
    "Each atom is a body with 6 freedoms. A bond that can rotate removes 5 of them (a\n"
    "hinge), one that cannot (peptide, double, aromatic) 6. Those that remain are internal\n"
    "degrees of freedom: a ring of six single bonds has none, a ring of seven has one. The\n"
    "count uses the graph alone, not positions: it misses that a ring of six can move as a\n"
    "boat, though not as a chair. No contact breaks, so the answer depends on\n"
    "--hbond-cutoff: try --dilution.\n"
    "\n"
    "A linkage (graph, .xml) has joints, and bars that fix their distances. Its degrees of\n"
    "freedom are computed three ways: from the rank of the rigidity matrix at the positions\n"
    "in the file, from its rank at almost all positions, and by counting bars (pebble game).\n"
    "Redundant bars are listed. Pinned joints stay fixed.\n"
    "\n"
    "Freedoms that contacts in molecules remove:";

constexpr const char* footer =
    "How to read it:\n"
    "  flexibility  of a bond: 1 rotates freely, 1/7 in a ring of seven that moves as a whole,\n"
    "               0 locked, below 0 locked by more constraints than needed (redundant)\n"
    "               of a residue: the mean of its N-CA and CA-C bonds\n"
    "  dilution     hydrogen bonds are removed one by one, weakest first: the clusters that last\n"
    "               longest are the core, and it comes apart at hinges\n"
    "\n"
    "Examples:\n"
    "  pliant rigidity protein.pdb\n"
    "  pliant rigidity protein.pdb --dilution --page rigid.html\n"
    "  pliant rigidity protein.pdb -o rigid && cd rigid && pymol show.pml\n"
    "  pliant rigidity protein.pdb --csv > residues.csv\n"
    "  pliant rigidity linkage.xml";

void add_options(CommandLine& line, RigiditySettings& settings) {
  add_input_options(line, settings.molecule.input, true);
  add_model_options(line, settings.molecule.model);
  line.start_group("Counting");
  for (const auto& field : rigidity_fields())
    if (field.users.command) add_option(line, field, field.place(settings.counting));
  line.add_flag("--dilution", settings.dilution,
                "remove hydrogen bonds one by one, weakest first, starting at --hbond-cutoff");
  line.start_group("Output");
  line.add_text("-o,--output", settings.output, "FOLDER",
                "write tables, PDB files with clusters and flexibility as B factors, scripts "
                "for PyMOL and ChimeraX, and with --dilution a picture (dilution.svg)");
  line.add_text("--page", settings.page, "FILE",
                "write an HTML page: the molecule in 3-D coloured by cluster and by flexibility, "
                "clusters by residues, with --dilution the plot (made by the Python package)");
  line.add_flag("--overwrite", settings.overwrite, "replace the page, and files of that folder");
  line.add_flag("--csv", settings.as_csv,
                "print a table of residues, or with --dilution of the hydrogen bonds removed, "
                "or of the bars of a graph");
  line.add_flag("--json", settings.as_json, "print one JSON object with all that was found");
  add_verbose(line, settings.verbose);
}

void refuse_input_as_output(const RigiditySettings& settings) {
  std::vector<std::string> outputs{settings.page};
  for (const std::string& name : rigidity_file_names(settings.dilution))
    if (!settings.output.empty()) outputs.push_back(path_text(path_of(settings.output) / name));
  refuse_same_files(inputs_of(settings.molecule), outputs);
}

void dilute(RigidityReport& report) {
  const std::string file = path_text(path_of(report.file).filename());
  DrawnDilution drawn = draw_dilution(report, printable_name(file));
  report.dilution = std::move(drawn.rows);
  report.dilution_svg = std::move(drawn.svg);
}

/// Path of the program that makes the page; "" where none is asked for.
std::filesystem::path page_program(const RigiditySettings& settings) {
  if (settings.page.empty()) return "";
  std::filesystem::path path = find_external("rigidity-page");
  if (path.empty())
    throw InputError(
        "--page is made by the Python package: install it (pip install pliant), so that "
        "pliant-rigidity-page is on PATH");
  return path;
}

int write_page(const std::filesystem::path& program, const RigiditySettings& settings,
               const RigidityReport& report) {
  Arguments arguments{"-o", settings.page};
  if (settings.overwrite) arguments.push_back("--overwrite");
  return run_with_input(program, arguments, json_for_page(report).text());
}

RigidityReport report_of(const RigiditySettings& settings, Messages& messages) {
  const Log log = messages.log_of_model(settings.molecule.input.file, settings.verbose);
  RigidityReport report{find_rigidity(contact_model(read_input(settings.molecule.input, log),
                                                    model_options_of(settings.molecule.model,
                                                                     ModelKind::protein, log)),
                                      settings.counting),
                        settings.molecule.input.file,
                        {},
                        {}};
  messages.end_model(report.model.left_out);
  if (const std::string note = note_on_rings_of_six(report.rigidity.rings_of_six); !note.empty())
    messages.log().note(note);
  if (settings.dilution) dilute(report);
  return report;
}

/// Throws OptionError naming an option that is for molecules alone.
void check_for_graph(const RigiditySettings& settings) {
  const auto refuse = [](bool is_given, const std::string& option) {
    if (is_given) throw OptionError(option + ": is for molecules, not for a graph");
  };
  refuse(settings.dilution, "--dilution");
  refuse(!settings.output.empty(), "--output");
  refuse(!settings.page.empty(), "--page");
  const RigidityAsked usual;
  refuse(settings.counting.hbond_bars != usual.hbond_bars, "--hbond-bars");
  refuse(settings.counting.tether_bars != usual.tether_bars, "--tether-bars");
  refuse(!settings.counting.free_angles.empty(), "--free-angles");
}

/// Says where the rank hangs on the last digits of coordinates.
void warn_of_rank(const BarRankThere& rank, const Log& log) {
  if (!rank.nearly_dependent.empty())
    log.warn(
        fmt::format("the positions are nearly special: singular values below 0.0001 count in "
                    "the rank: {}, the least {:.1e}; if rounded coordinates are the reason, "
                    "so many degrees of freedom are missing",
                    rank.nearly_dependent.size(), rank.nearly_dependent.front()));
}

int rigidity_of_graph(const RigiditySettings& settings) {
  check_for_graph(settings);
  Messages messages(settings.as_json);
  const Molecule graph = load_molecule(settings.molecule, messages.log());
  const GraphRigidityReport report{settings.molecule.input.file, graph.framework,
                                   framework_rigidity(graph.framework, graph.structure.positions)};
  warn_of_rank(report.found.rank, messages.log());
  if (settings.as_csv)
    fmt::print("{}", bars_as_csv(report));
  else if (settings.as_json)
    print_json(json_of_rigidity(report) +
               Json{{"warnings", messages.warnings()}, {"notes", messages.notes()}});
  else
    print_rigidity(report);
  return exit_ok;
}

}  // namespace

int command_rigidity(const Arguments& arguments) {
  CommandLine line("pliant rigidity", summary + bars_of_contacts());
  line.set_footer(footer);
  RigiditySettings settings;
  add_options(line, settings);
  line.set_common({"--dilution", "--hbond-cutoff", "--page", "--output", "--csv"});
  if (const int code = line.parse(arguments); code >= 0) return code;
  if (settings.as_csv && settings.as_json) throw OptionError("--csv, --json: expected one of them");
  if (settings.overwrite && settings.output.empty() && settings.page.empty())
    throw OptionError("--overwrite: goes with --output or --page");
  if (is_graph(settings.molecule)) return rigidity_of_graph(settings);
  refuse_input_as_output(settings);
  const std::filesystem::path program = page_program(settings);
  Messages messages(settings.as_json);
  const RigidityReport report = report_of(settings, messages);
  if (!settings.output.empty())
    write_rigidity_folder(settings.output, report, settings.overwrite, messages.log());
  if (!program.empty())
    if (const int code = write_page(program, settings, report); code != exit_ok) return code;
  if (settings.as_csv)
    fmt::print("{}", settings.dilution ? dilution_as_csv(report) : residues_as_csv(report));
  else if (settings.as_json)
    print_json(json_of_rigidity(report) +
               Json{{"warnings", messages.warnings()}, {"notes", messages.notes()}});
  else
    print_rigidity(report);
  return exit_ok;
}

}  // namespace pliant::app
