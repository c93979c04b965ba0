// SPDX-License-Identifier: MIT
// One thing of each public header, by name: what a header needs is installed too, and what it
// declares is in the libraries that find_package(pliant) gives.
#include <cstddef>
#include <cstdio>
#include <string_view>

#include "pliant/base/error.hpp"
#include "pliant/base/log.hpp"
#include "pliant/base/vec3.hpp"
#include "pliant/framework/frame.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/jobs/sample_task.hpp"
#include "pliant/model/model.hpp"
#include "pliant/model/rigidity/rigidity.hpp"
#include "pliant/molecule/bonds/bonds.hpp"
#include "pliant/molecule/read/read.hpp"
#include "pliant/molecule/structure/structure.hpp"
#include "pliant/path/path.hpp"
#include "pliant/path/path_options.hpp"
#include "pliant/perturb/steering.hpp"
#include "pliant/record/h5md/h5md_reader.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"
#include "pliant/resolve/method/resolve_options.hpp"
#include "pliant/resolve/method/resolve_summary.hpp"
#include "pliant/resolve/method/technique.hpp"
#include "pliant/resolve/resolve.hpp"
#include "pliant/run/motion.hpp"
#include "pliant/run/run.hpp"
#include "pliant/run/run_options.hpp"
#include "pliant/run/run_summary.hpp"
#include "pliant/sample/sample_options.hpp"

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
    of("pliant/base/error.hpp", &quoted),
    of_type<Log>("pliant/base/log.hpp"),
    of_type<Vec3>("pliant/base/vec3.hpp"),
    of_type<SampleOptions>("pliant/sample/sample_options.hpp"),
    of("pliant/molecule/bonds/bonds.hpp", &perceive_bonds),
    of("pliant/molecule/read/read.hpp", &formats),
    of_type<Structure>("pliant/molecule/structure/structure.hpp"),
    of("pliant/model/model.hpp", &build_model),
    of("pliant/model/rigidity/rigidity.hpp", &analyse_rigidity),
    of("pliant/framework/frame.hpp", overload<std::string_view(Stop)>(&name)),
    of_type<State>("pliant/framework/framework.hpp"),
    of("pliant/resolve/method/resolve_options.hpp", overload<void(const ResolveOptions&)>(&check)),
    of("pliant/resolve/method/resolve_summary.hpp", &note_violations),
    of_type<Technique>("pliant/resolve/method/technique.hpp"),
    of("pliant/resolve/resolve.hpp", &Resolver::check_arguments),
    of("pliant/path/path.hpp", &find_path),
    of("pliant/path/path_options.hpp", &find_path_atoms),
    of("pliant/perturb/steering.hpp", &Steering::release),
    of("pliant/run/motion.hpp", &Motion::step),
    of("pliant/run/run.hpp", &run),
    of("pliant/run/run_options.hpp", &replayed_steps),
    of("pliant/run/run_summary.hpp", &add),
    of("pliant/record/h5md/h5md_reader.hpp", &H5mdReader::frames),
    of("pliant/record/h5md/h5md_recorder.hpp", &H5mdRecorder::flush),
    of("pliant/jobs/sample_task.hpp", &SampleTask::run),
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
