#include "engines/control/sort_and_test.h"

#include <cstddef>

namespace cellsweep::control {
namespace {

// The order that makes results exact: at equal values a minimum comes first, so that two intervals that only
// touch stand in the order of two that overlap (X5).
struct ExactRules {
  static bool after(const Endpoint& one, const Endpoint& other, int axis) {
    if (*one.pValue != *other.pValue) return *one.pValue > *other.pValue;
    return one.is_max(axis) && !other.is_max(axis);
  }
  static bool overlap(float min, float max, float min_next, float max_next) {
    return min <= max_next && min_next <= max;
  }
};

struct LiteralRules {
  static bool after(const Endpoint& one, const Endpoint& other, int /*axis*/) {
    return *one.pValue > *other.pValue;
  }
  static bool overlap(float min, float max, float min_next, float max_next) {
    return (min <= min_next && max >= min_next) || (min <= max_next && max >= max_next);
  }
};

// Writes down how the owners of two endpoints that were just swapped overlap on this axis.
template <class Rules>
void test_swapped(const Endpoint& lower, const Endpoint& upper, int axis, PairManager& pairs,
                  SortEvents& events) {
  const auto k = static_cast<std::size_t>(axis);
  const bool now =
      Rules::overlap(lower.pBox->min[k], lower.pBox->max[k], upper.pBox->min[k], upper.pBox->max[k]);
  PairInfo& info = pairs.find(lower.ownerID, upper.ownerID);
  if (info.value[axis] == now) return;
  const bool collided = info.colliding();
  info.value[axis] = now;
  if (info.colliding() != collided) events.changed->push_back(info);
}

template <class Rules>
void sort_by_insertion(EndpointList& list, int axis, PairManager& pairs, SortEvents& events) {
  const auto count = static_cast<std::ptrdiff_t>(list.size());
  for (std::ptrdiff_t j = 1; j < count; ++j) {
    const Endpoint current = list[j];
    std::ptrdiff_t i = j - 1;
    while (i >= 0 && Rules::after(list[i], current, axis)) {
      list[i + 1] = list[i];
      list[i] = current;
      ++events.swaps;
      // Never the two ends of one body: its minimum entered the list first and is never above its maximum.
      test_swapped<Rules>(list[i], list[i + 1], axis, pairs, events);
      --i;
    }
  }
}

}  // namespace

void sort_and_test(EndpointList& list, int axis, PairManager& pairs, SortEvents& events) {
  sort_by_insertion<ExactRules>(list, axis, pairs, events);
}

void sort_and_test_literal(EndpointList& list, int axis, PairManager& pairs, SortEvents& events) {
  sort_by_insertion<LiteralRules>(list, axis, pairs, events);
}

}  // namespace cellsweep::control
