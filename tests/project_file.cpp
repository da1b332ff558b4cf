#include "project_file.h"

namespace cellsweep {

std::string project_file(const std::string& name) {
  return CELLSWEEP_SOURCE_DIR "/" + name;
}

}  // namespace cellsweep
