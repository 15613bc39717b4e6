#include <fmt/format.h>

#include <map>
#include <set>
#include <string>
#include <utility>

#include "load/json/fields.h"
#include "load/link/link.h"
#include "load/link/place_model.h"
#include "load/link/position_finder.h"
#include "load/model/read_model.h"

namespace hearth {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBareFace = "#ffffff";  // of faces without a material or texture

/// A model as the meshes that show it need it.
struct LinkedModel {
  fs::path file;
  std::optional<Model> model;       ///< none after an error
  std::vector<TextureId> textures;  ///< by material
};

class MeshLinker {
 public:
  MeshLinker(Linking& linking, const ModelPlace& place) : linking_(linking), place_(place) {}

  /// Reads the models of all meshes; false if these have more faces than may be.
  bool readModels();
  void placeMeshes();
  std::vector<fs::path> takeFiles() { return std::move(files_); }

 private:
  LinkedModel read(const NameReference& file);
  void tell(const ModelMistake& mistake, Place place);
  void keepFiles(const std::vector<fs::path>& files);
  std::vector<TextureId> linkMaterials(const ModelRead& read, Place place);
  std::string nameInLevel(const fs::path& image) const;
  void place(const MeshDescription& described, const LinkedModel& model,
             const PositionFinder& finder);
  bool addFaces(const MeshDescription& described, const LinkedModel& model,
                const ModelPlacement& placement, std::optional<TextureId> bare);

  Linking& linking_;
  const ModelPlace& place_;
  std::map<std::string, LinkedModel> models_;  // by name
  std::size_t faces_ = 0;                      // of all meshes
  std::vector<fs::path> files_;                // that were read
  std::set<fs::path> areKept_;                 // the same
  std::set<std::string> told_;                 // mistakes
};

bool MeshLinker::readModels() {
  for (const MeshDescription& mesh : linking_.description.meshes) {
    auto found = models_.find(mesh.file.name);
    if (found == models_.end()) found = models_.emplace(mesh.file.name, read(mesh.file)).first;
    if (!found->second.model) continue;
    faces_ += found->second.model->faces.size();
    if (faces_ <= place_.limits.meshFaces) continue;
    linking_.report.error(mesh.file.place,
                          fmt::format("the meshes up to this one have {} faces, more than {}",
                                      faces_, place_.limits.meshFaces),
                          "raise the limit with --max-mesh-faces");
    return false;
  }
  return true;
}

LinkedModel MeshLinker::read(const NameReference& file) {
  LinkedModel linked{place_.level.parent_path() / file.name, {}, {}};
  ModelRead read = readModel(linked.file, place_.limits, place_.files);
  for (const ModelMistake& mistake : read.mistakes) tell(mistake, file.place);
  keepFiles(read.files);
  if (read.model) linked.textures = linkMaterials(read, file.place);
  linked.model = std::move(read.model);
  return linked;
}

/// Tells each mistake once: models may share a file of materials.
void MeshLinker::tell(const ModelMistake& mistake, Place place) {
  std::string message = mistake.file.string();
  if (mistake.line > 0) message += fmt::format(":{}", mistake.line);
  message += ": " + mistake.message;
  if (!told_.insert(message).second) return;
  if (mistake.isError)
    linking_.report.error(place, std::move(message), mistake.advice);
  else
    linking_.report.warning(place, std::move(message), mistake.advice, "model-skips");
}

void MeshLinker::keepFiles(const std::vector<fs::path>& files) {
  for (const fs::path& file : files)
    if (areKept_.insert(file).second) files_.push_back(file);
}

std::vector<TextureId> MeshLinker::linkMaterials(const ModelRead& read, Place place) {
  std::vector<TextureId> textures;
  for (const ModelMaterial& material : read.model->materials) {
    const Rgb color = material.color;
    textures.push_back(
        material.image
            ? linking_.textures.idOf({nameInLevel(*material.image), place},
                                     ForeignImage{*material.image, material.imageNamedAt})
            : linking_.textures.idOf(
                  {fmt::format("#{:02x}{:02x}{:02x}", color.r, color.g, color.b), place}));
  }
  return textures;
}

/// Its path as the level file would give it.
std::string MeshLinker::nameInLevel(const fs::path& image) const {
  const fs::path relative = image.lexically_relative(place_.level.parent_path());
  return relative.empty() ? image.string() : relative.string();
}

void MeshLinker::placeMeshes() {
  const PositionFinder finder(linking_);
  linking_.level.meshFaces.reserve(faces_);
  for (const MeshDescription& mesh : linking_.description.meshes)
    place(mesh, models_.at(mesh.file.name), finder);
}

void MeshLinker::place(const MeshDescription& described, const LinkedModel& model,
                       const PositionFinder& finder) {
  // Named images must exist, whether a face wears them or not.
  std::optional<TextureId> bare;
  if (described.texture) bare = linking_.textures.idOf(*described.texture);
  const auto standing = finder.find(described);
  if (!standing || !model.model) return;
  Mesh mesh = described.mesh;
  mesh.position = standing->position;
  mesh.sector = standing->sector;
  mesh.standsOnFloor = !described.z;
  std::vector<MeshFace>& faces = linking_.level.meshFaces;
  mesh.firstFace = static_cast<std::uint32_t>(faces.size());
  if (!addFaces(described, model, {described.scale, described.angle, mesh.position}, bare)) return;
  mesh.faceCount = static_cast<std::uint32_t>(faces.size()) - mesh.firstFace;
  if (mesh.faceCount == 0)
    return linking_.report.error(
        described.file.place,
        fmt::format("no face of {} has an area at this scale", model.file.string()),
        "raise \"scale\"");
  linking_.level.meshes.push_back(std::move(mesh));
}

/// False after a mistake. Leaves out faces that have no area any more.
bool MeshLinker::addFaces(const MeshDescription& described, const LinkedModel& model,
                          const ModelPlacement& placement, std::optional<TextureId> bare) {
  for (const ModelFace& face : model.model->faces) {
    MeshFace placed = placement(face);
    for (const Vec3& corner : placed.corners) {
      if (isInReach(corner)) continue;
      linking_.report.error(
          described.file.place,
          fmt::format("{}:{}: a corner of this face is at ({}, {}, {}) of the level, beyond {} m",
                      model.file.string(), face.line, corner.x, corner.y, corner.z, kWorldLimit),
          "lower \"scale\", or move the mesh");
      return false;
    }
    if (!hasArea(placed)) continue;
    if (!face.material && !bare)
      bare = linking_.textures.idOf({std::string(kBareFace), described.file.place});
    placed.texture = face.material ? model.textures[*face.material] : *bare;
    linking_.level.meshFaces.push_back(placed);
  }
  return true;
}

}  // namespace

std::vector<fs::path> linkMeshes(Linking& linking, const ModelPlace& place) {
  if (linking.description.meshes.empty()) return {};
  MeshLinker linker(linking, place);
  if (linker.readModels()) linker.placeMeshes();
  return linker.takeFiles();
}

}  // namespace hearth
