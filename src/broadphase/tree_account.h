/// @file
/// What a tree for queries costs, and what questions have paid for it.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace cellsweep {

/// Counts in looks: what questions without a tree take longer than in one, a nanosecond or so. From any
/// number of threads: pay(). What the caller of KeptTree::begin() may do: made() to lost(). While nobody
/// asks: the rest.
///
/// A tree is made once all questions have paid for it, and brought up to date after an update once those
/// since then have paid for that. What they paid beyond the price of bringing a tree up to date is saved for
/// making one: worlds in which few bodies change get one after some updates, and those in which it would not
/// pay never do.
class TreeAccount {
 public:
  /// Whether the price of a tree for this update is paid now.
  bool pay(std::uint64_t looks) {
    return paid_.fetch_add(looks, std::memory_order_relaxed) + looks >=
           price_.load(std::memory_order_relaxed);
  }

  void made();
  void brought_up_to_date() { spent_ += update_price_; }
  /// Whether to bring the tree up to date again and again has cost as much as another one.
  bool has_paid_off() const { return spent_ >= make_price_; }
  /// It reaches too far by now. Where it was saved for over many updates, and did not pay off, half as much
  /// is saved for another one from now on; what the questions of one update pay counts as before.
  void wears_out();
  /// There is no tree any more, and what was paid is forgotten.
  void lost();

  /// An update that changed so many of the bodies. `had_tree`: there was one for the update before.
  void begin_update(std::size_t changes, std::size_t bodies, bool had_tree);
  /// There is a tree to be brought up to date after so many changes.
  void expect_changes(std::size_t changes, std::size_t bodies, bool had_tree);

  /// From how many changes on all bodies of a tree are gone through.
  static std::size_t few_of(std::size_t bodies);

 private:
  void save(std::uint64_t paid);

  std::atomic<std::uint64_t> paid_ = 0;  // since the update, and what was saved before
  std::atomic<std::uint64_t> price_ = 0;
  std::uint64_t make_price_ = 0;    // of a tree
  std::uint64_t change_price_ = 0;  // of bringing one up to date if this update alone had changed anything
  std::uint64_t update_price_ = 0;  // of bringing the one that there is up to date
  std::uint64_t spent_ = 0;         // on that, since it was made
  std::uint64_t saved_ = 0;         // for another one, before the update
  unsigned saving_ = 0;             // over so many updates
  bool was_saved_for_ = false;      // over many
  unsigned halved_ = 0;             // times that what is saved was
};

}  // namespace cellsweep
