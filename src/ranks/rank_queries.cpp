#include "ranks/rank_queries.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "base/float_environment.h"

namespace cellsweep::ranks {
namespace {

QuestionRow row_of(std::size_t number, const Aabb& box, const std::array<double, 3>& direction, double reach,
                   const RankQueries::Filter& as, std::size_t count = 0) {
  return {number, box, direction, reach, count, as.value_or(BodyFilter()), as.has_value() ? 1U : 0U};
}

QueryFilter filter_of(const QuestionRow& question) {
  QueryFilter filter;
  if (question.has_as != 0) filter.as = BodyFilter(question.as);
  return filter;
}

Path path_of(const QuestionRow& question) {
  return MovingBox{question.box, question.direction, question.reach};
}

// A box around all points that are so near to it: a little larger than it need be.
Aabb around(const Aabb& box, double distance) {
  const double more = distance * (1 + 1e-12);
  Aabb large;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    large.min[axis] = std::nextafter(static_cast<float>(box.min[axis] - more), -kInfinity);
    large.max[axis] = std::nextafter(static_cast<float>(box.max[axis] + more), kInfinity);
  }
  return large;
}

// What a local answer says beside the body.
double value_of(BodyId) {
  return 0;
}
double value_of(const Touch& touch) {
  return touch.time;
}
double value_of(const Neighbor& neighbor) {
  return neighbor.distance;
}
Local local_of(BodyId body) {
  return body;
}
Local local_of(const Touch& touch) {
  return touch.body;
}
Local local_of(const Neighbor& neighbor) {
  return neighbor.body;
}

// By question, value and body; a body that several ranks have answers once.
void sort_answers(std::vector<AnswerRow>& answers) {
  const auto key = [](const AnswerRow& row) { return std::tuple(row.number, row.value, row.body); };
  std::ranges::sort(answers, {}, key);
  const auto same = [&](const AnswerRow& one, const AnswerRow& other) { return key(one) == key(other); };
  answers.erase(std::unique(answers.begin(), answers.end(), same), answers.end());
}

// The first `most` of each question, which the answers are sorted by.
template <class Answer, class Make>
BatchAnswers<Answer> by_question(std::span<const AnswerRow> answers, std::size_t questions, std::size_t most,
                                 const Make& make) {
  BatchAnswers<Answer> found;
  found.first.reserve(questions + 1);
  std::size_t next = 0;
  for (std::size_t question = 0; question < questions; ++question) {
    found.first.push_back(found.answers.size());
    for (std::size_t taken = 0; next < answers.size() && answers[next].number == question; ++next) {
      if (taken++ < most) found.answers.push_back(make(answers[next]));
    }
  }
  found.first.push_back(found.answers.size());
  return found;
}

constexpr std::size_t kAll = static_cast<std::size_t>(-1);

GlobalId body_of(const AnswerRow& row) {
  return row.body;
}
GlobalTouch touch_of(const AnswerRow& row) {
  return {row.body, row.value};
}
GlobalNeighbor neighbor_of(const AnswerRow& row) {
  return {row.body, row.value};
}

}  // namespace

template <class Reached>
void RankQueries::send(const QuestionRow& question, const Reached& reached, QuestionsByRank& to) const {
  std::vector<int> ranks;
  cuts_.find_reached(reached, ranks);
  for (const int rank : ranks) to[static_cast<std::size_t>(rank)].push_back(question);
}

RankQueries::QuestionsByRank RankQueries::regions_by_rank(std::span<const cellsweep::Region> regions,
                                                          const Filter& as) const {
  QuestionsByRank to(static_cast<std::size_t>(job_.ranks()));
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const auto& [box, distance] = regions[i];
    send(row_of(i, box, {}, distance, as), around(box, distance), to);
  }
  return to;
}

RankQueries::QuestionsByRank RankQueries::paths_by_rank(std::span<const Path> paths, const Filter& as) const {
  QuestionsByRank to(static_cast<std::size_t>(job_.ranks()));
  for (std::size_t i = 0; i < paths.size(); ++i)
    send(row_of(i, paths[i].box, paths[i].direction, paths[i].end, as), paths[i], to);
  return to;
}

