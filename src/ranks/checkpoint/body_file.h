/// @file
/// Bodies in an HDF5 file, of which each rank writes and reads its rows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/filter.h"
#include "cellsweep/ranks.h"
#include "cellsweep/status.h"
#include "ranks/job.h"

namespace cellsweep::ranks {

/// Of some bodies, one row a body.
struct BodyRows {
  std::vector<GlobalId> ids{};
  std::vector<Aabb> boxes{};
  std::vector<std::uint32_t> categories{};
  std::vector<std::uint32_t> masks{};
  std::vector<std::uint8_t> is_static{};

  void resize(std::size_t bodies);
  friend bool operator==(const BodyRows&, const BodyRows&) = default;
};

/// Of the whole world.
struct WorldRow {
  std::uint64_t bodies = 0;
  std::uint64_t pairs = 0;
  std::uint64_t pair_hash = 0;
  std::string note{};
};

/// Collective: fills the file, which is there and empty. Its bodies are those of all ranks, in the order of
/// ranks; the first `first_bytes` of it, a power of two from 512 on, are left alone. Errors, the same on all
/// ranks: write_failed, capacity.
Status write_bodies(const Job& job, const std::string& path, std::size_t first_bytes, const WorldRow& world,
                    BodyRows& mine);

/// Collective: the world's row and this rank's part of the bodies: the next `rows` behind those of the ranks
/// before; none: as many as each other rank gets. Errors, the same on all ranks: bad_input, capacity.
Status read_bodies(const Job& job, const std::string& path, std::optional<std::uint64_t> rows,
                   WorldRow& world, BodyRows& mine);

}  // namespace cellsweep::ranks
