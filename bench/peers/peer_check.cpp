#include "bench/peers/peer_check.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "bench/peers/grid_oracle.h"
#include "report/oracle.h"

namespace cellsweep::bench {
namespace {

// Beyond that, comparing all with all takes longer than the row.
constexpr std::size_t kMostByBruteForce = 10'000;

// By cells, of the bodies that are there.
std::vector<Pair> grid_pairs_of(const PeerRun& run) {
  std::vector<Aabb> boxes;
  for (const BodyId id : run.bodies()) boxes.push_back(run.boxes()[id]);
  std::vector<Pair> pairs = grid_pairs(boxes);
  for (Pair& pair : pairs) pair = {run.bodies()[pair.a], run.bodies()[pair.b]};
  return pairs;
}

std::vector<Pair> true_pairs(const PeerRun& run) {
  const bool by_brute_force = run.bodies().size() <= kMostByBruteForce;
  return by_brute_force ? report::oracle_pairs(run.bodies(), run.boxes()) : grid_pairs_of(run);
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

Mismatch compare_with_oracle(const PeerRun& run) {
  std::vector<Pair> expected = true_pairs(run);
  std::vector<Pair> pairs = run.pairs();
  std::sort(expected.begin(), expected.end());
  std::sort(pairs.begin(), pairs.end());
  return {only_in_first(expected, pairs), only_in_first(pairs, expected)};
}

Mismatch check_peer(const PeerInfo& info, const PeerSetting& setting, std::size_t frames) {
  PeerRun run(info, setting);
  Mismatch sum;
  for (std::size_t frame = 0; frame < frames; ++frame) {
    run.next_frame();
    const Mismatch mismatch = compare_with_oracle(run);
    sum.missing += mismatch.missing;
    sum.extra += mismatch.extra;
  }
  return sum;
}

PairSum oracle_sum(const PeerSetting& setting, const PeerRun& run) {
  using Key =
      std::tuple<std::string, std::size_t, std::optional<double>, GiantSlot, std::uint64_t, std::size_t>;
  static std::map<Key, PairSum> known;
  const SceneSettings scene = scene_of(setting, run.key().seed);
  const auto [entry, is_new] =
      known.try_emplace({scene.scene, scene.bodies, scene.moving, scene.giant, scene.seed, run.key().frame});
  if (is_new) {
    const std::vector<Pair> pairs = true_pairs(run);
    entry->second = {pairs.size(), pair_set_hash(pairs)};
  }
  return entry->second;
}

}  // namespace cellsweep::bench
