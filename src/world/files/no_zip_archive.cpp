#include "world/files/file_fault.h"
#include "world/files/zip_archive.h"

namespace cellsweep {
namespace {

Status no_libzip() {
  return bad_recording(
      "this build reads and writes no .npz, for it was configured without libzip (Debian: libzip-dev)");
}

}  // namespace

bool zip_is_there() {
  return false;
}

Result<std::vector<ZipMember>> read_zip(std::span<const std::byte>) {
  return no_libzip();
}

Result<std::vector<ZipMember>> read_zip_file(const std::string&, std::uint64_t) {
  return no_libzip();
}

Result<std::vector<std::byte>> zip_bytes(std::span<const ZipMember>) {
  return no_libzip();
}

}  // namespace cellsweep
