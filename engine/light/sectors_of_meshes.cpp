#include "light/sectors_of_meshes.h"

namespace hearth {

std::vector<std::vector<SectorId>> sectorsOfMeshes(const Level& level) {
  std::vector<std::vector<SectorId>> sectors(level.meshes.size());
  for (const MeshInSector& at : level.meshesBySector) sectors[at.mesh].push_back(at.sector);
  return sectors;
}

}  // namespace hearth
