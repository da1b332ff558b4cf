/// @file
/// A plugin with the library inside, as a program loads and unloads one.
#include <vector>

#include "cellsweep/broadphase.h"
#include "cellsweep/options.h"

/// Uses an engine with threads; how many pairs it found, or -1.
extern "C" [[gnu::visibility("default")]] long count_pairs_of_row(unsigned bodies) {
  auto broadphase = cellsweep::make_broadphase(cellsweep::StreamOptions{.threads = 2});
  if (!broadphase) return -1;
  for (unsigned i = 0; i < bodies; ++i) {
    const auto x = static_cast<float>(i);
    if (!broadphase->insert(i, {{x, 0, 0}, {x + 1, 1, 1}}).ok()) return -1;
  }
  if (!broadphase->update()) return -1;
  return static_cast<long>(broadphase->pairs().size());
}
