/// @file
/// What the tests of engines on SPEs have in common: the engines, bodies for them, and a look at what they
/// say.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

#include "cellsweep/cell.h"
#include "cellsweep/world/frame_source.h"
#include "contract/random.h"

namespace cellsweep::cell {

/// An engine by name, made on given SPEs with its other settings as they are.
struct NamedEngine {
  std::string name;
  Result<Broadphase> (*make)(const SpeOptions& spes);
};

template <class Options>
Result<Broadphase> make_on(const SpeOptions& spes) {
  Options options;
  options.spes = spes;
  return make_broadphase(options);
}

inline const std::array<NamedEngine, 4> kEngines = {{{"paper", make_on<CellPaperOptions>},
                                                     {"brute", make_on<CellBruteOptions>},
                                                     {"resident", make_on<CellResidentOptions>},
                                                     {"stream", make_on<CellStreamOptions>}}};

inline void PrintTo(const NamedEngine& engine, std::ostream* out) {
  *out << engine.name;
}

/// An engine that must not be refused.
template <class Options>
Broadphase make(const Options& options = {}) {
  auto made = make_broadphase(options);
  EXPECT_TRUE(made.ok()) << made.status().message;
  return std::move(*made);
}

/// Ids 0 … count − 1.
inline std::vector<BodyId> ids_up_to(std::size_t count) {
  std::vector<BodyId> ids(count);
  std::iota(ids.begin(), ids.end(), BodyId{0});
  return ids;
}

/// A cube of edge 1 on the diagonal.
inline Aabb cube(float at) {
  return {{at, at, at}, {at + 1, at + 1, at + 1}};
}

inline Aabb random_box(contract::Random& random) {
  Aabb box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.min[axis] = random.between(-5, 5);
    box.max[axis] = box.min[axis] + random.between(0, random.one_in(20) ? 8.0F : 1.5F);
  }
  return box;
}

/// Boxes in a small world; of a hundred each overlaps a few others.
inline std::vector<Aabb> random_boxes(contract::Random& random, std::size_t count) {
  std::vector<Aabb> boxes;
  for (std::size_t i = 0; i < count; ++i) boxes.push_back(random_box(random));
  return boxes;
}

/// A copy, for what comes after the next update.
inline std::vector<Pair> pairs_of(const Broadphase& engine) {
  return {engine.pairs().begin(), engine.pairs().end()};
}

inline std::uint64_t counter(const Broadphase& engine, std::string_view name) {
  const auto& counters = engine.statistics().counters;
  const auto found = std::ranges::find(counters, name, &Counter::name);
  if (found != counters.end()) return found->value;
  ADD_FAILURE() << "no counter is called " << name;
  return 0;
}

/// Hands over all bodies of a source, as 0 … n − 1.
inline Status insert_all(Broadphase& engine, const FrameSource& source) {
  return engine.insert(ids_up_to(source.boxes().size()), source.boxes());
}

/// Hands over the bodies that changed in the frame that the source stands at.
inline Status move_changed(Broadphase& engine, const FrameSource& source) {
  std::vector<Aabb> boxes;
  for (const BodyId id : source.moved()) boxes.push_back(source.boxes()[id]);
  return engine.move(source.moved(), boxes);
}

}  // namespace cellsweep::cell
