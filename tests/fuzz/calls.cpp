#include "fuzz/calls.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "base/text.h"
#include "cellsweep/broadphase.h"
#include "contract/box_kinds.h"
#include "contract/checked_engine.h"
#include "contract/executors.h"
#include "contract/random.h"

namespace cellsweep::fuzz {
namespace {

using contract::BoxKind;
using contract::CheckedEngine;
using contract::Random;
using testing::AssertionFailure;
using testing::AssertionResult;
using testing::AssertionSuccess;

/// As many calls as find anything: what comes behind them would only take longer.
constexpr int kMostCalls = 100;
/// Bodies of the smallest worlds.
constexpr std::size_t kFew = 40;
/// Boxes of one call that are spelt out byte by byte; any more come from a seed.
constexpr std::size_t kMostSpelt = 24;
/// Bodies of a world in which new boxes may be of any kind.
constexpr std::size_t kMostOfAnyKind = 300;
/// What an engine with a limit on pairs may find.
constexpr std::uint64_t kFewPairs = 100;

/// What is left of the input.
class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : left_(bytes) {}

  bool at_end() const { return left_.empty(); }

  void end() { left_ = {}; }

  unsigned next() {
    if (at_end()) return 0;
    const unsigned byte = left_.front();
    left_ = left_.subspan(1);
    return byte;
  }

 private:
  std::span<const std::uint8_t> left_;
};

/// Each machine has `best` and `portable`; one that lacks another has `best` in its place.
VectorIsa isa_of(unsigned byte) {
  if ((byte & 4U) != 0) return (byte & 32U) == 0 ? VectorIsa::portable : VectorIsa::sse41;
  return (byte & 32U) == 0 ? VectorIsa::best : VectorIsa::avx2;
}

StreamOptions options_of(unsigned byte) {
  constexpr float kMargins[] = {0, 0, 0.25F, 100};
  StreamOptions options{.threads = 1, .margin = kMargins[byte & 3U]};
  options.isa = isa_of(byte);
  if ((byte & 8U) != 0) {
    options.threads = contract::kConcurrency;
    options.executor = std::make_shared<contract::SequentialExecutor>();
  }
  if ((byte & 16U) != 0) options.max_pairs = kFewPairs;
  return options;
}

/// How many times as many bodies a world has: few worlds are large, for they take long. Of the largest
/// `stream` makes cells.
std::size_t times_of(unsigned byte) {
  if (byte % 64 == 63) return 64;
  return byte % 8 == 7 ? 8 : 1;
}

/// Ascending ids: 0, 1, 2 …, or from all over the range, its ends among them.
std::vector<BodyId> names_of(bool scattered, std::size_t count) {
  std::set<BodyId> names;
  if (scattered) names = {0, 1, 0xffff, 0x10000, 0x7fffffff, 0x80000000, 0xfffffffe, 0xffffffff};
  Random random(count);
  while (names.size() < count) names.insert(static_cast<BodyId>(scattered ? random.bits() : names.size()));
  return {names.begin(), names.end()};
}

class ByteCaller {
 public:
  explicit ByteCaller(std::span<const std::uint8_t> bytes)
      : bytes_(bytes),
        options_(options_of(bytes_.next())),
        world_(bytes_.next()),
        times_(times_of(world_)),
        names_(names_of((world_ & 64U) != 0, kFew * times_)),
        engine_(made(options_), story()) {}

  CallsOutcome run() {
    CallsOutcome outcome{story()};
    AssertionResult right = AssertionSuccess();
    for (int call = 0; call < kMostCalls && !bytes_.at_end() && right; ++call) right = make_call();
    // What the engine keeps inside shows at an update.
    if (right) right = update();
    outcome.updates = updates_;
    outcome.pairs = pairs_;
    if (!right) outcome.failure = right.message();
    return outcome;
  }

 private:
  static Broadphase made(StreamOptions options) {
    Result<Broadphase> broadphase = make_broadphase(options);
    if (!broadphase && options.isa != VectorIsa::best) {
      options.isa = VectorIsa::best;
      broadphase = make_broadphase(options);
    }
    if (!broadphase) throw std::runtime_error(broadphase.status().message);
    return std::move(*broadphase);
  }

