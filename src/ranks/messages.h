/// @file
/// What ranks tell each other about bodies, as rows that are sent as they lie in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/filter.h"
#include "cellsweep/ranks.h"

namespace cellsweep::ranks {

/// A filter without holes.
struct FilterRow {
  std::uint32_t category = 1;
  std::uint32_t mask = 0xffffffffU;
  std::uint32_t is_static = 0;

  FilterRow() = default;
  FilterRow(const BodyFilter& filter)
      : category(filter.category), mask(filter.mask), is_static(filter.is_static ? 1 : 0) {}
  operator BodyFilter() const { return {category, mask, is_static != 0}; }
};

/// A body that the receiver has: its box now. All that most ghosts ever cost.
struct MoveRow {
  GlobalId id;
  Aabb box;
};

/// The same of a body with a small id, as most jobs have.
struct SmallMoveRow {
  std::uint32_t id;
  Aabb box;
};

/// A body in full: one that the receiver has not, or that is not what it was.
struct BodyRow {
  GlobalId id;
  Aabb box;
  Aabb box_before;
  FilterRow filter;
  FilterRow filter_before;
  std::uint32_t existed;  ///< at the last update, as `..._before`
  std::uint32_t renewed;  ///< and is another one now: removed and inserted again
};

/// A body that the receiver has no more, and what became of it.
struct LeaveRow {
  GlobalId id;
  Aabb box;
  FilterRow filter;
  std::uint16_t removed;  ///< nobody has it any more
  std::uint16_t renewed;  ///< as of BodyRow
};

/// A body that belongs to the receiver from now on, followed by the ranks that know of it: RankRow.
struct AdoptRow {
  GlobalId id;
  std::uint32_t ranks;
  std::uint32_t owner_before;  ///< at the last update
};

struct RankRow {
  std::uint32_t rank;
  std::uint32_t has_it;  ///< now; else it must be told that it has it no more
};

/// What became of a body, for its entry in the directory.
struct OwnerRow {
  GlobalId id;
  std::uint32_t owner;  ///< kNobody: it is gone
  std::uint32_t unused = 0;
};

inline constexpr std::uint32_t kNobodysBody = 0xffffffffU;

/// What another rank said of a body that the receiver owns; or, for the directory, that it wants to say it.
struct CallRow {
  GlobalId id;
  std::uint32_t giver;
  std::uint32_t must_exist;
  std::uint32_t inserted;
  std::uint32_t exists;
  std::uint32_t has_box;
  std::uint32_t has_filter;
  Aabb box;
  FilterRow filter;
  std::uint32_t unused = 0;
};

enum class Fault : std::uint32_t { unknown, duplicate, named_twice };

/// Why a call cannot be done, for the rank that made it.
struct FaultRow {
  GlobalId id;
  Fault fault;
  std::uint32_t other;  ///< rank that named the body, too
};

static_assert(sizeof(MoveRow) == 32 && sizeof(SmallMoveRow) == 28 && sizeof(BodyRow) == 88 &&
              sizeof(LeaveRow) == 48);
static_assert(sizeof(AdoptRow) == 16 && sizeof(CallRow) == 72);

inline constexpr std::size_t words_of(std::size_t bytes) {
  return (bytes + 7) / 8;
}

/// Rows of several kinds one behind the other, each kind with its number in front.
class MessageWriter {
 public:
  template <class Row>
  void write(std::span<const Row> rows) {
    static_assert(std::is_trivially_copyable_v<Row>);
    const std::uint64_t count = rows.size();
    append(&count, sizeof count);
    append(rows.data(), rows.size_bytes());
  }
  /// In words of eight bytes.
  std::vector<std::uint64_t> take() { return std::move(words_); }

 private:
  void append(const void* from, std::size_t bytes) {
    const std::size_t at = words_.size();
    words_.resize(at + words_of(bytes));
    if (bytes > 0) std::memcpy(words_.data() + at, from, bytes);
  }

  std::vector<std::uint64_t> words_;
};

/// Reads the rows in the order in which they were written.
class MessageReader {
 public:
  explicit MessageReader(std::span<const std::uint64_t> words) : words_(words) {}

  template <class Row>
  std::vector<Row> read() {
    std::vector<Row> rows(words_.front());
    if (!rows.empty())
      std::memcpy(static_cast<void*>(rows.data()), words_.data() + 1, rows.size() * sizeof(Row));
    words_ = words_.subspan(1 + words_of(rows.size() * sizeof(Row)));
    return rows;
  }

 private:
  std::span<const std::uint64_t> words_;
};

}  // namespace cellsweep::ranks
