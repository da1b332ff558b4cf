#include "ranks/owned_pairs.h"

#include <algorithm>

namespace cellsweep::ranks {
namespace {

bool were_pair(const Version& one, const Version& other) {
  return one.exists && other.exists && overlap(one.box, other.box) &&
         may_pair(BodyFilter(one.filter), BodyFilter(other.filter));
}

bool owns(const Region& region, const Version& one, const Version& other) {
  return holds(region, lower_corner(one.box, other.box));
}

}  // namespace

template <class IsMine>
void OwnedPairs::list(std::span<const Pair> engine, const IsMine& is_mine,
                      std::vector<GlobalPair>& pairs) const {
  pairs.clear();
  pairs.reserve(engine.size());
  for (const auto& [a, b] : engine) {
    if ((held_.flags(a) & held_.flags(b) & kLinked) != 0 && !is_mine(held_.link(a), held_.link(b))) continue;
    const GlobalId one = held_.id(a);
    const GlobalId other = held_.id(b);
    pairs.push_back({std::min(one, other), std::max(one, other)});
  }
  std::ranges::sort(pairs);
}

void OwnedPairs::list_began(std::span<const Pair> engine, const Cuts& cuts,
                            std::vector<GlobalPair>& began) const {
  const Region& region = cuts.region(rank_);
  list(
      engine,
      [&](const Link& a, const Link& b) {
        return owns(region, a.now, b.now) && (a.renewed || b.renewed || !were_pair(a.before, b.before));
      },
      began);
}

void OwnedPairs::list_ended(std::span<const Pair> engine, const Cuts& before,
                            std::vector<GlobalPair>& ended) const {
  const Region& region = before.region(rank_);
  list(
      engine,
      [&](const Link& a, const Link& b) {
        return owns(region, a.before, b.before) && (a.renewed || b.renewed || !were_pair(a.now, b.now));
      },
      ended);
}

void OwnedPairs::list_all(std::span<const Pair> engine, const Cuts& before,
                          std::vector<GlobalPair>& pairs) const {
  const Region& region = before.region(rank_);
  list(
      engine, [&](const Link& a, const Link& b) { return owns(region, a.before, b.before); }, pairs);
}

}  // namespace cellsweep::ranks
