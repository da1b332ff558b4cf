/// @file
/// Who finds all pairs of boxes in one call, structures and all, and what it is given.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/find_pairs.h"

namespace cellsweep::bench {

/// Boxes whose pairs are wanted: those among `a` if there is no `b`, else those of one from each.
struct BoxSets {
  std::vector<Aabb> a;
  std::vector<Aabb> b;
};

/// A search that is timed, and what it has found, which is not.
class Searcher {
 public:
  virtual ~Searcher() = default;

  virtual void find(const BoxSets& sets) = 0;
  /// In any order, of one set the smaller place first. A search that only counts lists none.
  virtual void list(std::vector<CrossPair>& pairs) const = 0;
  virtual std::size_t count() const = 0;
};

struct SearcherInfo {
  std::string_view name;
  bool takes_one_set = true;
  bool lists = true;
  std::unique_ptr<Searcher> (*make)() = nullptr;
};

/// `cellsweep` first.
std::span<const SearcherInfo> own_searchers();

/// CGAL's, in a program that is linked with it: its package is under the GPL.
std::span<const SearcherInfo> cgal_searchers();

}  // namespace cellsweep::bench
