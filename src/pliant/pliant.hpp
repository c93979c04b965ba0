// SPDX-License-Identifier: MIT
// All of Pliant, in the order in which data flows.
#pragma once

// base: vectors, errors, messages, random numbers
#include "pliant/base/choices.hpp"               // tables of named things
#include "pliant/base/elements.hpp"              // symbols, masses, radii
#include "pliant/base/error.hpp"                 // Error, InputError, OptionError, FileError
#include "pliant/base/graphs/disjoint_sets.hpp"  // which things are together
#include "pliant/base/graphs/graph.hpp"          // nodes and edges; components, blocks
#include "pliant/base/graphs/grouped.hpp"        // things in slots: what graphs are kept in
#include "pliant/base/log.hpp"                   // notes and warnings, through a callback
#include "pliant/base/option_fields.hpp"         // tables of options
#include "pliant/base/parameter.hpp"             // values of options in files
#include "pliant/base/random.hpp"  // draws as functions of (seed, domain, walker, step, joint)
#include "pliant/base/range.hpp"   // what an option may be
#include "pliant/base/system/descriptor.hpp"  // files as the system has them
#include "pliant/base/system/sockets.hpp"     // TCP
#include "pliant/base/threads.hpp"            // where there are any
#include "pliant/base/vec3.hpp"               // Vec3
#include "pliant/base/version.hpp"            // of this library

// text: files
#include "pliant/text/file_text.hpp"    // the text of a file, expanded
#include "pliant/text/output_file.hpp"  // files that are there whole or not at all

// molecule: files to structures, structures to frameworks
#include "pliant/molecule/bars_file.hpp"                 // bars, limits and sterics as text
#include "pliant/molecule/bonds/bond_options.hpp"        // how bonds are perceived
#include "pliant/molecule/bonds/bonds.hpp"               // bond perception
#include "pliant/molecule/build_framework.hpp"           // bonds or angles to bars
#include "pliant/molecule/crystal_additives.hpp"         // names of what crystals are grown from
#include "pliant/molecule/read/read.hpp"                 // PDB, mmCIF, XYZ, SDF
#include "pliant/molecule/read/shared/read_options.hpp"  // which model, which assembly
#include "pliant/molecule/sterics_lines.hpp"             // the sterics of such a text
#include "pliant/molecule/structure/cell.hpp"            // the periodic cell
#include "pliant/molecule/structure/structure.hpp"       // atoms, positions, bonds

// model: structures to models of molecules
#include "pliant/model/amplitude.hpp"                 // how far frames of an ensemble are to go
#include "pliant/model/atoms/atom_graph.hpp"          // who is bonded to whom
#include "pliant/model/contacts/contact_file.hpp"     // contacts as text
#include "pliant/model/contacts/contact_kinds.hpp"    // their kinds
#include "pliant/model/contacts/contact_list.hpp"     // contacts, and the limits that they are
#include "pliant/model/contacts/contact_options.hpp"  // how they are found
#include "pliant/model/contacts/hydrogen_bond_energy.hpp"  // of one hydrogen bond
#include "pliant/model/contacts/hydrogen_bonds.hpp"        // hydrogen bonds and salt bridges
#include "pliant/model/contacts/tethers.hpp"               // hydrophobic tethers, metals
#include "pliant/model/model.hpp"                          // the model of a molecule
#include "pliant/model/prepare/prepare.hpp"                // waters out, hydrogens in
#include "pliant/model/prepare/protonation.hpp"            // forms of residues
#include "pliant/model/prepare/select_part.hpp"            // the atoms that a selection names
#include "pliant/model/prepare/survey.hpp"                 // what there is and what is missing
#include "pliant/model/rigidity/dilution_picture.hpp"  // rigid clusters as hydrogen bonds go, drawn
#include "pliant/model/rigidity/rigidity.hpp"          // rigid clusters, degrees of freedom
#include "pliant/model/rigidity/rigidity_dilution.hpp"  // the same as hydrogen bonds go
#include "pliant/model/rigidity/rigidity_network.hpp"   // atoms as bodies joined by bars
#include "pliant/model/steric_table.hpp"                // least distances of atoms
#include "pliant/model/torsions_of_residues.hpp"        // rotamers, the Ramachandran plot

