/// @file
/// Ten million random boxes through `stream`, its pairs compared with an oracle that shares no code with it.
/// One argument, if any: how many boxes instead.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <vector>

#include "bench/peers/grid_oracle.h"
#include "cellsweep/broadphase.h"
#include "world/scene_recipes.h"

namespace {

using namespace cellsweep;

using Clock = std::chrono::steady_clock;

constexpr std::size_t kBodies = 10'000'000;
constexpr std::size_t kMostBodies = 100'000'000;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Bytes of this process that are in memory now; 0 where the system does not say.
double resident_bytes() {
  std::ifstream file("/proc/self/statm");
  double all = 0;
  double resident = 0;
  constexpr double kPage = 4096;
  return file >> all >> resident ? resident * kPage : 0;
}

// Scene `uniform`, without the rigid bodies that would be larger than everything measured here.
std::vector<Aabb> random_boxes(std::size_t bodies) {
  const SceneRecipe& recipe = scene_recipes().front();
  const auto edge = static_cast<float>(recipe.world_edge(static_cast<double>(bodies)));
  std::vector<Aabb> boxes(bodies);
  for (std::size_t i = 0; i < bodies; ++i) {
    Random random(1, i);
    const Placement placement = recipe.place({static_cast<BodyId>(i), edge, true}, random);
    for (std::size_t k = 0; k < 3; ++k) {
      boxes[i].min[k] = placement.centre[k] - 0.5F * placement.edges[k];
      boxes[i].max[k] = placement.centre[k] + 0.5F * placement.edges[k];
    }
  }
  return boxes;
}

// All bodies one twentieth of an edge on, along an axis that differs from one to the next.
void move_all(std::vector<Aabb>& boxes) {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    boxes[i].min[i % 3] += 0.05F;
    boxes[i].max[i % 3] += 0.05F;
  }
}

bool same_pairs(const Broadphase& engine, const std::vector<Aabb>& boxes) {
  const Clock::time_point start = Clock::now();
  const std::vector<Pair> expected = bench::grid_pairs(boxes);
  const std::uint64_t expected_hash = pair_set_hash(expected);
  const std::uint64_t hash = pair_set_hash(engine.pairs());
  const bool same = expected.size() == engine.pairs().size() && expected_hash == hash;
  std::printf("  pairs  %zu, hash %s\n  oracle %zu, hash %s, in %.1f s: %s\n", engine.pairs().size(),
              hash_text(hash).c_str(), expected.size(), hash_text(expected_hash).c_str(),
              seconds_since(start), same ? "the same" : "DIFFERENT");
  return same;
}

void print_memory(double before, std::size_t bodies) {
  const double bytes = resident_bytes() - before;
  std::printf("  memory %.0f MB, %.0f bytes a body\n", bytes / 1e6, bytes / static_cast<double>(bodies));
}

int run(std::size_t bodies) {
  std::printf("%zu boxes\n", bodies);
  std::vector<Aabb> boxes = random_boxes(bodies);
  std::vector<BodyId> ids(bodies);
  for (std::size_t i = 0; i < bodies; ++i) ids[i] = static_cast<BodyId>(i);
  Broadphase engine;
  const double before = resident_bytes();

  Clock::time_point start = Clock::now();
  bool good = engine.insert(ids, boxes).ok() && engine.update().ok();
  std::printf("all new: %.2f s\n", seconds_since(start));
  print_memory(before, bodies);
  good = same_pairs(engine, boxes) && good;

  move_all(boxes);
  start = Clock::now();
  good = engine.move(ids, boxes).ok() && engine.update().ok() && good;
  std::printf("all moved: %.2f s\n", seconds_since(start));
  print_memory(before, bodies);
  good = same_pairs(engine, boxes) && good;
  return good ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t bodies = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : kBodies;
  if (argc > 2 || bodies == 0 || bodies > kMostBodies) {
    std::fprintf(stderr, "usage: big [BODIES], 1 to %zu\n", kMostBodies);
    return 2;
  }
  return run(bodies);
}
