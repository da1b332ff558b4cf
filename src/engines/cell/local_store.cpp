#include "cellsweep/local_store.h"

#include <numeric>

#include "base/text.h"
#include "cellsweep/cell.h"
#include "engines/cell/emulation.h"
#include "engines/cell/ppu/brute.h"
#include "engines/cell/ppu/layout.h"
#include "engines/cell/ppu/paper.h"
#include "engines/cell/ppu/resident.h"
#include "engines/cell/ppu/spe_counts.h"
#include "engines/cell/ppu/stream_spes.h"

namespace cellsweep {
namespace {

/// Ids tell no more bodies apart; all sums of bytes for so many stay far below 64 bits.
constexpr std::uint64_t kMostBodies = std::uint64_t{1} << 32U;

template <class Options>
Result<LocalStoreMap> map_of(const char* engine, const Options& options, unsigned spus,
                             const cell::BufferList& buffers, std::uint64_t bodies) {
  auto emulation = cell::make_emulation(options.spes);
  if (!emulation) return emulation.status();
  if (Status status = cell::check(options); !status.ok()) return status;
  if (bodies > kMostBodies) {
    return Status::over_capacity(
        text("bodies is ", bodies, "; ids tell at most ", kMostBodies, " bodies apart."), bodies,
        kMostBodies);
  }
  LocalStoreMap map = cell::make_local_store_map(engine, (*emulation)->local_store(), buffers, bodies);
  map.spus = spus == 0 ? cell::kDefaultSpus : spus;
  return map;
}

}  // namespace

std::uint64_t LocalStoreMap::used() const {
  return std::accumulate(parts.begin(), parts.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const LocalStorePart& part) { return sum + part.bytes; });
}

Result<LocalStoreMap> local_store_map(const CellPaperOptions& options, std::uint64_t bodies) {
  const auto buffers = [&](std::uint64_t count) { return cell::paper_buffers(options, count); };
  return map_of("cell-paper", options, cell::kAxes, buffers, bodies);
}

Result<LocalStoreMap> local_store_map(const CellBruteOptions& options, std::uint64_t bodies) {
  return map_of("cell-brute", options, options.spus, cell::brute_buffers, bodies);
}

Result<LocalStoreMap> local_store_map(const CellResidentOptions& options, std::uint64_t bodies) {
  const auto buffers = [&](std::uint64_t count) { return cell::resident_buffers(options, count); };
  return map_of("cell-resident", options, options.spus, buffers, bodies);
}

Result<LocalStoreMap> local_store_map(const CellStreamOptions& options, std::uint64_t bodies) {
  return map_of("cell-stream", options, options.spus, cell::stream_buffers, bodies);
}

}  // namespace cellsweep
