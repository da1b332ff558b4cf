/// @file
/// Cuts the world by recursive bisection of coordinates, which Zoltan does.
#pragma once

#include <mpi.h>

#include <memory>
#include <span>
#include <vector>

#include "cellsweep/query.h"
#include "cellsweep/status.h"
#include "ranks/region.h"

struct Zoltan_Struct;

namespace cellsweep::ranks {

class Cutter {
 public:
  /// Collective, as is the destructor. Once, before all other calls. Errors, which only this rank may have:
  /// capacity, for want of memory.
  Status begin(MPI_Comm communicator);

  /// Collective: a region for each rank, with about as many of all ranks' points in each. Errors, which only
  /// this rank may have: capacity, for want of memory. May throw std::bad_alloc once all is done.
  Result<std::vector<Region>> cut(std::span<const Point> points);

 private:
  struct Destroy {
    void operator()(Zoltan_Struct* zoltan) const;
  };

  Result<std::vector<Region>> regions() const;

  int ranks_ = 1;
  std::unique_ptr<Zoltan_Struct, Destroy> zoltan_;  // null for one rank, which Zoltan builds no tree for
};

}  // namespace cellsweep::ranks
