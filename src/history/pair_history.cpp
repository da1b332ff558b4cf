#include "cellsweep/pair_history.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "base/memory/array.h"
#include "base/pairs/pair_of.h"
#include "base/text.h"
#include "history/queue.h"

namespace cellsweep {
namespace {

/// What one update changed: so many of the pairs that are remembered, those that ended first.
struct UpdateNote {
  std::uint64_t number = 0;
  std::size_t ended = 0;
  std::size_t began = 0;

  std::size_t size() const { return ended + began; }
};

/// A change and its place among all that are looked at, twice, and 1 more where the pair began.
struct PlacedChange {
  std::uint64_t key = 0;
  std::uint64_t place = 0;

  bool is_begin() const { return place % 2 == 1; }
};

std::size_t count_changes(std::span<const UpdateNote> notes) {
  std::size_t count = 0;
  for (const UpdateNote& note : notes) count += note.size();
  return count;
}

/// The changes of these updates, those of each pair one behind the other, in the order in which they came.
void list_by_pair(std::span<const UpdateNote> notes, std::span<const Pair> pairs,
                  Array<PlacedChange>& changes) {
  changes.renew(pairs.size());
  std::size_t i = 0;
  const auto add = [&](std::size_t count, std::uint64_t begin) {
    for (const std::size_t end = i + count; i < end; ++i)
      changes.data()[i] = {pair_key(pairs[i]), 2 * std::uint64_t{i} + begin};
  };
  for (const UpdateNote& note : notes) {
    add(note.ended, 0);
    add(note.began, 1);
  }
  const std::span<PlacedChange> all = changes.view();
  std::sort(all.begin(), all.end(), [](const PlacedChange& one, const PlacedChange& other) {
    return one.key != other.key ? one.key < other.key : one.place < other.place;
  });
}

}  // namespace

class PairHistory::Impl {
 public:
  explicit Impl(std::size_t most_pairs) : most_pairs_(most_pairs) {}

  Status record(std::uint64_t number, const PairChanges& changes) {
    if (latest_ && number != *latest_ + 1) return out_of_order(number);
    const UpdateNote note{number, changes.ended.size(), changes.began.size()};
    // Nobody can ask for what was before update 0.
    const bool is_kept = note.size() > 0 && note.size() <= most_pairs_ && number > 0;
    if (is_kept) {
      updates_.make_room(1);
      pairs_.make_room(note.size());
    }
    // Nothing fails from here on.
    if (!latest_) oldest_ = number > 0 ? number - 1 : 0;
    latest_ = number;
    if (note.size() > most_pairs_) oldest_ = number;
    make_way(is_kept ? note.size() : 0);
    if (!is_kept) return {};
    updates_.push(note);
    for (const Pair& pair : changes.ended) pairs_.push(pair);
    for (const Pair& pair : changes.began) pairs_.push(pair);
    return {};
  }

  Result<PairChanges> since(std::uint64_t number) {
    if (!latest_ || number > *latest_) return not_recorded(number);
    if (number < oldest_) return forgotten(number);
    const std::span<const UpdateNote> all = updates_.view();
    const auto first =
        std::upper_bound(all.begin(), all.end(), number,
                         [](std::uint64_t wanted, const UpdateNote& note) { return wanted < note.number; });
    const std::span<const UpdateNote> notes(first, all.end());
    Array<PlacedChange> changes;
    list_by_pair(notes, pairs_.view().last(count_changes(notes)), changes);
    return take_net(changes.view());
  }

 private:
  // Forgets the oldest updates until there may be so many changes more, and those before the oldest.
  void make_way(std::size_t more) {
    while (updates_.size() > 0) {
      const UpdateNote& first = updates_.view().front();
      if (first.number > oldest_ && pairs_.size() + more <= most_pairs_) return;
      oldest_ = std::max(oldest_, first.number);
      pairs_.pop(first.size());
      updates_.pop(1);
    }
  }

  // The first change of a pair says whether it overlapped before all of them, the last whether it does now.
  PairChanges take_net(std::span<const PlacedChange> changes) {
    Array<Pair> began, ended;
    began.renew(changes.size());
    ended.renew(changes.size());
    std::size_t begins = 0, ends = 0;
    for (std::size_t i = 0; i < changes.size(); ++i) {
      const bool is_first = i == 0 || changes[i - 1].key != changes[i].key;
      const bool is_last = i + 1 == changes.size() || changes[i + 1].key != changes[i].key;
      const Pair pair = pair_of<Pair>(changes[i].key);
      if (is_first && !changes[i].is_begin()) ended.data()[ends++] = pair;
      if (is_last && changes[i].is_begin()) began.data()[begins++] = pair;
    }
    began.shrink(begins);
    ended.shrink(ends);
    began_ = std::move(began);
    ended_ = std::move(ended);
    return {std::as_const(began_).view(), std::as_const(ended_).view()};
  }

  Status out_of_order(std::uint64_t number) const {
    return Status::bad_input(text("Update ", number, " was to be recorded after update ", *latest_,
                                  "; each one's number is that of the one before and 1, and one who left an "
                                  "update out begins with a new history."),
                             {}, number, *latest_ + 1);
  }
  Status not_recorded(std::uint64_t number) const {
    const std::string last = latest_ ? text("the last one recorded is ", *latest_) : "none is recorded";
    return Status::bad_input(text("What changed since update ", number, " was asked for, but ", last, "."),
                             {}, number, latest_.value_or(0));
  }
  Status forgotten(std::uint64_t number) const {
    return Status::over_capacity(
        text("What changed since update ", number, " was asked for, but the oldest that is remembered is ",
             oldest_, ": begin anew with all pairs, and raise most_pairs, which is ", most_pairs_,
             ", to remember more."),
        number, oldest_, "most_pairs");
  }

  std::size_t most_pairs_;
  std::uint64_t oldest_ = 0;  // that since() may be asked for
  std::optional<std::uint64_t> latest_;
  Queue<UpdateNote> updates_;  // those since the oldest that changed anything
  Queue<Pair> pairs_;          // theirs, one update's behind the other's
  Array<Pair> began_;          // what since() handed out
  Array<Pair> ended_;
};

PairHistory::PairHistory(std::size_t most_pairs) : impl_(std::make_unique<Impl>(most_pairs)) {}
PairHistory::PairHistory(PairHistory&& other) noexcept = default;
PairHistory& PairHistory::operator=(PairHistory&& other) noexcept = default;
PairHistory::~PairHistory() = default;

Status PairHistory::record(std::uint64_t update_number, const PairChanges& changes) {
  return impl_->record(update_number, changes);
}

Result<PairChanges> PairHistory::since(std::uint64_t update_number) {
  return impl_->since(update_number);
}

}  // namespace cellsweep
