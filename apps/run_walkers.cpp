// SPDX-License-Identifier: MIT
#include "run_walkers.hpp"

#include <algorithm>
#include <atomic>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

#include "interrupt.hpp"
#include "messages.hpp"
#include "pliant/base/elements.hpp"
#include "pliant/laboratory/force_recorder.hpp"
#include "pliant/record/topology_pdb.hpp"
#include "pliant/resolve/lanes/lane_kernels.hpp"

namespace pliant::app {
namespace {

std::vector<RecordedBond> recorded_bonds(const Structure& structure) {
  std::vector<RecordedBond> bonds;
  bonds.reserve(structure.bonds.size());
  for (const Bond& bond : structure.bonds)
    bonds.push_back({bond.a, bond.b, static_cast<std::uint8_t>(bond.origin), bond.order});
  return bonds;
}

H5mdHeader header_of(const RunSettings& settings, const Molecule& molecule, std::int64_t walker) {
  H5mdHeader header;
  header.bonds = recorded_bonds(molecule.structure);
  header.bond_origin_names.assign(bond_origin_names.begin(), bond_origin_names.end());
  if (molecule.structure.format != "graph")
    for (std::uint8_t element : molecule.structure.atoms.elements)
      header.masses.push_back(element_mass(element));
  header.creator_version = PLIANT_VERSION;
  header.parameters = parameters_of(settings, molecule.framework, walker);
  return header;
}

/// What the walkers share. HDF5 as Debian builds it is for one thread at a time, so every use of a
/// recorder holds `hdf5`.
struct Shared {
  const RunSettings& settings;
  const Molecule& molecule;
  const Log& log;
  ProgressBar& progress;
  std::mutex hdf5 = {};
  std::atomic<std::int64_t> next_walker{0}, steps_done{0};
  std::int64_t group_size = 1;  ///< walkers that step together
  std::exception_ptr failure = nullptr;
  std::vector<RunSummary> summaries = {};

  /// Holds hdf5. Of the exception being handled; the first is told once all walkers have ended.
  void keep_failure() {
    if (!failure) failure = std::current_exception();
  }
};

/// One sidecar serves all walkers.
void write_sidecar(const Shared& shared) {
  if (shared.settings.topology == "none") return;
  TopologyPdbOptions options;
  options.overwrite = shared.settings.record.overwrite;
  options.log = shared.log;
  const Structure& structure = shared.molecule.structure;
  write_topology_pdb(shared.settings.topology, structure.atoms, structure.positions,
                     recorded_bonds(structure), options);
}

/// Records a walker's pushes, or nothing.
std::optional<ForceRecorder> force_recorder(const Shared& shared, std::int64_t walker) {
  const RunSettings& settings = shared.settings;
  if (settings.record_forces.empty()) return {};
  ForceFile forces;
  forces.set(settings.run.perturb_options, settings.run.resolve.tolerance,
             settings.run.resolve.max_sweeps);
  return std::optional<ForceRecorder>(std::in_place,
                                      of_walker(settings, settings.record_forces, walker),
                                      settings.record.overwrite, shared.molecule.framework, forces);
}

/// A walker with its outputs.
struct RecordedWalker {
  std::int64_t number;
  H5mdRecorder recorder;
  std::optional<ForceRecorder> forces;
  State state;
  std::int64_t last_step = 0;

  /// Holds shared.hdf5.
  RecordedWalker(const Shared& shared, std::int64_t walker)
      : number(walker),
        recorder(output_of(shared.settings, walker), shared.molecule.framework,
                 header_of(shared.settings, shared.molecule, walker), shared.settings.record),
        forces(force_recorder(shared, walker)),
        state(shared.molecule.structure.positions) {}

  WalkerRun run(Shared& shared) {
    WalkerRun run{state, static_cast<std::uint64_t>(number)};
    run.observers = {[this, &shared](const Frame& frame) { return record(shared, frame); }};
    if (forces) run.on_push = [this](const Push& push) { forces->record(push); };
    if (number == 0) run.log = shared.log;
    return run;
  }

  /// A walker that cannot be recorded stops; the others go on.
  bool record(Shared& shared, const Frame& frame) {
    const std::lock_guard hold(shared.hdf5);
    try {
      recorder.record(frame);
    } catch (...) {
      shared.keep_failure();
      return true;
    }
    shared.progress.show(shared.steps_done += frame.step - last_step);
    last_step = frame.step;
    return interrupted();
  }

  /// Holds shared.hdf5.
  void close(Shared& shared) {
    try {
      recorder.close();
      if (forces) forces->publish();
    } catch (...) {
      shared.keep_failure();
    }
  }
};

/// Those of walkers [first, end) whose outputs can be made; throws if none can.
std::deque<RecordedWalker> make_group(Shared& shared, std::int64_t first, std::int64_t end) {
  std::deque<RecordedWalker> walkers;  // which stay where they are
  const std::lock_guard hold(shared.hdf5);
  for (std::int64_t walker = first; walker < end; ++walker) {
    try {
      walkers.emplace_back(shared, walker);
    } catch (...) {
      shared.keep_failure();
    }
  }
  if (walkers.empty()) std::rethrow_exception(shared.failure);
  if (first == 0) write_sidecar(shared);
  return walkers;
}

/// Walkers [first, end) in step with each other.
void run_group(Shared& shared, std::int64_t first, std::int64_t end) {
  std::deque<RecordedWalker> walkers = make_group(shared, first, end);
  std::vector<WalkerRun> runs;
  for (RecordedWalker& walker : walkers) runs.push_back(walker.run(shared));
  RunOptions options = shared.settings.run;
  options.resolve.should_stop = interrupted;
  const auto summaries = pliant::run_walkers(shared.molecule.framework, runs, options);
  const std::lock_guard hold(shared.hdf5);
  for (std::size_t k = 0; k < walkers.size(); ++k) {
    shared.summaries[static_cast<std::size_t>(walkers[k].number)] = summaries[k];
    walkers[k].close(shared);
  }
}

void run_next_groups(Shared& shared) {
  for (;;) {
    const std::int64_t first = shared.next_walker.fetch_add(shared.group_size);
    if (first >= shared.settings.walkers || interrupted()) return;
    try {
      run_group(shared, first, std::min(first + shared.group_size, shared.settings.walkers));
    } catch (...) {
      const std::lock_guard hold(shared.hdf5);
      shared.keep_failure();
      return;
    }
  }
}

/// As many as fit into the lanes, if that leaves no thread without.
std::int64_t group_size(const RunSettings& settings) {
  const std::int64_t share = (settings.walkers + settings.threads - 1) / settings.threads;
  return std::clamp<std::int64_t>(share, 1, std::int64_t(lane_count));
}

}  // namespace

std::vector<RunSummary> run_walkers(const RunSettings& settings, const Molecule& molecule,
                                    const Log& log) {
  ProgressBar progress(settings.walkers * settings.run.steps, "steps", settings.quiet);
  Shared shared{settings, molecule, log, progress};
  shared.summaries.resize(static_cast<std::size_t>(settings.walkers));
  shared.group_size = group_size(settings);
  {
    std::vector<std::jthread> threads;
    for (std::int64_t i = 1; i < std::min(settings.threads, settings.walkers); ++i)
      threads.emplace_back([&shared] { run_next_groups(shared); });
    run_next_groups(shared);
  }
  if (shared.failure) std::rethrow_exception(shared.failure);
  for (RunSummary& summary : shared.summaries)  // a walker that begins shows a frame
    if (summary.frames == 0) summary.stopped_by_caller = true;
  return std::move(shared.summaries);
}

}  // namespace pliant::app
