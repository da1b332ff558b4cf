/// @file
/// The round of messages of an update: who has to know of which body, and what comes of what others tell.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cellsweep/ranks.h"
#include "ranks/cuts.h"
#include "ranks/directory.h"
#include "ranks/engine_plan.h"
#include "ranks/held_bodies.h"
#include "ranks/job.h"
#include "ranks/messages.h"
#include "ranks/staged_calls.h"

namespace cellsweep::ranks {

/// What a rank knows, as the next update will have it.
struct World {
  HeldBodies held{};
  StagedCalls calls{};
  EnginePlan plan{};
  std::vector<Handover> departed{};
  std::vector<Handover> arrived{};
};

/// What was told, counted in rows.
struct Told {
  std::uint64_t moves = 0;
  std::uint64_t enters = 0;
  std::uint64_t leaves = 0;
  std::uint64_t adoptions = 0;
  std::uint64_t messages = 0;
  std::uint64_t bytes = 0;
};

/// In this order: draft(), which finds out what to tell, exchange(), read(), reserve(), then apply(), which
/// cannot fail. Until then the world is as it was, and a round that is dropped has done nothing.
class Round {
 public:
  Round(const Job& job, const Cuts& cuts) : job_(job), cuts_(cuts) {}

  /// Of all links that were touched, and of new bodies. May throw std::bad_alloc.
  void draft(const World& world);
  /// Collective.
  Status exchange() { return job_.exchange(out_, in_); }
  /// What came. May throw std::bad_alloc.
  void read();
  /// Makes room in the world for all that apply() does. May throw std::bad_alloc.
  void reserve(World& world, Directory& directory);
  void apply(World& world, Directory& directory);

  /// Whether a body comes back that left this rank in an update which failed. Its pairs end and begin for the
  /// engine, with bodies that have no links, too. After read().
  bool has_return(const World& world) const;
  /// How many bodies the engine will have that has so many now. After read().
  std::size_t bodies_after(const World& world, std::size_t bodies) const;

  const Told& told() const { return told_; }

 private:
  /// Where a body of this rank is now.
  struct Place {
    std::vector<int> reached;  // other ranks
    bool stays = false;        // it reaches this one
    int home = 0;              // whose it is, if not
  };
  struct LinkDraft {
    Local local;
    Place place;
    std::vector<int> told;
  };
  struct InsertDraft {
    const StagedCall* call;
    Place place;
    std::vector<int> told;
  };
  /// To another rank.
  struct Out {
    std::vector<LeaveRow> leaves;
    std::vector<BodyRow> bodies;
    std::vector<MoveRow> moves;
    std::vector<SmallMoveRow> small_moves;
    std::vector<AdoptRow> adoptions;
    std::vector<RankRow> ranks;
    std::vector<OwnerRow> departures;
  };
  struct Adoption {
    AdoptRow row;
    std::vector<int> reached;
    std::vector<int> told;
  };

  Place place_of(const Aabb& box) const;
  void draft_link(const World& world, Local local);
  void tell_rank(GlobalId id, const Link& link, const Place& place, int rank);
  void draft_insert(const StagedCall& call);
  int tell_first_owner(const World& world, GlobalId id, int home);
  void hand_over(GlobalId id, const Place& place, const std::vector<int>& told, int owner_before);
  Out& out_to(int rank) { return outs_[static_cast<std::size_t>(rank)]; }
  void write_messages();
  void read_adoptions(std::span<const AdoptRow> rows, std::span<const RankRow> ranks);

  static void apply_link(World& world, Directory& directory, LinkDraft& draft);
  static void apply_insert(World& world, InsertDraft& draft);
  static void apply_leave(World& world, const LeaveRow& row);
  static void apply_body(World& world, const BodyRow& row);
  static void apply_move(World& world, const MoveRow& row);
  void forget_departure(World& world, GlobalId id);
  void apply_adoption(World& world, Directory& directory, Adoption& adoption);
  static void insert_into_engine(World& world, Local local, const Link& link);

  const Job& job_;
  const Cuts& cuts_;
  mutable std::vector<int> reached_;
  std::vector<LinkDraft> links_;
  std::vector<InsertDraft> inserts_;
  std::vector<Out> outs_;
  std::vector<Message> out_;
  std::vector<Message> in_;
  std::vector<LeaveRow> leaves_;
  std::vector<BodyRow> bodies_;
  std::vector<MoveRow> moves_;
  std::vector<Adoption> adoptions_;
  std::vector<OwnerRow> departures_;
  std::size_t departed_before_ = 0;  // with updates that failed
  std::vector<GlobalId> new_ids_;    // ascending
  Told told_;
};

}  // namespace cellsweep::ranks
