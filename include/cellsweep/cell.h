/// @file
/// The engines that run on the SPEs of a Cell, emulated or its own, of the library cellsweep::cell: their
/// settings, poses, local stores and times.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cellsweep/broadphase.h"
#include "cellsweep/export.h"
#include "cellsweep/local_store.h"
#include "cellsweep/pose.h"

namespace cellsweep {

/// When a DMA transfer moves its bytes.
enum class DmaMode {
  eager,  ///< when the command is issued; every rule of the hardware is checked
  late,   ///< at the wait that covers it, in an order shuffled by a seed, its destination poisoned until then
  unchecked  ///< when the command is issued; no rules, to measure what they cost
};

/// What executes the programs of SPEs.
enum class SpeEngine {
  host,  ///< the program compiled for this machine, a thread for each SPE
  isa    ///< the program compiled for a real SPU, instruction by instruction; needs a build with the SPU
         ///< compiler
};

/// The SPEs of an engine.
struct SpeOptions {
  /// The local store of one SPE, in bytes, that code, data, heap and stack must fit into, a multiple of 128;
  /// 0 switches the limit off.
  std::uint64_t local_store = std::uint64_t{256} << 10;

  /// What executes the SPU programs. `isa` has 256 KB of local store at most.
  SpeEngine spe_engine = SpeEngine::host;

  /// With SpeEngine::isa: count the time on a Cell (cell_statistics()). Several times slower.
  bool cycles = false;

  /// With `cycles`: numbers of the model that are to be others, as "NAME=VALUE". Main memory is shared by as
  /// many SPEs as the engine uses, unless `sharing_spes` says otherwise.
  std::vector<std::string> cycle_parameter{};

  DmaMode dma = DmaMode::eager;

  /// Chooses the order in which late transfers land.
  std::uint64_t dma_seed = 1;
};

/// Engine `cell-paper`: the document's Cell version (4.2) step by step. Three SPUs, one for each axis.
struct CellPaperOptions {
  SpeOptions spes{};
  unsigned method = 1;    ///< the document's overlap test, 1 (walk along the sorted ids, C11) or 2 (C12)
  bool literal = false;   ///< the document's own logic as it stands (C9, C11, C12); not exact
  bool list_dma = false;  ///< send results by DMA list instead of in chunks (C13)
  /// As ControlOptions::pair_map_bytes: the same map stands on its host side (C15).
  std::uint64_t pair_map_bytes = std::uint64_t{512} << 20;
  std::string trace{};  ///< as StreamOptions::trace; with each transfer and each wait of the SPEs
};

/// Engine `cell-brute`: every changed body against all others, no sort (2.6.2).
struct CellBruteOptions {
  SpeOptions spes{};
  unsigned spus = 0;    ///< that work; 0 lets the engine choose, 16 at most
  std::string trace{};  ///< as CellPaperOptions::trace
};

/// Engine `cell-resident`: the document's future work (6.2).
struct CellResidentOptions {
  SpeOptions spes{};
  unsigned spus = 0;  ///< that work, 3 to 16; 0 lets the engine choose
  bool spu_boxes =
      false;  ///< take poses (insert_poses()) and make their boxes on the SPUs (F3); costs local store
  std::string trace{};  ///< as CellPaperOptions::trace
};

/// Engine `cell-stream`: engine `stream` whose cells go through the local stores of SPEs.
struct CellStreamOptions {
  SpeOptions spes{};
  unsigned spus = 0;       ///< that work; 0 lets the engine choose, 16 at most
  StreamOptions stream{};  ///< its settings on the host
};

/// Empty engines. Errors: bad_option for settings out of range, capacity for a local store in which not even
/// one body or piece fits, spe_failed when no SPE can be had. update() may fail with spe_failed and the rule
/// that an SPE broke; the next one starts the programs anew.
CELLSWEEP_API Result<Broadphase> make_broadphase(const CellPaperOptions& options);
CELLSWEEP_API Result<Broadphase> make_broadphase(const CellBruteOptions& options);
CELLSWEEP_API Result<Broadphase> make_broadphase(const CellResidentOptions& options);
CELLSWEEP_API Result<Broadphase> make_broadphase(const CellStreamOptions& options);

/// Adds `cell-paper`, `cell-brute`, `cell-resident` and `cell-stream` to engine_table().
CELLSWEEP_API void add_cell_engines();

/// insert() and move() with boxes that the SPUs make (F3): each encloses its pose's box, is wider to each
/// side by 2^-23 of the centre's coordinate and 2^-19 of the sum of the half extents at most (a rod a
/// kilometre long by 1 mm, in any direction), and of a body that is not turned it is c - h to c + h, rounded
/// outwards. They are made at once; a body may be given boxes and poses in turn. Errors: those of insert()
/// and move(), invalid_box for a pose that breaks the rules of BodyPose, spe_failed, and bad_option unless
/// the broadphase was made with CellResidentOptions::spu_boxes.
CELLSWEEP_API Status insert_poses(Broadphase& broadphase, std::span<const BodyId> ids,
                                  std::span<const BodyPose> poses);
CELLSWEEP_API Status move_poses(Broadphase& broadphase, std::span<const BodyId> ids,
                                std::span<const BodyPose> poses);

/// What one SPE of a Cell would take for an update, in microseconds, by the steps of the document's chapter
/// 4.2. Waits for mailboxes are not in it.
struct SpeTime {
  double sort = 0;
  double change_detection = 0;
  double compaction = 0;
  double overlap = 0;
  double dma_wait = 0;  ///< in any step
  double other = 0;     ///< start-up, allocation, bookkeeping

  double total() const { return sort + change_detection + compaction + overlap + dma_wait + other; }
};

/// The last update() on a Cell's clock, and what belongs to the host of it.
struct CellTime {
  std::vector<SpeTime> spes;  ///< one an SPE; they work at the same time
  /// CPU time, measured here, of the calling thread in update() that is no work of the frame: set-up phases,
  /// starting SPEs and waiting for them.
  double set_aside_ms = 0;
  bool threads_started = false;
};

/// What only a Cell engine can tell.
struct CellStatistics {
  /// CPU time of the SPE that worked longest in the last update(), in milliseconds; 0 where programs run on
  /// between updates.
  double longest_spu_ms = 0;
  std::uint64_t dma_gets = 0;  ///< this and what follows: of all SPEs, since they were started
  std::uint64_t dma_puts = 0;
  std::uint64_t dma_bytes_in = 0;
  std::uint64_t dma_bytes_out = 0;
  std::uint64_t dma_list_elements = 0;
  std::uint64_t local_store_high_water = 0;  ///< bytes in use at most, of the SPE with most
  std::optional<CellTime> time{};            ///< with SpeOptions::cycles
};

/// Nothing for an engine without SPEs.
CELLSWEEP_API std::optional<CellStatistics> cell_statistics(const Broadphase& broadphase);

}  // namespace cellsweep
