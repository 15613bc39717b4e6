#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/model_figures.h"

namespace hearth {

struct ModelRow {
  std::string_view name;
  std::string words;
};

/// The figures of a model in words. The axes are those of the level, with `z` up.
std::vector<ModelRow> modelRows(const ModelFigures& figures);

/// A section of the overlay.
void showModel(const ModelFigures& figures);

}  // namespace hearth
