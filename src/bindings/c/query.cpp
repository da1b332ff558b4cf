#include "cellsweep/query.h"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "bindings/c/call.h"
#include "bindings/c/objects.h"
#include "bindings/c/views.h"

using namespace cellsweep;
using namespace cellsweep::c;

static_assert(offsetof(cellsweep_touch, time) == offsetof(Touch, time));
static_assert(offsetof(cellsweep_neighbor, distance) == offsetof(Neighbor, distance));
static_assert(offsetof(cellsweep_region, distance) == offsetof(Region, distance));
static_assert(offsetof(cellsweep_path, direction) == offsetof(Path, direction));
static_assert(offsetof(cellsweep_path, end) == offsetof(Path, end));

namespace {

using Kind = cellsweep_answers::Kind;

QueryFilter filter_of(const cellsweep_query_filter* filter) {
  QueryFilter made;
  if (filter == nullptr) return made;
  if (filter->as != nullptr) made.as = {filter->as->category, filter->as->mask, filter->as->is_static};
  if (filter->predicate == nullptr) return made;
  made.predicate = [asked = filter->predicate, context = filter->context](BodyId id) {
    return asked(context, id);
  };
  return made;
}

/// Questions that must be there if there are any.
Needed some(const void* questions, std::size_t count, const char* name) {
  static constexpr char kNone = 0;
  return {count == 0 ? &kNone : questions, name};
}

/// Answers of one kind. Until all are there, and after an exception, there are none; a refusal leaves what
/// there was.
template <class Answer, class Find>
Status answer(cellsweep_answers& answers, Kind kind, BatchAnswers<Answer>& to, const Find& find) {
  const Kind before = std::exchange(answers.kind, Kind::none);
  Status status = find(to);
  answers.kind = status.ok() ? kind : before;
  return status;
}

/// A list for each question, by the engine's threads; for a single one without.
template <class Question, class Answer, class FindOne, class FindAll>
Status find_lists(std::span<const Question> questions, BatchAnswers<Answer>& to, const FindOne& find_one,
                  const FindAll& find_all) {
  if (questions.size() != 1) return find_all(questions, to);
  to.first.reserve(2);
  Status status = find_one(questions.front(), to.answers);
  if (status.ok()) to.first = {0, to.answers.size()};
  return status;
}

/// The answers to one question; null and none where there is no such question.
template <class Told, class Answer>
const Told* tell(const cellsweep_answers* answers, Kind kind, BatchAnswers<Answer> cellsweep_answers::*of,
                 std::size_t question, std::size_t* count) {
  const bool is_there = answers != nullptr && answers->kind == kind && question < (answers->*of).size();
  const std::span<const Answer> told = is_there ? (answers->*of)[question] : std::span<const Answer>();
  if (count != nullptr) *count = told.size();
  return is_there ? seen_as<const Told>(told.data()) : nullptr;
}

}  // namespace

cellsweep_status cellsweep_prepare_queries(const cellsweep_broadphase* broadphase,
                                           cellsweep_failure* failure) {
  return call(failure, {{broadphase, "broadphase"}}, [&] {
    broadphase->handle.queries().prepare();
    return Status{};
  });
}

cellsweep_status cellsweep_answers_create(cellsweep_answers** made, cellsweep_failure* failure) {
  return call(failure, {{made, "made"}}, [&] {
    *made = std::make_unique<cellsweep_answers>().release();
    return Status{};
  });
}

void cellsweep_answers_destroy(cellsweep_answers* answers) {
  delete answers;
}

