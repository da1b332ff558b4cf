/// @file
/// Body ids, pairs of them, and the hash by which two pair sets are compared.
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <string>

#include "cellsweep/export.h"

namespace cellsweep {

/// A name the caller gives to a body: any 32-bit number, dense or sparse.
using BodyId = std::uint32_t;

/// Two overlapping bodies, always with `a < b`.
struct Pair {
  BodyId a = 0;
  BodyId b = 0;

  // NOLINTNEXTLINE(modernize-use-nullptr): the comparison that is generated has no pointer in it.
  friend auto operator<=>(const Pair&, const Pair&) = default;
};

/// The pair of two different bodies in the one order that the project knows.
constexpr Pair make_pair_of(BodyId one, BodyId other) {
  return one < other ? Pair{one, other} : Pair{other, one};
}

/// `(a << 32) | b`: one number a pair, ordered as pairs are.
constexpr std::uint64_t pair_key(Pair pair) {
  return (std::uint64_t{pair.a} << 32) | pair.b;
}

/// The finaliser of splitmix64: a bijection of 64-bit numbers in which every input bit moves every output
/// bit.
constexpr std::uint64_t mix64(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

/// The hash of a set of pairs: XOR over its pairs of `mix64(pair_key + 0x9e3779b97f4a7c15)`, so that order
/// does not matter. A pair listed twice cancels itself; compare the count too.
constexpr std::uint64_t pair_set_hash(std::span<const Pair> pairs) {
  std::uint64_t hash = 0;
  for (const Pair& pair : pairs) hash ^= mix64(pair_key(pair) + 0x9e3779b97f4a7c15ULL);
  return hash;
}

/// A hash as it is printed everywhere: sixteen lower-case hex digits.
CELLSWEEP_API std::string hash_text(std::uint64_t hash);

}  // namespace cellsweep
