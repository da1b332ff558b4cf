// Stands in for checkpoints in a build without parallel HDF5.
#include "cellsweep/checkpoint.h"

namespace cellsweep {
namespace {

Status no_hdf5() {
  return Status::bad_input(
      "This build has no checkpoints: it was made without parallel HDF5 "
      "(Debian: libhdf5-openmpi-dev).");
}

}  // namespace

Status save_checkpoint(const DistributedBroadphase&, const std::string&, std::string_view) {
  return no_hdf5();
}

Result<RestoredWorld> load_checkpoint(MPI_Comm, const std::string&, const RankOptions&) {
  return no_hdf5();
}

}  // namespace cellsweep