cellsweep_status cellsweep_find_overlaps(const cellsweep_broadphase* broadphase,
                                         const cellsweep_region* regions, size_t count,
                                         const cellsweep_query_filter* filter, cellsweep_answers* answers,
                                         cellsweep_failure* failure) {
  return call(failure, {{broadphase, "broadphase"}, some(regions, count, "regions"), {answers, "answers"}},
              [&] {
                const Queries queries(broadphase->handle);
                const QueryFilter with = filter_of(filter);
                return answer(*answers, Kind::bodies, answers->bodies, [&](BatchAnswers<BodyId>& to) {
                  return find_lists(
                      seen_as<const Region>(regions, count), to,
                      [&](const Region& region, std::vector<BodyId>& one) {
                        return queries.find_overlaps(region, one, with);
                      },
                      [&](std::span<const Region> all, BatchAnswers<BodyId>& lists) {
                        return queries.find_overlaps(all, lists, with);
                      });
                });
              });
}

cellsweep_status cellsweep_find_touches(const cellsweep_broadphase* broadphase, const cellsweep_path* paths,
                                        size_t count, const cellsweep_query_filter* filter,
                                        cellsweep_answers* answers, cellsweep_failure* failure) {
  return call(failure, {{broadphase, "broadphase"}, some(paths, count, "paths"), {answers, "answers"}}, [&] {
    const Queries queries(broadphase->handle);
    const QueryFilter with = filter_of(filter);
    return answer(*answers, Kind::touches, answers->touches, [&](BatchAnswers<Touch>& to) {
      return find_lists(
          seen_as<const Path>(paths, count), to,
          [&](const Path& path, std::vector<Touch>& one) { return queries.find_touches(path, one, with); },
          [&](std::span<const Path> all, BatchAnswers<Touch>& lists) {
            return queries.find_touches(all, lists, with);
          });
    });
  });
}

cellsweep_status cellsweep_find_nearest(const cellsweep_broadphase* broadphase, const cellsweep_aabb* boxes,
                                        size_t count, size_t nearest, double most,
                                        const cellsweep_query_filter* filter, cellsweep_answers* answers,
                                        cellsweep_failure* failure) {
  return call(failure, {{broadphase, "broadphase"}, some(boxes, count, "boxes"), {answers, "answers"}}, [&] {
    const Queries queries(broadphase->handle);
    const QueryFilter with = filter_of(filter);
    return answer(*answers, Kind::neighbors, answers->neighbors, [&](BatchAnswers<Neighbor>& to) {
      return find_lists(
          seen_as<const Aabb>(boxes, count), to,
          [&](const Aabb& box, std::vector<Neighbor>& one) {
            return queries.find_nearest(box, nearest, one, most, with);
          },
          [&](std::span<const Aabb> all, BatchAnswers<Neighbor>& lists) {
            return queries.find_nearest(all, nearest, lists, most, with);
          });
    });
  });
}

cellsweep_status cellsweep_find_within(const cellsweep_broadphase* broadphase,
                                       const cellsweep_region* regions, size_t count,
                                       const cellsweep_query_filter* filter, cellsweep_answers* answers,
                                       cellsweep_failure* failure) {
  return call(failure, {{broadphase, "broadphase"}, some(regions, count, "regions"), {answers, "answers"}},
              [&] {
                const Queries queries(broadphase->handle);
                const QueryFilter with = filter_of(filter);
                return answer(*answers, Kind::neighbors, answers->neighbors, [&](BatchAnswers<Neighbor>& to) {
                  return find_lists(
                      seen_as<const Region>(regions, count), to,
                      [&](const Region& region, std::vector<Neighbor>& one) {
                        return queries.find_within(region, one, with);
                      },
                      [&](std::span<const Region> all, BatchAnswers<Neighbor>& lists) {
                        return queries.find_within(all, lists, with);
                      });
                });
              });
}

const uint32_t* cellsweep_bodies(const cellsweep_answers* answers, size_t question, size_t* count) {
  return tell<uint32_t>(answers, Kind::bodies, &cellsweep_answers::bodies, question, count);
}

const cellsweep_touch* cellsweep_touches(const cellsweep_answers* answers, size_t question, size_t* count) {
  return tell<cellsweep_touch>(answers, Kind::touches, &cellsweep_answers::touches, question, count);
}

const cellsweep_neighbor* cellsweep_neighbors(const cellsweep_answers* answers, size_t question,
                                              size_t* count) {
  return tell<cellsweep_neighbor>(answers, Kind::neighbors, &cellsweep_answers::neighbors, question, count);
}

