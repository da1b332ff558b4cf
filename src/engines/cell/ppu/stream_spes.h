/// @file
/// Engine `stream` on SPEs: its cells, in pieces, go through the local stores.
#pragma once

#include <memory>
#include <vector>

#include "cellsweep/engines.h"
#include "cellsweep/local_store.h"
#include "engines/cell/emulation.h"
#include "engines/cell/ppu/dma_memory.h"
#include "engines/cell/ppu/spe_group.h"
#include "engines/cell/stream_wire.h"
#include "engines/stream/cells/piece_finder.h"

namespace cellsweep::cell {

/// What an SPU of stream allocates, whatever the number of bodies.
std::vector<LocalStorePart> stream_buffers(std::uint64_t bodies);

class StreamSpes final : public stream::PieceFinder {
 public:
  /// Errors: bad_option for spus, capacity for a local store that the buffers do not fit into, spe_failed.
  static Result<std::unique_ptr<stream::PieceFinder>> make(const EngineOptions& options,
                                                           std::shared_ptr<Emulation> emulation);

  void find(std::span<const stream::CellBoxes> cells, const BodyId* ids, stream::KeyBuffer& found) override;
  void add_counters(std::vector<Counter>& counters) const override;
  std::optional<CellTime> take_cell_time() override { return spes_->take_cell_time(); }

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
  void take_results(const BodyId* ids, stream::KeyBuffer& found);

  std::unique_ptr<SpeGroup> spes_;
  std::vector<Share> shares_;
  DmaVector<StreamJob> jobs_;
  DmaVector<StreamResult> results_;
  std::uint64_t pieces_ = 0;
};

}  // namespace cellsweep::cell
