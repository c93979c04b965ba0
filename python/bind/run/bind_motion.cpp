// SPDX-License-Identifier: MIT
// Motion: one walker, step by step.
#include "pliant/run/motion.hpp"

#include <nanobind/stl/variant.h>

#include <atomic>
#include <variant>

#include "arrays.hpp"
#include "collected.hpp"
#include "interrupt.hpp"
#include "messages.hpp"
#include "options.hpp"
#include "run/observers.hpp"
#include "run/pushers.hpp"
#include "run/pushes.hpp"

namespace pliant::python {
namespace {

/// A Motion on a State that Python sees too.
class PythonMotion {
 public:
  PythonMotion(const Framework& framework, State start, MotionOptions options, std::uint64_t walker)
      : state_(nb::cast(std::move(start))),
        callable_(options.technique),
        motion_(framework, std::ref(nb::cast<State&>(state_)), watched(std::move(options)),
                walker) {}

  OwnedFrame start() { return framed(&Motion::start); }
  OwnedFrame step() { return framed(&Motion::step); }

  void add(nb::handle pusher) {
    const Use use(*this);
    const std::shared_ptr<Pusher> added = pusher_from(pusher, state_);
    if (auto of_python = std::dynamic_pointer_cast<PusherOfPython>(added))
      of_python_.push_back(std::move(of_python));
    motion_.add(added);
  }

  /// A function that pushes or resolves often sees the Motion that it pushes for.
  int traverse(visitproc visit, void* argument) const {
    for (const auto& pusher : of_python_)
      if (PyObject* object = pusher->object().ptr())
        if (const int answer = visit(object, argument)) return answer;
    return callable_.traverse(visit, argument);
  }
  void clear() {
    for (const auto& pusher : of_python_) pusher->forget_object();
    callable_.clear();
  }

  /// Whoever asks may change it.
  nb::object state() {
    is_lent_ = true;
    return state_;
  }

  OwnedRunSummary summary() {
    const Use use(*this);
    return {motion_.summary(), state_};
  }

  bool is_over() {
    const Use use(*this);
    return motion_.is_over();
  }

 private:
  /// One call at a time.
  class Use {
   public:
    explicit Use(PythonMotion& motion) : in_use_(motion.in_use_) {
      if (in_use_.exchange(true)) throw std::runtime_error("Motion: a step is under way");
    }
    ~Use() { in_use_ = false; }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

   private:
    std::atomic<bool>& in_use_;
  };

  MotionOptions watched(MotionOptions options) {
    options.log = python_log();
    options.resolve.should_stop = [this] { return watch_(); };
    return options;
  }

  OwnedFrame framed(Frame (Motion::*act)()) {
    const Use use(*this);
    watch_ = InterruptWatch();
    Frame frame;
    {
      const nb::gil_scoped_release no_gil;
      if (is_lent_.exchange(false)) motion_.change_state();
      frame = (motion_.*act)();
    }
    if (watch_.raised()) std::rethrow_exception(watch_.raised());
    return {frame, state_};
  }