  std::string story() const {
    return text("calls by bytes, ", options_.threads, " threads, margin ", options_.margin, ", at most ",
                options_.max_pairs, " pairs, ", names_.size(), " ids");
  }

  AssertionResult make_call() {
    switch (bytes_.next() % 13) {
      case 0:
        return insert(false);
      case 1:
        return insert(true);
      case 2:
        return add();
      case 3:
      case 4:
        return move(some_of(held()));
      case 5:
        return move(held());
      case 6:
        return engine_.remove(some_of(held()));
      case 7:
        return replace();
      case 8:
        return set_filters();
      case 9:
        return refuse();
      case 10:
        bytes_.end();
        return AssertionSuccess();
      default:
        return update();
    }
  }

  AssertionResult insert(bool with_filters) {
    const std::vector<BodyId> ids = some_of(absent());
    const std::vector<Aabb> boxes = new_boxes(ids.size());
    return with_filters ? engine_.insert(ids, boxes, filters(ids.size())) : engine_.insert(ids, boxes);
  }

  AssertionResult add() {
    const std::size_t room = names_.size() - std::min(names_.size(), engine_.model().boxes.size());
    const std::size_t count = std::min(room, times_ * (bytes_.next() % 32));
    std::vector<BodyId> ids;
    return engine_.add(new_boxes(count), ids);
  }

  /// One of them twice, now and then: the last box is the one that counts.
  AssertionResult move(std::vector<BodyId> ids) {
    const unsigned byte = bytes_.next();
    if (!ids.empty() && byte % 8 == 0) ids.push_back(ids[byte / 8 % ids.size()]);
    return engine_.move(ids, byte % 2 == 0 ? new_boxes(ids.size()) : boxes_near(ids));
  }

  /// Others under the same ids, or, as far as anybody can see from outside, the same.
  AssertionResult replace() {
    const std::vector<BodyId> ids = some_of(held());
    std::vector<Aabb> boxes;
    for (const BodyId id : ids) boxes.push_back(engine_.model().boxes.at(id));
    if (bytes_.next() % 2 == 0) boxes = new_boxes(ids.size());
    if (AssertionResult removed = engine_.remove(ids); !removed) return removed;
    return engine_.insert(ids, boxes);
  }

  AssertionResult set_filters() {
    const std::vector<BodyId> ids = some_of(held());
    return engine_.set_filters(ids, filters(ids.size()));
  }

  /// Refused where there are more pairs than there may be, and then bodies go until there are fewer.
  AssertionResult update() {
    ++updates_;
    engine_.look_at_pairs(updates_ % 3 != 0);
    while (options_.max_pairs > 0 && engine_.model().brute_force().size() > options_.max_pairs) {
      Status status;
      if (AssertionResult refused = engine_.refuse_update(status); !refused) return refused;
      if (status.code != StatusCode::capacity) return AssertionFailure() << story() << ": " << status.message;
      std::vector<BodyId> half = held();
      half.resize((half.size() + 1) / 2);
      if (AssertionResult removed = engine_.remove(half); !removed) return removed;
    }
    AssertionResult right = engine_.update();
    pairs_ += engine_.model().pairs.size();
    return right;
  }

  /// A bad one among good arguments: nothing of the call may have been done.
  AssertionResult refuse() {
    const unsigned kind = bytes_.next() % 6;
    std::vector<BodyId> ids = some_of(kind < 3 ? absent() : held());
    if (ids.empty()) return AssertionSuccess();
    std::vector<Aabb> boxes = new_boxes(ids.size());
    const std::size_t place = bytes_.next() % ids.size();
    const std::vector<BodyId> others = kind < 3 ? held() : absent();
    if (kind == 0) boxes[place].max[place % 3] = std::numeric_limits<float>::quiet_NaN();
    if (kind == 1) ids.push_back(ids[place]);
    if (kind == 4) boxes[place].min[place % 3] = std::numeric_limits<float>::infinity();
    if (kind == 2 || kind == 3 || kind == 5) {
      if (others.empty()) return AssertionSuccess();
      ids[place] = others[place % others.size()];
    }
    boxes.resize(ids.size(), boxes[place]);
    Status status;
    return engine_.refuse(
        [&](Broadphase& e) {
          if (kind < 3) return e.insert(ids, boxes);
          return kind == 5 ? e.remove(ids) : e.move(ids, boxes);
        },
        status);
  }

