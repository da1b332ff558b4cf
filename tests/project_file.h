/// @file
/// The project's own files.
#pragma once

#include <string>

namespace cellsweep {

/// The whole path of one that is named from the project's folder on, such as
/// "bench/scenes/bullet-pile-1024.aabbs".
std::string project_file(const std::string& name);

}  // namespace cellsweep
