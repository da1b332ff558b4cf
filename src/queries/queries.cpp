#include <algorithm>
#include <utility>

#include "base/float_environment.h"
#include "broadphase/bodies/refusals.h"
#include "broadphase/bodies/seen_bodies.h"
#include "cellsweep/query.h"
#include "queries/batch.h"
#include "queries/checks.h"
#include "queries/questions.h"
#include "queries/tree_price.h"

namespace cellsweep {
namespace {

using queries::Asked;
using queries::Batch;
using queries::World;

/// What every call does whose thread computes as the library does: an update is caught meanwhile.
class Call {
 public:
  explicit Call(const Broadphase& broadphase)
      : last_(EngineAccess::last_update(broadphase)), reading_(last_.readers), world_(last_) {}

  const LastUpdate& last() const { return last_; }
  const World& world() const { return world_; }

 private:
  const LastUpdate& last_;
  Reading reading_;
  World world_;
};

// Questions are checked as the library computes, too: a caller's thread may take a denormal number for 0.

/// What `answer(asked)` returns, after a check.
template <class Answered, class Question, class Answer>
Answered answer_one(const Broadphase& broadphase, const Question& question, const QueryFilter& filter,
                    const Answer& answer) {
  const DefaultFloats floats;
  if (!queries::is_good(question)) return queries::check(question);
  const Call call(broadphase);
  return answer(Asked{call.world(), filter});
}

/// `list(asked, question, answers)` for each question of a batch.
template <class Question, class Answer, class List>
Status answer_lists(const Broadphase& broadphase, std::span<const Question> questions,
                    const QueryFilter& filter, BatchAnswers<Answer>& found, const List& list) {
  const DefaultFloats floats;
  if (Status status = queries::check_all(questions); !status.ok()) return status;
  const Call call(broadphase);
  const Asked asked{call.world(), filter};
  Batch(call.last()).list(questions, found, [&](std::size_t i, std::vector<Answer>& answers) {
    list(asked, questions[i], answers);
  });
  return {};
}

/// `answer(asked, question)` into one place for each question of a batch.
template <class Question, class Answer, class Find>
Status answer_each(const Broadphase& broadphase, std::span<const Question> questions,
                   const QueryFilter& filter, std::span<Answer> found, const Find& find) {
  if (Status status = queries::check_room(questions.size(), found.size()); !status.ok()) return status;
  const DefaultFloats floats;
  if (Status status = queries::check_all(questions); !status.ok()) return status;
  const Call call(broadphase);
  const Asked asked{call.world(), filter};
  Batch(call.last()).for_each(questions, [&](std::size_t i) { found[i] = find(asked, questions[i]); });
  return {};
}

}  // namespace

Queries Broadphase::queries() const {
  return Queries(*this);
}

void Queries::prepare() const {
  const DefaultFloats floats;
  queries::make_tree(Call(*broadphase_).world());
}

Status Queries::find_overlaps(const Region& region, std::vector<BodyId>& found,
                              const QueryFilter& filter) const {
  return answer_one<Status>(*broadphase_, region, filter, [&](const Asked& asked) {
    found.clear();
    queries::list_overlaps(asked, region, found);
    return Status{};
  });
}

Status Queries::visit_overlaps(const Region& region, FunctionRef<bool(BodyId)> visit,
                               const QueryFilter& filter) const {
  return answer_one<Status>(*broadphase_, region, filter, [&](const Asked& asked) {
    queries::visit_overlaps(asked, region, visit);
    return Status{};
  });
}

Result<bool> Queries::any_overlap(const Region& region, const QueryFilter& filter) const {
  return answer_one<Result<bool>>(*broadphase_, region, filter,
                                  [&](const Asked& asked) { return queries::any_overlap(asked, region); });
}

Status Queries::find_overlaps(std::span<const Region> regions, BatchAnswers<BodyId>& found,
                              const QueryFilter& filter) const {
  return answer_lists(*broadphase_, regions, filter, found, queries::list_overlaps);
}

Status Queries::any_overlaps(std::span<const Region> regions, std::span<bool> any,
                             const QueryFilter& filter) const {
  return answer_each(*broadphase_, regions, filter, any, queries::any_overlap);
}

Status Queries::find_touches(const Path& path, std::vector<Touch>& found, const QueryFilter& filter) const {
  return answer_one<Status>(*broadphase_, path, filter, [&](const Asked& asked) {
    found.clear();
    queries::list_touches(asked, path, found);
    return Status{};
  });
}

Status Queries::visit_touches(const Path& path, FunctionRef<double(const Touch&, double)> visit,
                              const QueryFilter& filter) const {
  return answer_one<Status>(*broadphase_, path, filter, [&](const Asked& asked) {
    queries::visit_touches(asked, path, visit);
    return Status{};
  });
}

Result<std::optional<Touch>> Queries::first_touch(const Path& path, const QueryFilter& filter) const {
  using First = Result<std::optional<Touch>>;
  return answer_one<First>(*broadphase_, path, filter,
                           [&](const Asked& asked) { return queries::first_touch(asked, path); });
}

Result<bool> Queries::any_touch(const Path& path, const QueryFilter& filter) const {
  return answer_one<Result<bool>>(*broadphase_, path, filter,
                                  [&](const Asked& asked) { return queries::any_touch(asked, path); });
}

Status Queries::find_touches(std::span<const Path> paths, BatchAnswers<Touch>& found,
                             const QueryFilter& filter) const {
  return answer_lists(*broadphase_, paths, filter, found, queries::list_touches);
}

Status Queries::first_touches(std::span<const Path> paths, std::span<std::optional<Touch>> first,
                              const QueryFilter& filter) const {
  return answer_each(*broadphase_, paths, filter, first, queries::first_touch);
}

Status Queries::any_touches(std::span<const Path> paths, std::span<bool> any,
                            const QueryFilter& filter) const {
  return answer_each(*broadphase_, paths, filter, any, queries::any_touch);
}

Status Queries::find_nearest(const Aabb& box, std::size_t count, std::vector<Neighbor>& found, double most,
                             const QueryFilter& filter) const {
  const DefaultFloats floats;
  if (Status status = queries::check_most(most); !status.ok()) return status;
  return answer_one<Status>(*broadphase_, box, filter, [&](const Asked& asked) {
    queries::list_nearest(asked, box, count, most, found);
    return Status{};
  });
}

Status Queries::find_nearest(std::span<const Aabb> boxes, std::size_t count, BatchAnswers<Neighbor>& found,
                             double most, const QueryFilter& filter) const {
  const DefaultFloats floats;
  if (Status status = queries::check_most(most); !status.ok()) return status;
  return answer_lists(*broadphase_, boxes, filter, found,
                      [&](const Asked& asked, const Aabb& box, std::vector<Neighbor>& answers) {
                        std::vector<Neighbor> nearest;
                        queries::list_nearest(asked, box, count, most, nearest);
                        answers.insert(answers.end(), nearest.begin(), nearest.end());
                      });
}

Status Queries::find_within(const Region& region, std::vector<Neighbor>& found,
                            const QueryFilter& filter) const {
  return answer_one<Status>(*broadphase_, region, filter, [&](const Asked& asked) {
    found.clear();
    queries::list_within(asked, region, found);
    return Status{};
  });
}

Status Queries::find_within(std::span<const Region> regions, BatchAnswers<Neighbor>& found,
                            const QueryFilter& filter) const {
  return answer_lists(*broadphase_, regions, filter, found, queries::list_within);
}

Status Queries::find_pairs_of(std::span<const BodyId> bodies, std::vector<Pair>& found) const {
  const DefaultFloats floats;
  const Call call(*broadphase_);
  const World& world = call.world();
  const SeenBodies seen(call.last().bodies.table(), call.last().bodies.staged());
  const auto is_unseen = [&](BodyId id) { return seen.find(id) == kNoSlot; };
  if (Status status = find_unseen(bodies, is_unseen); !status.ok()) return status;
  found.clear();
  for (const BodyId id : bodies) {
    const Slot slot = seen.find(id);
    const QueryFilter filter{.as = world.filter(slot)};
    queries::visit_overlaps({world, filter}, Region(world.box(slot)), [&](BodyId other) {
      if (other != id) found.push_back(make_pair_of(id, other));
      return true;
    });
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return {};
}

}  // namespace cellsweep
