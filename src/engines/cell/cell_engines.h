/// @file
/// Makes the Cell engines: the place where they get the SPEs they run on.
#pragma once

#include <cstdint>
#include <memory>

#include "cellsweep/broadphase.h"
#include "cellsweep/engines.h"
#include "cellsweep/local_store.h"

namespace cellsweep {

/// Empty engines. Errors: bad_option for settings out of range, spe_failed when no SPE can be had.
Result<std::unique_ptr<Broadphase>> make_cell_paper(const EngineOptions& options);
Result<std::unique_ptr<Broadphase>> make_cell_brute(const EngineOptions& options);
Result<std::unique_ptr<Broadphase>> make_cell_resident(const EngineOptions& options);

/// `stream` with its pairs found on SPEs (EngineOptions::on_spes).
Result<std::unique_ptr<Broadphase>> make_stream_on_spes(const EngineOptions& options);

/// Layouts for so many bodies. Errors: bad_option.
Result<LocalStoreMap> cell_paper_map(const EngineOptions& options, std::uint64_t bodies);
Result<LocalStoreMap> cell_brute_map(const EngineOptions& options, std::uint64_t bodies);
Result<LocalStoreMap> cell_resident_map(const EngineOptions& options, std::uint64_t bodies);

}  // namespace cellsweep
