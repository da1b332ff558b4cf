#include "engines/stream/worlds.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engines/oracle/brute_force.h"

namespace cellsweep::stream {

std::vector<BodyId> ids_below(std::size_t count) {
  std::vector<BodyId> ids(count);
  std::iota(ids.begin(), ids.end(), BodyId{0});
  return ids;
}

Aabb cube_in(contract::Random& random, float edge, float world) {
  Aabb box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.min[axis] = random.between(0, world);
    box.max[axis] = box.min[axis] + edge;
  }
  return box;
}

std::vector<Aabb> uniform_boxes(std::size_t count, std::uint64_t seed) {
  contract::Random random(seed);
  const float world = 2 * std::cbrt(static_cast<float>(count));
  std::vector<Aabb> boxes;
  for (std::size_t i = 0; i < count; ++i) boxes.push_back(cube_in(random, 1, world));
  return boxes;
}

void shake(std::vector<Aabb>& boxes, float step, std::uint64_t seed) {
  contract::Random random(seed);
  for (Aabb& box : boxes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float by = random.between(-step, step);
      box.min[axis] += by;
      box.max[axis] += by;
    }
  }
}

Broadphase engine_with(const std::vector<Aabb>& boxes, const StreamOptions& options) {
  Broadphase engine = std::move(*make_broadphase(options));
  insert_all(engine, boxes);
  return engine;
}

void insert_all(Broadphase& engine, const std::vector<Aabb>& boxes) {
  ASSERT_TRUE(engine.insert(ids_below(boxes.size()), boxes).ok());
}

void move_every(Broadphase& engine, const std::vector<Aabb>& boxes, std::size_t every) {
  std::vector<BodyId> ids;
  std::vector<Aabb> moved;
  for (std::size_t i = 0; i < boxes.size(); i += every) {
    ids.push_back(static_cast<BodyId>(i));
    moved.push_back(boxes[i]);
  }
  ASSERT_TRUE(engine.move(ids, moved).ok());
}

std::vector<Pair> pairs_among(const std::vector<Aabb>& boxes) {
  return brute_force_pairs(boxes);
}

testing::AssertionResult is_exact(const Broadphase& engine, const std::vector<Aabb>& boxes) {
  const std::vector<Pair> truth = brute_force_pairs(boxes);
  if (std::ranges::equal(engine.pairs(), truth)) return testing::AssertionSuccess();
  return testing::AssertionFailure() << engine.pairs().size() << " pairs, brute force finds " << truth.size()
                                     << ", or they are not in ascending order";
}

std::uint64_t counter(const Broadphase& engine, std::string_view name) {
  for (const Counter& candidate : engine.statistics().counters) {
    if (candidate.name == name) return candidate.value;
  }
  ADD_FAILURE() << "no counter is called " << name;
  return 0;
}

}  // namespace cellsweep::stream
