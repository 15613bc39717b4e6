#pragma once

#include "math/parallel.h"
#include "viewer/host/screenshots.h"
#include "viewer/host/storage.h"
#include "viewer/host/window_host.h"

namespace hearth {

/// What the program gives to a walk. A walk starts no threads of its own.
struct WalkHost {
  WindowHost& window;
  Storage& storage;
  Screenshots& screenshots;
  Workers* workers = nullptr;  ///< threads that help to draw, if any
};

}  // namespace hearth
