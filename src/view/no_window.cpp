#include "view/view.h"

namespace cellsweep::view {

ViewEnd show(Simulation&, const ViewSettings&) {
  return {
      Status::bad_option(
          "",
          "This build has no window, for it is sanitized or was configured without GLFW 3, libepoxy, Dear "
          "ImGui or libpng (Debian: libglfw3-dev, libepoxy-dev, libimgui-dev, libpng-dev)."),
      ""};
}

}  // namespace cellsweep::view
