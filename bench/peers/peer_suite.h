/// @file
/// The suite of peers: peer x scene x number of bodies x mode.
#pragma once

#include "cellsweep/world/scene.h"

namespace cellsweep::bench {

/// Registers a row `peers/NAME/SCENE/N/MODE` for every peer and every combination that it takes, each scene
/// with a giant in this place.
///
/// Before a row runs, the peer is compared with all boxes against all over some frames of the scene with
/// 1,000 bodies, and after each run the last frame with the oracle. A row whose peer was off by a pair is
/// timed all the same: its counters `missing` and `extra` say by how many pairs, and its label that it is not
/// exact.
///
/// A repetition makes the peer anew and takes as many frames as peer_mode.h says, or only three of those that
/// take long, where bodies move after two that are not timed; its time is their mean, from the new boxes to
/// the list of pairs in the caller's memory. With all bodies new and up to 10,000 of them, 64 worlds come one
/// after the other. Counters: `frames`, `pairs` of the last one, the `median`, the 99th percentile `p99` and
/// the `slowest` in microseconds; of peers that count what they do, how many boxes were `placed` into cells
/// and how many pairs of boxes `compared` in a frame, in the mean; the label is the hash of the pairs of the
/// last frame.
void register_peer_suite(GiantSlot giant = GiantSlot::none);

}  // namespace cellsweep::bench
