#pragma once

#include <optional>

#include "viewer/input/event.h"

union SDL_Event;

namespace hearth {

/// The event in the viewer's words, if it is one that matters there.
std::optional<Event> eventFrom(const SDL_Event& event);

}  // namespace hearth
