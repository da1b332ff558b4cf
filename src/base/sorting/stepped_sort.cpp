#include "base/sorting/stepped_sort.h"

#include <algorithm>
#include <utility>

#include "base/sorting/prefix_sums.h"

namespace cellsweep {

void SteppedSort::begin(List<std::uint64_t>& keys) {
  sorted_.reserve(keys.size());
  counts_.renew(kDigits * kValues);
  std::fill_n(counts_.data(), counts_.size(), 0U);
  keys_.clear();
  std::swap(keys_, keys);
  sorted_.set_size(keys_.size());
  is_counted_ = false;
  digit_ = 0;
  place_ = 0;
}

void SteppedSort::give_back() {
  *this = SteppedSort();
}

// A pass counts, and each further one is by one digit, the lowest first, stably.
bool SteppedSort::go_on(std::size_t& steps) {
  while (digit_ < kDigits && steps > 0) {
    if (place_ == 0 && is_counted_ && !prepare_digit()) {
      ++digit_;
      continue;
    }
    const std::size_t part = std::min(steps, keys_.size() - place_);
    const auto keys = std::as_const(keys_).view().subspan(place_, part);
    is_counted_ ? distribute(keys) : count(keys);
    steps -= part;
    place_ += part;
    if (place_ == keys_.size()) end_pass();
  }
  return digit_ == kDigits;
}

void SteppedSort::end_pass() {
  place_ = 0;
  if (!std::exchange(is_counted_, true)) return;
  std::swap(keys_, sorted_);
  ++digit_;
}

void SteppedSort::count(std::span<const std::uint64_t> keys) {
  for (const std::uint64_t key : keys) {
    for (unsigned digit = 0; digit < kDigits; ++digit) ++counts(digit)[value(key, digit)];
  }
}

// False when all keys have the same, which leaves them in the order that they are in.
bool SteppedSort::prepare_digit() {
  std::uint32_t* const places = counts(digit_);
  if (keys_.empty() || places[value(keys_[0], digit_)] == keys_.size()) return false;
  make_prefix_sums({places, kValues});
  return true;
}

void SteppedSort::distribute(std::span<const std::uint64_t> keys) {
  std::uint32_t* const places = counts(digit_);
  std::uint64_t* const to = sorted_.data();
  for (const std::uint64_t key : keys) to[places[value(key, digit_)]++] = key;
}

}  // namespace cellsweep
