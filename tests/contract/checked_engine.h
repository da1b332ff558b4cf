/// @file
/// An engine with the truth beside it: every call goes to both, and every answer is compared.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "cellsweep/broadphase.h"
#include "contract/contract_engines.h"

namespace cellsweep::contract {

/// What an engine should know: its bodies with canonical boxes, and its pairs as of the last update,
/// ascending.
struct Model {
  std::map<BodyId, Aabb> boxes;
  std::vector<Pair> pairs;

  /// All ids, ascending.
  std::vector<BodyId> ids() const;

  /// The pairs that brute force finds among the boxes now, ascending.
  std::vector<Pair> brute_force() const;
};

/// The parts of one update's answer, copied in the order in which the engine gave them.
struct Answer {
  std::vector<Pair> pairs;
  std::vector<Pair> began;
  std::vector<Pair> ended;

  friend bool operator==(const Answer&, const Answer&) = default;
};

/// Drives one engine. insert(), move(), remove() and update() expect the engine to accept, compare its answer
/// with the model, and check that what it handed out earlier is still there as long as the contract promises.
/// The results carry the engine, the story and the step, so that a failure can be found again from its
/// message.
class CheckedEngine {
 public:
  /// `story` says what is special about this run: the kind of boxes, the seed.
  CheckedEngine(const ContractEngine& engine, std::string story);

  testing::AssertionResult insert(const std::vector<BodyId>& ids, const std::vector<Aabb>& boxes);
  testing::AssertionResult move(const std::vector<BodyId>& ids, const std::vector<Aabb>& boxes);
  testing::AssertionResult remove(const std::vector<BodyId>& ids);
  testing::AssertionResult update();

  /// Makes a call that the engine must refuse, and checks that bodies and pairs stay as they were. What the
  /// engine keeps inside shows at the next update(), which compares with a model that never saw the call.
  testing::AssertionResult refuse(const std::function<Status(Broadphase&)>& call, Status& status);

  const Model& model() const { return model_; }
  const Broadphase& engine() const { return *engine_; }
  /// The most bodies the engine takes.
  std::size_t capacity() const { return static_cast<std::size_t>(engine_->capacity().bodies); }
  /// The answer to the last update().
  const Answer& answer() const { return answer_; }

 private:
  testing::AssertionResult failure() const;
  testing::AssertionResult accepted(const char* call, const Status& status) const;
  testing::AssertionResult state_is_kept() const;
  testing::AssertionResult changes_are_right(const Answer& expected) const;
  testing::AssertionResult pairs_are_right(const std::vector<Pair>& expected) const;
  testing::AssertionResult same(const char* what, const std::vector<Pair>& given,
                                const std::vector<Pair>& expected) const;
  std::string describe(const Pair& pair) const;

  std::unique_ptr<Broadphase> engine_;
  std::string story_;
  std::uint64_t updates_ = 0;
  Model model_;
  Answer answer_;         ///< copies of what the engine gave
  PairChanges handed_{};  ///< the engine's own memory, valid until the next update
};

}  // namespace cellsweep::contract
