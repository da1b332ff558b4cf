/// @file
/// CGAL's box_self_intersection_d, sequential and parallel. CGAL's package is under the GPL: what is linked
/// with this file is, too.
#include <CGAL/box_intersection_d.h>
#include <tbb/enumerable_thread_specific.h>

#include <cstddef>

#include "bench/peers/peer_table.h"

namespace cellsweep::bench {
namespace {

/// CGAL sorts these.
struct Entry {
  Aabb box;
  BodyId id = 0;
};

/// How CGAL reads an entry.
struct EntryTraits {
  using Box_parameter = const Entry&;
  using NT = float;
  using ID = std::size_t;
  static int dimension() { return 3; }
  static float min_coord(const Entry& entry, int axis) {
    return entry.box.min[static_cast<std::size_t>(axis)];
  }
  static float max_coord(const Entry& entry, int axis) {
    return entry.box.max[static_cast<std::size_t>(axis)];
  }
  static std::size_t id(const Entry& entry) { return entry.id; }
};

constexpr std::ptrdiff_t kCutoff = 10;  // CGAL's default

template <class Tag>
class CgalPeer final : public Peer {
 public:
  void insert(std::span<const Aabb> boxes) override {
    entries_.resize(boxes.size());
    for (std::size_t id = 0; id < boxes.size(); ++id) entries_[id] = {boxes[id], static_cast<BodyId>(id)};
    for (auto& list : found_) list.clear();
    const auto take = [this](const Entry& one, const Entry& other) {
      found_.local().push_back(make_pair_of(one.id, other.id));
    };
    CGAL::box_self_intersection_d<Tag>(entries_.begin(), entries_.end(), take, EntryTraits(), kCutoff,
                                       CGAL::Box_intersection_d::CLOSED);
  }

  void update(std::span<const Aabb> boxes, const PeerChanges&) override { insert(boxes); }

  void list_pairs(std::vector<Pair>& pairs) override {
    pairs.clear();
    for (const auto& list : found_) pairs.insert(pairs.end(), list.begin(), list.end());
  }

 private:
  std::vector<Entry> entries_;
  tbb::enumerable_thread_specific<std::vector<Pair>> found_;
};

template <class Tag>
PeerInfo cgal_peer(std::string_view name, std::string_view threads) {
  PeerInfo info;
  info.name = name;
  info.threads = threads;
  info.margin = "none";
  info.settings = "`box_self_intersection_d`, cutoff 10 (default), everything anew each frame";
  info.exactness = "exactly the pairs";
  info.most_bodies = kAnyNumber;
  info.remembers = false;
  info.make = [] { return std::make_unique<CgalPeer<Tag>>(); };
  return info;
}

}  // namespace

void add_cgal_peers(std::vector<PeerInfo>& peers) {
  peers.push_back(cgal_peer<CGAL::Sequential_tag>("cgal", "1"));
  peers.push_back(cgal_peer<CGAL::Parallel_tag>("cgal_parallel", "all cores"));
}

}  // namespace cellsweep::bench
