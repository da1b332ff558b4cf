#include "report/picture/image.h"

namespace cellsweep::report {

std::string png_of(const Image&) {
  return {};
}

Status write_png(const Image&, const std::filesystem::path&) {
  return Status::bad_option(
      "", "This build writes no PNG files, for it was configured without libpng (Debian: libpng-dev).");
}

}  // namespace cellsweep::report
