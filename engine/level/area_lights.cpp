#include "level/area_lights.h"

#include "math/trig.h"

namespace hearth {

Vec3 Sun::direction() const { return directionAt(angle, pitch); }

}  // namespace hearth
