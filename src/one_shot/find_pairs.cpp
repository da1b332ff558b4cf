#include "cellsweep/find_pairs.h"

#include <array>
#include <utility>

#include "base/float_environment.h"
#include "base/pairs/pair_of.h"
#include "base/sorting/pair_sort.h"
#include "base/threads/make_crew.h"
#include "base/tuning.h"
#include "engines/stream/common_options.h"
#include "engines/stream/kernels/kernel.h"
#include "one_shot/apart.h"
#include "one_shot/box_set.h"
#include "one_shot/exact.h"
#include "one_shot/outlet.h"
#include "one_shot/pair_search.h"

namespace cellsweep::one_shot {
namespace {

using Outlets = std::vector<std::unique_ptr<Outlet>>;

/// One call of a public function.
class Call {
 public:
  explicit Call(const FindPairsOptions& options)
      : options_(options), kernels_(stream::find_kernels(options.isa)) {}

  /// Checks and reads everything.
  Status begin(Sets sets) {
    if (options_.threads > stream::kMostThreads) return stream::too_many_threads(options_.threads);
    if (kernels_ == nullptr) return stream::no_such_isa(options_.isa);
    Status status = check_sets(sets);
    if (!status.ok()) return status;
    const bool is_double = sets[0].is_double();
    status = is_double ? read_doubles(sets, exact_) : read_floats(sets, boxes_);
    if (!status.ok()) return status;
    found_.boxes = &boxes_;
    if (options_.max_pairs != 0) found_.most_pairs = options_.max_pairs;
    if (is_double) {
      found_.exact = exact_.data();
      found_.most_candidates = tuning::kCandidatesOfRounded * exact_.size() + tuning::kFewOfRounded;
      boxes_.second_place = static_cast<std::uint32_t>(sets[0].size());
      boxes_.are_two = sets.size() == 2;
      make_rounded(exact_.view(), boxes_.own);
      search_own();
    }
    crew_ = make_crew(options_.executor, options_.threads);
    return {};
  }

  /// `find(search)` finds all pairs. It is called once more when rounded boxes have too many candidates.
  template <class Find>
  Status search(const Find& find) {
    try {
      try {
        search_once(find);
      } catch (const TooManyCandidates&) {
        make_ranked(exact_.view(), boxes_.own);
        search_own();
        found_.most_candidates = ~std::uint64_t{0};
        found_.pairs = found_.candidates = 0;
        search_once(find);
      }
    } catch (const stream::TooManyPairs&) {
      return stream::too_many_pairs(options_.max_pairs);
    }
    return {};
  }

  Crew& crew() { return *crew_; }
  Found& found() { return found_; }

  /// One for each worker.
  template <class AnyOutlet>
  Outlets make_outlets() {
    Outlets outlets;
    for (unsigned worker = 0; worker < crew_->active(); ++worker)
      outlets.push_back(std::make_unique<AnyOutlet>(found_));
    return outlets;
  }

 private:
  void search_own() {
    boxes_.boxes = std::as_const(boxes_.own).view();
    boxes_.second = boxes_.second_place;
    boxes_.places = {};
  }

  template <class Find>
  void search_once(const Find& find) {
    if (boxes_.are_two) leave_out_apart(boxes_);
    PairSearch search(*crew_, *kernels_, boxes_);
    find(search);
  }

  const FindPairsOptions& options_;
  const stream::Kernels* kernels_;
  Array<ExactBox> exact_;
  SearchedBoxes boxes_;
  Found found_;
  std::shared_ptr<Crew> crew_;
};

template <class AnyPair>
Result<std::vector<AnyPair>> list(Sets sets, const FindPairsOptions& options) {
  const DefaultFloats floats;
  Call call(options);
  if (Status status = call.begin(sets); !status.ok()) return status;
  Array<Pair> sorted;
  Status status = call.search([&](PairSearch& search) {
    const Outlets outlets = call.make_outlets<ListOutlet>();
    search.find(outlets);
    std::vector<std::span<const std::uint64_t>> parts;
    for (const auto& outlet : outlets) parts.push_back(static_cast<const ListOutlet&>(*outlet).view());
    Array<std::uint64_t> scratch;
    sort_pairs(call.crew(), parts, scratch, sorted);
  });
  if (!status.ok()) return status;
  std::vector<AnyPair> pairs;
  pairs.reserve(sorted.size());
  for (const Pair& pair : sorted.view()) pairs.push_back({pair.a, pair.b});
  return pairs;
}

Result<std::uint64_t> count(Sets sets, const FindPairsOptions& options) {
  const DefaultFloats floats;
  Call call(options);
  if (Status status = call.begin(sets); !status.ok()) return status;
  Status status = call.search([&](PairSearch& search) { search.find(call.make_outlets<CountOutlet>()); });
  if (!status.ok()) return status;
  return call.found().pairs.load();
}

/// Shows them to a visitor.
template <class AnyPair>
class VisitOutlet final : public Outlet {
 public:
  VisitOutlet(Found& found, FunctionRef<bool(AnyPair)> visit) : Outlet(found), visit_(visit) {}

 protected:
  void take(std::span<const std::uint64_t> place_keys) override {
    for (const std::uint64_t key : place_keys) {
      if (!visit_(pair_of<AnyPair>(key))) throw SeenEnough();
    }
  }

 private:
  FunctionRef<bool(AnyPair)> visit_;
};

template <class AnyPair>
Status visit(Sets sets, FunctionRef<bool(AnyPair)> visitor, const FindPairsOptions& options) {
  const DefaultFloats floats;
  Call call(options);
  if (Status status = call.begin(sets); !status.ok()) return status;
  Found& found = call.found();
  const std::uint64_t most_pairs = found.most_pairs;
  try {
    return call.search([&](PairSearch& search) {
      // What a visitor has seen cannot be found anew: whether there are too many candidates is asked before.
      if (found.exact != nullptr && found.most_candidates != ~std::uint64_t{0}) {
        found.most_pairs = ~std::uint64_t{0};
        search.find(call.make_outlets<CountOutlet>());
      }
      found.most_pairs = most_pairs;
      found.pairs = found.candidates = 0;
      VisitOutlet<AnyPair> outlet(found, visitor);
      search.find(outlet);
    });
  } catch (const SeenEnough&) {
    return {};
  }
}

}  // namespace
}  // namespace cellsweep::one_shot

namespace cellsweep {

Result<std::vector<Pair>> find_pairs(const BoxView& boxes, const FindPairsOptions& options) {
  return one_shot::list<Pair>({&boxes, 1}, options);
}

Result<std::vector<CrossPair>> find_pairs(const BoxView& a, const BoxView& b,
                                          const FindPairsOptions& options) {
  return one_shot::list<CrossPair>(std::array{a, b}, options);
}

Result<std::uint64_t> count_pairs(const BoxView& boxes, const FindPairsOptions& options) {
  return one_shot::count({&boxes, 1}, options);
}

Result<std::uint64_t> count_pairs(const BoxView& a, const BoxView& b, const FindPairsOptions& options) {
  return one_shot::count(std::array{a, b}, options);
}

Status visit_pairs(const BoxView& boxes, FunctionRef<bool(Pair)> visit, const FindPairsOptions& options) {
  return one_shot::visit<Pair>({&boxes, 1}, visit, options);
}

Status visit_pairs(const BoxView& a, const BoxView& b, FunctionRef<bool(CrossPair)> visit,
                   const FindPairsOptions& options) {
  return one_shot::visit<CrossPair>(std::array{a, b}, visit, options);
}

}  // namespace cellsweep
