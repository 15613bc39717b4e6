#include "level/sun.h"

#include "math/check.h"
#include "math/trig.h"

namespace hearth {

Sun::Sun(double angle, double pitch, double size) : angle_(angle), pitch_(pitch), size_(size) {
  CHECK(0 <= size && size < 180, size);
  direction_ = directionAt(angle, pitch);
  sinRadius_ = sinCosDegrees(size / 2).sin;
  cosRadius_ = sinCosDegrees(size / 2).cos;
}

}  // namespace hearth
