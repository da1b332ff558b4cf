#include <algorithm>
#include <vector>

#include "world/arithmetic.h"
#include "world/scene_settings.h"
#include "world/scenes/scripted_scene.h"
#include "world/scenes/tremble.h"

namespace cellsweep {
namespace {

constexpr double kHighestFall = 20;
constexpr float kPlaneThickness = 1;

/// Cubes of edges 0.6 to 1 that fall on a heap, the shape of a pyramid twice as wide as high.
class Pile final : public SceneScript {
 public:
  explicit Pile(const ScriptSettings& settings) : speed_(settings.speed) {
    const auto count = static_cast<double>(settings.bodies);
    width_ = std::max(kNarrowest, cube_root(std::max(6 * count, 1.0)));  // a unit of volume for each
    Random random(settings.seed);
    seed_ = random.next();
    const std::uint64_t places_seed = random.next();
    for (std::size_t i = 0; i < settings.bodies; ++i) {
      Random place_random(places_seed, i);
      places_.push_back(place(place_random));
      falls_.push_back(0);
    }
    movers_ = list_movers(settings.bodies, settings.moving, random);
    for (const BodyId id : movers_) falls_[id] = random.between(0, kHighestFall);
  }

  Aabb bounds() const override {
    const auto width = static_cast<float>(width_);
    return {{0, 0, 0}, {width, static_cast<float>(0.5 * width_ + 1 + kHighestFall), width}};
  }

  Aabb giant() const override {
    constexpr double kTimesTheHeap = 1000;
    const auto reach = static_cast<float>(0.5 * kTimesTheHeap * width_);
    return {{-reach, -kPlaneThickness, -reach}, {reach, 0, reach}};
  }

  void enter(SceneBodies& bodies) override {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      bodies.insert(static_cast<BodyId>(i), shifted(places_[i], {0, falls_[i], 0}));
    }
  }

  void step(std::size_t frame, SceneBodies& bodies) override {
    left_ *= std::max(0.0, 1 - kSettling * speed_);
    if (left_ < kAtRest) left_ = 0;
    for (const BodyId id : movers_) {
      Offset offset = tremble(seed_, id, frame, kTremble * speed_);
      offset[1] += left_ * falls_[id];
      bodies.move(id, shifted(places_[id], offset));
    }
  }

 private:
  static constexpr double kNarrowest = 4;
  static constexpr double kSettling = 0.05;  // of what is left of its fall, a frame
  static constexpr double kAtRest = 1e-7;
  static constexpr double kTremble = 1e-4;

  // The lowest half unit is pressed flat: those bodies lie exactly on the plane.
  Aabb place(Random& random) const {
    constexpr double kPressed = 0.5;
    const double edge = random.between(0.6, 1);
    const double top = 0.5 * width_;
    double x = 0;
    double y = 0;
    double z = 0;
    do {
      x = random.between(0, width_);
      y = random.between(0, top);
      z = random.between(0, width_);
    } while (std::min(std::min(x, width_ - x), std::min(z, width_ - z)) < y);
    const double floor = std::max(0.0, y - kPressed);
    const auto low = [edge](double centre) { return static_cast<float>(centre - 0.5 * edge); };
    const auto high = [edge](double centre) { return static_cast<float>(centre + 0.5 * edge); };
    return {{low(x), static_cast<float>(floor), low(z)},
            {high(x), static_cast<float>(floor + edge), high(z)}};
  }

  double speed_;
  double width_ = 0;
  std::uint64_t seed_ = 0;
  std::vector<Aabb> places_;
  std::vector<double> falls_;
  std::vector<BodyId> movers_;
  double left_ = 1;  // of all falls
};

}  // namespace

ScriptedScene pile_scene() {
  return {{"pile", "cubes that settle in a heap, and tremble there, on a plane a thousand times as wide", 1.0,
           false},
          14,
          make_script_of<Pile>,
          false,
          GiantSlot::first};
}

}  // namespace cellsweep
