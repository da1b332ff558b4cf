/// @file
/// The table of engines: their names, what they are, and how to make one.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cellsweep/broadphase.h"

namespace cellsweep {

/// When a DMA transfer of a Cell engine moves its bytes.
enum class DmaMode {
  eager,  ///< when the command is issued; every rule of the hardware is checked
  late,   ///< at the wait that covers it, in an order shuffled by a seed, its destination poisoned until then
  unchecked  ///< when the command is issued; no rules, to measure what they cost
};

/// What executes the programs of a Cell engine's SPEs.
enum class SpeEngine {
  host,  ///< the program compiled for this machine, a thread for each SPE
  isa    ///< the program compiled for a real SPU, instruction by instruction; needs a build with the SPU
         ///< compiler
};

/// The instruction set of an engine's vector kernels.
enum class VectorIsa {
  best,      ///< the widest that the processor has
  portable,  ///< plain C++, on any processor
  sse41,     ///< x86: four boxes at a time
  avx2,      ///< eight
  avx512     ///< sixteen
};

/// Settings of all engines; an engine reads those that it names and ignores the others.
struct EngineOptions {
  /// Worker threads of engines that have them; 0 lets the engine choose. `control` has one thread, as in the
  /// document, and the Cell engines have SPUs instead. `stream` uses as many as are asked for, as soon
  /// as each has 16 bodies to do; left to itself, as many as the machine has, 16 at most, where they pay.
  unsigned threads = 0;

  /// stream: the instruction set of its kernels.
  VectorIsa isa = VectorIsa::best;

  /// stream: the most pairs that there may be; 0 for no limit. An update() that finds more stops there and
  /// returns StatusCode::capacity: the pairs of the update before stay, bodies keep the boxes they were
  /// given, and the next update() starts anew. It depends on the pairs alone, not on threads, whether one is
  /// refused.
  std::uint64_t max_pairs = 0;

  /// stream: find pairs on SPEs: the cells, in pieces, go through their local stores by DMA, and the settings
  /// of the Cell engines below hold. Bodies that leave their hulls make it find everything anew.
  bool on_spes = false;

  /// control: run listing 4.5 to the letter: an overlap test that misses a box inside another, and an order
  /// by value only that misses touches. Not exact; there to count what it misses.
  ///
  /// cell-paper: the document's own logic as it stands (C9, C11, C12); not exact either.
  bool literal = false;

  /// control: the most memory, in bytes, that its map of all possible pairs may take (X1). The default holds
  /// 4,096 bodies.
  /// cell-paper keeps the same map on its host side (C15).
  std::uint64_t pair_map_bytes = std::uint64_t{512} << 20;

  /// cell-paper: the document's overlap test, 1 (walk along the sorted ids, C11) or 2 (all others, C12).
  unsigned method = 1;

  /// Cell engines: how many SPUs work; 0 lets the engine choose. cell-paper has one for each axis, always.
  unsigned spus = 0;

  /// Cell engines: the local store of one SPE that code, data, heap and stack must fit into, a multiple of
  /// 128; 0 switches the limit off.
  std::uint64_t local_store_bytes = std::uint64_t{256} << 10;

  /// Cell engines: what executes the SPU programs. `isa` has 256 KB of local store at most.
  SpeEngine spe_engine = SpeEngine::host;

  /// Cell engines with SpeEngine::isa: count the time on a Cell (Statistics::cell). Several times slower.
  bool cycles = false;

  /// With `cycles`: numbers of the model that are to be others, as "NAME=VALUE". Main memory is shared by as
  /// many SPEs as the engine uses, unless `sharing_spes` says otherwise.
  std::vector<std::string> cycle_parameters{};

  /// Cell engines: when DMA transfers move their bytes.
  DmaMode dma = DmaMode::eager;

  /// Cell engines: chooses the order in which late transfers land.
  std::uint64_t dma_seed = 1;

  /// cell-paper: send results by DMA list instead of in chunks (C13).
  bool list_dma = false;

  /// cell-resident: take poses (Broadphase::insert_poses()) and make their boxes on the SPUs, an axis each
  /// (F3). Costs local store.
  bool spu_boxes = false;

  /// Write a timeline (opens in Perfetto) to this file when the last engine that names it is destroyed:
  /// calls, phases and waits of each engine, and of Cell engines' SPEs each transfer and each wait. Empty
  /// writes none. All of it is kept in memory until then.
  std::string trace_file{};
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
