// SPDX-License-Identifier: MIT
// One thing of each public header, by name: what a header needs is installed too, and what it
// declares is in the libraries that find_package(pliant) gives.
#include <cstddef>
#include <cstdio>
#include <string_view>

#include "pliant/base/choices.hpp"
#include "pliant/base/elements.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/graphs/disjoint_sets.hpp"
#include "pliant/base/graphs/graph.hpp"
#include "pliant/base/graphs/grouped.hpp"
#include "pliant/base/log.hpp"
#include "pliant/base/math/dense_matrix.hpp"
#include "pliant/base/option_fields.hpp"
#include "pliant/base/parameter.hpp"
#include "pliant/base/random.hpp"
#include "pliant/base/range.hpp"
#include "pliant/base/system/descriptor.hpp"
#include "pliant/base/system/sockets.hpp"
#include "pliant/base/threads.hpp"
#include "pliant/base/vec3.hpp"
#include "pliant/base/version.hpp"
#include "pliant/framework/atom_table.hpp"
#include "pliant/framework/contact_kind_rows.hpp"
#include "pliant/framework/course.hpp"
#include "pliant/framework/disturbed.hpp"
#include "pliant/framework/edits.hpp"
#include "pliant/framework/fingerprint.hpp"
#include "pliant/framework/frame.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/framework/graph.hpp"
#include "pliant/framework/joint_names.hpp"
#include "pliant/framework/limits.hpp"
#include "pliant/framework/measures/check_positions.hpp"
#include "pliant/framework/measures/feasibility.hpp"
#include "pliant/framework/measures/limit_counts.hpp"
#include "pliant/framework/measures/neighbour_list.hpp"
#include "pliant/framework/measures/residual.hpp"
#include "pliant/framework/sterics.hpp"
#include "pliant/framework/torsion_preferences.hpp"
#include "pliant/jobs/conformers_task.hpp"
#include "pliant/jobs/force_recorder.hpp"
#include "pliant/jobs/recorded_run.hpp"
#include "pliant/jobs/recorded_sample.hpp"
#include "pliant/jobs/rigidity_task.hpp"
#include "pliant/jobs/sample_task.hpp"
#include "pliant/lab/examples/examples.hpp"
#include "pliant/lab/generate/fundamental_cycles.hpp"
#include "pliant/lab/generate/random_graphs.hpp"
#include "pliant/lab/test_sets/make_test_set.hpp"
#include "pliant/lab/test_sets/read_test_set.hpp"
#include "pliant/lab/test_sets/test_results.hpp"
#include "pliant/lab/test_sets/test_set.hpp"
#include "pliant/model/amplitude.hpp"
#include "pliant/model/atoms/atom_graph.hpp"
#include "pliant/model/contacts/contact_file.hpp"
#include "pliant/model/contacts/contact_kinds.hpp"
#include "pliant/model/contacts/contact_list.hpp"
#include "pliant/model/contacts/contact_options.hpp"
#include "pliant/model/contacts/hydrogen_bond_energy.hpp"
#include "pliant/model/contacts/hydrogen_bonds.hpp"
#include "pliant/model/contacts/tethers.hpp"
#include "pliant/model/model.hpp"
#include "pliant/model/prepare/prepare.hpp"
#include "pliant/model/prepare/protonation.hpp"
#include "pliant/model/prepare/select_part.hpp"
#include "pliant/model/prepare/survey.hpp"
#include "pliant/model/rigidity/dilution_picture.hpp"
#include "pliant/model/rigidity/rigidity.hpp"
#include "pliant/model/rigidity/rigidity_dilution.hpp"
#include "pliant/model/rigidity/rigidity_network.hpp"
#include "pliant/model/steric_table.hpp"
#include "pliant/model/torsions_of_residues.hpp"
#include "pliant/molecule/bars_file.hpp"
#include "pliant/molecule/bonds/bond_options.hpp"
#include "pliant/molecule/bonds/bonds.hpp"
#include "pliant/molecule/build_framework.hpp"
#include "pliant/molecule/crystal_additives.hpp"
#include "pliant/molecule/read/read.hpp"
#include "pliant/molecule/read/shared/read_options.hpp"
#include "pliant/molecule/sterics_lines.hpp"
#include "pliant/molecule/structure/cell.hpp"
#include "pliant/molecule/structure/structure.hpp"
#include "pliant/order/check_ordering.hpp"
#include "pliant/order/ordering.hpp"
#include "pliant/order/ordering_file.hpp"
#include "pliant/order/traversal.hpp"
#include "pliant/path/ends.hpp"
#include "pliant/path/matching.hpp"
#include "pliant/path/path.hpp"
#include "pliant/path/path_options.hpp"
#include "pliant/path/path_table.hpp"
#include "pliant/path/sequence.hpp"
#include "pliant/path/trace.hpp"
#include "pliant/perturb/force_files/force_events.hpp"
#include "pliant/perturb/force_files/force_file.hpp"
#include "pliant/perturb/force_files/force_header.hpp"
#include "pliant/perturb/guide.hpp"
#include "pliant/perturb/perturbation.hpp"
#include "pliant/perturb/push.hpp"
#include "pliant/perturb/pusher.hpp"
#include "pliant/perturb/pushers.hpp"
#include "pliant/perturb/steering.hpp"
#include "pliant/record/h5md/h5md_checkpoint_reader.hpp"
#include "pliant/record/h5md/h5md_header.hpp"
#include "pliant/record/h5md/h5md_reader.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"
#include "pliant/record/h5md/saved_part.hpp"
#include "pliant/record/pdb_recorder.hpp"
#include "pliant/record/sdf_recorder.hpp"
#include "pliant/record/topology_pdb.hpp"
#include "pliant/record/xml/graph_xml.hpp"
#include "pliant/record/xml/write_graph_xml.hpp"
#include "pliant/resolve/auto.hpp"
#include "pliant/resolve/method/project_bar.hpp"
#include "pliant/resolve/method/resolve_options.hpp"
#include "pliant/resolve/method/resolve_summary.hpp"
#include "pliant/resolve/method/technique.hpp"
#include "pliant/resolve/method/walker_positions.hpp"
#include "pliant/resolve/resolve.hpp"
#include "pliant/resolve/techniques.hpp"
#include "pliant/resolve/walkers.hpp"
#include "pliant/rigidity/bar_rank.hpp"
#include "pliant/rigidity/framework_rigidity.hpp"
#include "pliant/rigidity/pebble_game.hpp"
#include "pliant/rigidity/rigid_clusters.hpp"
#include "pliant/run/ensemble.hpp"
#include "pliant/run/force_settings.hpp"
#include "pliant/run/motion.hpp"
#include "pliant/run/replay_events.hpp"
#include "pliant/run/run.hpp"
#include "pliant/run/run_fields.hpp"
#include "pliant/run/run_options.hpp"
#include "pliant/run/run_summary.hpp"
#include "pliant/run/steered_walk.hpp"
#include "pliant/sample/network/b_factors.hpp"
#include "pliant/sample/network/elastic_network.hpp"
#include "pliant/sample/network/mode_field.hpp"
#include "pliant/sample/network/network_modes.hpp"
#include "pliant/sample/sample.hpp"
#include "pliant/sample/sample_fields.hpp"
#include "pliant/sample/sample_options.hpp"
#include "pliant/sample/sample_summary.hpp"
#include "pliant/sample/sampler.hpp"
#include "pliant/sample/samplers.hpp"
#include "pliant/stream/imd_commands.hpp"
#include "pliant/stream/imd_exchange.hpp"
#include "pliant/stream/imd_follower.hpp"
#include "pliant/stream/imd_packets.hpp"
#include "pliant/stream/imd_server.hpp"
#include "pliant/stream/imd_session.hpp"
#include "pliant/text/file_text.hpp"
#include "pliant/text/output_file.hpp"

