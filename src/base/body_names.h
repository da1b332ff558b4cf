/// @file
/// Bodies as the subject of a sentence.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>

#include "base/text.h"
#include "cellsweep/status.h"

namespace cellsweep {

/// "Body 3 is" or "Bodies 3, 4 and 5 are", and no more than a status names.
template <class Id>
[[gnu::cold]] std::string subject(std::span<const Id> bodies) {
  if (bodies.size() == 1) return text("Body ", bodies[0], " is");
  std::string names = text("Bodies ", bodies[0]);
  const std::size_t named = std::min(bodies.size(), Status::kMostBodies);
  for (std::size_t i = 1; i < named; ++i) names += text(i + 1 == bodies.size() ? " and " : ", ", bodies[i]);
  if (named < bodies.size()) names += text(" and ", bodies.size() - named, " more");
  return names + " are";
}

}  // namespace cellsweep
