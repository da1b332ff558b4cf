/// @file
/// The limit that memory sets, and the project's own engines as peers.
#include <numeric>
#include <utility>

#include "bench/peers/grid_oracle.h"
#include "bench/peers/peer_table.h"
#include "cellsweep/engines.h"
#include "report/all_engines.h"
#include "world/random.h"

namespace cellsweep::bench {
namespace {

/// What no broadphase can do without: copies the boxes in when any moved, and the pairs out.
class MemoryLimit final : public Peer {
 public:
  void prepare(const Stage& stage) override { pairs_ = grid_pairs(stage.boxes); }

  void insert(std::span<const Aabb> boxes) override { boxes_.assign(boxes.begin(), boxes.end()); }

  void update(std::span<const Aabb> boxes, const PeerChanges& changes) override {
    if (changes.any()) insert(boxes);
  }

  void list_pairs(std::vector<Pair>& pairs) override { pairs.assign(pairs_.begin(), pairs_.end()); }

 private:
  std::vector<Pair> pairs_;
  std::vector<Aabb> boxes_;
};

/// An engine of the engine table. Its list is there without a copy, and is copied all the same: the others
/// write theirs into the caller's memory, too.
class OwnEngine : public Peer {
 public:
  OwnEngine(std::string_view name, SettingValues settings) : name_(name), settings_(std::move(settings)) {}

  void prepare(const Stage& stage) override {
    engine_ = std::move(*make_broadphase(name_, settings_));
    ids_.resize(stage.boxes.size());
    for (std::size_t i = 0; i < ids_.size(); ++i) ids_[i] = static_cast<BodyId>(i);
    gathered_.reserve(ids_.size());
  }

  void insert(std::span<const Aabb> boxes) override { insert(ids_, boxes); }

  Work work() const override { return engine_.statistics().work; }

  void update(std::span<const Aabb> boxes, const PeerChanges& changes) override {
    if (!changes.removed.empty()) check(engine_.remove(ids_of(changes.removed)));
    if (!changes.inserted.empty()) {
      const auto gathered = gather(boxes, changes.inserted);
      check(engine_.insert(ids_of(changes.inserted), gathered));
    }
    if (changes.moved.size() == boxes.size()) {
      check(engine_.move(ids_, boxes));
    } else if (!changes.moved.empty()) {
      const auto gathered = gather(boxes, changes.moved);
      check(engine_.move(ids_of(changes.moved), gathered));
    }
    check(engine_.update().status());
  }

  // A call that failed leaves no pairs, which the oracle denies.
  void list_pairs(std::vector<Pair>& pairs) override {
    const auto found = failed_ ? std::span<const Pair>() : engine_.pairs();
    pairs.assign(found.begin(), found.end());
  }

 protected:
  void insert(std::span<const BodyId> ids, std::span<const Aabb> boxes) {
    check(engine_.insert(ids, boxes));
    check(engine_.update().status());
  }

  /// The ids that the engine knows these bodies by.
  virtual std::span<const BodyId> ids_of(std::span<const BodyId> bodies) { return bodies; }

  std::vector<BodyId> ids_;  // by body

 private:
  std::span<const Aabb> gather(std::span<const Aabb> boxes, std::span<const BodyId> bodies) {
    gathered_.clear();
    for (const BodyId id : bodies) gathered_.push_back(boxes[id]);
    return gathered_;
  }

  void check(const Status& status) { failed_ = failed_ || !status.ok(); }

  std::string_view name_;
  SettingValues settings_;
  Broadphase engine_;
  std::vector<Aabb> gathered_;
  bool failed_ = false;
};

/// The same with ids from all over 32 bits: what ids cost.
class ScatteredEngine : public OwnEngine {
 public:
  using OwnEngine::OwnEngine;

  void prepare(const Stage& stage) override {
    OwnEngine::prepare(stage);
    for (BodyId& id : ids_) id *= kScatter;
    some_ids_.reserve(ids_.size());
  }

  BodyId body_of(BodyId id) const override { return id * kGather; }

 private:
  // An odd number modulo 2^32 is undone by another.
  static constexpr BodyId kScatter = 2654435761U;
  static constexpr BodyId kGather = 244002641U;
  static_assert(kScatter * kGather == 1);

  std::span<const BodyId> ids_of(std::span<const BodyId> bodies) override {
    some_ids_.clear();
    for (const BodyId body : bodies) some_ids_.push_back(ids_[body]);
    return some_ids_;
  }

  std::vector<BodyId> some_ids_;
};

/// And with bodies that come in no order: what lies side by side in memory is far apart in space, and the
/// calls of move() name bodies in another order than insert() did.
class ShuffledEngine final : public ScatteredEngine {
 public:
  using ScatteredEngine::ScatteredEngine;

  // The boxes' order is the user's own, and no part of the frame.
  void prepare(const Stage& stage) override {
    ScatteredEngine::prepare(stage);
    std::vector<BodyId> order(ids_.size());
    std::iota(order.begin(), order.end(), BodyId{0});
    Random random(1, order.size());
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    for (const BodyId body : order) {
      shuffled_ids_.push_back(ids_[body]);
      shuffled_boxes_.push_back(stage.boxes[body]);
    }
  }

  void insert(std::span<const Aabb>) override { OwnEngine::insert(shuffled_ids_, shuffled_boxes_); }

 private:
  std::vector<BodyId> shuffled_ids_;
  std::vector<Aabb> shuffled_boxes_;
};

template <class Own>
PeerInfo own_engine(std::string_view row, std::string_view name, std::string_view threads,
                    std::string_view settings, const SettingValues& values = {}) {
  PeerInfo info;
  info.name = row;
  info.threads = threads;
  info.removes = true;
  info.margin = name == "stream" ? "fat boxes, chosen by itself" : "none";
  info.settings = settings;
  info.exactness = "exactly the pairs, in ascending order; also which began and ended";
  info.most_bodies = make_broadphase(name, values)->capacity().bodies;
  info.make = [name, values] { return std::make_unique<Own>(name, values); };
  return info;
}

}  // namespace

void add_own_peers(std::vector<PeerInfo>& peers) {
  report::add_all_engines();
  PeerInfo memory;
  memory.name = "memory";
  memory.threads = "1";
  memory.margin = "none";
  memory.settings = "the limit: all boxes copied in when one moved, all pairs copied out";
  memory.exactness = "nothing";
  memory.most_bodies = kAnyNumber;
  memory.removes = true;
  memory.finds_pairs = false;
  memory.make = [] { return std::make_unique<MemoryLimit>(); };
  peers.push_back(std::move(memory));

  constexpr std::string_view kAsItFindsToPay = "as many as it finds to pay";
  peers.push_back(own_engine<OwnEngine>("stream", "stream", kAsItFindsToPay, "as it comes"));
  peers.push_back(own_engine<ScatteredEngine>("stream_scattered", "stream", kAsItFindsToPay,
                                              "as it comes; ids from all over 32 bits"));
  peers.push_back(own_engine<ShuffledEngine>(
      "stream_shuffled", "stream", kAsItFindsToPay,
      "as it comes; ids from all over 32 bits, bodies inserted in an order of chance"));
  peers.push_back(own_engine<OwnEngine>("stream_1", "stream", "1", "`--threads 1`", {{"threads", "1"}}));
  if (find_engine("cell-resident") != nullptr)
    peers.push_back(
        own_engine<OwnEngine>("cell-resident", "cell-resident", "one for each SPU", "as it comes"));
}

}  // namespace cellsweep::bench
