/// @file
/// The random numbers of the tests: splitmix64, the same bits for the same seed everywhere.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace cellsweep::contract {

/// A stream of random numbers; written out here rather than shared with the library that it tests.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }

  /// A whole number from 0 to bound − 1; bound must not be 0.
  std::size_t below(std::size_t bound) { return static_cast<std::size_t>(bits() % bound); }

  /// A small whole number from `low` to `high`, both included.
  int whole(int low, int high) {
    return low + static_cast<int>(below(static_cast<std::size_t>(high - low + 1)));
  }

  /// A multiple of 2^-24 from 0 up to, but not including, 1.
  float unit() { return static_cast<float>(bits() >> 40) * 0x1p-24F; }

  float between(float low, float high) { return low + unit() * (high - low); }

  bool one_in(std::size_t n) { return below(n) == 0; }

  template <class T>
  const T& pick(const std::vector<T>& items) {
    return items[below(items.size())];
  }

  template <class T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t left = items.size(); left > 1; --left) std::swap(items[left - 1], items[below(left)]);
  }

 private:
  std::uint64_t state_;
};

}  // namespace cellsweep::contract
