/// @file
/// What a Cell engine puts into the local store of one SPE (C14).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cellsweep/engines.h"
#include "cellsweep/export.h"
#include "cellsweep/status.h"

namespace cellsweep {

struct CellPaperOptions;
struct CellBruteOptions;
struct CellResidentOptions;
struct CellStreamOptions;

/// A named piece of local store.
struct LocalStorePart {
  std::string name;
  std::uint64_t bytes = 0;
};

/// The layout of the SPE that holds most.
struct CELLSWEEP_API LocalStoreMap {
  std::string engine;
  std::uint64_t bodies = 0;
  std::uint64_t limit = 0;            ///< bytes; 0: no limit
  std::vector<LocalStorePart> parts;  ///< code, data and stack, then every buffer
  unsigned spus = 0;                  ///< SPEs that work, each with a local store laid out so

  std::uint64_t used() const;
  bool fits() const { return limit == 0 || used() <= limit; }
};

/// The layout for so many bodies, whether or not it fits. Errors: those of make_broadphase(); capacity for
/// more than 2^32 bodies, which ids do not tell apart.
CELLSWEEP_API Result<LocalStoreMap> local_store_map(const CellPaperOptions& options, std::uint64_t bodies);
CELLSWEEP_API Result<LocalStoreMap> local_store_map(const CellBruteOptions& options, std::uint64_t bodies);
CELLSWEEP_API Result<LocalStoreMap> local_store_map(const CellResidentOptions& options, std::uint64_t bodies);
CELLSWEEP_API Result<LocalStoreMap> local_store_map(const CellStreamOptions& options, std::uint64_t bodies);

/// The same for an engine of engine_table(), with settings as there; bad_option for one without SPEs.
CELLSWEEP_API Result<LocalStoreMap> local_store_map(std::string_view engine, const SettingValues& settings,
                                                    std::uint64_t bodies);

}  // namespace cellsweep
