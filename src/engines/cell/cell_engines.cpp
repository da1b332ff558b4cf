#include <optional>

#include "cellsweep/cell.h"
#include "cellsweep/engine/engine.h"
#include "cellsweep/engine/piece_finder.h"
#include "engines/cell/cell_engine.h"
#include "engines/cell/emulation.h"
#include "engines/cell/ppu/brute.h"
#include "engines/cell/ppu/paper.h"
#include "engines/cell/ppu/resident.h"
#include "engines/cell/ppu/stream_spes.h"

namespace cellsweep {
namespace {

/// An engine or finder on SPEs of its own, whose transfers go to the timeline `trace`.
template <class Made, class Maker, class Options>
Result<std::unique_ptr<Made>> make_on_spes(Maker* make, const Options& options, const std::string& trace) {
  auto emulation = cell::make_emulation(options.spes, trace);
  if (!emulation) return emulation.status();
  return make(options, std::move(*emulation));
}

/// The row of an engine is that of the Cell's other processor.
std::string row_of(std::string_view engine) {
  return "PPU, " + std::string(engine);
}

template <class Maker, class Options>
Result<Broadphase> make_cell(std::string_view name, Maker* make, const Options& options) {
  return EngineAccess::make(
      name, [make, options] { return make_on_spes<Engine>(make, options, options.trace); }, options.trace,
      row_of(name));
}

}  // namespace

Result<Broadphase> make_broadphase(const CellPaperOptions& options) {
  return make_cell("cell-paper", &cell::Paper::make, options);
}

Result<Broadphase> make_broadphase(const CellBruteOptions& options) {
  return make_cell("cell-brute", &cell::Brute::make, options);
}

Result<Broadphase> make_broadphase(const CellResidentOptions& options) {
  return make_cell("cell-resident", &cell::Resident::make, options);
}

Result<Broadphase> make_broadphase(const CellStreamOptions& options) {
  const auto make_finder = [options] {
    return make_on_spes<stream::PieceFinder>(&cell::StreamSpes::make, options, options.stream.trace);
  };
  return stream::make_stream_broadphase(options.stream, "cell-stream", make_finder, row_of("cell-stream"));
}

std::optional<CellStatistics> cell_statistics(const Broadphase& broadphase) {
  const Engine& engine = EngineAccess::engine_of(broadphase);
  const auto* on_spes = dynamic_cast<const cell::CellEngine*>(&engine);
  if (const auto* with_finder = dynamic_cast<const stream::HasFinder*>(&engine))
    on_spes = dynamic_cast<const cell::CellEngine*>(with_finder->finder());
  if (on_spes == nullptr) return std::nullopt;
  return on_spes->cell_statistics();
}

}  // namespace cellsweep
