// SPDX-License-Identifier: MIT
#include "run_walkers.hpp"

#include <atomic>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

#include "interrupt.hpp"
#include "messages.hpp"
#include "pliant/base/elements.hpp"
#include "pliant/laboratory/force_recorder.hpp"
#include "pliant/record/topology_pdb.hpp"

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
  std::exception_ptr failure = nullptr;
  std::vector<RunSummary> summaries = {};
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

RunSummary run_walker(Shared& shared, std::int64_t walker) {
  std::unique_lock lock(shared.hdf5);
  H5mdRecorder recorder(output_of(shared.settings, walker), shared.molecule.framework,
                        header_of(shared.settings, shared.molecule, walker),
                        shared.settings.record);
  if (walker == 0) write_sidecar(shared);
  std::optional<ForceRecorder> forces = force_recorder(shared, walker);
  lock.unlock();
  RunOptions options = shared.settings.run;
  options.resolve.walker = static_cast<std::uint64_t>(walker);
  options.resolve.should_stop = interrupted;
  if (forces) options.on_push = [&forces](const Push& push) { forces->record(push); };
  if (walker == 0) options.log = shared.log;
  std::int64_t last_step = 0;
  const Observer record = [&](const Frame& frame) {
    const std::lock_guard hold(shared.hdf5);
    recorder.record(frame);
    shared.progress.show(shared.steps_done += frame.step - last_step);
    last_step = frame.step;
    return interrupted();
  };
  State state(shared.molecule.structure.positions);
  const RunSummary summary = run(shared.molecule.framework, state, options, {record});
  lock.lock();
  recorder.close();
  if (forces) forces->publish();
  return summary;
}

void run_next_walkers(Shared& shared) {
  for (;;) {
    const std::int64_t walker = shared.next_walker++;
    if (walker >= shared.settings.walkers || interrupted()) return;
    try {
      shared.summaries[static_cast<std::size_t>(walker)] = run_walker(shared, walker);
    } catch (...) {
      const std::lock_guard hold(shared.hdf5);
      if (!shared.failure) shared.failure = std::current_exception();
      return;
    }
  }
}

}  // namespace

std::vector<RunSummary> run_walkers(const RunSettings& settings, const Molecule& molecule,
                                    const Log& log) {
  ProgressBar progress(settings.walkers * settings.run.steps, "steps", settings.quiet);
  Shared shared{settings, molecule, log, progress};
  shared.summaries.resize(static_cast<std::size_t>(settings.walkers));
  {
    std::vector<std::jthread> threads;
    for (std::int64_t i = 1; i < std::min(settings.threads, settings.walkers); ++i)
      threads.emplace_back([&shared] { run_next_walkers(shared); });
    run_next_walkers(shared);
  }
  if (shared.failure) std::rethrow_exception(shared.failure);
  return std::move(shared.summaries);
}

}  // namespace pliant::app