// rigidity: what is rigid, by its graph alone
#include "pliant/rigidity/bar_rank.hpp"            // rank of the rigidity matrix
#include "pliant/rigidity/framework_rigidity.hpp"  // freedoms of joints and bars
#include "pliant/rigidity/pebble_game.hpp"         // bars that count, one by one
#include "pliant/rigidity/rigid_clusters.hpp"      // what comes of them

// framework: joints, bars and what is known of them
#include "pliant/framework/atom_table.hpp"         // names of joints
#include "pliant/framework/contact_kind_rows.hpp"  // kinds of molecular contacts
#include "pliant/framework/course.hpp"             // the way of a push that is no straight line
#include "pliant/framework/disturbed.hpp"          // what a resolve has to look at
#include "pliant/framework/edits.hpp"              // bars and contacts cut, added and restored
#include "pliant/framework/fingerprint.hpp"        // whether two mean the same atoms
#include "pliant/framework/frame.hpp"              // what a step shows
#include "pliant/framework/framework.hpp"          // Framework, State
#include "pliant/framework/graph.hpp"              // components, cycles, bridges, blocks
#include "pliant/framework/joint_names.hpp"        // how text files speak of joints
#include "pliant/framework/limits.hpp"             // distances held to intervals
#include "pliant/framework/measures/check_positions.hpp"  // can these positions carry the framework?
#include "pliant/framework/measures/feasibility.hpp"      // bars that cannot hold together
#include "pliant/framework/measures/limit_counts.hpp"     // how many of them hold
#include "pliant/framework/measures/neighbour_list.hpp"   // near pairs of joints
#include "pliant/framework/measures/residual.hpp"    // length errors, violations and tolerances
#include "pliant/framework/sterics.hpp"              // how near joints may come
#include "pliant/framework/torsion_preferences.hpp"  // turns about bonds that are usual

// order, resolve: the techniques
#include "pliant/order/check_ordering.hpp"             // validator
#include "pliant/order/ordering.hpp"                   // the table of orderings
#include "pliant/order/ordering_file.hpp"              // an ordering stated bar by bar
#include "pliant/order/traversal.hpp"                  // breadth first, depth first
#include "pliant/resolve/auto.hpp"                     // what auto chooses
#include "pliant/resolve/method/project_bar.hpp"       // the kernel
#include "pliant/resolve/method/resolve_options.hpp"   // tolerance, limit of sweeps
#include "pliant/resolve/method/resolve_summary.hpp"   // what a resolve did
#include "pliant/resolve/method/technique.hpp"         // ordering + weighting
#include "pliant/resolve/method/walker_positions.hpp"  // one copy of many
#include "pliant/resolve/resolve.hpp"                  // sweeps until whole
#include "pliant/resolve/techniques.hpp"               // the table of them
#include "pliant/resolve/walkers.hpp"                  // many copies at once

// perturb, run: the loop
#include "pliant/perturb/force_files/force_events.hpp"  // what a person did, to repeat
#include "pliant/perturb/force_files/force_file.hpp"    // pushes to replay
#include "pliant/perturb/force_files/force_header.hpp"  // what force files were made for
#include "pliant/perturb/guide.hpp"                     // where joints are asked to go
#include "pliant/perturb/perturbation.hpp"              // the pushers that need no more than a name
#include "pliant/perturb/push.hpp"                      // what a step pushed
#include "pliant/perturb/pusher.hpp"                    // what breaks the bars
#include "pliant/perturb/pushers.hpp"                   // the table of them
#include "pliant/perturb/steering.hpp"                  // forces from another thread
#include "pliant/run/ensemble.hpp"                      // many walkers; shards of them
#include "pliant/run/force_settings.hpp"                // options that force files keep
#include "pliant/run/motion.hpp"                        // one walker, step by step
#include "pliant/run/replay_events.hpp"                 // what a person did, once more
#include "pliant/run/run.hpp"                           // a motion shown to observers
#include "pliant/run/run_fields.hpp"                    // the table of its options
#include "pliant/run/run_options.hpp"                   // what it is asked for
#include "pliant/run/run_summary.hpp"                   // what a run did
#include "pliant/run/steered_walk.hpp"                  // a motion in somebody's hands