cellsweep_status cellsweep_any_overlaps(const cellsweep_broadphase* broadphase,
                                        const cellsweep_region* regions, size_t count,
                                        const cellsweep_query_filter* filter, bool* any,
                                        cellsweep_failure* failure) {
  return call(
      failure, {{broadphase, "broadphase"}, some(regions, count, "regions"), some(any, count, "any")}, [&] {
        const Queries queries(broadphase->handle);
        return queries.any_overlaps(seen_as<const Region>(regions, count), {any, count}, filter_of(filter));
      });
}

cellsweep_status cellsweep_any_touches(const cellsweep_broadphase* broadphase, const cellsweep_path* paths,
                                       size_t count, const cellsweep_query_filter* filter, bool* any,
                                       cellsweep_failure* failure) {
  return call(
      failure, {{broadphase, "broadphase"}, some(paths, count, "paths"), some(any, count, "any")}, [&] {
        const Queries queries(broadphase->handle);
        return queries.any_touches(seen_as<const Path>(paths, count), {any, count}, filter_of(filter));
      });
}

cellsweep_status cellsweep_first_touches(const cellsweep_broadphase* broadphase, const cellsweep_path* paths,
                                         size_t count, const cellsweep_query_filter* filter,
                                         cellsweep_first_touch* first, cellsweep_failure* failure) {
  return call(
      failure, {{broadphase, "broadphase"}, some(paths, count, "paths"), some(first, count, "first")}, [&] {
        const Queries queries(broadphase->handle);
        std::vector<std::optional<Touch>> found(count);
        Status status = queries.first_touches(seen_as<const Path>(paths, count), found, filter_of(filter));
        if (!status.ok()) return status;
        for (std::size_t i = 0; i < count; ++i) {
          first[i] = {};
          if (found[i]) first[i] = {true, {found[i]->body, found[i]->time}};
        }
        return status;
      });
}

cellsweep_status cellsweep_visit_overlaps(const cellsweep_broadphase* broadphase,
                                          const cellsweep_region* region,
                                          const cellsweep_query_filter* filter,
                                          bool (*visit)(void* context, uint32_t id), void* context,
                                          cellsweep_failure* failure) {
  const auto see = [&](BodyId id) { return visit(context, id); };
  return call(failure,
              {{broadphase, "broadphase"}, {region, "region"}, {reinterpret_cast<void*>(visit), "visit"}},
              [&] {
                const Queries queries(broadphase->handle);
                return queries.visit_overlaps(*seen_as<const Region>(region), see, filter_of(filter));
              });
}

cellsweep_status cellsweep_visit_touches(const cellsweep_broadphase* broadphase, const cellsweep_path* path,
                                         const cellsweep_query_filter* filter,
                                         double (*visit)(void* context, cellsweep_touch touch, double end),
                                         void* context, cellsweep_failure* failure) {
  const auto see = [&](const Touch& touch, double end) {
    return visit(context, {touch.body, touch.time}, end);
  };
  return call(failure,
              {{broadphase, "broadphase"}, {path, "path"}, {reinterpret_cast<void*>(visit), "visit"}}, [&] {
                const Queries queries(broadphase->handle);
                return queries.visit_touches(*seen_as<const Path>(path), see, filter_of(filter));
              });
}

cellsweep_status cellsweep_find_pairs_of(const cellsweep_broadphase* broadphase, cellsweep_ids ids,
                                         cellsweep_pair_list* list, cellsweep_failure* failure) {
  return call(failure, {{broadphase, "broadphase"}, {list, "list"}}, [&] {
    Bodies bodies;
    if (Status status = bodies.read(ids); !status.ok()) return status;
    std::vector<Pair> found;
    Status status = Queries(broadphase->handle).find_pairs_of(bodies.ids.view(), found);
    if (!status.ok()) return status;
    list->pairs = std::move(found);
    list->cross_pairs = {};
    return status;
  });
}
