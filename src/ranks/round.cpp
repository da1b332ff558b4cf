#include "ranks/round.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace cellsweep::ranks {
namespace {

// Ascending lists.
bool contains(const std::vector<int>& ranks, int rank) {
  return std::ranges::binary_search(ranks, rank);
}

std::vector<int> either(const std::vector<int>& one, const std::vector<int>& other) {
  std::vector<int> both;
  std::ranges::set_union(one, other, std::back_inserter(both));
  return both;
}

BodyRow as_row(GlobalId id, const Link& link) {
  return {id,
          link.now.box,
          link.before.box,
          link.now.filter,
          link.before.filter,
          link.before.exists ? 1U : 0U,
          link.renewed ? 1U : 0U};
}

}  // namespace

Round::Place Round::place_of(const Aabb& box) const {
  cuts_.find_reached(box, reached_);
  Place place;
  place.stays = contains(reached_, job_.rank());
  place.home = place.stays ? job_.rank() : cuts_.home_of(box.min);
  place.reached.reserve(reached_.size());
  std::ranges::remove_copy(reached_, std::back_inserter(place.reached), job_.rank());
  return place;
}

void Round::draft(const World& world) {
  outs_.resize(static_cast<std::size_t>(job_.ranks()));
  for (const Local local : world.held.touched()) {
    if (world.held.is(local, kOwned)) draft_link(world, local);
  }
  for (const StagedCall& call : world.calls.calls()) {
    if (call.inserted && !call.must_exist) draft_insert(call);
  }
  write_messages();
}

void Round::draft_link(const World& world, Local local) {
  const Link& link = world.held.link(local);
  const GlobalId id = world.held.id(local);
  Place place;
  if (link.now.exists) place = place_of(link.now.box);
  std::vector<int> told = either(link.told, place.reached);
  for (const int rank : told) tell_rank(id, link, place, rank);
  if (link.now.exists && !place.stays) {
    told.insert(std::ranges::lower_bound(told, job_.rank()), job_.rank());
    hand_over(id, place, told, tell_first_owner(world, id, place.home));
  }
  links_.push_back({local, std::move(place), std::move(told)});
}

void Round::tell_rank(GlobalId id, const Link& link, const Place& place, int rank) {
  Out& out = out_to(rank);
  if (!contains(place.reached, rank)) {
    out.leaves.push_back({id, link.now.box, link.now.filter, static_cast<std::uint16_t>(!link.now.exists),
                          static_cast<std::uint16_t>(link.renewed)});
  } else if (!contains(link.reached, rank)) {
    out.bodies.push_back(as_row(id, link));
    ++told_.enters;
  } else if (link.must_renew || link.must_filter) {
    out.bodies.push_back(as_row(id, link));
  } else if (link.must_tell && id <= std::numeric_limits<std::uint32_t>::max()) {
    out.small_moves.push_back({static_cast<std::uint32_t>(id), link.now.box});
  } else if (link.must_tell) {
    out.moves.push_back({id, link.now.box});
  }
}

void Round::draft_insert(const StagedCall& call) {
  Place place = place_of(call.box);
  for (const int rank : place.reached) {
    out_to(rank).bodies.push_back({call.id, call.box, {}, call.filter, {}, 0, 0});
    ++told_.enters;
  }
  std::vector<int> told = place.reached;
  if (!place.stays) hand_over(call.id, place, told, job_.rank());
  inserts_.push_back({&call, std::move(place), std::move(told)});
}

// Where a body was adopted by an update that failed, its owner of before is told who has it in the end.
int Round::tell_first_owner(const World& world, GlobalId id, int home) {
  const auto adopted = std::ranges::find(world.arrived, id, &Handover::id);
  if (adopted == world.arrived.end()) return job_.rank();
  if (adopted->rank != home)
    out_to(adopted->rank).departures.push_back({id, static_cast<std::uint32_t>(home)});
  return adopted->rank;
}

void Round::hand_over(GlobalId id, const Place& place, const std::vector<int>& told, int owner_before) {
  Out& out = out_to(place.home);
  out.adoptions.push_back(
      {id, static_cast<std::uint32_t>(told.size()), static_cast<std::uint32_t>(owner_before)});
  for (const int rank : told)
    out.ranks.push_back({static_cast<std::uint32_t>(rank), contains(place.reached, rank) ? 1U : 0U});
}

