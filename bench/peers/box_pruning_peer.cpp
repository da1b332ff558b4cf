/// @file
/// The yardstick as a peer.
#include "bench/peers/box_pruning.h"
#include "bench/peers/peer_table.h"

namespace cellsweep::bench {
namespace {

class BoxPruningPeer final : public Peer {
 public:
  void insert(std::span<const Aabb> boxes) override { pruning_.find_pairs(boxes, found_); }
  void update(std::span<const Aabb> boxes, const PeerChanges&) override { insert(boxes); }
  // The next search writes into whatever memory the caller had.
  void list_pairs(std::vector<Pair>& pairs) override { pairs.swap(found_); }

 private:
  BoxPruning pruning_;
  std::vector<Pair> found_;
};

}  // namespace

void add_box_pruning(std::vector<PeerInfo>& peers) {
  PeerInfo info;
  info.name = "box_pruning";
  info.threads = "1";
  info.margin = "none";
  info.settings = "our yardstick: radix sort on the widest axis, a sweep in AVX2, everything anew each frame";
  info.exactness = "exactly the pairs";
  info.most_bodies = kAnyNumber;
  info.remembers = false;
  info.make = [] { return std::make_unique<BoxPruningPeer>(); };
  peers.push_back(std::move(info));
}

}  // namespace cellsweep::bench
