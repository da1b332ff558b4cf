#include "bench/peers/box_pruning.h"

#include <bit>
#include <limits>

namespace cellsweep::bench {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr unsigned kDigitBits = 11;
constexpr unsigned kDigits = 3;
constexpr std::uint64_t kDigitMask = (1U << kDigitBits) - 1;

/// The axis on which the boxes' middles lie farthest apart, by their variance.
std::size_t widest_axis(std::span<const Aabb> boxes) {
  std::size_t widest = 0;
  double most = -1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double sum = 0;
    double squares = 0;
    for (const Aabb& box : boxes) {
      const double middle = 0.5 * (static_cast<double>(box.min[axis]) + static_cast<double>(box.max[axis]));
      sum += middle;
      squares += middle * middle;
    }
    const double variance = squares - sum * sum / static_cast<double>(boxes.size());
    if (variance > most) {
      most = variance;
      widest = axis;
    }
  }
  return widest;
}

// Unsigned numbers in the order of the floats; both zeros are one.
std::uint64_t ordered_bits(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value + 0.0F);
  return bits >> 31 != 0 ? ~bits : bits | 0x80000000U;
}

}  // namespace

void BoxPruning::sort(std::span<const Aabb> boxes, std::size_t axis) {
  const std::size_t count = boxes.size();
  keys_.resize(count);
  other_keys_.resize(count);
  std::array<std::array<std::uint32_t, kDigitMask + 1>, kDigits> starts{};
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t bits = ordered_bits(boxes[i].min[axis]);
    keys_[i] = bits << 32 | i;
    for (unsigned digit = 0; digit < kDigits; ++digit) {
      ++starts[digit][(bits >> (digit * kDigitBits)) & kDigitMask];
    }
  }
  for (unsigned digit = 0; digit < kDigits; ++digit) {
    std::uint32_t start = 0;
    for (std::uint32_t& place : starts[digit]) {
      const std::uint32_t size = place;
      place = start;
      start += size;
    }
    const unsigned shift = 32 + digit * kDigitBits;
    for (const std::uint64_t key : keys_) other_keys_[starts[digit][(key >> shift) & kDigitMask]++] = key;
    keys_.swap(other_keys_);
  }
}

void BoxPruning::fill_lists(std::span<const Aabb> boxes, std::size_t axis) {
  const std::size_t count = boxes.size();
  lists_.count = count;
  lists_.ids.resize(count);
  for (std::size_t k = 0; k < 3; ++k) {
    lists_.min[k].resize(count + SweepLists::kPadding);
    lists_.max[k].resize(count + SweepLists::kPadding);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const auto id = static_cast<BodyId>(keys_[i]);
    lists_.ids[i] = id;
    for (std::size_t k = 0; k < 3; ++k) {
      lists_.min[k][i] = boxes[id].min[(axis + k) % 3];
      lists_.max[k][i] = boxes[id].max[(axis + k) % 3];
    }
  }
  for (std::size_t i = count; i < count + SweepLists::kPadding; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      lists_.min[k][i] = kInfinity;
      lists_.max[k][i] = -kInfinity;
    }
  }
}

void BoxPruning::find_pairs(std::span<const Aabb> boxes, std::vector<Pair>& pairs) {
  pairs.clear();
  if (boxes.empty()) return;
  const std::size_t axis = widest_axis(boxes);
  sort(boxes, axis);
  fill_lists(boxes, axis);
  sweep_(lists_, pairs);
}

void sweep_portable(const SweepLists& lists, std::vector<Pair>& pairs) {
  const auto& min = lists.min;
  const auto& max = lists.max;
  for (std::size_t i = 0; i < lists.count; ++i) {
    for (std::size_t j = i + 1; min[0][j] <= max[0][i]; ++j) {
      if (min[1][j] <= max[1][i] && min[1][i] <= max[1][j] && min[2][j] <= max[2][i] &&
          min[2][i] <= max[2][j]) {
        pairs.push_back(make_pair_of(lists.ids[i], lists.ids[j]));
      }
    }
  }
}

Sweep best_sweep() {
#ifdef CELLSWEEP_X86_PRUNING
  if (__builtin_cpu_supports("avx2")) return sweep_avx2;
#endif
  return sweep_portable;
}

}  // namespace cellsweep::bench
