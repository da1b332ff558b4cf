// A row of boxes on a static ground, two of them an actor, of which every other one is lifted and then
// removed, told in PhysX's way.
#include <cstdio>
#include <numeric>
#include <vector>

#include "broad_phase.h"

namespace {

using namespace physx_front;

struct Objects {
  std::vector<cellsweep::Aabb> bounds;
  std::vector<Group> groups;
  std::vector<float> distances;

  void add(const cellsweep::Aabb& box, Group group) {
    bounds.push_back(box);
    groups.push_back(group);
    distances.push_back(0.02F);
  }
};

bool step(BroadPhase& broad_phase, const Objects& objects, std::span<const Index> created,
          std::span<const Index> updated, std::span<const Index> removed) {
  const UpdateData data{created, updated, removed, objects.bounds, objects.groups, objects.distances};
  if (!broad_phase.update(data)) {
    std::fprintf(stderr, "%s\n", broad_phase.error().c_str());
    return false;
  }
  const Results& results = broad_phase.results();
  std::printf("%zu pairs created, %zu deleted\n", results.created_pairs.size(), results.deleted_pairs.size());
  return true;
}

}  // namespace

int main() {
  Objects objects;
  objects.add({{-1000, -1, -1000}, {1000, 0, 1000}}, kStatic);
  for (int i = 0; i < 100; ++i) {
    const auto x = static_cast<float>(i);
    objects.add({{x + 0.01F, 0.01F, 0}, {x + 0.99F, 1, 1}},
                static_cast<Group>(1 + i / 2));  // two are an actor
  }
  BroadPhase broad_phase;
  std::vector<Index> all(objects.bounds.size());
  std::iota(all.begin(), all.end(), Index{0});
  if (!step(broad_phase, objects, all, {}, {})) return 1;

  std::vector<Index> every_other;
  for (Index i = 1; i < all.size(); i += 2) {
    every_other.push_back(i);
    objects.bounds[i].min[1] += 5;
    objects.bounds[i].max[1] += 5;
  }
  if (!step(broad_phase, objects, {}, every_other, {})) return 1;
  if (!step(broad_phase, objects, {}, {}, every_other)) return 1;
  return 0;
}
