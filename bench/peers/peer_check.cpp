#include "bench/peers/peer_check.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "bench/peers/grid_oracle.h"
#include "report/oracle.h"

namespace cellsweep::bench {
namespace {

// Beyond that, comparing all with all takes longer than the row.
constexpr std::size_t kMostByBruteForce = 10'000;

std::vector<Pair> true_pairs(std::span<const Aabb> boxes) {
  return boxes.size() <= kMostByBruteForce ? report::oracle_pairs(boxes) : grid_pairs(boxes);
}

// Pairs of the first sorted list that the second has not.
std::size_t only_in_first(const std::vector<Pair>& first, const std::vector<Pair>& second) {
  std::vector<Pair> rest;
  std::set_difference(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(rest));
  return rest.size();
}

}  // namespace

std::string describe(const Mismatch& mismatch) {
  return std::to_string(mismatch.missing) + " pairs missing, " + std::to_string(mismatch.extra) + " too many";
}

Mismatch compare_with_oracle(std::span<const Aabb> boxes, std::vector<Pair> pairs) {
  std::vector<Pair> expected = true_pairs(boxes);
  std::sort(expected.begin(), expected.end());
  std::sort(pairs.begin(), pairs.end());
  return {only_in_first(expected, pairs), only_in_first(pairs, expected)};
}

Mismatch check_peer(const PeerInfo& info, const PeerSetting& setting, std::size_t frames) {
  PeerRun run(info, setting);
  Mismatch sum;
  for (std::size_t frame = 0; frame < frames; ++frame) {
    run.next_frame();
    const Mismatch mismatch = compare_with_oracle(run.boxes(), run.pairs());
    sum.missing += mismatch.missing;
    sum.extra += mismatch.extra;
  }
  return sum;
}

PairSum oracle_sum(const PeerSetting& setting, std::size_t frame, std::span<const Aabb> boxes) {
  static std::map<std::tuple<std::string, std::size_t, double, std::size_t>, PairSum> known;
  // Where nothing moves, all frames are one.
  const double moving = info_of(setting.mode).moving;
  const auto [entry, is_new] =
      known.try_emplace({setting.scene, setting.bodies, moving, moving == 0 ? 0 : frame});
  if (is_new) {
    const std::vector<Pair> pairs = true_pairs(boxes);
    entry->second = {pairs.size(), pair_set_hash(pairs)};
  }
  return entry->second;
}

}  // namespace cellsweep::bench
