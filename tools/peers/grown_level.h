#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "measure/frame_times.h"
#include "peers/peer_inputs.h"

namespace hearth {

/// A level without lightmaps, seen in 16 directions from one place in it.
class GrownLevel {
 public:
  /// Loads a file, and removes it. The error says what is wrong with it.
  static tl::expected<std::shared_ptr<GrownLevel>, std::string> of(
      const std::filesystem::path& file, Vec3 eye);

  GrownLevel(LoadedLevel level, Vec3 eye);

  /// Of all directions, some rounds.
  FrameBench measure(const Clock& clock);

  std::vector<Image> pictures() const;

 private:
  Camera cameraTo(int heading) const;
  void drawAll(const Clock& clock);

  PeerLevel level_;
  SectorId start_;
  Vec3 eye_;
  FrameTimes frames_;
};

}  // namespace hearth
