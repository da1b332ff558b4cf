/// @file
/// The limit that memory sets, and the project's own engines as peers.
#include <utility>

#include "bench/peers/grid_oracle.h"
#include "bench/peers/peer_table.h"
#include "cellsweep/engines.h"

namespace cellsweep::bench {
namespace {

/// What no broadphase can do without: copies the boxes in when any moved, and the pairs out.
class MemoryLimit final : public Peer {
 public:
  void prepare(const Stage& stage) override { pairs_ = grid_pairs(stage.boxes); }

  void insert(std::span<const Aabb> boxes) override { boxes_.assign(boxes.begin(), boxes.end()); }

  void update(std::span<const Aabb> boxes, std::span<const BodyId> moved) override {
    if (!moved.empty()) insert(boxes);
  }

  void list_pairs(std::vector<Pair>& pairs) override { pairs.assign(pairs_.begin(), pairs_.end()); }

 private:
  std::vector<Pair> pairs_;
  std::vector<Aabb> boxes_;
};

/// An engine of the engine table. Its list is there without a copy, and is copied all the same: the others
/// write theirs into the caller's memory, too.
class OwnEngine final : public Peer {
 public:
  OwnEngine(std::string_view name, EngineOptions options) : name_(name), options_(std::move(options)) {}

  void prepare(const Stage& stage) override {
    engine_ = std::move(*make_engine(name_, options_));
    ids_.resize(stage.boxes.size());
    for (std::size_t i = 0; i < ids_.size(); ++i) ids_[i] = static_cast<BodyId>(i);
    moved_boxes_.reserve(ids_.size());
  }

  void insert(std::span<const Aabb> boxes) override {
    check(engine_->insert(ids_, boxes));
    check(engine_->update().status());
  }

  void update(std::span<const Aabb> boxes, std::span<const BodyId> moved) override {
    if (moved.size() == boxes.size()) {
      check(engine_->move(ids_, boxes));
    } else if (!moved.empty()) {
      moved_boxes_.clear();
      for (const BodyId id : moved) moved_boxes_.push_back(boxes[id]);
      check(engine_->move(moved, moved_boxes_));
    }
    check(engine_->update().status());
  }

  // A call that failed leaves no pairs, which the oracle denies.
  void list_pairs(std::vector<Pair>& pairs) override {
    const auto found = failed_ ? std::span<const Pair>() : engine_->pairs();
    pairs.assign(found.begin(), found.end());
  }

 private:
  void check(const Status& status) { failed_ = failed_ || !status.ok(); }

  std::string_view name_;
  EngineOptions options_;
  std::unique_ptr<Broadphase> engine_;
  std::vector<BodyId> ids_;
  std::vector<Aabb> moved_boxes_;
  bool failed_ = false;
};

PeerInfo own_engine(std::string_view row, std::string_view name, std::string_view threads,
                    std::string_view settings, const EngineOptions& options) {
  PeerInfo info;
  info.name = row;
  info.threads = threads;
  info.margin = name == "stream" ? "hulls, chosen by itself" : "none";
  info.settings = settings;
  info.exactness = "exactly the pairs, in ascending order; also which began and ended";
  info.most_bodies = (*make_engine(name, options))->capacity().bodies;
  info.make = [name, options] { return std::make_unique<OwnEngine>(name, options); };
  return info;
}

}  // namespace

void add_own_peers(std::vector<PeerInfo>& peers) {
  PeerInfo memory;
  memory.name = "memory";
  memory.threads = "1";
  memory.margin = "none";
  memory.settings = "the limit: all boxes copied in when one moved, all pairs copied out";
  memory.exactness = "nothing";
  memory.most_bodies = kAnyNumber;
  memory.finds_pairs = false;
  memory.make = [] { return std::make_unique<MemoryLimit>(); };
  peers.push_back(std::move(memory));

  peers.push_back(own_engine("stream", "stream", "as many as it finds to pay", "as it comes", {}));
  EngineOptions one_thread;
  one_thread.threads = 1;
  peers.push_back(own_engine("stream_1", "stream", "1", "`--threads 1`", one_thread));
#ifdef CELLSWEEP_CELL_ENGINES
  peers.push_back(own_engine("cell-resident", "cell-resident", "one for each SPU", "as it comes", {}));
#endif
}

}  // namespace cellsweep::bench
