#pragma once

namespace hearth {

/// What of texture and light a picture shows.
enum class LightMode {
  Both,
  None,  ///< the texture's colour alone
  Only,  ///< the light in place of the texture; sky is white
};

}  // namespace hearth
