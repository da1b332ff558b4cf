/// @file
/// Changes to a scene that must not change which bodies overlap: other orders, names, axes, signs and scales.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <span>

#include "contract/contract_fixture.h"
#include "contract/effort.h"
#include "contract/random.h"

namespace cellsweep::contract {
namespace {

/// The same bodies in a row of frames: boxes[frame][body].
using Film = std::vector<std::vector<Aabb>>;

/// What an engine says of a film, each list in terms of body numbers and ascending.
struct Report {
  std::vector<std::vector<Pair>> pairs;
  std::vector<std::vector<Pair>> began;
  std::vector<std::vector<Pair>> ended;

  friend bool operator==(const Report&, const Report&) = default;
};

Film make_film(const BoxKind& kind, std::size_t bodies, std::uint64_t seed) {
  Random random(seed);
  Film film = {make_boxes(kind, random, bodies)};
  for (int frame = 1; frame < effort(4, 3); ++frame) {
    film.push_back(film.back());
    for (Aabb& box : film.back()) {
      if (random.one_in(2)) box = next_box(kind, random, box, random.pick(film[0]));
    }
  }
  return film;
}

/// The pairs with `names[body]` turned back into `body`.
std::vector<Pair> by_number(std::span<const Pair> pairs, const std::vector<BodyId>& names) {
  std::map<BodyId, BodyId> numbers;
  for (std::size_t body = 0; body < names.size(); ++body) {
    numbers[names[body]] = static_cast<BodyId>(body);
  }
  std::vector<Pair> result;
  for (const Pair& pair : pairs) result.push_back(make_pair_of(numbers.at(pair.a), numbers.at(pair.b)));
  std::ranges::sort(result);
  return result;
}

/// Which way a scene is told to the engine.
struct Telling {
  std::vector<BodyId> names;                   ///< the id of each body
  std::vector<std::size_t> order;              ///< in which the bodies are listed
  std::function<Aabb(const Aabb&)> transform;  ///< of every box
  bool one_by_one = false;
};

Telling plain_telling(std::size_t bodies) {
  Telling telling{std::vector<BodyId>(bodies), std::vector<std::size_t>(bodies),
                  [](const Aabb& box) { return box; }};
  std::iota(telling.names.begin(), telling.names.end(), BodyId{0});
  std::iota(telling.order.begin(), telling.order.end(), std::size_t{0});
  return telling;
}

Status tell_frame(Broadphase& engine, const Telling& telling, const std::vector<Aabb>& frame, bool first) {
  std::vector<BodyId> ids;
  std::vector<Aabb> boxes;
  for (const std::size_t body : telling.order) {
    ids.push_back(telling.names[body]);
    boxes.push_back(telling.transform(frame[body]));
  }
  if (!telling.one_by_one) return first ? engine.insert(ids, boxes) : engine.move(ids, boxes);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    Status status = first ? engine.insert(ids[i], boxes[i]) : engine.move(ids[i], boxes[i]);
    if (!status.ok()) return status;
  }
  return {};
}

Report play(const ContractEngine& entry, const Telling& telling, const Film& film) {
  Broadphase engine = make(entry);
  Report report;
  for (std::size_t frame = 0; frame < film.size(); ++frame) {
    const Status status = tell_frame(engine, telling, film[frame], frame == 0);
    EXPECT_TRUE(status.ok()) << status.message;
    const auto changes = engine.update();
    if (!changes) {
      ADD_FAILURE() << changes.status().message;
      return report;
    }
    report.pairs.push_back(by_number(engine.pairs(), telling.names));
    report.began.push_back(by_number(changes->began, telling.names));
    report.ended.push_back(by_number(changes->ended, telling.names));
  }
  return report;
}

/// Turns the plain telling of a scene into another one.
using Change = std::function<void(Telling&, Random&)>;

class MetamorphicContract : public PerEngineAndKind {
 protected:
  /// Plays scenes as they are and as each of the changes tells them. In the gate one scene for each kind of
  /// boxes, told in one of the ways: an engine meets all sizes and all ways by the time that it has met all
  /// kinds.
  void expect_no_difference(const std::vector<Change>& all_changes) {
    const auto& [engine, kind] = GetParam();
    const std::size_t turn = turn_of(kind);
    const auto room = static_cast<std::size_t>(make(engine).capacity().bodies);
    const std::vector<Change> changes =
        is_long() ? all_changes : std::vector<Change>{all_changes[turn % all_changes.size()]};
    constexpr std::uint64_t kSeeds = 4;
    const std::uint64_t first = is_long() ? 0 : turn % kSeeds;
    for (std::uint64_t seed = first; seed < (is_long() ? kSeeds : first + 1); ++seed) {
      const std::size_t bodies = std::min<std::size_t>(20 + 13 * seed, room);
      const Film film = make_film(kind, bodies, seed);
      const Report plain = play(engine, plain_telling(bodies), film);
      for (const Change& change : changes) {
        Telling telling = plain_telling(bodies);
        Random random(seed + 100);
        change(telling, random);
        const Report changed = play(engine, telling, film);
        ASSERT_TRUE(plain == changed) << engine << ", " << kind << ", " << bodies << " bodies, seed " << seed
                                      << ": " << difference(plain, changed);
      }
    }
  }

