// SPDX-License-Identifier: MIT
#include "pliant/jobs/rigidity_task.hpp"

#include <filesystem>
#include <utility>

#include "pliant/base/printable.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/molecule/selection.hpp"

namespace pliant {
namespace {

constexpr std::string_view group = "Counting";

template <auto Member>
constexpr auto at = place_at<RigidityAsked, Member>;

constexpr OptionField<RigidityAsked> table[] = {
    {{.name = "hbond_bars",
      .group = group,
      .summary = "how many freedoms a hydrogen bond or salt bridge removes",
      .range = Range::positive,
      .largest = freedoms_of_body,
      .in_python = "Bars of a hydrogen bond or salt bridge, 1 to 6."},
     at<&RigidityAsked::hbond_bars>},
    {{.name = "tether_bars",
      .group = group,
      .summary = "how many a hydrophobic contact removes; 0 ignores these contacts",
      .range = Range::zero_or_more,
      .largest = freedoms_of_body,
      .in_python = "Bars of a hydrophobic contact, 0 to 6."},
     at<&RigidityAsked::tether_bars>},
    {{.name = "ends_turn",
      .group = group,
      .summary = "an atom with only one bond does not rotate about it if a hydrogen bond "
                 "holds the atom: D-H of D-H..A stays fixed",
      .in_python = "Whether the bond to an atom with no other bond turns where a hydrogen bond\n"
                   "holds that atom (D-H of D-H..A), as in FIRST.",
      .users = {.command = false}},
     at<&RigidityAsked::ends_turn>},
    {{.name = "free_angles",
      .group = group,
      .summary = "hold no angle at these atoms, which become ball joints: \"element O\" frees "
                 "Si-O-Si in a silicate",
      .kind = "SELECTION",
      .in_python = "Selection of atoms at which no angle is held: they become ball joints, as\n"
                   "Si-O-Si of silicates."},
     at<&RigidityAsked::free_angles>},
};

RigidityOptions options_of(const RigidityAsked& asked, const AtomTable& atoms) {
  for (const OptionField<RigidityAsked>& field : rigidity_fields())
    check_option(field, field.place(places_of(asked)));
  RigidityOptions options;
  for (const MolecularContactKindEntry& row : molecular_contact_kinds())
    if (row.has_hydrogen()) options.bars[row.kind] = static_cast<std::uint8_t>(asked.hbond_bars);
  options.bars[MolecularContactKind::hydrophobic] = static_cast<std::uint8_t>(asked.tether_bars);
  options.ends_turn = asked.ends_turn;
  if (!asked.free_angles.empty())
    options.free_angles = select_some_atoms(atoms, asked.free_angles, "free angles");
  return options;
}

}  // namespace

std::span<const OptionField<RigidityAsked>> rigidity_fields() { return table; }

MoleculeRigidity find_rigidity(ContactModel model, const RigidityAsked& asked) {
  const RigidityOptions options = options_of(asked, model.structure.atoms);
  Rigidity found = analyse_rigidity(model.structure, model.contacts, options);
  return {std::move(model), std::move(found)};
}

DrawnDilution draw_dilution(const MoleculeRigidity& found, const std::string& name) {
  const std::filesystem::path file = path_of(found.model.structure.source);
  const std::string title = name.empty() ? printable_name(path_text(file.filename())) : name;
  return draw_dilution(found.model, found.rigidity.network, dilution_title(title));
}

}  // namespace pliant
