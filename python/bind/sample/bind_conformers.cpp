// SPDX-License-Identifier: MIT
// Conformers: starts, draws with our own energy, and the choice among them.
#include "arrays.hpp"
#include "messages.hpp"
#include "model/model_arguments.hpp"
#include "molecule/structure.hpp"
#include "pliant/conformers/choice/choose_conformers.hpp"
#include "pliant/jobs/conformers_task.hpp"

namespace pliant::python {
namespace {

using Frames = nb::ndarray<nb::numpy, double, nb::shape<-1, -1, 3>, nb::c_contig>;
using GivenFrames = nb::ndarray<const double, nb::shape<-1, -1, 3>, nb::c_contig, nb::device::cpu>;

/// (F, N, 3) of as many sets of N positions.
template <class Sets, class PositionsIn>
Frames frames_of(const Sets& sets, std::size_t atoms, const PositionsIn& positions_in) {
  auto* flat = new std::vector<Vec3>;
  nb::capsule owner(flat, [](void* p) noexcept { delete static_cast<std::vector<Vec3>*>(p); });
  flat->reserve(sets.size() * atoms);
  for (const auto& set : sets) {
    const std::vector<Vec3>& x = positions_in(set);
    flat->insert(flat->end(), x.begin(), x.end());
  }
  return Frames(reinterpret_cast<double*>(flat->data()), {sets.size(), atoms, 3}, owner);
}

std::span<const Vec3> frame_of(const GivenFrames& frames, std::size_t frame) {
  const auto* all = reinterpret_cast<const Vec3*>(frames.data());
  return {all + frame * frames.shape(1), frames.shape(1)};
}

nb::tuple draw(const nb::object& structure, std::int64_t starts, std::int64_t frames,
               std::uint64_t seed, bool turn_amides, std::int64_t threads) {
  const auto& given = nb::cast<const Structure&>(structure);
  const ConformersAsked asked{frames, seed, turn_amides, threads, python_log()};
  std::vector<MolecularModel> models;
  DrawnConformers drawn;
  {
    const nb::gil_scoped_release no_gil;
    models = conformer_starts(given, starts, asked);
    drawn = draw_conformers(models, asked);
  }
  const std::size_t atoms = given.size();
  return nb::make_tuple(
      frames_of(
          drawn.positions, atoms, [](const auto& x) -> const auto& { return x; }),
      array_of(std::vector<std::int64_t>(drawn.start.begin(), drawn.start.end())),
      array_of(drawn.energies),
      frames_of(
          models, atoms, [](const auto& model) -> const auto& { return model.positions; }),
      drawn.max_residual, drawn.worst_bar, drawn.failed);
}

/// Shapes of conformers by the symmetries of their molecule.
class Shapes {
 public:
  explicit Shapes(const nb::object& structure)
      : model_(build_model(nb::cast<const Structure&>(structure), options())),
        symmetries_(
            symmetries(model_.framework, BondChemistry(model_.framework, model_.positions))) {}
  /// Of all frames, one set after the other. This must outlive them.
  template <class... Sets>
  ShapeDistances distances(const Sets&... sets) const {
    ShapeDistances found(symmetries_);
    (add_to(found, sets), ...);
    return found;
  }

 private:
  static void add_to(ShapeDistances& found, const GivenFrames& frames) {
    for (std::size_t k = 0; k < frames.shape(0); ++k) found.add(frame_of(frames, k));
  }

  static ModelOptions options() {
    ModelOptions options;
    options.kind = ModelKind::angles;
    return options;
  }
  MolecularModel model_;
  Symmetries symmetries_;
};

nb::object choose_among(const nb::object& structure, const GivenFrames& positions,
                        const std::vector<double>& energies, std::size_t most, double rms,
                        double window) {
  const Shapes shapes(structure);
  const std::vector<std::size_t> chosen =
      choose_conformers(shapes.distances(positions), energies, {most, rms, window});
  return nb::cast(array_of(std::vector<std::int64_t>(chosen.begin(), chosen.end())));
}

nb::object nearest(const nb::object& structure, const GivenFrames& positions,
                   const GivenFrames& goals) {
  const Shapes shapes(structure);
  const ShapeDistances distances = shapes.distances(positions, goals);
  std::vector<double> out;
  for (std::size_t k = 0; k < positions.shape(0); ++k)
    for (std::size_t m = 0; m < goals.shape(0); ++m)
      out.push_back(distances.between(k, positions.shape(0) + m));
  return nb::cast(array_of(out));
}

}  // namespace

void bind_conformers(nb::module_& module) {
  using namespace nb::literals;
  module.def(
      "conformer_rows", [] { return argument_rows(ModelArguments::small); },
      nb::sig("def conformer_rows() -> list[dict[str, typing.Any]]"),
      "The table of what ``pliant conformers`` takes of the options of a molecule.");
  module.def("_draw_conformers", &draw, "structure"_a, "starts"_a, "frames"_a, "seed"_a,
             "turn_amides"_a = false, "threads"_a = 1);
  module.def("_choose_conformers", &choose_among, "structure"_a, "positions"_a, "energies"_a,
             "most"_a, "rms"_a, "window"_a);
  module.def("_symmetric_rmsd", &nearest, "structure"_a, "positions"_a, "goals"_a);
}

}  // namespace pliant::python
