#include <array>
#include <cmath>
#include <vector>

#include "world/scene_settings.h"
#include "world/scenes/scripted_scene.h"
#include "world/scenes/tremble.h"

namespace cellsweep {
namespace {

/// Where a part is in its ragdoll, and half of its edges.
struct Part {
  Offset centre;
  Offset half;
};

// Each overlaps the one that it hangs on by 0.03 at least.
constexpr std::array kParts = {
    Part{{0, 1.00, 0}, {0.18, 0.12, 0.12}},      // pelvis
    Part{{0, 1.18, 0}, {0.16, 0.10, 0.11}},      // belly
    Part{{0, 1.40, 0}, {0.20, 0.16, 0.13}},      // chest
    Part{{0, 1.66, 0}, {0.11, 0.13, 0.12}},      // head
    Part{{-0.28, 1.40, 0}, {0.12, 0.07, 0.07}},  // upper arms and forearms
    Part{{-0.48, 1.40, 0}, {0.12, 0.06, 0.06}},
    Part{{0.28, 1.40, 0}, {0.12, 0.07, 0.07}},
    Part{{0.48, 1.40, 0}, {0.12, 0.06, 0.06}},
    Part{{-0.10, 0.72, 0}, {0.09, 0.22, 0.09}},  // thighs and shins
    Part{{-0.10, 0.30, 0}, {0.07, 0.24, 0.07}},
    Part{{0.10, 0.72, 0}, {0.09, 0.22, 0.09}},
    Part{{0.10, 0.30, 0}, {0.07, 0.24, 0.07}},
};

// From −1 to 1 and back in one period, in straight lines: sines differ between machines.
double wave(double periods) {
  const double place = periods - std::floor(periods);
  return 4 * std::abs(place - 0.5) - 1;
}

/// A crowd on a square, close enough for arms to touch. Who is awake sways, and its parts swing.
class Ragdolls final : public SceneScript {
 public:
  explicit Ragdolls(const ScriptSettings& settings) : bodies_(settings.bodies), speed_(settings.speed) {
    const std::size_t ragdolls = (bodies_ + kParts.size() - 1) / kParts.size();
    while (side_ * side_ < ragdolls) ++side_;
    Random random(settings.seed);
    places_seed_ = random.next();
    awake_ = list_movers(ragdolls, settings.moving, random);
  }

  Aabb bounds() const override {
    constexpr float kTallest = 2;
    const auto side = static_cast<float>(side_);
    return {{0, 0, 0},
            {static_cast<float>(kSpacingX) * side + 2, kTallest, static_cast<float>(kSpacingZ) * side + 2}};
  }

  void enter(SceneBodies& bodies) override {
    const std::size_t ragdolls = (bodies_ + kParts.size() - 1) / kParts.size();
    for (std::size_t i = 0; i < ragdolls; ++i) {
      const auto ragdoll = static_cast<BodyId>(i);
      const Offset feet = place_of(ragdoll);
      for (std::size_t part = 0; part < parts_of(ragdoll); ++part) {
        bodies.insert(id_of(ragdoll, part), box_of(part, feet));
      }
    }
  }

  void step(std::size_t frame, SceneBodies& bodies) override {
    for (const BodyId ragdoll : awake_) {
      const Offset feet = swayed(ragdoll, frame);
      for (std::size_t part = 0; part < parts_of(ragdoll); ++part) {
        const BodyId id = id_of(ragdoll, part);
        bodies.move(id, box_of(part, plus(feet, swing(id, frame))));
      }
    }
  }

 private:
  static constexpr double kSpacingX = 1.1;
  static constexpr double kSpacingZ = 0.5;
  static constexpr double kSway = 0.25;
  static constexpr double kSwing = 0.01;  // less than what keeps two parts together

  static BodyId id_of(BodyId ragdoll, std::size_t part) {
    return static_cast<BodyId>(ragdoll * kParts.size() + part);
  }

  static Offset plus(const Offset& a, const Offset& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

  static Aabb box_of(std::size_t part, const Offset& feet) {
    const auto& [centre, half] = kParts[part];
    Aabb box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] = static_cast<float>(feet[axis] + centre[axis] - half[axis]);
      box.max[axis] = static_cast<float>(feet[axis] + centre[axis] + half[axis]);
    }
    return box;
  }

  // The last ragdoll may lack some.
  std::size_t parts_of(BodyId ragdoll) const {
    return std::min(kParts.size(), bodies_ - ragdoll * kParts.size());
  }

  // Not all in one line.
  Offset place_of(BodyId ragdoll) const {
    constexpr double kJitter = 0.1;
    Random random(places_seed_, ragdoll);
    const std::size_t column = ragdoll % side_;
    const std::size_t row = ragdoll / side_;
    return {1 + kSpacingX * static_cast<double>(column) + random.between(-kJitter, kJitter), 0,
            1 + kSpacingZ * static_cast<double>(row) + random.between(-kJitter, kJitter)};
  }

  // Sways in 100 to 400 frames, from its place on.
  Offset swayed(BodyId ragdoll, std::size_t frame) const {
    Random random(places_seed_ + 1, ragdoll);
    const double time = speed_ * static_cast<double>(frame);
    Offset feet = place_of(ragdoll);
    for (const std::size_t axis : {0, 2}) {
      const double rate = random.between(0.0025, 0.01);
      feet[axis] += kSway * wave(kFromThePlace + time * rate);
    }
    return feet;
  }

  Offset swing(BodyId id, std::size_t frame) const {
    Random random(places_seed_ + 2, id);
    const double time = speed_ * static_cast<double>(frame);
    Offset offset{};
    for (double& x : offset) x = kSwing * wave(kFromThePlace + time * random.between(0.01, 0.03));
    return offset;
  }

  static constexpr double kFromThePlace = 0.25;  // the wave is 0 there

  std::size_t bodies_;
  double speed_;
  std::size_t side_ = 1;
  std::uint64_t places_seed_ = 0;
  std::vector<BodyId> awake_;
};

}  // namespace

ScriptedScene ragdolls_scene() {
  return {{"ragdolls", "a crowd of ragdolls of 12 linked boxes each, 1 % of them awake", 0.01, false},
          15,
          make_script_of<Ragdolls>};
}

}  // namespace cellsweep
