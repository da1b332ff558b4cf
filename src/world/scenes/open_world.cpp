#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "world/scene_settings.h"
#include "world/scenes/scripted_scene.h"

namespace cellsweep {
namespace {

constexpr std::size_t kWindow = 8;           // chunks on a side of the square that is there
constexpr std::size_t kWorld = 2 * kWindow;  // and of the world
constexpr std::size_t kFramesAChunk = 2 * kWindow;

/// A square of the world's floor.
struct Chunk {
  std::size_t x = 0;
  std::size_t z = 0;
};

/// Around a camera a square of chunks is there. The camera goes around the world; for each chunk of its way
/// those behind go, one a frame, and then those ahead come, one a frame. A chunk that comes has the ids of
/// one that went: both have the same place modulo the square's side.
class OpenWorld final : public SceneScript {
 public:
  explicit OpenWorld(const ScriptSettings& settings) : bodies_(settings.bodies), speed_(settings.speed) {
    // Each body has a room of 9 of its own: it overlaps about one other.
    edge_ = std::max(kSmallestChunk, 1.5 * std::sqrt(static_cast<double>(bodies_) / kBatches));
    Random random(settings.seed);
    chunks_seed_ = random.next();
    walkers_ = list_movers(bodies_, settings.moving, random);
    actors_.resize(bodies_);
  }

  Aabb bounds() const override {
    const auto width = static_cast<float>(edge_ * static_cast<double>(kWorld));
    return {{0, 0, 0}, {width, static_cast<float>(kHeight), width}};
  }

  void enter(SceneBodies& bodies) override {
    for (std::size_t z = 0; z < kWindow; ++z) {
      for (std::size_t x = 0; x < kWindow; ++x) load({x, z}, bodies);
    }
  }

  // What comes this frame walks from the next one on.
  void step(std::size_t frame, SceneBodies& bodies) override {
    const std::size_t way = (frame - 1) / kFramesAChunk;
    const std::size_t phase = (frame - 1) % kFramesAChunk;
    if (phase < kWindow) unload(chunk_behind(way, phase), bodies);
    walk(bodies);
    if (phase >= kWindow) load(chunk_ahead(way, phase - kWindow), bodies);
  }

 private:
  static constexpr std::size_t kBatches = kWindow * kWindow;
  static constexpr double kSmallestChunk = 4;
  static constexpr double kHeight = 4;

  /// A body as it stands in its chunk.
  struct Actor {
    std::array<double, 3> centre{};
    double half = 0;
    std::array<double, 2> velocity{};  ///< on x and z
    Chunk chunk;
  };

  // The lower corner of the square after so many chunks of the way: along x, along z, and back.
  static Chunk camera_after(std::size_t way) {
    const std::size_t done = way % kWindow;
    switch (way / kWindow % 4) {
      case 0:
        return {done, 0};
      case 1:
        return {kWindow, done};
      case 2:
        return {kWindow - done, kWindow};
      default:
        return {0, kWindow - done};
    }
  }

  /// Chunk number `index` of those that are in the square from one camera and not from the other.
  static Chunk only_from(Chunk one, Chunk other, std::size_t index) {
    constexpr std::size_t kFar = kWindow - 1;
    if (one.x < other.x) return {one.x, one.z + index};
    if (one.x > other.x) return {one.x + kFar, one.z + index};
    if (one.z < other.z) return {one.x + index, one.z};
    return {one.x + index, one.z + kFar};
  }

  static Chunk chunk_behind(std::size_t way, std::size_t index) {
    return only_from(camera_after(way), camera_after(way + 1), index);
  }

  static Chunk chunk_ahead(std::size_t way, std::size_t index) {
    return only_from(camera_after(way + 1), camera_after(way), index);
  }

  static std::size_t batch_of(Chunk chunk) { return chunk.z % kWindow * kWindow + chunk.x % kWindow; }

  std::size_t first_of(std::size_t batch) const {
    return batch * (bodies_ / kBatches) + std::min(batch, bodies_ % kBatches);
  }

  void load(Chunk chunk, SceneBodies& bodies) {
    Random random(chunks_seed_, chunk.z * kWorld + chunk.x);
    const std::size_t batch = batch_of(chunk);
    for (std::size_t i = first_of(batch); i < first_of(batch + 1); ++i) {
      actors_[i] = place(chunk, random);
      bodies.insert(static_cast<BodyId>(i), box_of(actors_[i]));
    }
  }

  void unload(Chunk chunk, SceneBodies& bodies) const {
    const std::size_t batch = batch_of(chunk);
    for (std::size_t i = first_of(batch); i < first_of(batch + 1); ++i) bodies.remove(static_cast<BodyId>(i));
  }

  Actor place(Chunk chunk, Random& random) const {
    constexpr double kFastest = 0.05;
    Actor actor;
    actor.chunk = chunk;
    actor.half = random.between(0.25, 0.75);
    actor.centre = {random.between(low(chunk.x), low(chunk.x + 1)),
                    random.between(actor.half, kHeight - actor.half),
                    random.between(low(chunk.z), low(chunk.z + 1))};
    for (double& v : actor.velocity) v = speed_ * random.between(-kFastest, kFastest);
    return actor;
  }

  double low(std::size_t chunk) const { return edge_ * static_cast<double>(chunk); }

  void walk(SceneBodies& bodies) {
    for (const BodyId id : walkers_) {
      if (!bodies.has(id)) continue;
      Actor& actor = actors_[id];
      walk(actor.centre[0], actor.velocity[0], actor.chunk.x);
      walk(actor.centre[2], actor.velocity[1], actor.chunk.z);
      bodies.move(id, box_of(actor));
    }
  }

  // It turns back at the ends of its chunk, which go and come with it.
  void walk(double& centre, double& velocity, std::size_t chunk) const {
    centre += velocity;
    if ((centre < low(chunk) && velocity < 0) || (centre > low(chunk + 1) && velocity > 0)) {
      velocity = -velocity;
    }
  }

  static Aabb box_of(const Actor& actor) {
    Aabb box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] = static_cast<float>(actor.centre[axis] - actor.half);
      box.max[axis] = static_cast<float>(actor.centre[axis] + actor.half);
    }
    return box;
  }

  std::size_t bodies_;
  double speed_;
  double edge_ = 0;
  std::uint64_t chunks_seed_ = 0;
  std::vector<BodyId> walkers_;
  std::vector<Actor> actors_;
};

}  // namespace

ScriptedScene open_world_scene() {
  return {
      {"open-world",
       "an open world around a moving camera: a batch of bodies goes behind it or comes ahead in each frame, "
       "and 5 % of them walk",
       0.05, false},
      16,
      make_script_of<OpenWorld>,
      true};
}

}  // namespace cellsweep
