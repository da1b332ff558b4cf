/// @file
/// A broadphase with the truth beside it: every call goes to both, and every answer is compared.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cellsweep/broadphase.h"
#include "contract/contract_engines.h"

namespace cellsweep::contract {

/// The parts of one update's answer, copied in the order in which they were given.
struct Answer {
  std::vector<Pair> pairs;
  std::vector<Pair> began;
  std::vector<Pair> ended;

  friend bool operator==(const Answer&, const Answer&) = default;
};

/// What a broadphase should know: its bodies with canonical boxes, now and as of the last update, and its
/// pairs as of the last update, ascending.
struct Model {
  std::map<BodyId, Aabb> boxes;
  std::map<BodyId, Aabb> shown;
  std::map<BodyId, BodyFilter> filters;  ///< of bodies that have another than the default
  std::set<BodyId> gone;                 ///< removed since the last update, though the id may be back
  std::vector<Pair> pairs;

  /// All ids, ascending.
  std::vector<BodyId> ids() const;

  /// The pairs that brute force finds among the boxes now, and filters allow, ascending.
  std::vector<Pair> brute_force() const;

  BodyFilter filter(BodyId id) const;

  void remove(BodyId id);

  /// What an update must answer now. Afterwards it has been.
  Answer update();

  /// Whether a body with this id had pairs whose end has not been told.
  bool is_in_pairs(BodyId id) const;
};

/// Drives one broadphase. Its calls expect to be accepted, compare the answer with the model, and check that
/// what was handed out earlier is still there as long as the contract promises. The results carry the engine,
/// the story and the step, so that a failure can be found again from its message.
class CheckedEngine {
 public:
  /// `story` says what is special about this run: the kind of boxes, the seed.
  CheckedEngine(const ContractEngine& engine, std::string story);
  CheckedEngine(Broadphase engine, std::string story);

  testing::AssertionResult insert(const std::vector<BodyId>& ids, const std::vector<Aabb>& boxes);
  testing::AssertionResult insert(const std::vector<BodyId>& ids, const std::vector<Aabb>& boxes,
                                  const std::vector<BodyFilter>& filters);
  /// Sets `ids` to those that were handed out.
  testing::AssertionResult add(const std::vector<Aabb>& boxes, std::vector<BodyId>& ids);
  testing::AssertionResult move(const std::vector<BodyId>& ids, const std::vector<Aabb>& boxes);
  testing::AssertionResult remove(const std::vector<BodyId>& ids);
  testing::AssertionResult set_filters(const std::vector<BodyId>& ids,
                                       const std::vector<BodyFilter>& filters);
  testing::AssertionResult update();

  /// Makes a call that must be refused, and checks that bodies and pairs stay as they were. What the engine
  /// keeps inside shows at the next update(), which compares with a model that never saw the call.
  testing::AssertionResult refuse(const std::function<Status(Broadphase&)>& call, Status& status);

  /// An update() that must fail, and leave pairs, boxes and what was called since the last one as they were.
  testing::AssertionResult refuse_update(Status& status);

  /// Whether all is there that the last update gave, with the bodies and boxes that the model has.
  testing::AssertionResult state_is_kept();

  /// Whether pairs() is called from now on: a caller may look at what changed alone.
  void look_at_pairs(bool look) { looks_ = look; }

  /// `around` is told before a call (true) and after it (false). From now on calls may not get the memory or
  /// the threads they need: they must leave everything as it was, and are made again.
  void surround_calls(std::function<void(bool)> around) { around_ = std::move(around); }
  /// How many calls did not get what they needed.
  int failures() const { return failures_; }

  const Model& model() const { return model_; }
  const Broadphase& engine() const { return engine_; }
  /// The broadphase itself, for what the model need not know.
  Broadphase& handle() { return engine_; }
  /// The most bodies that there may be.
  std::size_t capacity() const { return static_cast<std::size_t>(engine_.capacity().bodies); }
  /// The answer to the last update(). When nobody looked at pairs(), they are the model's.
  const Answer& answer() const { return answer_; }

 private:
  template <class Call>
  auto call_engine(Call call) -> decltype(call());
  testing::AssertionResult failure() const;
  testing::AssertionResult accepted(const char* call, const Status& status);
  testing::AssertionResult bodies_are_kept() const;
  testing::AssertionResult boxes_are_kept();
  testing::AssertionResult ids_are_right(const std::vector<BodyId>& ids) const;
  void count_bodies(std::size_t more);
  testing::AssertionResult answer_is(const Answer& expected) const;
  testing::AssertionResult same(const char* what, const std::vector<Pair>& given,
                                const std::vector<Pair>& expected) const;
  std::string describe(const Pair& pair) const;

  Broadphase engine_;
  std::string story_;
  std::uint64_t updates_ = 0;
  bool looks_ = true;
  std::function<void(bool)> around_;
  int failures_ = 0;
  Model model_;
  std::size_t removed_ = 0;      // since the last update, those that none has seen among them
  std::size_t most_bodies_ = 0;  // at a time, the removed ones among them
  bool ids_are_slots_ = true;    // nobody chose an id or changed a filter
  Answer answer_;                ///< copies of what was given
  /// The memory that was handed out, valid until the next update().
  std::optional<PairChanges> handed_;
  std::optional<std::span<const Pair>> handed_pairs_;
};

}  // namespace cellsweep::contract
