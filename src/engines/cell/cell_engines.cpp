#include "engines/cell/cell_engines.h"

#include "engines/cell/emulation.h"
#include "engines/cell/ppu/brute.h"
#include "engines/cell/ppu/layout.h"
#include "engines/cell/ppu/paper.h"
#include "engines/cell/ppu/resident.h"
#include "engines/cell/ppu/stream_spes.h"
#include "engines/stream/stream.h"

namespace cellsweep {
namespace {

// What cell-brute and cell-resident choose, and cell-paper has always.
constexpr unsigned kDefaultSpus = 3;

Result<LocalStoreMap> map_of(const char* engine, const EngineOptions& options,
                             const cell::BufferList& buffers, std::uint64_t bodies, unsigned spus) {
  auto emulation = cell::make_emulation(options);
  if (!emulation) return emulation.status();
  LocalStoreMap map = cell::make_local_store_map(engine, (*emulation)->local_store(), buffers, bodies);
  map.spus = spus == 0 ? kDefaultSpus : spus;
  return map;
}

}  // namespace

Result<std::unique_ptr<Broadphase>> make_cell_paper(const EngineOptions& options) {
  auto emulation = cell::make_emulation(options);
  if (!emulation) return emulation.status();
  return cell::Paper::make(options, std::move(*emulation));
}

Result<LocalStoreMap> cell_paper_map(const EngineOptions& options, std::uint64_t bodies) {
  const auto buffers = [&](std::uint64_t count) { return cell::paper_buffers(options, count); };
  return map_of("cell-paper", options, buffers, bodies, kDefaultSpus);
}

Result<std::unique_ptr<Broadphase>> make_cell_brute(const EngineOptions& options) {
  auto emulation = cell::make_emulation(options);
  if (!emulation) return emulation.status();
  return cell::Brute::make(options, std::move(*emulation));
}

Result<LocalStoreMap> cell_brute_map(const EngineOptions& options, std::uint64_t bodies) {
  return map_of("cell-brute", options, cell::brute_buffers, bodies, options.spus);
}

Result<std::unique_ptr<Broadphase>> make_cell_resident(const EngineOptions& options) {
  auto emulation = cell::make_emulation(options);
  if (!emulation) return emulation.status();
  return cell::Resident::make(options, std::move(*emulation));
}

Result<LocalStoreMap> cell_resident_map(const EngineOptions& options, std::uint64_t bodies) {
  const auto buffers = [&](std::uint64_t count) { return cell::resident_buffers(options, count); };
  return map_of("cell-resident", options, buffers, bodies, options.spus);
}

Result<std::unique_ptr<Broadphase>> make_stream_on_spes(const EngineOptions& options) {
  auto emulation = cell::make_emulation(options);
  if (!emulation) return emulation.status();
  auto spes = cell::StreamSpes::make(options, std::move(*emulation));
  if (!spes) return spes.status();
  return make_stream(options, std::move(*spes));
}

}  // namespace cellsweep
