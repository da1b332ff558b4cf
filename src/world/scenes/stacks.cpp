#include <cmath>
#include <vector>

#include "world/arithmetic.h"
#include "world/scene_settings.h"
#include "world/scenes/scripted_scene.h"
#include "world/scenes/tremble.h"

namespace cellsweep {
namespace {

constexpr std::size_t kCubesInAStack = 10;
constexpr float kSpacing = 1.25F;

/// Stacks of unit cubes on a square. At frame 0 each cube lies exactly on the one below.
class Stacks final : public SceneScript {
 public:
  explicit Stacks(const ScriptSettings& settings) : bodies_(settings.bodies), speed_(settings.speed) {
    const std::size_t stacks = (bodies_ + kCubesInAStack - 1) / kCubesInAStack;
    while (side_ * side_ < stacks) ++side_;
    Random random(settings.seed);
    seed_ = random.next();
    movers_ = list_movers(bodies_, settings.moving, random);
    reaches_.reserve(movers_.size());
    for (std::size_t i = 0; i < movers_.size(); ++i)
      reaches_.push_back(kLeast * power(kRange, random.unit()));
  }

  Aabb bounds() const override {
    const float edge = kSpacing * static_cast<float>(side_);
    return {{0, 0, 0}, {edge, static_cast<float>(kCubesInAStack), edge}};
  }

  void enter(SceneBodies& bodies) override {
    for (std::size_t i = 0; i < bodies_; ++i) {
      const auto id = static_cast<BodyId>(i);
      bodies.insert(id, place_of(id));
    }
  }

  void step(std::size_t frame, SceneBodies& bodies) override {
    for (std::size_t i = 0; i < movers_.size(); ++i) {
      const BodyId id = movers_[i];
      bodies.move(id, shifted(place_of(id), tremble(seed_, id, frame, speed_ * reaches_[i])));
    }
  }

 private:
  static constexpr double kLeast = 1e-6;
  static constexpr double kRange = 1000;

  Aabb place_of(BodyId id) const {
    const std::size_t stack = id / kCubesInAStack;
    const std::size_t row = stack / side_;
    const float x = kSpacing * static_cast<float>(stack % side_);
    const auto y = static_cast<float>(id % kCubesInAStack);
    const float z = kSpacing * static_cast<float>(row);
    return {{x, y, z}, {x + 1, y + 1, z + 1}};
  }

  std::size_t bodies_;
  double speed_;
  std::size_t side_ = 1;
  std::uint64_t seed_ = 0;
  std::vector<BodyId> movers_;
  std::vector<double> reaches_;  // by place in movers_
};

}  // namespace

ScriptedScene stacks_scene() {
  return {
      {"stacks", "stacks of ten unit cubes that lie on each other and tremble by 1e-6 to 1e-3", 1.0, false},
      13,
      make_script_of<Stacks>};
}

}  // namespace cellsweep
