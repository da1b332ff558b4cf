/// @file
/// The table of engines: their names, what they are, and how to make one.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "cellsweep/broadphase.h"

namespace cellsweep {

/// Settings of all engines; an engine reads those that it names and ignores the others.
struct EngineOptions {
  /// Worker threads; 0 lets the engine choose. Read by no engine yet that has only one thread: `control` is
  /// single-threaded, as in the document.
  unsigned threads = 0;

  /// control: run listing 4.5 to the letter: an overlap test that misses a box inside another, and an order
  /// by value only that misses touches. Not exact; there to count what it misses.
  bool literal = false;

  /// control: the most memory, in bytes, that its map of all possible pairs may take (X1). The default holds
  /// 4,096 bodies.
  std::uint64_t pair_map_bytes = std::uint64_t{512} << 20;
};

/// One row of the engine table.
struct EngineInfo {
  std::string_view name;
  std::string_view summary;  ///< one sentence for a person
};

/// All engines, in the order of the project's story.
std::span<const EngineInfo> engine_table();

/// A new engine, empty. Errors: bad_option for a name that is not in the table (the message lists those that
/// are) or a setting out of range. Safe to call from any thread.
Result<std::unique_ptr<Broadphase>> make_engine(std::string_view name, const EngineOptions& options = {});

}  // namespace cellsweep
