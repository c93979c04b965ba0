// SPDX-License-Identifier: MIT
// Conformers: starts, draws with our own energy, and the choice among them.
#include "arrays.hpp"
#include "messages.hpp"
#include "molecule/structure.hpp"
#include "option_fields.hpp"
#include "pliant/conformers/choice/choose_conformers.hpp"
#include "pliant/conformers/torsions/bond_turn_kinds.hpp"
#include "pliant/jobs/conformers_task.hpp"
#include "pliant/jobs/job.hpp"

namespace pliant::python {
namespace {

/// (F, N, 3) of as many sets of N positions.
template <class Sets, class PositionsIn>
FramesView frames_of(const Sets& sets, std::size_t atoms, const PositionsIn& positions_in) {
  std::vector<Vec3> flat;
  flat.reserve(sets.size() * atoms);
  for (const auto& set : sets) {
    const std::vector<Vec3>& x = positions_in(set);
    flat.insert(flat.end(), x.begin(), x.end());
  }
  return new_frames(std::move(flat), sets.size(), atoms);
}

/// Of those that `take_options` gave.
ConformerOptions options_from(const nb::dict& values) {
  ConformerOptions options;
  take_values(conformer_fields(), nb::cast<nb::dict>(values.attr("copy")()), options);
  options.both_hands = values.contains("both_hands") && nb::cast<bool>(values["both_hands"]);
  options.log = python_log();
  return options;
}

nb::tuple draw(const nb::object& structure, const nb::dict& options) {
  const auto& given = nb::cast<const Structure&>(structure);
  const ConformerOptions asked = options_from(options);
  std::vector<MolecularModel> models;
  DrawnConformers drawn;
  {
    const nb::gil_scoped_release no_gil;
    models = conformer_starts(given, asked);
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
      drawn.max_residual);
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
                        const std::vector<double>& energies, const nb::dict& options) {
  const Shapes shapes(structure);
  const ConformerOptions asked = options_from(options);
  const double window = asked.window > 0.0 ? asked.window : HUGE_VAL;
  const std::vector<std::size_t> chosen = choose_conformers(
      shapes.distances(positions), energies, {std::size_t(asked.max), asked.rms, window});
  return nb::cast(array_of(std::vector<std::int64_t>(chosen.begin(), chosen.end())));
}

/// (K, 4) atoms of torsions about axes of atropisomers.
nb::object axes_of(const nb::object& structure) {
  const MolecularModel model =
      build_model(nb::cast<const Structure&>(structure), {.kind = ModelKind::angles});
  nb::list found;
  for (const auto& [one, a, b, other] :
       atropisomer_axes(BondChemistry(model.framework, model.positions)))
    found.append(nb::make_tuple(one, a, b, other));
  return found;
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

/// Options of a call by name, those of one ligand that are not as usual below "molecule".
nb::dict take_options(const nb::kwargs& more) {
  nb::dict given(more), values, molecule;
  Job job = usual_job("conformers"), usual = job;
  take_values(conformer_fields(), given, job.conformers);
  settle(job.conformers);
  for (const OptionRow<Job>& row : job_rows("conformers")) {
    const nb::str name(row.facts->name.data(), row.facts->name.size());
    const OptionPlace place = row.place(job);
    if (given.contains(name)) {
      take_value(*row.facts, place, given[name]);
      check_option(*row.facts, place);
      nb::del(given[name]);
    }
    if (row.path.starts_with("conformers/"))
      values[name] = value_of(place);
    else if (option_text(place) != option_text(row.place(usual)))
      molecule[name] = value_of(place);
  }
  refuse_unknown(nb::module_::import_("pliant._core").attr("conformers"),
                 nb::make_tuple(nb::none()), given);
  values["molecule"] = molecule;
  return values;
}

/// As `pliant.jobs.conformers.suite` finds them.
nb::object conformers_of(const nb::object& molecule, const nb::object& max,
                         const nb::kwargs& more) {
  nb::dict given(more);
  if (!max.is_none()) given["max"] = max;
  return nb::module_::import_("pliant.jobs.conformers.suite").attr("found")(molecule, given);
}

constexpr const char* conformers_doc =
    R"(Return ranked conformers of a molecule, or an iterator over those of a library.

Candidates are drawn from several starts without overlaps, those that are alike are left out, and at
most `max` are kept, lowest energy first. Lengths and angles are those of the start.

Parameters
----------
molecule : rdkit.Chem.Mol, SMILES, Structure, path or iterable
    One molecule; or a library: the path of an SDF, MOL or SMILES file (also compressed), or of a PDB,
    mmCIF or XYZ file of one ligand, or an iterable of molecules. A molecule without positions is
    embedded by RDKit, with hydrogens. The options from `format` on are of such a file of one ligand,
    those from `select` on also of a Structure.
)";

constexpr const char* rest_of_conformers_doc =
    R"(
Returns
-------
rdkit.Chem.Mol, Conformers or iterator
    A Mol, with its properties and hydrogens, for a Mol or a SMILES: each conformer has the properties
    pliant_energy (kcal/mol) and pliant_start. Conformers for a Structure. For a library one of these
    after the other (Conformers for a path), in its order, and a `FailedMolecule`, which is false, for
    each molecule that fails.

Raises
------
ImportError
    RDKit or OpenMM is needed and not installed; the message says how to install it.
InputError, OptionError, FileError
    A single molecule cannot be used, or an option is wrong; a library cannot be read.

Warns
-----
PliantWarning
    Stereo of a molecule that is made 3-D is not given: one isomer is made. Hydrogens that were missing
    are added. Bond orders or charges of a ligand are guessed. A molecule of a library was there
    before: it is done again.
)";

void bind_conformers_function(nb::module_& module) {
  Job usual = usual_job("conformers");
  const std::string molecules =
      std::string(any_molecule) + " | collections.abc.Iterable[typing.Any]";
  std::string signature = "def conformers(molecule: " + molecules, doc = conformers_doc;
  for (const OptionRow<Job>& row : job_rows("conformers")) {
    signature += ", " + argument_text(*row.facts, row.place(usual));
    if (row.facts->name == "max") signature += ", *";
    doc += argument_doc(*row.facts, row.place(usual));
  }
  module.def("conformers", &conformers_of, "molecule"_a.none(), "max"_a = nb::none(), "options"_a,
             nb::sig((signature + ") -> typing.Any").c_str()),
             (doc + rest_of_conformers_doc).c_str());
  module.def("conformer_options", &take_options, "options"_a,
             nb::sig("def conformer_options(**options: typing.Any) -> dict[str, typing.Any]"),
             "What ``conformers`` is asked for by such options, checked, by name.");
}

}  // namespace

void bind_conformers(nb::module_& module) {
  bind_conformers_function(module);
  module.def("_draw_conformers", &draw, "structure"_a, "options"_a);
  module.def("_atropisomer_axes", &axes_of, "structure"_a);
  module.def("_choose_conformers", &choose_among, "structure"_a, "positions"_a, "energies"_a,
             "options"_a);
  module.def("_symmetric_rmsd", &nearest, "structure"_a, "positions"_a, "goals"_a);
}

}  // namespace pliant::python
