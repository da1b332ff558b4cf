#include "ranks/directory.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "base/body_names.h"
#include "base/text.h"

namespace cellsweep::ranks {
namespace {

CallRow as_row(const StagedCall& call, int giver) {
  return {call.id,
          static_cast<std::uint32_t>(giver),
          call.must_exist ? 1U : 0U,
          call.inserted ? 1U : 0U,
          call.exists ? 1U : 0U,
          call.has_box ? 1U : 0U,
          call.has_filter ? 1U : 0U,
          call.box,
          call.filter};
}

// Whether the directory has to see a call: not of one's own bodies, nor what it has seen.
bool is_for_others(const HeldBodies& held, const StagedCall& call) {
  if (call.is_known) return false;
  const Local local = held.find(call.id);
  return local == kNoLocal || !held.is(local, kOwned);
}

// What one reason says of these bodies, or nothing.
Status describe(std::span<const FaultRow> faults, Fault fault) {
  std::vector<GlobalId> ids;
  std::uint32_t other = 0;
  for (const FaultRow& row : faults) {
    if (row.fault != fault) continue;
    ids.push_back(row.id);
    other = row.other;
  }
  if (ids.empty()) return {};
  std::ranges::sort(ids);
  Status status;
  status.number = ids.size();
  const std::string who = subject(std::span<const GlobalId>(ids));
  switch (fault) {
    case Fault::unknown:
      status.code = StatusCode::unknown_body;
      status.message = who + " in no rank's world.";
      break;
    case Fault::duplicate:
      status.code = StatusCode::duplicate_body;
      status.message = who + " in the world already.";
      break;
    case Fault::named_twice:
      status.code = StatusCode::bad_input;
      status.message = text(who, " named by rank ", other, ", too; between two updates one rank may.");
      break;
  }
  return status;
}

Status describe(std::span<const FaultRow> faults) {
  for (const Fault fault : {Fault::unknown, Fault::duplicate, Fault::named_twice}) {
    if (Status status = describe(faults, fault); !status.ok()) return status;
  }
  return {};
}

}  // namespace

void Directory::reserve(std::size_t more) {
  if (news_.size() + more > news_.capacity())
    news_.reserve(news_.size() + std::max(more, news_.capacity() / 2));
}

void Directory::tell(GlobalId id, bool is_gone) {
  news_.push_back({id, is_gone ? kNobodysBody : static_cast<std::uint32_t>(job_.rank())});
}

bool Directory::is_needed(const HeldBodies& held, const StagedCalls& calls) {
  return std::ranges::any_of(calls.calls(),
                             [&](const StagedCall& call) { return is_for_others(held, call); });
}

std::uint32_t Directory::owner_of(GlobalId id) const {
  const Slot place = places_.find(id);
  return place == kNoSlot ? kNobodysBody : owners_[place];
}

void Directory::set_owner(GlobalId id, std::uint32_t owner) {
  const Slot place = places_.find(id);
  if (owner == kNobodysBody) {
    if (place == kNoSlot) return;
    places_.erase(id);
    free_.push_back(place);
  } else if (place != kNoSlot) {
    owners_[place] = owner;
  } else if (free_.empty()) {
    places_.insert(id, static_cast<Slot>(owners_.size()));
    owners_.push_back(owner);
  } else {
    places_.insert(id, free_.back());
    owners_[free_.back()] = owner;
    free_.pop_back();
  }
}

Status Directory::exchange(std::vector<Message>& out, std::vector<Message>& in) {
  const auto is_of_others = [&](const Message& message) { return message.rank != job_.rank(); };
  const auto self = std::partition(out.begin(), out.end(), is_of_others);
  const std::span<Message> others(out.begin(), self);
  ++rounds_;
  messages_ += others.size();
  for (const Message& message : others) bytes_ += message.words.size() * sizeof(std::uint64_t);
  Status status = job_.exchange(others, in);
  return job_.agree([&] {
    in.insert(in.end(), std::make_move_iterator(self), std::make_move_iterator(out.end()));
    return status;
  });
}

template <class Row>
Status Directory::exchange_rows(const std::vector<std::vector<Row>>& out, std::vector<Row>& in) {
  std::vector<Message> messages;
  std::vector<Message> answers;
  Status status = job_.agree([&]() -> Status {
    for (std::size_t rank = 0; rank < out.size(); ++rank) {
      if (out[rank].empty()) continue;
      MessageWriter writer;
      writer.write(std::span<const Row>(out[rank]));
      messages.push_back({static_cast<int>(rank), writer.take()});
    }
    return {};
  });
  if (!status.ok()) return status;
  if (status = exchange(messages, answers); !status.ok()) return status;
  return job_.agree([&]() -> Status {
    for (const Message& answer : answers) {
      const auto rows = MessageReader(answer.words).read<Row>();
      in.insert(in.end(), rows.begin(), rows.end());
    }
    return {};
  });
}

// News first: what was told is as good as known.
Status Directory::ask(const HeldBodies& held, const StagedCalls& calls, Asked& asked) {
  const auto ranks = static_cast<std::size_t>(job_.ranks());
  std::vector<Message> out;
  std::vector<Message> in;
  Status status = job_.agree([&]() -> Status {
    std::vector<std::vector<OwnerRow>> news(ranks);
    std::vector<std::vector<CallRow>> rows(ranks);
    for (const OwnerRow& row : news_) {
      const Local local = held.find(row.id);
      const bool is_mine = local != kNoLocal && held.is(local, kOwned);
      if (is_mine == (row.owner != kNobodysBody))
        news[static_cast<std::size_t>(part_of(row.id))].push_back(row);
    }
    for (const StagedCall& call : calls.calls()) {
      if (is_for_others(held, call))
        rows[static_cast<std::size_t>(part_of(call.id))].push_back(as_row(call, job_.rank()));
    }
    for (std::size_t rank = 0; rank < ranks; ++rank) {
      if (news[rank].empty() && rows[rank].empty()) continue;
      MessageWriter writer;
      writer.write(std::span<const OwnerRow>(news[rank]));
      writer.write(std::span<const CallRow>(rows[rank]));
      out.push_back({static_cast<int>(rank), writer.take()});
    }
    return {};
  });
  if (!status.ok()) return status;
  if (status = exchange(out, in); !status.ok()) return status;
  status = job_.agree([&]() -> Status {
    std::vector<OwnerRow> news;
    for (const Message& message : in) {
      MessageReader reader(message.words);
      const auto told = reader.read<OwnerRow>();
      news.insert(news.end(), told.begin(), told.end());
      const auto rows = reader.read<CallRow>();
      asked.calls.insert(asked.calls.end(), rows.begin(), rows.end());
    }
    const std::size_t most = places_.size() + news.size() + asked.calls.size();
    places_.reserve(most);
    owners_.reserve(std::max(owners_.size(), most));
    free_.reserve(std::max(owners_.size(), most));
    take_news(news);
    asked.faults.resize(ranks);
    asked.forwarded.resize(ranks);
    judge(asked);
    return {};
  });
  if (status.ok()) news_.clear();
  return status;
}

// Some may be told again after an update that failed.
void Directory::take_news(std::span<const OwnerRow> news) {
  for (const OwnerRow& row : news) set_owner(row.id, row.owner);
}

void Directory::judge(Asked& asked) const {
  std::ranges::sort(asked.calls, {}, [](const CallRow& row) { return std::pair(row.id, row.giver); });
  for (std::size_t first = 0; first < asked.calls.size();) {
    std::size_t last = first + 1;
    while (last < asked.calls.size() && asked.calls[last].id == asked.calls[first].id) ++last;
    judge_body(std::span<const CallRow>(asked.calls).subspan(first, last - first), asked);
    first = last;
  }
}

void Directory::judge_body(std::span<const CallRow> calls, Asked& asked) const {
  const CallRow& call = calls.front();
  const std::uint32_t owner = owner_of(call.id);
  if (calls.size() > 1) {
    for (const CallRow& one : calls) {
      const CallRow& other = &one == &call ? calls[1] : call;
      asked.faults[one.giver].push_back({one.id, Fault::named_twice, other.giver});
    }
  } else if ((call.must_exist != 0) != (owner != kNobodysBody)) {
    asked.faults[call.giver].push_back(
        {call.id, call.must_exist != 0 ? Fault::unknown : Fault::duplicate, owner});
  } else if (call.must_exist != 0) {
    asked.forwarded[owner].push_back(call);
    return;
  } else {
    asked.inserted.push_back(call);
    return;
  }
  asked.any_fault = true;
}

// An owner that named the body itself says no.
Status Directory::bring(const HeldBodies& held, const StagedCalls& calls, const Asked& asked,
                        std::vector<CallRow>& mine, std::vector<std::vector<FaultRow>>& faults,
                        bool& any_fault) {
  if (Status status = exchange_rows(asked.forwarded, mine); !status.ok()) return status;
  Together together;
  Status status = job_.agree([&]() -> Status {
    faults.assign(static_cast<std::size_t>(job_.ranks()), {});
    for (const CallRow& call : mine) {
      const Local local = held.find(call.id);
      const bool is_named = calls.find(call.id) != nullptr || (local != kNoLocal && held.is(local, kNamed));
      if (!is_named && local != kNoLocal) continue;
      faults[call.giver].push_back(
          {call.id, is_named ? Fault::named_twice : Fault::unknown, static_cast<std::uint32_t>(job_.rank())});
      any_fault = true;
    }
    return {};
  });
  if (!status.ok()) return status;
  static_cast<void>(job_.agree(Status(), 0, any_fault, together));
  any_fault = together.any;
  return {};
}

// Those who made the calls forget them.
Status Directory::refuse(HeldBodies& held, StagedCalls& calls,
                         const std::vector<std::vector<FaultRow>>& faults) {
  std::vector<FaultRow> mine;
  if (Status status = exchange_rows(faults, mine); !status.ok()) return status;
  Status refusal;
  Status status = job_.agree([&]() -> Status {
    refusal = describe(mine);
    std::vector<GlobalId> ids;
    ids.reserve(mine.size());
    for (const FaultRow& row : mine) ids.push_back(row.id);
    if (ids.empty()) return {};
    calls.forget(ids);
    for (const GlobalId id : ids) {
      const Local local = held.find(id);
      if (local != kNoLocal) held.clear(local, kStaged);
    }
    return {};
  });
  if (!status.ok()) return status;
  return job_.agree(refusal);
}

Status Directory::resolve(HeldBodies& held, StagedCalls& calls) {
  messages_ = bytes_ = rounds_ = 0;
  Asked asked;
  if (Status status = ask(held, calls, asked); !status.ok()) return status;
  Together together;
  static_cast<void>(job_.agree(Status(), 0, asked.any_fault, together));
  if (together.any) return refuse(held, calls, asked.faults);
  std::vector<CallRow> mine;
  std::vector<std::vector<FaultRow>> faults;
  bool any_fault = false;
  if (Status status = bring(held, calls, asked, mine, faults, any_fault); !status.ok()) return status;
  if (any_fault) return refuse(held, calls, faults);
  StagedCalls kept;
  Status status = job_.agree([&]() -> Status {
    std::vector<GlobalId> sent;
    for (const StagedCall& call : calls.calls()) {
      if (call.must_exist && is_for_others(held, call)) sent.push_back(call.id);
    }
    kept = calls;
    kept.forget(sent);
    kept.reserve(mine.size());
    return {};
  });
  if (!status.ok()) return status;
  for (const CallRow& call : asked.inserted) {
    if (call.exists != 0) set_owner(call.id, call.giver);
  }
  for (StagedCall& call : kept.calls()) call.is_known = call.is_known || call.inserted;
  for (const StagedCall& call : calls.calls()) {
    const Local local = held.find(call.id);
    if (local != kNoLocal && kept.find(call.id) == nullptr) held.clear(local, kStaged);
  }
  for (const CallRow& call : mine) {
    kept.take_over({call.id, call.must_exist != 0, call.inserted != 0, call.exists != 0, false,
                    call.has_box != 0, call.has_filter != 0, call.box, call.filter});
    held.set(held.find(call.id), kStaged);
  }
  calls = std::move(kept);
  return {};
}

}  // namespace cellsweep::ranks
