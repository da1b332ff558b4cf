#include "contract/checked_engine.h"

#include <algorithm>
#include <iterator>
#include <span>
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

std::vector<Pair> without(const std::vector<Pair>& pairs, const std::vector<Pair>& others) {
  std::vector<Pair> rest;
  std::ranges::set_difference(pairs, others, std::back_inserter(rest));
  return rest;
}

/// The call as a user would make it: one body by the single call, several by the bulk call. The arguments are
/// copies that are overwritten afterwards, so that an engine that keeps hold of them is found out.
template <class One, class Bulk>
Status call_with_boxes(std::vector<BodyId> ids, std::vector<Aabb> boxes, One one, Bulk bulk) {
  const Status status = ids.size() == 1 ? one(ids[0], boxes[0]) : bulk(ids, boxes);
  std::ranges::fill(ids, 0xdeadbeefU);
  std::ranges::fill(boxes, Aabb{{-1, -1, -1}, {-1, -1, -1}});
  return status;
}

}  // namespace

std::vector<BodyId> Model::ids() const {
  std::vector<BodyId> all;
  for (const auto& [id, box] : boxes) all.push_back(id);
  return all;
}

std::vector<Pair> Model::brute_force() const {
  std::vector<Aabb> all_boxes;
  for (const auto& [id, box] : boxes) all_boxes.push_back(box);
  return brute_force_pairs(ids(), all_boxes);
}

CheckedEngine::CheckedEngine(const ContractEngine& engine, std::string story)
    : engine_(make(engine)), story_(engine.label + ", " + std::move(story)) {}

AssertionResult CheckedEngine::insert(const std::vector<BodyId>& ids, const std::vector<Aabb>& boxes) {
  const Status status = call_with_boxes(
      ids, boxes, [&](BodyId id, const Aabb& box) { return engine_->insert(id, box); },
      [&](std::span<const BodyId> all, std::span<const Aabb> with) { return engine_->insert(all, with); });
  for (std::size_t i = 0; i < ids.size(); ++i) model_.boxes.emplace(ids[i], canonical_box(boxes[i]));
  return accepted("insert", status);
}

AssertionResult CheckedEngine::move(const std::vector<BodyId>& ids, const std::vector<Aabb>& boxes) {
  const Status status = call_with_boxes(
      ids, boxes, [&](BodyId id, const Aabb& box) { return engine_->move(id, box); },
      [&](std::span<const BodyId> all, std::span<const Aabb> to) { return engine_->move(all, to); });
  for (std::size_t i = 0; i < ids.size(); ++i) model_.boxes.at(ids[i]) = canonical_box(boxes[i]);
  return accepted("move", status);
}

AssertionResult CheckedEngine::remove(const std::vector<BodyId>& ids) {
  std::vector<BodyId> passed = ids;
  const Status status = passed.size() == 1 ? engine_->remove(passed[0]) : engine_->remove(passed);
  std::ranges::fill(passed, 0xdeadbeefU);
  for (const BodyId id : ids) model_.boxes.erase(id);
  return accepted("remove", status);
}

AssertionResult CheckedEngine::update() {
  if (AssertionResult kept = state_is_kept(); !kept) return kept;
  const Result<PairChanges> result = engine_->update();
  ++updates_;
  if (!result) return accepted("update", result.status());

  Answer expected{.pairs = model_.brute_force(), .began = {}, .ended = {}};
  expected.began = without(expected.pairs, model_.pairs);
  expected.ended = without(model_.pairs, expected.pairs);
  model_.pairs = expected.pairs;
  handed_ = *result;
  answer_ = {copy(engine_->pairs()), copy(handed_.began), copy(handed_.ended)};

  if (AssertionResult right = changes_are_right(expected); !right) return right;
  if (engine_->statistics().updates != updates_) {
    return failure() << "statistics count " << engine_->statistics().updates << " updates";
  }
  return pairs_are_right(expected.pairs);
}

AssertionResult CheckedEngine::refuse(const std::function<Status(Broadphase&)>& call, Status& status) {
  status = call(*engine_);
  if (status.ok()) return failure() << "the engine accepted the call";
  return state_is_kept();
}

AssertionResult CheckedEngine::failure() const {
  return AssertionFailure() << story_ << ", after " << updates_ << " updates: ";
}

AssertionResult CheckedEngine::accepted(const char* call, const Status& status) const {
  if (!status.ok()) return failure() << call << " was refused: " << status.message;
  return state_is_kept();
}

AssertionResult CheckedEngine::state_is_kept() const {
  if (engine_->size() != model_.boxes.size()) {
    return failure() << "size() is " << engine_->size() << " with " << model_.boxes.size() << " bodies held";
  }
  const bool kept = std::ranges::equal(engine_->pairs(), answer_.pairs) &&
                    std::ranges::equal(handed_.began, answer_.began) &&
                    std::ranges::equal(handed_.ended, answer_.ended);
  if (!kept) return failure() << "what the last update gave has changed before the next one";
  return AssertionSuccess();
}

AssertionResult CheckedEngine::changes_are_right(const Answer& expected) const {
  if (AssertionResult right = same("began", answer_.began, expected.began); !right) return right;
  return same("ended", answer_.ended, expected.ended);
}

AssertionResult CheckedEngine::pairs_are_right(const std::vector<Pair>& expected) const {
  std::vector<Pair> sorted = answer_.pairs;
  std::ranges::sort(sorted);
  if (AssertionResult right = same("pairs()", sorted, expected); !right) return right;
  if (pair_set_hash(answer_.pairs) != pair_set_hash(expected)) {
    return failure() << "equal pair sets have different hashes";
  }
  return AssertionSuccess();
}

/// Compares lists that should be ascending; a repeated pair or a wrong order differs from the model's list
/// too.
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
