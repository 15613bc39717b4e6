#pragma once

#include <optional>

#include "viewer/input/event.h"

union SDL_Event;

namespace hearth {

/// The event as the viewer's, if the viewer has such an event.
std::optional<Event> eventFrom(const SDL_Event& event);

}  // namespace hearth
