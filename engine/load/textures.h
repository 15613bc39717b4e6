#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "files/file_source.h"
#include "image/image.h"
#include "level/scene.h"
#include "level/texel_holes.h"
#include "level/texture_mapping.h"
#include "load/json/report.h"
#include "load/limits.h"
#include "load/read/description.h"

namespace hearth {

/// An image that another file than the level's names.
struct ForeignImage {
  std::filesystem::path file;
  std::string namedAt;  ///< as FILE:LINE, for messages
};

/// An image of the textures folder or a colour; or an image from elsewhere, and what reports call
/// it.
struct NamedTexture : NameReference {
  std::optional<ForeignImage> foreign;
};

/// Gives every distinct texture an id, in the order of linking.
class TextureTable {
 public:
  TextureId idOf(const NameReference& name);
  /// The same file is the same texture, whatever its names.
  TextureId idOf(const NameReference& name, const ForeignImage& image);
  TextureMapping link(const TextureDescription& texture);
  /// For a texture that could not be read. A level with it must not be used.
  TextureMapping standIn();

  /// By id, each at the place of its first use in the file.
  const std::vector<NamedTexture>& textures() const { return textures_; }

 private:
  TextureId usedAt(TextureId id, Place place);

  std::vector<NamedTexture> textures_;
  std::map<std::string, TextureId> ids_;      ///< by name
  std::map<std::string, TextureId> foreign_;  ///< by path
};

struct TextureFiles {
  std::vector<Image> images;                 ///< by TextureId
  std::vector<std::filesystem::path> files;  ///< that were read
  std::size_t decoded = 0;                   ///< files of which more than the header was read
};

/// Where the images of a level lie.
struct TexturePlace {
  const FileSource& files;
  const std::filesystem::path& level;          ///< its file
  const std::optional<NameReference>& folder;  ///< that the level file names, if it does
};

/// Reads the images of surfaces that show, or may while flats move, and of things. For the others
/// it reads only the header, and gives one black pixel. Up to four threads read them. A missing or
/// broken image is reported where it is first used.
TextureFiles readTextures(Report& report, const TextureTable& table, const Scene& scene,
                          const TexturePlace& place, const LoadLimits& limits);

/// Gives views of sprites that have no size of their own that of their image.
void sizeSprites(Level& level, const std::vector<Image>& images);

/// By TextureId: the holes of images of masked middle textures; none for the others.
std::vector<TexelHoles> holesOfMaskedMiddles(const Scene& scene, const std::vector<Image>& images);

/// How much of red, green and blue light an image reflects: the means of its pixels that are no
/// holes, 0..1.
Vec3 reflectanceOf(const Image& image);

}  // namespace hearth