// sample: what a molecule can do
#include "pliant/base/math/dense_matrix.hpp"          // by rows
#include "pliant/sample/network/b_factors.hpp"        // which residues a crystal would show to move
#include "pliant/sample/network/elastic_network.hpp"  // the table of networks
#include "pliant/sample/network/mode_field.hpp"       // joints along one of them
#include "pliant/sample/network/network_modes.hpp"    // directions in which residues move together
#include "pliant/sample/sample.hpp"                   // frames along them
#include "pliant/sample/sample_fields.hpp"            // the table of its options
#include "pliant/sample/sample_options.hpp"           // what it is asked for
#include "pliant/sample/sample_summary.hpp"           // how exact, how far
#include "pliant/sample/sampler.hpp"                  // one way to move
#include "pliant/sample/samplers.hpp"                 // the table of ways to move

// path: from one structure of a molecule to another
#include "pliant/path/ends.hpp"          // what stands for what in both
#include "pliant/path/matching.hpp"      // residues of two structures
#include "pliant/path/path.hpp"          // the way, step by step or whole
#include "pliant/path/path_options.hpp"  // what it is asked for
#include "pliant/path/path_table.hpp"    // its table, frame by frame
#include "pliant/path/sequence.hpp"      // letters of residues, aligned
#include "pliant/path/trace.hpp"         // residues by one atom each

// record: trajectories and graphs
#include "pliant/record/h5md/h5md_checkpoint_reader.hpp"  // a run in a file, to go on
#include "pliant/record/h5md/h5md_header.hpp"             // what such a file says besides frames
#include "pliant/record/h5md/h5md_reader.hpp"             // frames of any H5MD file
#include "pliant/record/h5md/h5md_recorder.hpp"           // frames to an H5MD file
#include "pliant/record/h5md/saved_part.hpp"              // some of the joints, to record
#include "pliant/record/pdb_recorder.hpp"                 // frames as models of a PDB file
#include "pliant/record/sdf_recorder.hpp"                 // frames as records of an SDF file
#include "pliant/record/topology_pdb.hpp"                 // names and bonds for other programs
#include "pliant/record/xml/graph_xml.hpp"                // frameworks as XML
#include "pliant/record/xml/write_graph_xml.hpp"          // and back

// jobs: one door for each job, and what runs and samples go on from
#include "pliant/jobs/conformers_task.hpp"  // ranked conformers from several starts
#include "pliant/jobs/force_recorder.hpp"   // the pushes of a run as a force file
#include "pliant/jobs/recorded_run.hpp"     // a run, as files keep it
#include "pliant/jobs/recorded_sample.hpp"  // a sample, as files keep it
#include "pliant/jobs/rigidity_task.hpp"    // rigidity
#include "pliant/jobs/sample_task.hpp"      // an ensemble, or conformers, of a model

// stream: runs followed and steered while they go
#include "pliant/stream/imd_commands.hpp"  // what a client says
#include "pliant/stream/imd_exchange.hpp"  // what run and server share
#include "pliant/stream/imd_follower.hpp"  // what it asked for
#include "pliant/stream/imd_packets.hpp"   // what a server says
#include "pliant/stream/imd_server.hpp"    // live: VMD, MDAnalysis, pliant watch
#include "pliant/stream/imd_session.hpp"   // one client

// lab: frameworks of which everything is known; random graphs and test sets of the thesis
#include "pliant/lab/examples/examples.hpp"            // the table of them
#include "pliant/lab/generate/fundamental_cycles.hpp"  // one cycle for each non-tree bar
#include "pliant/lab/generate/random_graphs.hpp"       // trees, 1-, 2- and n-cycles
#include "pliant/lab/test_sets/make_test_set.hpp"      // of random graphs
#include "pliant/lab/test_sets/read_test_set.hpp"      // from folders
#include "pliant/lab/test_sets/test_results.hpp"       // what a heuristic did with each force
#include "pliant/lab/test_sets/test_set.hpp"           // graphs, forces and results in folders
