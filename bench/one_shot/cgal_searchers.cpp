/// @file
/// CGAL's box_self_intersection_d and box_intersection_d, sequential. CGAL's package is under the GPL: what
/// is linked with this file is, too.
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>

#include "bench/one_shot/searcher.h"

namespace cellsweep::bench {
namespace {

/// CGAL sorts these.
struct Entry {
  Aabb box;
  std::uint32_t place = 0;
  std::uint32_t number = 0;  ///< different for all boxes of both sets
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
  static std::size_t id(const Entry& entry) { return entry.number; }
};

class CgalSearcher final : public Searcher {
 public:
  void find(const BoxSets& sets) override {
    constexpr std::ptrdiff_t kCutoff = 10;  // CGAL's default
    std::vector<Entry> a = entries_of(sets.a, 0);
    pairs_.clear();
    if (sets.b.empty()) {
      CGAL::box_self_intersection_d(
          a.begin(), a.end(),
          [this](const Entry& one, const Entry& other) {
            pairs_.push_back({std::min(one.place, other.place), std::max(one.place, other.place)});
          },
          EntryTraits(), kCutoff, CGAL::Box_intersection_d::CLOSED);
      return;
    }
    std::vector<Entry> b = entries_of(sets.b, sets.a.size());
    CGAL::box_intersection_d(
        a.begin(), a.end(), b.begin(), b.end(),
        [this](const Entry& one, const Entry& other) {
          pairs_.push_back({one.place, other.place});
        },
        EntryTraits(), kCutoff, CGAL::Box_intersection_d::CLOSED);
  }
  void list(std::vector<CrossPair>& pairs) const override { pairs = pairs_; }
  std::size_t count() const override { return pairs_.size(); }

 private:
  static std::vector<Entry> entries_of(const std::vector<Aabb>& boxes, std::size_t before) {
    std::vector<Entry> entries(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
      entries[i] = {boxes[i], static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(before + i)};
    return entries;
  }

  std::vector<CrossPair> pairs_;
};

constexpr std::array<SearcherInfo, 1> kCgal = {SearcherInfo{
    "cgal", true, true, []() -> std::unique_ptr<Searcher> { return std::make_unique<CgalSearcher>(); }}};

}  // namespace

std::span<const SearcherInfo> cgal_searchers() {
  return kCgal;
}

}  // namespace cellsweep::bench