namespace {

using namespace pliant;

struct Use {
  const char* header;
  bool is_there;
};

/// Of a function or a member function. Kept where the compiler may not reason about it: the
/// address has to be asked of the linker.
template <class Function>
Use of(const char* header, Function function) {
  volatile Function kept = function;
  return {header, kept != nullptr};
}

/// Of a header all of whose functions are inline.
template <class Type>
Use of_type(const char* header) {
  const Type thing{};
  return {header, sizeof(thing) > 0};
}

/// Chooses among functions of one name.
template <class Signature>
Signature* overload(Signature* function) {
  return function;
}

const Use uses[] = {
    of("pliant/base/choices.hpp", &edit_distance),
    of("pliant/base/graphs/disjoint_sets.hpp", &DisjointSets::find),
    of("pliant/base/elements.hpp", &element_mass),
    of("pliant/base/error.hpp", &quoted),
    of("pliant/base/graphs/graph.hpp", overload<Components(const Graph&)>(&find_components)),
    of_type<Grouped<int>>("pliant/base/graphs/grouped.hpp"),
    of_type<Log>("pliant/base/log.hpp"),
    of("pliant/base/option_fields.hpp", &option_text),
    of_type<Parameter>("pliant/base/parameter.hpp"),
    of("pliant/base/random.hpp", &philox4x64),
    of("pliant/base/range.hpp", overload<bool(Range, double)>(&holds)),
    of("pliant/base/system/descriptor.hpp", &open_file),
    of("pliant/base/system/sockets.hpp", &listen_on),
    of_type<Mutex>("pliant/base/threads.hpp"),
    of_type<Vec3>("pliant/base/vec3.hpp"),
    of("pliant/base/version.hpp", &version),
    of("pliant/sample/network/b_factors.hpp", &relative_b_factors),
    of("pliant/base/math/dense_matrix.hpp", &dot_product),
    of("pliant/sample/network/elastic_network.hpp", &networks),
    of("pliant/sample/network/mode_field.hpp", &mode_field),
    of("pliant/sample/network/network_modes.hpp", &network_modes),
    of("pliant/sample/sample.hpp", &sample),
    of("pliant/sample/sample_fields.hpp", &sample_fields),
    of_type<SampleOptions>("pliant/sample/sample_options.hpp"),
    of("pliant/sample/sample_summary.hpp", &FluctuationSums::rmsf),
    of("pliant/sample/sampler.hpp", &Sampler::steps_a_frame),
    of("pliant/sample/samplers.hpp", &samplers),
    of("pliant/stream/imd_commands.hpp", &ImdCommandReader::next),
    of("pliant/stream/imd_exchange.hpp", &ImdExchange::wants),
    of("pliant/stream/imd_follower.hpp", &forces_of),
    of("pliant/stream/imd_packets.hpp", &imd_greeting),
    of("pliant/stream/imd_server.hpp", &ImdServer::close),
    of("pliant/stream/imd_session.hpp", &ImdSession::step),
    of("pliant/text/file_text.hpp", &read_bytes),
    of("pliant/text/output_file.hpp", &write_text_file),
    of("pliant/molecule/bars_file.hpp", &write_bars_file),
    of("pliant/molecule/bonds/bonds.hpp", &perceive_bonds),
    of_type<BondOptions>("pliant/molecule/bonds/bond_options.hpp"),
    of("pliant/molecule/build_framework.hpp", &build_framework),
    of("pliant/molecule/read/read.hpp", &formats),
    of_type<ReadOptions>("pliant/molecule/read/shared/read_options.hpp"),
    of("pliant/molecule/sterics_lines.hpp", &usual_kind),
    of("pliant/molecule/structure/cell.hpp", &CellImages::widths),
    of_type<Structure>("pliant/molecule/structure/structure.hpp"),
    of("pliant/model/amplitude.hpp", &choose_amplitude),
    of("pliant/model/atoms/atom_graph.hpp", &AtomGraph::are_bonded),
    of("pliant/model/contacts/contact_file.hpp", &parse_contacts),
    of_type<LimitKind>("pliant/framework/contact_kind_rows.hpp"),
    of("pliant/model/contacts/contact_kinds.hpp", &molecular_contact_kinds),
    of("pliant/model/contacts/contact_list.hpp", &limits_of),
    of_type<ContactOptions>("pliant/model/contacts/contact_options.hpp"),
    of("pliant/model/rigidity/dilution_picture.hpp", &dilution_title),
    of("pliant/model/contacts/hydrogen_bond_energy.hpp", &hydrogen_bond_energy),
    of("pliant/model/contacts/hydrogen_bonds.hpp", &hydrogen_bonds),
    of("pliant/model/model.hpp", &build_model),
    of("pliant/molecule/crystal_additives.hpp", &crystal_additives),
    of("pliant/model/prepare/prepare.hpp", &prepare),
    of("pliant/model/prepare/protonation.hpp", &protonation_of),
    of("pliant/model/rigidity/rigidity.hpp", &analyse_rigidity),
    of("pliant/model/rigidity/rigidity_dilution.hpp", &dilute_hydrogen_bonds),
    of("pliant/model/rigidity/rigidity_network.hpp", &rigidity_network),
    of("pliant/rigidity/bar_rank.hpp", &bar_rank),
    of("pliant/rigidity/framework_rigidity.hpp", &framework_rigidity),
    of("pliant/rigidity/pebble_game.hpp", &PebbleGame::rank),
    of("pliant/rigidity/rigid_clusters.hpp", &find_rigid_clusters),
    of("pliant/model/prepare/select_part.hpp", &select_part),
    of("pliant/model/steric_table.hpp", &molecular_sterics),
    of("pliant/model/prepare/survey.hpp", &survey),
    of("pliant/model/contacts/tethers.hpp", &hydrophobic_tethers),
    of("pliant/model/torsions_of_residues.hpp", &torsions_of_residues),
    of("pliant/framework/atom_table.hpp", overload<void(const AtomTable&)>(&check)),
    of("pliant/framework/measures/check_positions.hpp", &check_positions),
    of("pliant/framework/measures/neighbour_list.hpp", &NeighbourList::update),
    of_type<Course>("pliant/framework/course.hpp"),
    of_type<Disturbed>("pliant/framework/disturbed.hpp"),
    of("pliant/framework/edits.hpp", &edited),
    of("pliant/framework/measures/feasibility.hpp", &impossible_triangles),
    of("pliant/framework/frame.hpp", overload<std::string_view(Stop)>(&name)),
    of_type<State>("pliant/framework/framework.hpp"),
    of("pliant/framework/graph.hpp", &graph_facts),
    of("pliant/framework/joint_names.hpp", &JointNames::word_for),
    of_type<LimitCounts>("pliant/framework/measures/limit_counts.hpp"),
    of("pliant/framework/fingerprint.hpp", &fingerprint_text),
    of("pliant/framework/limits.hpp", &limit_kinds),
    of("pliant/framework/measures/residual.hpp", &measure),
    of("pliant/framework/sterics.hpp", overload<void(const Sterics&, std::size_t)>(&check)),
    of("pliant/framework/torsion_preferences.hpp", &torsion_angle),
    of("pliant/lab/examples/examples.hpp", &examples),
    of("pliant/lab/generate/fundamental_cycles.hpp", &fundamental_cycles),
    of("pliant/lab/generate/random_graphs.hpp", &generate),
    of("pliant/order/check_ordering.hpp", &check_ordering),
    of("pliant/order/ordering.hpp", &orderings),
    of("pliant/order/ordering_file.hpp", &write_ordering_file),
    of("pliant/order/traversal.hpp", &traverse_breadth_first),
    of("pliant/resolve/auto.hpp", &choose_technique),
    of("pliant/resolve/method/project_bar.hpp", &escape_direction),
    of("pliant/resolve/method/resolve_options.hpp", overload<void(const ResolveOptions&)>(&check)),
    of("pliant/resolve/method/resolve_summary.hpp", &note_violations),
    of_type<Technique>("pliant/resolve/method/technique.hpp"),
    of_type<WalkerPositions>("pliant/resolve/method/walker_positions.hpp"),
    of("pliant/resolve/resolve.hpp", &Resolver::check_arguments),
    of("pliant/resolve/techniques.hpp", &techniques),
    of("pliant/resolve/walkers.hpp", &WalkerResolver::level),
    of("pliant/path/ends.hpp", &match_ends),
    of("pliant/path/matching.hpp", &match_residues),
    of("pliant/path/path.hpp", &find_path),
    of("pliant/path/path_options.hpp", &find_path_atoms),
    of("pliant/path/path_table.hpp", &tight_places),
    of("pliant/path/sequence.hpp", &align),
    of("pliant/path/trace.hpp", &trace_of),
    of("pliant/perturb/force_files/force_events.hpp", &write_force_events),
    of("pliant/perturb/force_files/force_file.hpp", &write_force_file),
    of("pliant/perturb/force_files/force_header.hpp", &write_force_header),
    of("pliant/perturb/guide.hpp", &pushers_of),
    of("pliant/perturb/perturbation.hpp", &perturbations),
    of("pliant/perturb/push.hpp", &Push::disturbed),
    of("pliant/perturb/pusher.hpp", &apply_forces),
    of("pliant/perturb/pushers.hpp", &pushers),
    of("pliant/perturb/steering.hpp", &Steering::release),
    of("pliant/run/ensemble.hpp", &run_ensemble),
    of("pliant/run/force_settings.hpp", &force_settings),
    of("pliant/run/motion.hpp", &Motion::step),
    of("pliant/run/replay_events.hpp", &replay_events),
    of("pliant/run/run.hpp", &run),
    of("pliant/run/run_fields.hpp", &run_fields),
    of("pliant/run/run_options.hpp", &replayed_steps),
    of("pliant/run/run_summary.hpp", &add),
    of("pliant/run/steered_walk.hpp", &SteeredWalk::pull),
    of("pliant/record/h5md/h5md_checkpoint_reader.hpp", &read_checkpoint),
    of("pliant/record/h5md/h5md_reader.hpp", &H5mdReader::frames),
    of_type<H5mdHeader>("pliant/record/h5md/h5md_header.hpp"),
    of("pliant/record/h5md/h5md_recorder.hpp", &H5mdRecorder::flush),
    of("pliant/record/pdb_recorder.hpp", &PdbRecorder::close),
    of("pliant/record/h5md/saved_part.hpp", &SavedPart::shown),
    of("pliant/record/sdf_recorder.hpp", &SdfRecorder::close),
    of("pliant/record/topology_pdb.hpp", &write_topology_pdb),
    of("pliant/record/xml/graph_xml.hpp", &looks_like_xml),
    of("pliant/record/xml/write_graph_xml.hpp", &write_graph_xml),
    of("pliant/jobs/conformers_task.hpp", &draw_conformers),
    of("pliant/jobs/rigidity_task.hpp", &find_rigidity),
    of("pliant/jobs/sample_task.hpp", &SampleTask::run),
    of("pliant/jobs/force_recorder.hpp", &ForceRecorder::publish),
    of("pliant/lab/test_sets/make_test_set.hpp", &make_test_set),
    of("pliant/lab/test_sets/read_test_set.hpp", &read_test_set),
    of("pliant/jobs/recorded_run.hpp",
       overload<RunOptions(const H5mdCheckpoint&)>(&run_options_from)),
    of("pliant/jobs/recorded_sample.hpp", &add_frames),
    of("pliant/lab/test_sets/test_results.hpp", &summary_of),
    of("pliant/lab/test_sets/test_set.hpp", &TestSet::save),
};

}  // namespace

int main() {
  int missing = 0;
  for (const Use& use : uses) {
    if (!use.is_there) std::printf("nothing of %s\n", use.header);
    missing += use.is_there ? 0 : 1;
  }
  return missing;
}