void Round::write_messages() {
  for (int rank = 0; rank < job_.ranks(); ++rank) {
    const Out& out = out_to(rank);
    const std::size_t rows = out.leaves.size() + out.bodies.size() + out.moves.size() +
                             out.small_moves.size() + out.adoptions.size() + out.departures.size();
    if (rows == 0) continue;
    MessageWriter writer;
    writer.write(std::span<const LeaveRow>(out.leaves));
    writer.write(std::span<const BodyRow>(out.bodies));
    writer.write(std::span<const MoveRow>(out.moves));
    writer.write(std::span<const SmallMoveRow>(out.small_moves));
    writer.write(std::span<const AdoptRow>(out.adoptions));
    writer.write(std::span<const RankRow>(out.ranks));
    writer.write(std::span<const OwnerRow>(out.departures));
    out_.push_back({rank, writer.take()});
    told_.leaves += out.leaves.size();
    told_.moves += out.moves.size() + out.small_moves.size();
    told_.adoptions += out.adoptions.size();
    told_.bytes += out_.back().words.size() * sizeof(std::uint64_t);
    ++told_.messages;
  }
  outs_ = {};
}

void Round::read() {
  for (const Message& message : in_) {
    MessageReader reader(message.words);
    const auto append = [](auto& to, const auto& rows) { to.insert(to.end(), rows.begin(), rows.end()); };
    append(leaves_, reader.read<LeaveRow>());
    append(bodies_, reader.read<BodyRow>());
    append(moves_, reader.read<MoveRow>());
    for (const auto& [id, box] : reader.read<SmallMoveRow>()) moves_.push_back({id, box});
    const auto adoptions = reader.read<AdoptRow>();
    read_adoptions(adoptions, reader.read<RankRow>());
    append(departures_, reader.read<OwnerRow>());
  }
  in_ = {};
}

void Round::reserve(World& world, Directory& directory) {
  const std::size_t inserts = inserts_.size();
  const auto note_new = [&](GlobalId id) {
    if (world.held.find(id) == kNoLocal) new_ids_.push_back(id);
  };
  for (const InsertDraft& draft : inserts_) {
    if (draft.place.stays) note_new(draft.call->id);
  }
  for (const BodyRow& row : bodies_) note_new(row.id);
  std::ranges::sort(new_ids_);
  new_ids_.erase(std::unique(new_ids_.begin(), new_ids_.end()), new_ids_.end());
  world.held.reserve(inserts + bodies_.size(), inserts + bodies_.size());
  world.plan.reserve(links_.size() + inserts + leaves_.size() + bodies_.size() + moves_.size());
  world.departed.reserve(world.departed.size() + links_.size() + inserts);
  world.arrived.reserve(world.arrived.size() + adoptions_.size());
  directory.reserve(adoptions_.size() + links_.size() + inserts);
}

bool Round::has_return(const World& world) const {
  const HeldBodies& held = world.held;
  const auto returns = [&](Local local) {
    return local != kNoLocal && !held.is(local, kHeld) && held.link(local).before.exists;
  };
  return std::ranges::any_of(links_, [&](const LinkDraft& draft) { return returns(draft.local); }) ||
         std::ranges::any_of(bodies_, [&](const BodyRow& row) { return returns(held.find(row.id)); });
}

std::size_t Round::bodies_after(const World& world, std::size_t bodies) const {
  const auto is_held = [&](Local local) { return local != kNoLocal && world.held.is(local, kHeld); };
  for (const LinkDraft& draft : links_) {
    const bool stays = draft.place.stays && world.held.link(draft.local).now.exists;
    bodies += stays ? 1U : 0U;
    bodies -= is_held(draft.local) ? 1U : 0U;
  }
  for (const InsertDraft& draft : inserts_) bodies += draft.place.stays ? 1U : 0U;
  for (const BodyRow& row : bodies_) bodies += is_held(world.held.find(row.id)) ? 0U : 1U;
  for (const LeaveRow& row : leaves_) bodies -= is_held(world.held.find(row.id)) ? 1U : 0U;
  return bodies;
}

void Round::read_adoptions(std::span<const AdoptRow> rows, std::span<const RankRow> ranks) {
  for (const AdoptRow& row : rows) {
    Adoption& adoption = adoptions_.emplace_back();
    adoption.row = row;
    for (const RankRow& known : ranks.first(row.ranks)) {
      const int rank = static_cast<int>(known.rank);
      if (rank == job_.rank()) continue;
      adoption.told.push_back(rank);
      if (known.has_it != 0) adoption.reached.push_back(rank);
    }
    ranks = ranks.subspan(row.ranks);
  }
}

// Who leaves goes before who comes: a body may do both, with two ranks. New bodies get local names in the
// order of their ids, in which most callers name them.
void Round::apply(World& world, Directory& directory) {
  departed_before_ = world.departed.size();
  for (const GlobalId id : new_ids_) world.held.add(id);
  for (LinkDraft& draft : links_) apply_link(world, directory, draft);
  for (InsertDraft& draft : inserts_) apply_insert(world, draft);
  for (const LeaveRow& row : leaves_) apply_leave(world, row);
  for (const BodyRow& row : bodies_) apply_body(world, row);
  for (const MoveRow& row : moves_) apply_move(world, row);
  for (Adoption& adoption : adoptions_) apply_adoption(world, directory, adoption);
  for (const OwnerRow& row : departures_) {
    for (Handover& handover : world.departed) {
      if (handover.id == row.id) handover.rank = static_cast<int>(row.owner);
    }
  }
  world.calls.clear();
}