  std::vector<BodyId> held() const { return engine_.model().ids(); }

  std::vector<BodyId> absent() const {
    std::vector<BodyId> ids = names_;
    std::erase_if(ids, [&](BodyId id) { return engine_.model().boxes.contains(id); });
    return ids;
  }

  /// Every so manieth of them from a place on, as often backwards.
  std::vector<BodyId> some_of(std::vector<BodyId> all) {
    const std::size_t first = bytes_.next();
    const unsigned byte = bytes_.next();
    const std::size_t count = (byte & 31U) * times_ + 1;
    const std::size_t stride = 1 + (byte >> 6U);
    if ((byte & 32U) != 0) std::ranges::reverse(all);
    std::vector<BodyId> some;
    for (std::size_t i = first * all.size() / 256; i < all.size() && some.size() < count; i += stride)
      some.push_back(all[i]);
    return some;
  }

  /// Of a kind of the contract suite, or small whole numbers, a byte for a face and the edge behind it.
  std::vector<Aabb> new_boxes(std::size_t count) {
    const std::span<const BoxKind> kinds = contract::box_kinds();
    const std::size_t kind = bytes_.next() % (kinds.size() + 2);
    if (kind >= kinds.size() && count <= kMostSpelt) return spelt_boxes(count);
    Random random(bytes_.next());
    // Millions of pairs of a kind whose boxes all overlap would be the oracle's work, and nobody's else.
    const std::size_t bodies = engine_.model().boxes.size() + count;
    const bool few_pairs = bodies > kMostOfAnyKind || kind >= kinds.size();
    return contract::make_boxes(few_pairs ? contract::box_kind("uniform") : kinds[kind], random, count);
  }

  std::vector<Aabb> spelt_boxes(std::size_t count) {
    std::vector<Aabb> boxes(count);
    for (Aabb& box : boxes) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const unsigned byte = bytes_.next();
        box.min[axis] = static_cast<float>(byte & 15U);
        box.max[axis] = box.min[axis] + static_cast<float>(byte >> 4U);
      }
    }
    return boxes;
  }

  /// A little aside, against a face of another body, around it: what contract::next_box() knows.
  std::vector<Aabb> boxes_near(const std::vector<BodyId>& ids) {
    const std::vector<BodyId> all = held();
    Random random(bytes_.next());
    std::vector<Aabb> boxes;
    for (const BodyId id : ids) {
      const auto& known = engine_.model().boxes;
      boxes.push_back(contract::next_box(contract::box_kind("uniform"), random, known.at(id),
                                         known.at(random.pick(all))));
    }
    return boxes;
  }

  std::vector<BodyFilter> filters(std::size_t count) {
    const unsigned byte = bytes_.next();
    std::vector<BodyFilter> filters(count);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t turn = i + byte;
      if (turn % 3 == 0) continue;
      filters[i].category = 1U << (turn % 5);
      filters[i].mask = byte | 0xffff0000U;
      filters[i].is_static = turn % 4 == 0;
    }
    return filters;
  }

  Bytes bytes_;
  StreamOptions options_;
  unsigned world_;
  std::size_t times_;
  std::vector<BodyId> names_;
  CheckedEngine engine_;
  std::uint64_t updates_ = 0;
  std::uint64_t pairs_ = 0;
};

}  // namespace

CallsOutcome make_calls(std::span<const std::uint8_t> bytes) {
  return ByteCaller(bytes).run();
}

}  // namespace cellsweep::fuzz
