#pragma once

#include <span>
#include <string>

#include "measure/machine.h"
#include "peers/peers.h"

/// What was measured against peers, as text.
namespace hearth {

/// A paragraph for each row: how far it is from its target, what stands in the way where it falls
/// short, and what it is made of.
std::string tableOf(std::span<const PeerResult> results, const Machine& machine, int repeats);

/// The same as JSON.
std::string jsonOf(std::span<const PeerResult> results, const Machine& machine, int repeats);

}  // namespace hearth
