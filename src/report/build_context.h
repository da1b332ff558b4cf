/// @file
/// What a result must be read with: machine, compiler, flags, commit.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace cellsweep::report {

/// Name and value, for a person: cpu, cores, system, compiler, flags, build type, commit.
std::vector<std::pair<std::string, std::string>> build_context();

/// "cellsweep 1.0.0, commit 0123456789ab".
std::string version_text();

}  // namespace cellsweep::report