// All steps that need memory are agreed on: the answers are there on all ranks, or on none.
Status RankQueries::ask(const Status& allowed, const Asking& asking) const {
  QuestionsByRank to;
  std::vector<AnswerRow> answers;
  Status status = job_.agree([&]() -> Status {
    if (!allowed.ok()) return allowed;
    to = asking.questions();
    return {};
  });
  if (status.ok()) status = ask_ranks(job_, to, asking.answerer, answers);
  if (!status.ok()) return status;
  return job_.agree([&]() -> Status {
    sort_answers(answers);
    asking.take(answers);
    return {};
  });
}

template <class Answer>
void RankQueries::append(std::uint64_t number, std::span<const Answer> found,
                         std::vector<AnswerRow>& answers) const {
  for (const Answer& answer : found)
    answers.push_back({number, held_.id(local_of(answer)), value_of(answer)});
}

// Each engine answers one question at a time: they may have different filters.
Status RankQueries::answer_overlaps(Questions questions, std::vector<AnswerRow>& answers) const {
  std::vector<BodyId> found;
  for (const QuestionRow& question : questions) {
    const cellsweep::Region region(question.box, question.reach);
    if (Status status = Queries(engine_).find_overlaps(region, found, filter_of(question)); !status.ok())
      return status;
    append(question.number, std::span<const BodyId>(found), answers);
  }
  return {};
}

Status RankQueries::answer_touches(Questions questions, std::vector<AnswerRow>& answers) const {
  std::vector<Touch> found;
  for (const QuestionRow& question : questions) {
    if (Status status = Queries(engine_).find_touches(path_of(question), found, filter_of(question));
        !status.ok())
      return status;
    append(question.number, std::span<const Touch>(found), answers);
  }
  return {};
}

// All that are touched at the time of the first: which of them counts depends on their global names.
Status RankQueries::answer_first_touches(Questions questions, std::vector<AnswerRow>& answers) const {
  std::vector<Touch> found;
  for (const QuestionRow& question : questions) {
    Path path = path_of(question);
    const QueryFilter filter = filter_of(question);
    const auto first = Queries(engine_).first_touch(path, filter);
    if (!first) return first.status();
    if (!first->has_value()) continue;
    path.end = (*first)->time;
    if (Status status = Queries(engine_).find_touches(path, found, filter); !status.ok()) return status;
    append(question.number, std::span<const Touch>(found), answers);
  }
  return {};
}

Status RankQueries::answer_within(Questions questions, std::vector<AnswerRow>& answers) const {
  std::vector<Neighbor> found;
  for (const QuestionRow& question : questions) {
    const cellsweep::Region region(question.box, question.reach);
    if (Status status = Queries(engine_).find_within(region, found, filter_of(question)); !status.ok())
      return status;
    append(question.number, std::span<const Neighbor>(found), answers);
  }
  return {};
}

// How far the last of so many bodies is: no body that counts is further.
Status RankQueries::answer_nearest(Questions questions, std::vector<AnswerRow>& answers) const {
  std::vector<Neighbor> found;
  for (const QuestionRow& question : questions) {
    if (Status status = Queries(engine_).find_nearest(question.box, question.count, found, question.reach,
                                                      filter_of(question));
        !status.ok())
      return status;
    if (found.size() == question.count && !found.empty())
      append(question.number, std::span<const Neighbor>(found).last(1), answers);
  }
  return {};
}

Status RankQueries::find_overlaps(std::span<const cellsweep::Region> regions, BatchAnswers<GlobalId>& found,
                                  const Filter& as) const {
  const DefaultFloats floats;
  BatchAnswers<BodyId> none;
  BatchAnswers<GlobalId> all;
  const Status allowed = Job::attempt([&] { return Queries(Broadphase()).find_overlaps(regions, none); });
  Status status = ask(
      allowed,
      {[&] { return regions_by_rank(regions, as); }, answers_of(&RankQueries::answer_overlaps),
       [&](const auto& answers) { all = by_question<GlobalId>(answers, regions.size(), kAll, body_of); }});
  if (status.ok()) found = std::move(all);
  return status;
}

