/// @file
/// The bodies that this rank's engine has: global ids and the engine's own, whose they are, and of those that
/// other ranks know, too, what these know.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/sparse_table.h"
#include "cellsweep/aabb.h"
#include "cellsweep/ranks.h"
#include "ranks/messages.h"

namespace cellsweep::ranks {

/// What a body is called in this rank's engine: its place in arrays.
using Local = BodyId;
inline constexpr Local kNoLocal = kNoSlot;

/// Of a body at one time.
struct Version {
  Aabb box{};
  FilterRow filter{};
  bool exists = false;
};

/// A body that reaches other regions, too, or did at the last update, or is another rank's: a pair of two
/// such bodies may be found by several ranks. Also one that was inserted anew, removed or given another
/// filter.
struct Link {
  Version now{};               ///< as it will be with the next update
  Version before{};            ///< as it was at the last one
  bool renewed = false;        ///< removed and inserted again: another body since
  bool must_renew = false;     ///< and the engine has not been told
  bool must_filter = false;    ///< it got a filter since ranks and the engine were told last
  bool must_tell = false;      ///< it has changed since ranks were told last
  std::vector<int> reached{};  ///< of its owner: other ranks that have it
  std::vector<int> told{};     ///< and, with them, those that had it at the last update
};

// What is known of a local body, in bits.
enum : std::uint8_t {
  kHeld = 1,               ///< the engine will have it with the next update
  kOwned = 2,              ///< it belongs to this rank, from the next update on
  kLinked = 4,             ///< it has a Link
  kTouched = 8,            ///< it is in touched()
  kNamed = 16,             ///< a call of this rank named it since the last update
  kStaged = 32,            ///< and waits among the staged calls
  kWasOwned = kOwned << 5  ///< it belonged to this rank at the last update
};

std::uint64_t new_table_key();

/// Rows in a std::vector of the standard's own, whose memory is nobody's special concern.
template <class T>
using PlainRows = std::vector<T>;
using GlobalTable = SparseTable<GlobalId, PlainRows, new_table_key>;

/// Whatever needs memory has a reserve...() that takes it; then it cannot fail.
class HeldBodies {
 public:
  /// The local name of a body, or kNoLocal.
  Local find(GlobalId id) const { return table_.find(id); }
  /// Whether that is its local name, which may be any number.
  bool has(Local local, GlobalId id) const {
    return local < ids_.size() && ids_[local] == id && flags_[local] != 0;
  }

  std::size_t locals() const { return ids_.size(); }
  GlobalId id(Local local) const { return ids_[local]; }
  const GlobalId* ids() const { return ids_.data(); }
  std::uint8_t flags(Local local) const { return flags_[local]; }
  const std::uint8_t* flags() const { return flags_.data(); }
  bool is(Local local, std::uint8_t flag) const { return (flags_[local] & flag) != 0; }
  void set(Local local, std::uint8_t flag) { flags_[local] |= flag; }
  void clear(Local local, std::uint8_t flag) { flags_[local] &= static_cast<std::uint8_t>(~flag); }
  std::size_t count(std::uint8_t flag) const;
  void clear_all(std::uint8_t flag);
  /// After an update: kWasOwned are those that are kOwned.
  void commit_flags();

  /// Room for so many more bodies and links, and so many more that are touched.
  void reserve(std::size_t bodies, std::size_t links);

  /// A body that is not there; it must get a flag.
  Local add(GlobalId id);
  void forget(Local local);

  Link& link(Local local) { return links_[link_of_[local]]; }
  const Link& link(Local local) const { return links_[link_of_[local]]; }
  /// The body's link, a new one where it has none.
  Link& make_link(Local local);
  void drop_link(Local local);

  /// The body's link has changed since the last update.
  void touch(Local local);
  std::span<const Local> touched() const { return touched_; }
  void clear_touched();

  std::size_t bytes() const;

 private:
  GlobalTable table_;
  std::vector<GlobalId> ids_;
  std::vector<std::uint8_t> flags_;     // 0: nobody is there
  std::vector<std::uint32_t> link_of_;  // of those that have one
  std::vector<Local> free_;
  std::vector<Link> links_;
  std::vector<std::uint32_t> free_links_;
  std::vector<Local> touched_;
};

}  // namespace cellsweep::ranks
