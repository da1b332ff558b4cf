// Whatever each rank's caller has made of floating-point arithmetic, traps included, the world is the same.
#include "float_settings.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "cellsweep/query.h"
#include "ranks/twins.h"

namespace cellsweep::ranks {
namespace {

constexpr std::size_t kBodies = 120;

/// Boxes of which many touch, by whole numbers or by denormal ones.
std::vector<Aabb> boxes_near_each_other(std::mt19937& random) {
  const auto below = [&](int end) { return std::uniform_int_distribution<int>(0, end - 1)(random); };
  std::vector<Aabb> boxes(kBodies);
  for (Aabb& box : boxes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] = below(4) == 0 ? 1e-40F : static_cast<float>(below(13) - 6);
      box.max[axis] = box.min[axis] + static_cast<float>(below(3));
    }
  }
  return boxes;
}

/// Settings that differ from rank to rank and from call to call.
class ChangingSettings {
 public:
  FloatSettings next() {
    return FloatSettings(all_[(static_cast<std::size_t>(own_rank()) * 5 + calls_++) % all_.size()]);
  }
  std::size_t count() const { return all_.size(); }

 private:
  const decltype(all_float_settings()) all_ = all_float_settings();
  std::size_t calls_ = 0;
};

std::vector<BodyId> all_bodies() {
  std::vector<BodyId> ids(kBodies);
  for (BodyId id = 0; id < kBodies; ++id) ids[id] = id;
  return ids;
}

TEST(FloatsOfTheCaller, ChangeNothingThatTheRanksSay) {
  std::mt19937 random(3);
  ChangingSettings settings;
  Twins twins({.recut_every = 2});
  const std::vector<BodyId> ids = all_bodies();
  for (std::size_t frame = 0; frame <= settings.count(); ++frame) {
    const std::vector<Aabb> boxes = boxes_near_each_other(random);
    const int giver = static_cast<int>(frame) % all_ranks();
    {
      const FloatSettings mine = settings.next();
      frame == 0 ? twins.insert(giver, ids, boxes) : twins.move(giver, ids, boxes);
    }
    const auto said = [&] {
      const FloatSettings mine = settings.next();
      return twins.world().update();
    }();
    const auto truth = twins.whole().update();
    ASSERT_TRUE(on_all_ranks(said.ok() && truth.ok())) << said.status().message;
    ASSERT_EQ(twins.compare(*truth, *said), "") << "frame " << frame;
  }
}

TEST(FloatsOfTheCaller, ChangeNoAnswer) {
  std::mt19937 random(4);
  ChangingSettings settings;
  Twins twins;
  twins.insert(0, all_bodies(), boxes_near_each_other(random));
  ASSERT_EQ(twins.update_and_compare(), "");
  for (std::size_t i = 0; i < settings.count(); ++i) {
    std::vector<Region> regions;
    for (const Aabb& box : boxes_near_each_other(random)) regions.emplace_back(box, 0.25);
    BatchAnswers<GlobalId> said;
    BatchAnswers<BodyId> truth;
    const bool asked = [&] {
      const FloatSettings mine = settings.next();
      return twins.world().queries().find_overlaps(regions, said).ok();
    }();
    ASSERT_TRUE(on_all_ranks(asked && twins.whole().queries().find_overlaps(regions, truth).ok()));
    bool same = said.first == truth.first && said.answers.size() == truth.answers.size();
    for (std::size_t k = 0; same && k < said.answers.size(); ++k)
      same = said.answers[k] == global_id(truth.answers[k]);
    ASSERT_TRUE(on_all_ranks(same)) << "question " << i;
  }
}

}  // namespace
}  // namespace cellsweep::ranks