Status RankQueries::find_touches(std::span<const Path> paths, BatchAnswers<GlobalTouch>& found,
                                 const Filter& as) const {
  const DefaultFloats floats;
  BatchAnswers<Touch> none;
  BatchAnswers<GlobalTouch> all;
  const Status allowed = Job::attempt([&] { return Queries(Broadphase()).find_touches(paths, none); });
  Status status = ask(
      allowed,
      {[&] { return paths_by_rank(paths, as); }, answers_of(&RankQueries::answer_touches),
       [&](const auto& answers) { all = by_question<GlobalTouch>(answers, paths.size(), kAll, touch_of); }});
  if (status.ok()) found = std::move(all);
  return status;
}

Status RankQueries::first_touches(std::span<const Path> paths, std::span<std::optional<GlobalTouch>> first,
                                  const Filter& as) const {
  const DefaultFloats floats;
  BatchAnswers<GlobalTouch> all;
  const Status allowed = Job::attempt([&] {
    std::vector<std::optional<Touch>> none(first.size());
    return Queries(Broadphase()).first_touches(paths, none);
  });
  Status status =
      ask(allowed,
          {[&] { return paths_by_rank(paths, as); }, answers_of(&RankQueries::answer_first_touches),
           [&](const auto& answers) { all = by_question<GlobalTouch>(answers, paths.size(), 1, touch_of); }});
  if (!status.ok()) return status;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    first[i].reset();
    if (!all[i].empty()) first[i] = all[i].front();
  }
  return {};
}

Status RankQueries::find_within(std::span<const cellsweep::Region> regions,
                                BatchAnswers<GlobalNeighbor>& found, const Filter& as) const {
  const DefaultFloats floats;
  BatchAnswers<Neighbor> none;
  const Status allowed = Job::attempt([&] { return Queries(Broadphase()).find_within(regions, none); });
  return find_nearest_within(allowed, regions, kAll, found, as);
}

Status RankQueries::find_nearest_within(const Status& allowed, std::span<const cellsweep::Region> regions,
                                        std::size_t count, BatchAnswers<GlobalNeighbor>& found,
                                        const Filter& as) const {
  BatchAnswers<GlobalNeighbor> all;
  Status status =
      ask(allowed, {[&] { return regions_by_rank(regions, as); }, answers_of(&RankQueries::answer_within),
                    [&](const auto& answers) {
                      all = by_question<GlobalNeighbor>(answers, regions.size(), count, neighbor_of);
                    }});
  if (status.ok()) found = std::move(all);
  return status;
}

RankQueries::QuestionsByRank RankQueries::to_homes(std::span<const Aabb> boxes, std::size_t count,
                                                   double most, const Filter& as) const {
  QuestionsByRank to(static_cast<std::size_t>(job_.ranks()));
  for (std::size_t i = 0; count > 0 && i < boxes.size(); ++i) {
    const int home = cuts_.home_of(boxes[i].min);
    to[static_cast<std::size_t>(home)].push_back(row_of(i, boxes[i], {}, most, as, count));
  }
  return to;
}

// First the rank that a box begins in says how far its nearest bodies are; then all ranks that are as near.
Status RankQueries::find_nearest(std::span<const Aabb> boxes, std::size_t count,
                                 BatchAnswers<GlobalNeighbor>& found, double most, const Filter& as) const {
  const DefaultFloats floats;
  BatchAnswers<Neighbor> none;
  std::vector<cellsweep::Region> regions;
  const Status allowed =
      Job::attempt([&] { return Queries(Broadphase()).find_nearest(boxes, count, none, most); });
  Status status = ask(
      allowed, {[&] { return to_homes(boxes, count, most, as); }, answers_of(&RankQueries::answer_nearest),
                [&](const auto& bounds) {
                  for (const Aabb& box : boxes) regions.emplace_back(box, most);
                  for (const AnswerRow& bound : bounds) regions[bound.number].distance = bound.value;
                }});
  if (!status.ok()) return status;
  return find_nearest_within({}, regions, count, found, as);
}

}  // namespace cellsweep::ranks
