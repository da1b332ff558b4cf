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

Status ZipStream::read(std::span<std::byte>) {
  return no_libzip();
}

Status ZipStream::finish() {
  return no_libzip();
}

Result<ZipArchive> ZipArchive::open(std::shared_ptr<const ByteSource>) {
  return no_libzip();
}

Result<ZipStream> ZipArchive::stream(std::size_t) const {
  return no_libzip();
}

Status write_zip(std::span<const ZipMember>, const std::shared_ptr<ScratchFile>&) {
  return no_libzip();
}

}  // namespace cellsweep
