#include "base/sorting/key_sort.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <utility>

#include "base/memory/array.h"
#include "base/sorting/prefix_sums.h"
#include "base/tuning.h"

namespace cellsweep {
namespace {

using Key = std::uint64_t;

/// A digit has at most so many bits: more counters, and the places written to, outgrow the fastest cache.
constexpr unsigned kWidestDigit = 11;
constexpr unsigned kNarrowestDigit = 8;
constexpr unsigned kMostDigits = 64 / kNarrowestDigit;
constexpr std::size_t kMostValues = std::size_t{1} << kWidestDigit;

/// How often each value of each digit occurs; then where the next key with it goes.
using Counts = std::array<std::array<std::uint32_t, kMostValues>, kMostDigits>;

unsigned bits_of(std::uint64_t number) {
  return static_cast<unsigned>(std::bit_width(number));
}

/// By which digits keys are sorted, from the lowest on.
struct Digits {
  Key least = 0;       // is taken away from all keys
  unsigned bits = 0;   // of a digit
  unsigned count = 0;  // of digits
  std::array<unsigned, kMostDigits> shifts = {};

  std::size_t values() const { return std::size_t{1} << bits; }
  std::size_t value(Key key, unsigned digit) const {
    return ((key - least) >> shifts[digit]) & (values() - 1);
  }

  /// The next ones: as many as it takes for `all_bits` bits from `below` on.
  void add(unsigned below, unsigned all_bits) {
    while (all_bits > 0) {
      shifts[count++] = below;
      below += bits;
      all_bits -= std::min(bits, all_bits);
    }
  }
};

/// As few digits as so many keys are worth the counters of, all of them alike.
unsigned digit_bits(unsigned all_bits, std::size_t keys, unsigned narrowest) {
  const unsigned widest = std::clamp(bits_of(keys) - 1, narrowest, kWidestDigit);
  const unsigned count = std::max((all_bits + widest - 1) / widest, 1U);
  return (all_bits + count - 1) / count;
}

Digits all_digits(std::size_t keys, Key least, unsigned bits) {
  Digits digits;
  digits.least = least;
  digits.bits = digit_bits(bits, keys, kNarrowestDigit);
  digits.add(0, bits);
  return digits;
}

/// The upper bits of the first number, and of the second as many as fit into one digit.
Digits upper_digits(std::size_t keys, Key least, KeyBits bits) {
  const unsigned wanted = std::min(bits.first, bits_of(keys) + tuning::kBitsMore);
  Digits digits;
  digits.least = least;
  digits.bits = std::max(digit_bits(wanted, keys, 4), 1U);
  const unsigned of_second = std::min(bits.second, digits.bits);
  digits.add(bits.second - of_second, of_second);
  digits.add(bits.all() - wanted, wanted);
  return digits;
}

void count_values(std::span<const Key> keys, Digits digits, Counts& counts) {
  for (unsigned digit = 0; digit < digits.count; ++digit)
    std::fill_n(counts[digit].begin(), digits.values(), 0U);
  for (const Key key : keys) {
    for (unsigned digit = 0; digit < digits.count; ++digit) ++counts[digit][digits.value(key, digit)];
  }
}

/// By one digit, stably.
void distribute(std::span<const Key> from, Digits digits, unsigned digit, std::span<std::uint32_t> counts,
                Key* to) {
  make_prefix_sums(counts);
  for (const Key key : from) to[counts[digits.value(key, digit)]++] = key;
}

/// Digit by digit. Returns in which of the two they are.
std::span<Key> sort_by_digits(std::span<Key> keys, std::span<Key> spare, Digits digits) {
  Counts counts;  // NOLINT(*-member-init): written before it is read
  count_values(keys, digits, counts);
  for (unsigned digit = 0; digit < digits.count; ++digit) {
    distribute(keys, digits, digit, std::span(counts[digit]).first(digits.values()), spare.data());
    std::swap(keys, spare);
  }
  return keys;
}

/// Insertion sort that gives up after so many steps: false, and the keys are in another order.
bool sort_by_insertion(std::span<Key> keys, std::size_t most_steps) {
  std::size_t steps = 0;
  for (std::size_t i = 1; i < keys.size(); ++i) {
    if (keys[i - 1] <= keys[i]) continue;
    const Key key = keys[i];
    std::size_t place = i;
    for (; place > 0 && keys[place - 1] > key; --place) keys[place] = keys[place - 1];
    keys[place] = key;
    steps += i - place;
    if (steps > most_steps) return false;
  }
  return true;
}

/// The greatest key is less than 2^bits above the least.
std::span<Key> sort_range(std::span<Key> keys, std::span<Key> spare, Key least, KeyBits bits) {
  const Digits all = all_digits(keys.size(), least, bits.all());
  if (all.count <= tuning::kFewDigits) return sort_by_digits(keys, spare, all);
  const auto sorted = sort_by_digits(keys, spare, upper_digits(keys.size(), least, bits));
  if (sort_by_insertion(sorted, 2 * keys.size())) return sorted;
  return sort_by_digits(sorted, sorted.data() == keys.data() ? spare : keys, all);
}

}  // namespace

bool sort_few_keys(std::span<Key> keys) {
  return keys.size() <= tuning::kFewKeys && sort_by_insertion(keys, tuning::kFewKeys * tuning::kFewKeys);
}

std::span<Key> sort_keys(std::span<Key> keys, std::span<Key> spare, KeyBits bits) {
  return sort_few_keys(keys) ? keys : sort_range(keys, spare, 0, bits);
}

std::span<Key> sort_keys(std::span<Key> keys, std::span<Key> spare) {
  if (sort_few_keys(keys)) return keys;
  Key least = keys[0];
  Key greatest = keys[0];
  for (const Key key : keys) {
    least = std::min(least, key);
    greatest = std::max(greatest, key);
  }
  return sort_range(keys, spare, least, {bits_of(greatest - least), 0});
}

void sort_keys(std::span<Key> keys) {
  Array<Key> spare;
  if (keys.size() > tuning::kFewKeys) spare.renew(keys.size());
  const auto sorted = sort_keys(keys, spare.view());
  if (sorted.data() != keys.data()) std::ranges::copy(sorted, keys.begin());
}

void sort_numbers(std::span<std::uint32_t> numbers) {
  std::sort(numbers.begin(), numbers.end());
}

}  // namespace cellsweep