  nb::object state_;
  CallableOf callable_;
  InterruptWatch watch_;
  std::atomic<bool> in_use_{false}, is_lent_{false};
  std::vector<std::shared_ptr<PusherOfPython>> of_python_;
  Motion motion_;
};

State start_from(nb::handle state) {
  if (nb::isinstance<State>(state)) return nb::cast<const State&>(state);
  return State(positions_from(ArrayLike{nb::borrow(state)}, "state"));
}

void make_motion(PythonMotion* self, const Framework& framework, nb::handle state,
                 const TechniqueLike& technique, double weighting, bool mass_weighted,
                 const std::optional<OrderingColumns>& ordering,
                 const std::variant<std::string, std::vector<std::string>>& push, double force,
                 double timestep, double damping, double displacement, const PythonPushes& replay,
                 std::int64_t replay_from, const std::optional<Guide>& guide, double tolerance,
                 std::optional<double> tolerance_length, double tolerance_limit,
                 double tolerance_overlap, std::int64_t max_sweeps, std::uint64_t seed,
                 std::uint64_t walker) {
  const ResolveArguments resolve{
      technique,         weighting,  mass_weighted, tolerance, tolerance_length, tolerance_limit,
      tolerance_overlap, max_sweeps, seed,          walker,    ordering};
  MotionOptions options;
  options.technique = resolve.chosen(framework);
  options.resolve = resolve.options();
  if (const auto* one = std::get_if<std::string>(&push)) {
    options.push = {*one};
  } else {
    options.push = std::get<std::vector<std::string>>(push);
  }
  options.perturb = {force, timestep, damping, displacement};
  options.replay = pushes_from(replay);
  options.replay_from = replay_from;
  if (guide) options.guide = *guide;
  check_pushes(framework, options.replay);
  new (self) PythonMotion(framework, start_from(state), std::move(options), walker);
}

constexpr const char* motion_doc =
    "One walker, step by step: call ``start`` first, then ``step`` again and again.\n\n"
    "What follows depends on the state alone: a Motion made with a copy of ``state`` continues,\n"
    "without ``start``, with the same bits as this one. ``step`` releases the GIL; pushers "
    "written\n"
    "in Python take it. Two calls at once raise RuntimeError. Ctrl-C takes the step back.\n\n"
    "Parameters\n"
    "----------\n"
    "framework : Framework\n"
    "state : State or (N, 3) Angstrom\n"
    "    Copied; ``Motion.state`` is what moves.\n"
    "technique, weighting, mass_weighted, ordering\n"
    "    As for ``resolve``: the technique may be a function.\n"
    "push : str or sequence of str\n"
    "    Names in ``pushers()``, in the order in which they act in each step.\n"
    "force, timestep, damping, displacement : float\n"
    "    As for ``run``.\n"
    "replay : sequence of (joint, (x, y, z))\n"
    "    For pusher ``replay``: forces in kJ/(mol Angstrom), one per step.\n"
    "replay_from : int\n"
    "    The step after which replays and rocking begin.\n"
    "guide : Guide, optional\n"
    "    For pushers ``rock``, ``pull`` and ``pair_distance``.\n"
    "tolerance, tolerance_length, tolerance_limit, tolerance_overlap, max_sweeps\n"
    "    As for ``resolve``.\n"
    "seed, walker : int\n"
    "    All random numbers are functions of these, the step and the joint.";

}  // namespace

void bind_motion(nb::module_& module) {
  const Technique technique;
  const ResolveOptions resolve;
  const PerturbOptions perturb;
  nb::class_<PythonMotion>(module, "Motion", motion_doc,
                           nb::type_slots(Collected<PythonMotion>::slots))
      .def("__init__", &make_motion, nb::keep_alive<1, 2>(), "framework"_a, "state"_a,
           "technique"_a = technique.name, "weighting"_a = technique.weighting, nb::kw_only(),
           "mass_weighted"_a = technique.mass_weighted, "ordering"_a = nb::none(),
           "push"_a = "force", "force"_a = perturb.force, "timestep"_a = perturb.timestep,
           "damping"_a = perturb.damping, "displacement"_a = perturb.displacement,
           "replay"_a = PythonPushes(), "replay_from"_a = 0, "guide"_a = nb::none(),
           "tolerance"_a = resolve.tolerance.relative, "tolerance_length"_a = nb::none(),
           "tolerance_limit"_a = resolve.tolerance.limit,
           "tolerance_overlap"_a = resolve.tolerance.overlap, "max_sweeps"_a = resolve.max_sweeps,
           "seed"_a = resolve.seed, "walker"_a = resolve.walker)
      .def("add", &PythonMotion::add, "pusher"_a,
           "Acts in each step after the pushers that are there already: a ``Steering``, or\n"
           "something to be called with (step, positions, previous). It moves joints of\n"
           "``positions``, (N, 3) Angstrom, in place, and returns which: a sequence of joints or\n"
           "a mask, or None for any. ``previous`` is where they were before the step.\n"
           "Pinned joints stay, whatever it does. What it raises leaves the state as it was.")
      .def("start", &PythonMotion::start,
           "The first frame: positions are made whole if they are not, and are then at rest.")
      .def("step", &PythonMotion::step,
           "Pushes and resolves. The frame says whether it converged; its positions are a view\n"
           "of what the next step changes.")
      .def_prop_ro("state", &PythonMotion::state, nb::sig("def state(self) -> State"),
                   "What moves. To change it between steps ask for it each time.")
      .def_prop_ro("summary", &PythonMotion::summary, nb::sig("def summary(self) -> RunSummary"),
                   "What has been done until now.")
      .def_prop_ro("is_over", &PythonMotion::is_over,
                   "Ctrl-C, or no pusher has more to push; ``step`` works all the same.");
}

}  // namespace pliant::python
