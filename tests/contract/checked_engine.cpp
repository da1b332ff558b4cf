#include "contract/checked_engine.h"

#include <algorithm>
#include <iterator>
#include <new>
#include <utility>

#include "base/text.h"
#include "contract/box_kinds.h"
#include "engines/oracle/brute_force.h"

namespace cellsweep::contract {
namespace {

using testing::AssertionFailure;
using testing::AssertionResult;
using testing::AssertionSuccess;

std::vector<Pair> copy(std::span<const Pair> pairs) {
  return {pairs.begin(), pairs.end()};
}

/// Arguments of a call, overwritten afterwards, so that a broadphase that keeps hold of them is found out.
struct Arguments {
  std::vector<BodyId> ids;
  std::vector<Aabb> boxes;
  std::vector<BodyFilter> filters{};

  ~Arguments() {
    std::ranges::fill(ids, 0xdeadbeefU);
    std::ranges::fill(filters, BodyFilter{0, 0, true});
    std::ranges::fill(boxes, Aabb{{-1, -1, -1}, {-1, -1, -1}});
  }
};

}  // namespace

std::vector<BodyId> Model::ids() const {
  std::vector<BodyId> all;
  for (const auto& [id, box] : boxes) all.push_back(id);
  return all;
}

std::vector<Pair> Model::brute_force() const {
  std::vector<Aabb> all_boxes;
  for (const auto& [id, box] : boxes) all_boxes.push_back(box);
  std::vector<Pair> found = brute_force_pairs(ids(), all_boxes);
  if (filters.empty()) return found;
  std::erase_if(found, [&](const Pair& pair) { return !may_pair(filter(pair.a), filter(pair.b)); });
  return found;
}

BodyFilter Model::filter(BodyId id) const {
  const auto found = filters.find(id);
  return found == filters.end() ? BodyFilter{} : found->second;
}

void Model::remove(BodyId id) {
  boxes.erase(id);
  filters.erase(id);
  gone.insert(id);
}

// A body that came back under its id is another one: its pairs end, whether or not they begin again.
Answer Model::update() {
  Answer answer{.pairs = brute_force(), .began = {}, .ended = {}};
  std::vector<Pair> kept;
  std::ranges::set_intersection(pairs, answer.pairs, std::back_inserter(kept));
  std::erase_if(kept, [&](const Pair& pair) { return gone.contains(pair.a) || gone.contains(pair.b); });
  std::ranges::set_difference(answer.pairs, kept, std::back_inserter(answer.began));
  std::ranges::set_difference(pairs, kept, std::back_inserter(answer.ended));
  pairs = answer.pairs;
  shown = boxes;
  gone.clear();
  return answer;
}

bool Model::is_in_pairs(BodyId id) const {
  return gone.contains(id) &&
         std::ranges::any_of(pairs, [&](const Pair& pair) { return pair.a == id || pair.b == id; });
}

CheckedEngine::CheckedEngine(const ContractEngine& engine, std::string story)
    : CheckedEngine(make(engine), engine.label + ", " + story) {}

CheckedEngine::CheckedEngine(Broadphase engine, std::string story)
    : engine_(std::move(engine)), story_(std::move(story)) {}

namespace {

/// Whether a call says by what it returns that it was not made.
template <class Returned>
bool was_refused(const Returned& returned) {
  if constexpr (requires { returned.ok(); }) return !returned.ok();
  return false;
}

}  // namespace

// One call, or two when the first did not get what it needed.
template <class Call>
auto CheckedEngine::call_engine(Call call) -> decltype(call()) {
  if (!around_) return call();
  try {
    around_(true);
    auto result = call();
    around_(false);
    if (!was_refused(result)) return result;
  } catch (const std::bad_alloc&) {
    around_(false);
  }
  ++failures_;
  const std::function<void(bool)> around = std::exchange(around_, nullptr);
  EXPECT_TRUE(state_is_kept());
  around_ = around;
  return call();
}

// As a user would make it: one body by the single call, several by the bulk call.
AssertionResult CheckedEngine::insert(const std::vector<BodyId>& ids, const std::vector<Aabb>& boxes) {
  const Arguments with{ids, boxes};
  const Status status = call_engine([&] {
    return ids.size() == 1 ? engine_.insert(with.ids[0], with.boxes[0])
                           : engine_.insert(with.ids, with.boxes);
  });
  count_bodies(ids.size());
  ids_are_slots_ = ids_are_slots_ && ids.empty();
  for (std::size_t i = 0; i < ids.size(); ++i) model_.boxes.emplace(ids[i], canonical_box(boxes[i]));
  return accepted("insert", status);
}

AssertionResult CheckedEngine::insert(const std::vector<BodyId>& ids, const std::vector<Aabb>& boxes,
                                      const std::vector<BodyFilter>& filters) {
  const Arguments with{ids, boxes, filters};
  const Status status = call_engine([&] { return engine_.insert(with.ids, with.boxes, with.filters); });
  count_bodies(ids.size());
  ids_are_slots_ = ids_are_slots_ && ids.empty();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    model_.boxes.emplace(ids[i], canonical_box(boxes[i]));
    model_.filters[ids[i]] = filters[i];
  }
  return accepted("insert with filters", status);
}

