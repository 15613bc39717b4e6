#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "files/file_source.h"
#include "image/image.h"
#include "load/limits.h"
#include "math/vec.h"

namespace hearth {

/// What the faces of a model wear.
struct ModelMaterial {
  Rgb color;                                   ///< `Kd`
  std::optional<std::filesystem::path> image;  ///< `map_Kd`, which replaces the colour
  std::string imageNamedAt;                    ///< as FILE:LINE
};

/// A triangle of a model, in the axes of its file: x, y up, z; right-handed.
struct ModelFace {
  std::array<Vec3, 3> corners;            ///< counter-clockwise seen from its front
  std::array<Vec2, 3> image;              ///< `vt`: in repeats, to the right and up; 0 without
  std::optional<std::uint32_t> material;  ///< index
  std::uint32_t line;                     ///< of the file, from 1
};

/// A Wavefront OBJ file (Alias|Wavefront, "Object Files", version 3.0), with the materials of the
/// MTL files that it names.
struct Model {
  std::vector<ModelFace> faces;          ///< at least one; each has an area
  std::vector<ModelMaterial> materials;  ///< that it uses, in the order in which it begins to
  std::size_t vertices = 0;              ///< of the file: its `v`
  std::size_t polygons = 0;              ///< of the file: its `f`, which become the faces
};

/// What is wrong with a model, or what of it is left out.
struct ModelMistake {
  std::filesystem::path file;
  int line;  ///< from 1; 0 for the file as a whole
  bool isError;
  std::string message;
  std::string advice;
};

struct ModelRead {
  std::optional<Model> model;                ///< none after an error
  std::vector<ModelMistake> mistakes;        ///< in the order of the files
  std::vector<std::filesystem::path> files;  ///< that were read, the model's first
};

/// Reads `v`, `vt`, `f`, `usemtl`, `mtllib`, `newmtl`, `Kd` and `map_Kd`; all else is left out, and
/// told once for each file. Polygons become fans from their first corner; triangles without area
/// are left out, and told. Numbers are the nearest doubles. Of each file, the errors after the
/// first twenty are not told.
ModelRead readModel(const std::filesystem::path& file, const LoadLimits& limits,
                    const FileSource& files = DiskFiles());

}  // namespace hearth
