/// @file
/// Engine `cell-stream`: the cells of engine `stream`, in pieces, go through the local stores of SPEs.
#pragma once

#include <memory>
#include <vector>

#include "cellsweep/cell.h"
#include "cellsweep/engine/piece_finder.h"
#include "engines/cell/cell_engine.h"
#include "engines/cell/emulation.h"
#include "engines/cell/ppu/dma_memory.h"
#include "engines/cell/ppu/spe_group.h"
#include "engines/cell/stream_wire.h"

namespace cellsweep::cell {

/// Errors: bad_option.
Status check(const CellStreamOptions& options);

/// What an SPU of cell-stream allocates, whatever the number of bodies.
std::vector<LocalStorePart> stream_buffers(std::uint64_t bodies);

/// As a CellEngine it tells of the last update.
class StreamSpes final : public stream::PieceFinder, public CellEngine {
 public:
  /// Errors: bad_option for spus, capacity for a local store that the buffers do not fit into, spe_failed.
  static Result<std::unique_ptr<stream::PieceFinder>> make(const CellStreamOptions& options,
                                                           std::shared_ptr<Emulation> emulation);

  void begin_update() override;
  void find(std::span<const stream::CellBoxes> cells, stream::KeyBuffer& found) override;
  void add_counters(std::vector<Counter>& counters) const override;
  const CellStatistics& cell_statistics() const override { return cell_statistics_; }

 private:
  /// The pieces of one SPE, and how far they are.
  struct Share {
    DmaVector<StreamPiece> pieces;
    std::size_t done = 0;
    std::uint32_t rows_done = 0;
    DmaVector<std::uint32_t> pairs;
  };

  explicit StreamSpes(std::unique_ptr<SpeGroup> spes);
  void share_out(std::span<const stream::CellBoxes> cells);
  std::vector<void*> prepare_jobs();
  void run(std::span<void* const> jobs);
  void take_results(stream::KeyBuffer& found);
  void refresh_statistics();

  std::unique_ptr<SpeGroup> spes_;
  std::vector<Share> shares_;
  DmaVector<StreamJob> jobs_;
  DmaVector<StreamResult> results_;
  std::vector<double> milliseconds_;  // by SPE: CPU time in this update
  CellStatistics cell_statistics_;
  std::uint64_t pieces_ = 0;
};

}  // namespace cellsweep::cell
