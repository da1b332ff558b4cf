#include "engines/cell/spu/paper/change_detection.h"

#include <vmx2spu.h>

#include "engines/cell/wire.h"

namespace cellsweep::cell::paper {
namespace {

inline vec_uint4 ids_at(const std::uint32_t* ids, std::uint32_t i) {
  return reinterpret_cast<const vec_uint4*>(ids)[i];
}

inline vec_uint4 equal_values(const BeforeAndAfter& axis, std::uint32_t i) {
  return (vec_uint4)vec_cmpeq(reinterpret_cast<const vec_float4*>(axis.values_before)[i],
                              reinterpret_cast<const vec_float4*>(axis.values_after)[i]);
}

}  // namespace

void order_equal_values(const float* values, std::uint32_t* ids, std::uint32_t count) {
  for (std::uint32_t i = 1; i < count; ++i) {
    const std::uint32_t id = ids[i];
    std::uint32_t j = i;
    for (; j > 0 && values[j - 1] == values[i] && ids[j - 1] > id; --j) ids[j] = ids[j - 1];
    ids[j] = id;
  }
}

void compare_changes(const BeforeAndAfter& axis, std::uint32_t* ids) {
  const vec_uint4 plain = {~kMaximumFlag, ~kMaximumFlag, ~kMaximumFlag, ~kMaximumFlag};
  for (std::uint32_t i = 0; i < axis.count / kLanes; ++i) {
    const vec_uint4 before = ids_at(ids, i);
    const auto equal_ids = (vec_uint4)vec_cmpeq(before, ids_at(axis.ids_after, i));
    const vec_uint4 unchanged = vec_and(equal_values(axis, i), equal_ids);
    reinterpret_cast<vec_uint4*>(ids)[i] = vec_or(vec_and(before, plain), unchanged);
  }
}

void compare_changes_literal(const BeforeAndAfter& axis, std::uint32_t* ids) {
  for (std::uint32_t i = 0; i < axis.count / kLanes; ++i) {
    reinterpret_cast<vec_uint4*>(ids)[i] = vec_or(ids_at(ids, i), equal_values(axis, i));
  }
}

void mark_all_changed(std::uint32_t* ids, std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) {
    if (ids[i] != kUnchanged) ids[i] &= ~kMaximumFlag;
  }
}

}  // namespace cellsweep::cell::paper
