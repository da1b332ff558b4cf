#include "report/picture/picture.h"

namespace cellsweep::report {
namespace {

Status no_picture_status() {
  return {StatusCode::bad_option,
          "This build makes no pictures, for it was configured without Embree 3 or libpng (Debian: "
          "libembree-dev, libpng-dev).",
          std::nullopt,
          0,
          0,
          ""};
}

}  // namespace

Result<Image> trace_picture(const Tableau&, const PictureSettings&) {
  return no_picture_status();
}

std::string png_of(const Image&) {
  return {};
}

Status write_png(const Image&, const std::filesystem::path&) {
  return no_picture_status();
}

}  // namespace cellsweep::report