 private:
  /// The first pair, by body number, that only one of two reports has.
  static std::string difference(const Report& plain, const Report& changed) {
    for (std::size_t frame = 0; frame < plain.pairs.size(); ++frame) {
      std::vector<Pair> only;
      std::ranges::set_symmetric_difference(plain.pairs[frame], changed.pairs[frame],
                                            std::back_inserter(only));
      if (!only.empty()) {
        return "frame " + std::to_string(frame) + ": only one way of telling has bodies " +
               std::to_string(only[0].a) + " and " + std::to_string(only[0].b) + " overlap";
      }
    }
    return "the pair sets are equal, what began or ended is not";
  }
};

TEST_P(MetamorphicContract, TheOrderInWhichBodiesAreListedDoesNotMatter) {
  expect_no_difference({[](Telling& telling, Random& random) { random.shuffle(telling.order); }});
}

TEST_P(MetamorphicContract, OneCallForAllOrOneForEachDoesNotMatter) {
  expect_no_difference({[](Telling& telling, Random&) { telling.one_by_one = true; }});
}

TEST_P(MetamorphicContract, SparseIdsInTheSameOrderDoNotMatter) {
  expect_no_difference({[](Telling& telling, Random& random) {
    BodyId next = 0;
    for (BodyId& name : telling.names) {
      name = next;
      next += 1 + static_cast<BodyId>(random.below(0x1000000));
    }
    telling.names.back() = 0xffffffff;
  }});
}

TEST_P(MetamorphicContract, WhichBodyHasWhichIdDoesNotMatter) {
  expect_no_difference({[](Telling& telling, Random& random) { random.shuffle(telling.names); }});
}

TEST_P(MetamorphicContract, WhichAxisIsWhichDoesNotMatter) {
  constexpr std::array<std::size_t, 3> kOrders[] = {{1, 2, 0}, {2, 0, 1}, {0, 2, 1}};
  std::vector<Change> changes;
  for (const auto& from : kOrders) {
    changes.emplace_back([from](Telling& telling, Random&) {
      telling.transform = [from](const Aabb& box) {
        return Aabb{{box.min[from[0]], box.min[from[1]], box.min[from[2]]},
                    {box.max[from[0]], box.max[from[1]], box.max[from[2]]}};
      };
    });
  }
  expect_no_difference(changes);
}

TEST_P(MetamorphicContract, MirroringAnAxisDoesNotMatter) {
  std::vector<Change> changes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    changes.emplace_back([axis](Telling& telling, Random&) {
      telling.transform = [axis](Aabb box) {
        box.min[axis] = -box.min[axis];
        box.max[axis] = -box.max[axis];
        std::swap(box.min[axis], box.max[axis]);
        return box;
      };
    });
  }
  expect_no_difference(changes);
}

class ScalingContract : public MetamorphicContract {};

TEST_P(ScalingContract, ScalingByAPowerOfTwoDoesNotMatter) {
  constexpr int kExponents[] = {-40, -1, 3, 60};
  std::vector<Change> changes;
  for (const int exponent : kExponents) {
    changes.emplace_back([exponent](Telling& telling, Random&) {
      telling.transform = [exponent](Aabb box) {
        for (float& value : box.min) value = std::ldexp(value, exponent);
        for (float& value : box.max) value = std::ldexp(value, exponent);
        return box;
      };
    });
  }
  expect_no_difference(changes);
}

INSTANTIATE_TEST_SUITE_P(Engines, MetamorphicContract, all_engines_and_kinds(), engine_and_kind_label);

auto all_engines_and_scalable_kinds() {
  std::vector<BoxKind> kinds(box_kinds().begin(), box_kinds().end());
  std::erase_if(kinds, [](const BoxKind& kind) { return !kind.scalable; });
  return testing::Combine(all_engines(), testing::ValuesIn(kinds));
}

INSTANTIATE_TEST_SUITE_P(Engines, ScalingContract, all_engines_and_scalable_kinds(), engine_and_kind_label);

}  // namespace
}  // namespace cellsweep::contract
