/// @file
/// A world over ranks in a file, from which a job of any number of ranks goes on.
#pragma once

#include <mpi.h>

#include <cstddef>
#include <string>
#include <string_view>

#include "cellsweep/export.h"
#include "cellsweep/ranks.h"
#include "cellsweep/status.h"

namespace cellsweep {

/// A note is this long at most.
inline constexpr std::size_t kMostCheckpointNote = 32'768;

/// Collective over the ranks of `world`. Writes all bodies as of its last update(), with their boxes and
/// filters, to one file (parallel HDF5, 41 bytes a body and a few KB), and with them `note`: what the caller
/// wants to find again, such as the number of the frame and how his scene is called; the one of rank 0
/// counts. Calls that wait for the next update are not in it.
///
/// Until all is written, read back and on the disk the file is called `path` and `.part`; then it takes the
/// place of what `path` was. Whatever happens, a killed rank or machine included, there is the checkpoint of
/// before or the new one. A `.part` that was left is overwritten by the next one and is good for nothing.
///
/// Errors, the same on all ranks; then the checkpoint of before is as it was: bad_input for a path that
/// cannot be written to, a longer note, or in a build without HDF5; write_failed for a disk that is full or
/// at fault; capacity for want of memory (41 bytes for each body that a rank owns, twice).
CELLSWEEP_API Status save_checkpoint(const DistributedBroadphase& world, const std::string& path,
                                     std::string_view note = {});

struct RestoredWorld {
  DistributedBroadphase world;
  std::string note;
};

/// Collective over `communicator`, whose ranks may be fewer or more than those that wrote the file. The world
/// is what it was: its pairs are there without having begun, and what updates say from now on is, over all
/// ranks, what they would have said. Which rank owns which body may differ. Every byte of the file is checked
/// (a checksum), and so are the pairs that are found.
///
/// Errors, the same on all ranks: bad_input for a file that cannot be read, is no checkpoint, was cut short
/// or changed, or in a build without HDF5; those of make_distributed_broadphase() and update().
CELLSWEEP_API Result<RestoredWorld> load_checkpoint(MPI_Comm communicator, const std::string& path,
                                                    const RankOptions& options = {});

}  // namespace cellsweep
