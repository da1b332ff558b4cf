/// @file
/// What a Cell engine puts into the local store of one SPE (C14).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "cellsweep/engines.h"
#include "cellsweep/status.h"

namespace cellsweep {

/// A named piece of local store.
struct LocalStorePart {
  std::string name;
  std::uint64_t bytes = 0;
};

/// The layout of the SPE that holds most.
struct LocalStoreMap {
  std::string engine;
  std::uint64_t bodies = 0;
  std::uint64_t limit = 0;            ///< bytes; 0: no limit
  std::vector<LocalStorePart> parts;  ///< code, data and stack, then every buffer
  unsigned spus = 0;                  ///< SPEs that work, each with a local store laid out so

  std::uint64_t used() const;
  bool fits() const { return limit == 0 || used() <= limit; }
};

/// The layout of `engine` with these options and so many bodies, whether or not it fits. Errors: those of
/// make_engine(), and bad_option for an engine that has no local store.
Result<LocalStoreMap> local_store_map(std::string_view engine, const EngineOptions& options,
                                      std::uint64_t bodies);

}  // namespace cellsweep
