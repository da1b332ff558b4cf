#include <algorithm>
#include <array>

#include "bench/one_shot/searcher.h"

namespace cellsweep::bench {
namespace {

/// find_pairs() into a vector.
template <unsigned kThreads>
class OwnSearcher final : public Searcher {
 public:
  void find(const BoxSets& sets) override {
    const FindPairsOptions options{.threads = kThreads};
    if (sets.b.empty()) {
      pairs_ = *find_pairs(sets.a, options);
    } else {
      cross_ = *find_pairs(sets.a, sets.b, options);
    }
  }
  void list(std::vector<CrossPair>& pairs) const override {
    pairs = cross_;
    for (const Pair& pair : pairs_) pairs.push_back({pair.a, pair.b});
  }
  std::size_t count() const override { return pairs_.size() + cross_.size(); }

 private:
  std::vector<Pair> pairs_;
  std::vector<CrossPair> cross_;
};

/// count_pairs().
class OwnCounter final : public Searcher {
 public:
  void find(const BoxSets& sets) override {
    const FindPairsOptions options{.threads = 1};
    count_ = sets.b.empty() ? *count_pairs(sets.a, options) : *count_pairs(sets.a, sets.b, options);
  }
  void list(std::vector<CrossPair>&) const override {}
  std::size_t count() const override { return count_; }

 private:
  std::size_t count_ = 0;
};

/// All pairs of both sets together, of which those within a set are left out: the way of who has no search
/// between two sets.
class UnionSearcher final : public Searcher {
 public:
  void find(const BoxSets& sets) override {
    both_ = sets.a;
    both_.insert(both_.end(), sets.b.begin(), sets.b.end());
    const auto first = static_cast<std::uint32_t>(sets.a.size());
    cross_.clear();
    const auto pairs = find_pairs(both_, {.threads = 1});
    for (const Pair& pair : *pairs) {
      if (pair.a < first && pair.b >= first) cross_.push_back({pair.a, pair.b - first});
    }
  }
  void list(std::vector<CrossPair>& pairs) const override { pairs = cross_; }
  std::size_t count() const override { return cross_.size(); }

 private:
  std::vector<Aabb> both_;
  std::vector<CrossPair> cross_;
};

template <class Made>
std::unique_ptr<Searcher> make() {
  return std::make_unique<Made>();
}

constexpr std::array<SearcherInfo, 4> kOwn = {
    SearcherInfo{"cellsweep", true, true, make<OwnSearcher<1>>},
    SearcherInfo{"cellsweep_all_threads", true, true, make<OwnSearcher<0>>},
    SearcherInfo{"cellsweep_count", true, false, make<OwnCounter>},
    SearcherInfo{"union", false, true, make<UnionSearcher>}};

}  // namespace

std::span<const SearcherInfo> own_searchers() {
  return kOwn;
}

}  // namespace cellsweep::bench