// A changed filter takes a slot until the next update, as a body that is removed does.
AssertionResult CheckedEngine::set_filters(const std::vector<BodyId>& ids,
                                           const std::vector<BodyFilter>& filters) {
  const Arguments with{ids, {}, filters};
  const Status status = call_engine([&] {
    return ids.size() == 1 ? engine_.set_filter(with.ids[0], with.filters[0])
                           : engine_.set_filters(with.ids, with.filters);
  });
  for (std::size_t i = 0; i < ids.size(); ++i) model_.filters[ids[i]] = filters[i];
  removed_ += ids.size();
  count_bodies(0);
  ids_are_slots_ = ids_are_slots_ && ids.empty();
  return accepted("set_filters", status);
}

AssertionResult CheckedEngine::add(const std::vector<Aabb>& boxes, std::vector<BodyId>& ids) {
  const Arguments with{{}, boxes};
  ids.assign(boxes.size(), 0xdeadbeefU);
  const Status status = call_engine([&] {
    if (boxes.size() != 1) return engine_.add(with.boxes, ids);
    const Result<BodyId> id = engine_.add(with.boxes[0]);
    if (id) ids[0] = *id;
    return id.status();
  });
  if (!status.ok()) return accepted("add", status);
  count_bodies(ids.size());
  if (AssertionResult right = ids_are_right(ids); !right) return right;
  for (std::size_t i = 0; i < ids.size(); ++i) model_.boxes.emplace(ids[i], canonical_box(boxes[i]));
  return accepted("add", status);
}

AssertionResult CheckedEngine::move(const std::vector<BodyId>& ids, const std::vector<Aabb>& boxes) {
  const Arguments with{ids, boxes};
  const Status status = call_engine([&] {
    return ids.size() == 1 ? engine_.move(with.ids[0], with.boxes[0]) : engine_.move(with.ids, with.boxes);
  });
  for (std::size_t i = 0; i < ids.size(); ++i) model_.boxes.at(ids[i]) = canonical_box(boxes[i]);
  return accepted("move", status);
}

AssertionResult CheckedEngine::remove(const std::vector<BodyId>& ids) {
  const Arguments with{ids, {}};
  const Status status =
      call_engine([&] { return ids.size() == 1 ? engine_.remove(with.ids[0]) : engine_.remove(with.ids); });
  for (const BodyId id : ids) model_.remove(id);
  removed_ += ids.size();
  return accepted("remove", status);
}

AssertionResult CheckedEngine::update() {
  if (AssertionResult kept = state_is_kept(); !kept) return kept;
  handed_.reset();
  handed_pairs_.reset();
  const Result<PairChanges> result = call_engine([&] { return engine_.update(); });
  ++updates_;
  if (!result) return accepted("update", result.status());

  const Answer expected = model_.update();
  removed_ = 0;
  handed_ = *result;
  answer_ = {expected.pairs, copy(handed_->began), copy(handed_->ended)};
  if (looks_) {
    handed_pairs_ = call_engine([&] { return engine_.pairs(); });
    answer_.pairs = copy(*handed_pairs_);
  }
  if (engine_.statistics().updates != updates_) {
    return failure() << "statistics count " << engine_.statistics().updates << " updates";
  }
  const AssertionResult right = answer_is(expected);
  return right ? state_is_kept() : right;
}

AssertionResult CheckedEngine::refuse(const std::function<Status(Broadphase&)>& call, Status& status) {
  status = call(engine_);
  if (status.ok()) return failure() << "the call was accepted";
  return state_is_kept();
}

AssertionResult CheckedEngine::refuse_update(Status& status) {
  if (AssertionResult kept = state_is_kept(); !kept) return kept;
  handed_.reset();
  handed_pairs_.reset();
  status = engine_.update().status();
  if (status.ok()) return failure() << "the update was not refused";
  if (engine_.statistics().updates != updates_) return failure() << "an update that failed was counted";
  return state_is_kept();
}

AssertionResult CheckedEngine::failure() const {
  return AssertionFailure() << story_ << ", after " << updates_ << " updates: ";
}

AssertionResult CheckedEngine::accepted(const char* call, const Status& status) {
  if (!status.ok()) return failure() << call << " was refused: " << status.message;
  return state_is_kept();
}

