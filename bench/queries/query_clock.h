/// @file
/// Times what answers questions.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "bench/queries/query_peer.h"

namespace cellsweep::bench {

/// A peer and what it is asked; of several, each about a world of its own.
struct Asking {
  QueryPeer* peer = nullptr;
  const Questions* questions = nullptr;
};

/// Seconds for a question in the mean: all are asked three times over, but not for much longer than a second,
/// and the fastest time over counts. Of one who answers alone on this thread it is the thread's time on the
/// processor, which does not run while others have the core; else it is the time that passes.
double mean_seconds(std::span<const Asking> askings, const QueryPeerInfo& info);

/// Seconds within which 99 of 100 questions are answered: of each question the fastest of three times, or of
/// fewer where these take long.
double p99_seconds(std::span<const Asking> askings);

/// Seconds that pass during a call.
double seconds_of(const std::function<void()>& call);

}  // namespace cellsweep::bench
