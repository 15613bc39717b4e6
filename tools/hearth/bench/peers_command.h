#pragma once

#include "hearth/command.h"

namespace hearth {

/// `hearth bench --peers`: measures what does not depend on a level of the user's.
ExitStatus benchPeers(const OptionValues& values);

}  // namespace hearth