AssertionResult CheckedEngine::state_is_kept() {
  bool kept = true;
  if (handed_) {
    kept = std::ranges::equal(handed_->began, answer_.began) &&
           std::ranges::equal(handed_->ended, answer_.ended);
  }
  if (handed_pairs_) kept = kept && std::ranges::equal(*handed_pairs_, model_.pairs);
  if (looks_) {
    kept = kept && std::ranges::equal(call_engine([&] { return engine_.pairs(); }), model_.pairs);
  }
  if (!kept) return failure() << "what the last update gave has changed before the next one";
  if (AssertionResult bodies = bodies_are_kept(); !bodies) return bodies;
  return boxes_are_kept();
}

AssertionResult CheckedEngine::bodies_are_kept() const {
  if (engine_.size() != model_.boxes.size()) {
    return failure() << "size() is " << engine_.size() << " with " << model_.boxes.size() << " bodies held";
  }
  for (const auto& [id, box] : model_.boxes) {
    if (!engine_.contains(id)) return failure() << "contains() does not know body " << id;
  }
  for (const auto& [id, box] : model_.shown) {
    if (engine_.contains(id) != model_.boxes.contains(id)) {
      return failure() << "contains() says that body " << id << " is held, which was removed";
    }
  }
  return AssertionSuccess();
}

AssertionResult CheckedEngine::boxes_are_kept() {
  std::vector<BodyId> ids;
  std::vector<Aabb> expected;
  for (const auto& [id, box] : model_.shown) {
    ids.push_back(id);
    expected.push_back(box);
  }
  std::vector<Aabb> boxes(ids.size());
  const Status status = call_engine([&] { return engine_.boxes(ids, boxes); });
  if (!status.ok()) return failure() << "boxes() was refused: " << status.message;
  const auto [given, wanted] = std::ranges::mismatch(boxes, expected);
  if (given == boxes.end()) return AssertionSuccess();
  return failure() << "boxes() gives for body " << ids[static_cast<std::size_t>(given - boxes.begin())] << " "
                   << box_text(*given) << " instead of " << box_text(*wanted);
}

// Small: below the most bodies that there were at a time, those that have gone since the last update among
// them; twice that where the caller chose ids or changed filters, too.
AssertionResult CheckedEngine::ids_are_right(const std::vector<BodyId>& ids) const {
  std::vector<BodyId> sorted = ids;
  std::ranges::sort(sorted);
  if (std::ranges::adjacent_find(sorted) != sorted.end()) return failure() << "add() gives an id twice";
  const std::size_t bound = ids_are_slots_ ? most_bodies_ : 2 * most_bodies_;
  for (const BodyId id : sorted) {
    if (model_.boxes.contains(id)) return failure() << "add() gives body " << id << ", which is held";
    if (model_.is_in_pairs(id)) return failure() << "add() gives " << id << " before its pairs have ended";
    if (id >= bound)
      return failure() << "add() gives " << id << ", and there were " << most_bodies_ << " bodies";
  }
  return AssertionSuccess();
}

// `more` are about to come.
void CheckedEngine::count_bodies(std::size_t more) {
  most_bodies_ = std::max(most_bodies_, model_.boxes.size() + removed_ + more);
}

AssertionResult CheckedEngine::answer_is(const Answer& expected) const {
  if (AssertionResult right = same("began", answer_.began, expected.began); !right) return right;
  if (AssertionResult right = same("ended", answer_.ended, expected.ended); !right) return right;
  if (AssertionResult right = same("pairs()", answer_.pairs, expected.pairs); !right) return right;
  if (pair_set_hash(answer_.pairs) != pair_set_hash(expected.pairs)) {
    return failure() << "equal pair sets have different hashes";
  }
  return AssertionSuccess();
}

/// Compares lists that must be ascending; a repeated pair or a wrong order differs from the model's list too.
AssertionResult CheckedEngine::same(const char* what, const std::vector<Pair>& given,
                                    const std::vector<Pair>& expected) const {
  if (given == expected) return AssertionSuccess();
  AssertionResult result = failure() << what << " lists " << given.size() << " pairs, the oracle "
                                     << expected.size();
  const auto [in_given, in_expected] = std::ranges::mismatch(given, expected);
  if (in_expected != expected.end() && (in_given == given.end() || *in_expected < *in_given)) {
    return result << "; first difference: the oracle alone has " << describe(*in_expected);
  }
  const bool repeated = in_given != given.begin() && *in_given <= *std::prev(in_given);
  return result << "; first difference: the engine " << (repeated ? "repeats or misplaces " : "alone has ")
                << describe(*in_given);
}

std::string CheckedEngine::describe(const Pair& pair) const {
  const auto body = [&](BodyId id) {
    const auto found = model_.boxes.find(id);
    return text("\n  body ", id, ": ", found == model_.boxes.end() ? "removed" : box_text(found->second));
  };
  return text("(", pair.a, ", ", pair.b, ")", body(pair.a), body(pair.b));
}

}  // namespace cellsweep::contract
