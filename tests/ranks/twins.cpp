#include "ranks/twins.h"

#include <algorithm>
#include <sstream>

#include "ranks/job.h"

namespace cellsweep::ranks {
namespace {

std::vector<GlobalId> global_ids(std::span<const BodyId> ids) {
  std::vector<GlobalId> global;
  for (const BodyId id : ids) global.push_back(global_id(id));
  return global;
}

std::vector<GlobalPair> global_pairs(std::span<const Pair> pairs) {
  std::vector<GlobalPair> global;
  for (const auto& [a, b] : pairs) global.push_back({global_id(a), global_id(b)});
  return global;
}

/// The same words on all ranks: those of the first that has any.
std::string told_to_all(const std::string& words) {
  const Job job(MPI_COMM_WORLD);
  const Status status = job.agree(words.empty() ? Status() : Status::bad_input(words));
  return status.message;
}

std::string compare_lists(const char* what, std::span<const Pair> truth, std::span<const GlobalPair> mine) {
  if (const auto words =
          told_to_all(std::ranges::is_sorted(mine) ? "" : std::string(what) + " of a rank do not ascend");
      !words.empty())
    return words;
  const Job job(MPI_COMM_WORLD);
  auto said = job.gather(mine, 0);
  std::ostringstream words;
  if (own_rank() == 0) {
    std::ranges::sort(*said);
    const std::vector<GlobalPair> wanted = global_pairs(truth);
    const auto [one, other] = std::ranges::mismatch(wanted, *said);
    if (one != wanted.end() || other != said->end()) {
      words << what << ": " << wanted.size() << " pairs, of which the ranks say " << said->size();
      if (one != wanted.end()) words << "; next is (" << small_id(one->a) << ", " << small_id(one->b) << ")";
      if (other != said->end())
        words << "; said is (" << small_id(other->a) << ", " << small_id(other->b) << ")";
    }
  }
  return told_to_all(words.str());
}

}  // namespace

int own_rank() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

int all_ranks() {
  int ranks = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  return ranks;
}

bool on_all_ranks(bool here) {
  int all = here ? 1 : 0;
  MPI_Allreduce(MPI_IN_PLACE, &all, 1, MPI_INT, MPI_LAND, MPI_COMM_WORLD);
  return all != 0;
}

Twins::Twins(const RankOptions& options) : world_(make_distributed_broadphase(MPI_COMM_WORLD, options)) {}

void Twins::insert(int giver, std::span<const BodyId> ids, std::span<const Aabb> boxes,
                   std::span<const BodyFilter> filters) {
  static_cast<void>(whole_.insert(ids, boxes, filters));
  if (own_rank() == giver) static_cast<void>(world().insert(global_ids(ids), boxes, filters));
}

void Twins::move(int giver, std::span<const BodyId> ids, std::span<const Aabb> boxes) {
  static_cast<void>(whole_.move(ids, boxes));
  if (own_rank() == giver) static_cast<void>(world().move(global_ids(ids), boxes));
}

void Twins::set_filters(int giver, std::span<const BodyId> ids, std::span<const BodyFilter> filters) {
  static_cast<void>(whole_.set_filters(ids, filters));
  if (own_rank() == giver) static_cast<void>(world().set_filters(global_ids(ids), filters));
}

void Twins::remove(int giver, std::span<const BodyId> ids) {
  static_cast<void>(whole_.remove(ids));
  if (own_rank() == giver) static_cast<void>(world().remove(global_ids(ids)));
}

std::string Twins::update_and_compare() {
  const auto said = world().update();
  if (!said) return said.status().message;
  const auto truth = whole_.update();
  if (!truth) return truth.status().message;
  return compare(*truth, *said);
}

std::string Twins::compare(const PairChanges& truth, const RankChanges& said) const {
  for (const std::string& words :
       {compare_lists("began", truth.began, said.began), compare_lists("ended", truth.ended, said.ended),
        compare_pairs(), compare_bodies()}) {
    if (!words.empty()) return words;
  }
  return {};
}

std::string Twins::compare_pairs() const {
  return compare_lists("pairs", whole_.pairs(), world_->pairs());
}

// Every body is owned by one rank, which knows its box.
std::string Twins::compare_bodies() const {
  const std::vector<GlobalId> owned = world_->owned();
  std::vector<Aabb> boxes(owned.size());
  std::vector<Aabb> truth(owned.size());
  std::vector<BodyId> ids;
  for (const GlobalId id : owned) ids.push_back(small_id(id));
  const bool same = world_->boxes(owned, boxes).ok() && whole_.boxes(ids, truth).ok() && boxes == truth;
  if (!on_all_ranks(same)) return "boxes differ";
  const Job job(MPI_COMM_WORLD);
  const auto all = job.gather(std::span<const GlobalId>(owned), 0);
  std::string words;
  if (own_rank() == 0) {
    std::vector<GlobalId> sorted = *all;
    std::ranges::sort(sorted);
    if (std::ranges::adjacent_find(sorted) != sorted.end()) words = "a body is owned twice";
    if (sorted.size() != whole_.size() || world_->size() != whole_.size()) words = "bodies are lost";
  }
  return told_to_all(words);
}

}  // namespace cellsweep::ranks
