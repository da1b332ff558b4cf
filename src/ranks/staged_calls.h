/// @file
/// Calls that wait for an update, one for each body, into which all that was said of it is put together.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "cellsweep/ranks.h"
#include "cellsweep/status.h"
#include "ranks/held_bodies.h"

namespace cellsweep::ranks {

/// What becomes of a body.
struct StagedCall {
  GlobalId id = 0;
  bool must_exist = false;  ///< when the update comes; else it must not
  bool inserted = false;    ///< it is a new body
  bool exists = true;       ///< in the end
  bool is_known = false;    ///< the directory knows of the new body
  bool has_box = false;
  bool has_filter = false;
  Aabb box{};  ///< canonical
  FilterRow filter{};
};

/// Whatever needs memory has a reserve() before it; then it cannot fail.
class StagedCalls {
 public:
  bool empty() const { return calls_.empty(); }
  std::span<const StagedCall> calls() const { return calls_; }
  std::span<StagedCall> calls() { return calls_; }
  /// The call for a body; null when there is none.
  const StagedCall* find(GlobalId id) const;

  void reserve(std::size_t more);
  /// Into the body's call, or a new one.
  void insert(GlobalId id, const Aabb& box, const FilterRow& filter);
  void move(GlobalId id, const Aabb& box);
  void set_filter(GlobalId id, const FilterRow& filter);
  void remove(GlobalId id);
  /// That of another rank, for a body without one.
  void take_over(const StagedCall& call) { call_for(call.id, call.must_exist) = call; }

  /// Of these bodies, in any order. May throw std::bad_alloc, and has done nothing then.
  void forget(std::vector<GlobalId> ids);
  void clear();

 private:
  StagedCall& call_for(GlobalId id, bool must_exist);

  GlobalTable places_;
  std::vector<StagedCall> calls_;
};

}  // namespace cellsweep::ranks
