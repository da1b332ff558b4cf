/// @file
/// Boxes for the contract suite: one generator for each way in which a broadphase goes wrong.
#pragma once

#include <cstddef>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cellsweep/aabb.h"
#include "contract/random.h"

namespace cellsweep::contract {

/// A family of boxes.
struct BoxKind {
  std::string_view name;
  /// A box for the body `index` of `count`; any order of calls is fine.
  Aabb (*make)(Random& random, std::size_t index, std::size_t count);
  /// False when scaling by a power of two could overflow or run into denormals.
  bool scalable = true;
};

/// All families, each with the same chance in the tests that choose.
std::span<const BoxKind> box_kinds();

/// The family of that name; throws std::invalid_argument when there is none.
const BoxKind& box_kind(std::string_view name);

/// Boxes for `count` bodies.
std::vector<Aabb> make_boxes(const BoxKind& kind, Random& random, std::size_t count);

/// A next box for a body that has `box`: the same, a little aside, against a face of `other`, equal to
/// `other`, grown around `other`, or a new one of the kind. Always finite with min <= max.
Aabb next_box(const BoxKind& kind, Random& random, const Aabb& box, const Aabb& other);

/// The canonical values that the contract promises to work with, written apart from the library's own.
Aabb canonical_box(const Aabb& box);

/// `[min x, max x] × [min y, max y] × [min z, max z]`, in digits that name each float uniquely.
std::string box_text(const Aabb& box);

std::ostream& operator<<(std::ostream& out, const BoxKind& kind);

}  // namespace cellsweep::contract
