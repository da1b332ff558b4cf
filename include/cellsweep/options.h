/// @file
/// The settings of the engines of this library, one struct an engine.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "cellsweep/executor.h"
#include "cellsweep/vector_isa.h"

namespace cellsweep {

/// Engine `stream`: worlds of any size; the one to use. Nothing in it needs tuning.
struct StreamOptions {
  /// Threads, the caller's included. 0: as many as the machine has, 16 at most, where they pay. N: that many,
  /// as soon as each has 16 bodies to do; worlds of some 2,000 bodies are swept by the caller's alone. With
  /// an `executor`: at most so many of its tasks at a time.
  unsigned threads = 0;

  /// The caller's job system; null: threads of the library's own, started when they first pay, or taken over
  /// from an engine that was destroyed. Shared with the Broadphase, which keeps it alive.
  std::shared_ptr<Executor> executor{};

  VectorIsa isa = VectorIsa::best;

  /// How far a body may move about, in world units, without a look at its neighbourhood: its fat box reaches
  /// so far beyond it on all sides once it has moved. More saves work where bodies tremble and costs some
  /// where they are dense; pairs are exact all the same. 0: what it finds to pay by how each body moves, and
  /// no fat boxes in a small world in motion.
  float margin = 0;

  /// The most pairs that there may be; 0 for no limit. An update() that finds more stops there and returns
  /// StatusCode::capacity. Whether one is refused depends on the pairs alone, not on threads.
  std::uint64_t max_pairs = 0;

  /// Write a timeline (opens in Perfetto) to this file when the last Broadphase that names it is destroyed:
  /// calls, phases and waits. Empty writes none. All of it is kept in memory until then.
  std::string trace{};
};

/// Engine `control`: the document's x86 version (chapter 4.1), a yardstick. One thread.
struct ControlOptions {
  /// Run listing 4.5 to the letter: an overlap test that misses a box inside another, and an order by value
  /// only that misses touches. Not exact; there to count what it misses.
  bool literal = false;

  /// The most memory, in bytes, that its map of all possible pairs may take (X1). The default holds 4,096
  /// bodies.
  std::uint64_t pair_map_bytes = std::uint64_t{512} << 20;

  std::string trace{};  ///< as StreamOptions::trace
};

/// Engine `oracle`: all boxes against all boxes, which judges the others. One thread.
struct OracleOptions {
  std::string trace{};  ///< as StreamOptions::trace
};

}  // namespace cellsweep
