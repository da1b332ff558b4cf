/// @file
/// nanoflann's k-d tree, for worlds of points.
#include <cmath>
#include <nanoflann.hpp>

#include "bench/queries/query_peer.h"

namespace cellsweep::bench {
namespace {

/// Points as nanoflann asks for them.
struct Cloud {
  std::vector<Point> points;

  std::size_t kdtree_get_point_count() const { return points.size(); }
  float kdtree_get_pt(std::size_t point, std::size_t axis) const { return points[point][axis]; }
  template <class Box>
  bool kdtree_get_bbox(Box& /*box*/) const {
    return false;  // it finds them by itself
  }
};

using Tree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Cloud>, Cloud, 3, BodyId>;

class NanoflannQueries final : public QueryPeer {
 public:
  void build(std::span<const Aabb> boxes) override {
    boxes_ = boxes;
    cloud_.points.resize(boxes.size());
    make_tree();
  }

  void move(std::span<const BodyId> /*bodies*/) override { make_tree(); }

  void find_within(const Point& center, float radius, std::vector<BodyId>& found) override {
    nanoflann::SearchParams unsorted;
    unsorted.sorted = false;
    // It takes what is nearer than this, and nothing that is as far.
    const float square = std::nextafter(radius * radius, 2 * radius * radius);
    tree_->radiusSearch(center.data(), square, matches_, unsorted);
    found.clear();
    for (const auto& match : matches_) found.push_back(match.first);
  }

  void find_nearest(const Point& point, std::size_t count, std::vector<Neighbor>& found) override {
    indices_.resize(count);
    squares_.resize(count);
    const std::size_t some = tree_->knnSearch(point.data(), count, indices_.data(), squares_.data());
    found.clear();
    for (std::size_t i = 0; i < some; ++i) found.push_back({indices_[i], std::sqrt(squares_[i])});
  }

 private:
  void make_tree() {
    for (std::size_t i = 0; i < boxes_.size(); ++i) cloud_.points[i] = boxes_[i].min;
    tree_ = std::make_unique<Tree>(3, cloud_);
    tree_->buildIndex();
  }

  std::span<const Aabb> boxes_;
  Cloud cloud_;
  std::unique_ptr<Tree> tree_;
  std::vector<std::pair<BodyId, float>> matches_;
  std::vector<BodyId> indices_;
  std::vector<float> squares_;
};

}  // namespace

void add_nanoflann_query_peers(std::vector<QueryPeerInfo>& peers) {
  using enum QuestionKind;
  QueryPeerInfo info;
  info.name = "nanoflann";
  info.settings = "`KDTreeSingleIndexAdaptor` in floats, leaves of 10; points only";
  info.answers = {radius, nearest1, nearest8};
  info.only_points = true;
  info.make = [] { return std::make_unique<NanoflannQueries>(); };
  peers.push_back(std::move(info));
}

}  // namespace cellsweep::bench
