#include "one_shot/exact.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>

#include "base/sorting/key_sort.h"

namespace cellsweep::one_shot {
namespace {

/// Beyond it coordinates count as it. The floats around it are finite.
constexpr double kFarthest = 1e38;

/// A float that is not above the number, and one that is not below it: one to two steps away, so that the
/// same few instructions do for all numbers.
float at_most(double number) {
  const auto near = static_cast<float>(number);
  return near - (std::fabs(near) * FLT_EPSILON + FLT_MIN);
}
float at_least(double number) {
  const auto near = static_cast<float>(number);
  return near + (std::fabs(near) * FLT_EPSILON + FLT_MIN);
}

/// The middle one of some of the coordinates.
double find_middle(std::span<const ExactBox> exact, std::size_t axis) {
  constexpr std::size_t kSome = 127;
  std::array<double, kSome> some{};
  const std::size_t count = std::min(exact.size(), kSome);
  for (std::size_t i = 0; i < count; ++i) some[i] = exact[i * exact.size() / count].min[axis];
  std::nth_element(some.begin(), some.begin() + count / 2, some.begin() + count);
  return some[count / 2];
}

/// A number with the order of doubles; -0 is 0.
std::uint64_t order_of(double number) {
  constexpr std::uint64_t kSign = std::uint64_t{1} << 63;
  const auto bits = std::bit_cast<std::uint64_t>(number + 0.0);
  return (bits & kSign) != 0 ? ~bits : bits | kSign;
}

/// Ranks that floats hold exactly.
constexpr std::size_t kExactRanks = std::size_t{1} << 24;

}  // namespace

void make_rounded(std::span<const ExactBox> exact, Array<Aabb>& rounded) {
  rounded.renew(exact.size());
  std::array<double, 3> middle{};
  if (!exact.empty()) {
    for (std::size_t axis = 0; axis < 3; ++axis) middle[axis] = find_middle(exact, axis);
  }
  // Differences are rounded, which keeps their order, and may be infinite.
  const auto moved = [&](double coordinate, std::size_t axis) {
    return std::min(std::max(coordinate - middle[axis], -kFarthest), kFarthest);
  };
  for (std::size_t i = 0; i < exact.size(); ++i) {
    Aabb& box = rounded.data()[i];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] = at_most(moved(exact[i].min[axis], axis));
      box.max[axis] = at_least(moved(exact[i].max[axis], axis));
    }
  }
}

void make_ranked(std::span<const ExactBox> exact, Array<Aabb>& ranked) {
  ranked.renew(exact.size());
  const std::size_t count = 2 * exact.size();
  Array<std::uint64_t> numbers;
  Array<std::uint64_t> spare;
  numbers.renew(count);
  spare.renew(count);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < exact.size(); ++i) {
      numbers.data()[2 * i] = order_of(exact[i].min[axis]);
      numbers.data()[2 * i + 1] = order_of(exact[i].max[axis]);
    }
    const std::span<const std::uint64_t> sorted = sort_keys(numbers.view(), spare.view());
    const auto rank_of = [&](double coordinate) {
      return static_cast<double>(std::ranges::lower_bound(sorted, order_of(coordinate)) - sorted.begin());
    };
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const double low = rank_of(exact[i].min[axis]);
      const double high = rank_of(exact[i].max[axis]);
      ranked.data()[i].min[axis] = count <= kExactRanks ? static_cast<float>(low) : at_most(low);
      ranked.data()[i].max[axis] = count <= kExactRanks ? static_cast<float>(high) : at_least(high);
    }
  }
}

}  // namespace cellsweep::one_shot
