// SPDX-License-Identifier: MIT
// What a program that uses Pliant calls, in the order in which data flows. These headers are
// promised (docs/pages/stability.md); what they include is installed with them, and may change.
#pragma once

// base: vectors, errors, messages
#include "pliant/base/error.hpp"  // Error, InputError, OptionError, FileError
#include "pliant/base/log.hpp"    // notes and warnings, through a callback
#include "pliant/base/vec3.hpp"   // Vec3

// molecule: files to structures
#include "pliant/molecule/bonds/bonds.hpp"          // bond perception
#include "pliant/molecule/read/read.hpp"            // PDB, mmCIF, XYZ, SDF
#include "pliant/molecule/structure/structure.hpp"  // atoms, positions, bonds

// model: structures to models of molecules
#include "pliant/model/model.hpp"              // the model of a molecule
#include "pliant/model/rigidity/rigidity.hpp"  // rigid clusters, degrees of freedom

// framework: joints, bars and what is known of them
#include "pliant/framework/frame.hpp"      // what a step shows
#include "pliant/framework/framework.hpp"  // Framework, State

// resolve: broken bars made whole
#include "pliant/resolve/method/resolve_options.hpp"  // tolerance, limit of sweeps
#include "pliant/resolve/method/resolve_summary.hpp"  // what a resolve did
#include "pliant/resolve/method/technique.hpp"        // ordering + weighting
#include "pliant/resolve/resolve.hpp"                 // sweeps until whole

// perturb, run: the loop
#include "pliant/perturb/steering.hpp"  // forces from another thread
#include "pliant/run/motion.hpp"        // one walker, step by step
#include "pliant/run/run.hpp"           // a motion shown to observers
#include "pliant/run/run_options.hpp"   // what it is asked for
#include "pliant/run/run_summary.hpp"   // what a run did

// sample, path: what a molecule can do
#include "pliant/jobs/sample_task.hpp"       // an ensemble, or conformers, of a model
#include "pliant/path/path.hpp"              // the way, step by step or whole
#include "pliant/path/path_options.hpp"      // what it is asked for
#include "pliant/sample/sample_options.hpp"  // what it is asked for

// record: trajectories
#include "pliant/record/h5md/h5md_reader.hpp"    // frames of any H5MD file
#include "pliant/record/h5md/h5md_recorder.hpp"  // frames to an H5MD file
