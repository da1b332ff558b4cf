#include "report/picture/picture.h"

namespace cellsweep::report {

Result<Image> trace_picture(const Tableau&, const PictureSettings&) {
  return Status::bad_option(
      "",
      "This build makes no pictures, for it was configured without Embree 3 or libpng (Debian: "
      "libembree-dev, libpng-dev).");
}

}  // namespace cellsweep::report
