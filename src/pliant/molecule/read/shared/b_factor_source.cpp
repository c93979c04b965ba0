// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/shared/b_factor_source.hpp"

#include <algorithm>
#include <initializer_list>

#include "pliant/base/letters.hpp"

namespace pliant {
namespace {

bool has_any(std::string_view text, std::initializer_list<std::string_view> words) {
  const std::string lower = lower_case(text);
  return std::ranges::any_of(
      words, [&](std::string_view word) { return lower.find(word) != std::string::npos; });
}

}  // namespace

void take_method(Structure& structure, std::string_view record, std::string_view method) {
  if (structure.b_factor_source != BFactorSource::unknown) return;
  if (has_any(method, {"diffraction", "microscopy", "nmr", "crystallography", "scattering"}))
    structure.b_factor_source = BFactorSource::experiment;
  else if (has_any(method, {"model", "predict", "simulation"}))
    structure.b_factor_source = BFactorSource::model;
  else
    return;
  structure.b_factor_record = std::string(record) + " " + std::string(method);
}

void take_title_of_prediction(Structure& structure) {
  if (structure.b_factor_source == BFactorSource::experiment) return;
  if (!has_any(structure.title, {"alphafold", "esmfold", "colabfold"})) return;
  structure.b_factor_source = BFactorSource::confidence;
  structure.b_factor_record = "title " + structure.title;
}

}  // namespace pliant
