#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "level/mover.h"
#include "level/scene.h"
#include "viewer/edit/movers_edit.h"

namespace hearth {

/// Which requests about movers the walk grants.
struct MoverPermissions {
  bool canMove = false;  ///< else it grants nothing
  bool canWrite = false;
};

/// The movers of a level, as frames show them.
struct MoversSubject {
  const Scene& scene;
  std::span<const double> shares;  ///< by mover
  MoverPermissions permissions;
};

/// A section of the overlay: the level's movers, which can be dragged and edited.
class MoversSection {
 public:
  /// Returns what is to be written: once for each drag of a number, when it ends.
  std::optional<MoverEdit> show(const MoversSubject& subject);

  /// The mover that is dragged, and where to.
  const std::optional<MoverShare>& held() const { return held_; }
  /// Releases what the mouse holds.
  void release() { held_.reset(); }
  /// Leaves the number that is dragged as it was.
  void giveUp() { drag_.reset(); }

  /// What was returned has been written. It shows until the level is loaded anew.
  void noteWritten(const MoverEdit& edit) { written_ = edit; }
  /// Call it when the level has changed.
  void forget();

 private:
  /// A speed while it is dragged or typed.
  struct SpeedDrag {
    std::string name;  ///< of the mover
    double speed;
  };

  MoverEdit current(const Mover& mover) const;
  std::optional<MoverEdit> showTable(const MoversSubject& subject);
  MoverEdit showRow(const MoversSubject& subject, std::size_t index);
  void showShare(const MoversSubject& subject, std::size_t index);
  void showSpeed(MoverEdit& edit);
  std::optional<MoverEdit> endedDrag(const Level& level);

  std::optional<MoverShare> held_;
  std::optional<SpeedDrag> drag_;
  std::optional<MoverEdit> written_;
};

}  // namespace hearth