void Round::insert_into_engine(World& world, Local local, const Link& link) {
  world.plan.insert(local, link.now.box, link.now.filter);
  world.held.set(local, kHeld);
}

void Round::apply_link(World& world, Directory& directory, LinkDraft& draft) {
  HeldBodies& held = world.held;
  Link& link = held.link(draft.local);
  const bool is_held = held.is(draft.local, kHeld);
  if (!link.now.exists || !draft.place.stays) {
    if (is_held) world.plan.remove(draft.local);
    held.clear(draft.local, kHeld | kOwned);
    const GlobalId id = held.id(draft.local);
    if (!link.now.exists) {
      directory.tell(id, true);
    } else {
      if (std::erase_if(world.arrived, [&](const Handover& handover) { return handover.id == id; }) == 0)
        world.departed.push_back({id, draft.place.home});
    }
  } else if (!is_held) {
    insert_into_engine(world, draft.local, link);
  } else if (link.must_renew) {
    world.plan.remove(draft.local);
    insert_into_engine(world, draft.local, link);
  } else if (link.must_tell) {
    if (link.must_filter) world.plan.set_filter(draft.local, link.now.filter);
    world.plan.move(draft.local, link.now.box);
  }
  link.must_renew = link.must_filter = link.must_tell = false;
  link.reached = std::move(draft.place.reached);
  link.told = std::move(draft.told);
}

void Round::apply_insert(World& world, InsertDraft& draft) {
  const StagedCall& call = *draft.call;
  if (!draft.place.stays) {
    world.departed.push_back({call.id, draft.place.home});
    return;
  }
  HeldBodies& held = world.held;
  const Local local = held.find(call.id);
  const bool comes_again = held.flags(local) != 0;  // another body of this id goes with the same update
  held.set(local, kHeld | kOwned);
  world.plan.insert(local, call.box, call.filter);
  if (!comes_again && draft.place.reached.empty()) return;
  Link& link = held.make_link(local);
  link.now = {call.box, call.filter, true};
  link.renewed = comes_again;
  link.reached = std::move(draft.place.reached);
  link.told = std::move(draft.told);
  held.touch(local);
}

void Round::apply_leave(World& world, const LeaveRow& row) {
  HeldBodies& held = world.held;
  const Local local = held.find(row.id);
  if (local == kNoLocal) return;  // told of a body that came and went before it was held
  Link& link = held.link(local);
  link.now = {row.box, row.filter, row.removed == 0};
  link.renewed = link.renewed || row.renewed != 0;
  if (held.is(local, kHeld)) world.plan.remove(local);
  held.clear(local, kHeld);
  held.touch(local);
}

void Round::apply_body(World& world, const BodyRow& row) {
  HeldBodies& held = world.held;
  const Local local = held.find(row.id);
  const bool is_new = held.flags(local) == 0;
  Link& link = held.make_link(local);
  if (is_new) link.before = {row.box_before, row.filter_before, row.existed != 0};
  link.renewed = link.renewed || row.renewed != 0 || (!is_new && !link.now.exists);
  link.now = {row.box, row.filter, true};
  if (held.is(local, kHeld) && row.renewed == 0) {
    world.plan.set_filter(local, row.filter);
    world.plan.move(local, row.box);
  } else {
    if (held.is(local, kHeld)) world.plan.remove(local);
    insert_into_engine(world, local, link);
  }
  held.touch(local);
}

void Round::apply_move(World& world, const MoveRow& row) {
  const Local local = world.held.find(row.id);
  world.held.link(local).now.box = row.box;
  world.plan.move(local, row.box);
  world.held.touch(local);
}

// A body that departed with an update that failed comes back with this one; it does not do both in one round.
void Round::forget_departure(World& world, GlobalId id) {
  const auto end = world.departed.begin() + static_cast<std::ptrdiff_t>(departed_before_);
  const auto found = std::ranges::find(world.departed.begin(), end, id, &Handover::id);
  if (found == end) return;
  world.departed.erase(found);
  --departed_before_;
}

void Round::apply_adoption(World& world, Directory& directory, Adoption& adoption) {
  const GlobalId id = adoption.row.id;
  const Local local = world.held.find(id);
  world.held.set(local, kOwned);
  Link& link = world.held.link(local);
  link.reached = std::move(adoption.reached);
  link.told = std::move(adoption.told);
  world.held.touch(local);
  directory.tell(id, false);
  const int before = static_cast<int>(adoption.row.owner_before);
  forget_departure(world, id);
  if (before != job_.rank()) world.arrived.push_back({id, before});
}

}  // namespace cellsweep::ranks
