#include "contract/faults/questions.h"

#include <algorithm>

namespace cellsweep::contract {
namespace {

template <class Answer>
bool same(const Answer& given, const Answer& truth) {
  return given == truth;
}

template <class Answer>
bool same(const BatchAnswers<Answer>& given, const std::vector<std::vector<Answer>>& truth) {
  if (given.size() != truth.size()) return false;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (!std::ranges::equal(given[i], truth[i])) return false;
  }
  return true;
}

template <class Answer>
Status tell(const Result<Answer>& result, Answer& answer) {
  if (result) answer = *result;
  return result.status();
}

bool sooner(const Touch& one, const Touch& other) {
  return std::pair(one.time, one.body) < std::pair(other.time, other.body);
}

std::optional<Touch> first_of(const std::vector<Touch>& touches) {
  return touches.empty() ? std::nullopt : std::optional(touches.front());
}

class QuestionMaker {
 public:
  QuestionMaker(const Queries& queries, const queries::Reference& world, std::uint64_t seed)
      : queries_(queries), world_(world), random_(world, seed) {}

  void add_single();
  void add_batches();
  std::vector<Question> take() { return std::move(questions_); }

 private:
  /// `ask(answer)` returns a Status.
  template <class Answer, class Truth, class Ask>
  void add(const char* name, const Truth& truth, const Ask& ask) {
    const auto given = std::make_shared<std::optional<Answer>>();
    const auto ask_anew = [given, ask] {
      given->reset();
      Answer answer{};
      Status status = ask(answer);
      if (status.ok()) given->emplace(std::move(answer));
      return status;
    };
    questions_.push_back(
        {name, ask_anew, [given, truth] { return given->has_value() && same(**given, truth); }});
  }

  void add_overlaps(const Region& region, const QueryFilter& filter);
  void add_touches(const Path& path, const QueryFilter& filter);
  void add_nearest(const Aabb& box, const QueryFilter& filter);
  void add_pairs_of();
  void add_batches_of_regions(const QueryFilter& filter);
  void add_batches_of_paths(const QueryFilter& filter);
  void add_batch_of_boxes(const QueryFilter& filter);

  Queries queries_;
  const queries::Reference& world_;
  queries::RandomQuestions random_;
  std::vector<Question> questions_;
};

void QuestionMaker::add_overlaps(const Region& region, const QueryFilter& filter) {
  using Bodies = std::vector<BodyId>;
  const Bodies truth = world_.overlaps(region, filter);
  const Queries queries = queries_;
  add<Bodies>("find_overlaps", truth,
              [=](Bodies& found) { return queries.find_overlaps(region, found, filter); });
  add<Bodies>("visit_overlaps", truth, [=](Bodies& found) {
    const auto visit = [&](BodyId body) {
      found.push_back(body);
      return true;
    };
    Status status = queries.visit_overlaps(region, visit, filter);
    std::ranges::sort(found);
    return status;
  });
  add<bool>("any_overlap", !truth.empty(),
            [=](bool& any) { return tell(queries.any_overlap(region, filter), any); });
  using Neighbors = std::vector<Neighbor>;
  add<Neighbors>("find_within", world_.within(region, filter),
                 [=](Neighbors& found) { return queries.find_within(region, found, filter); });
}

void QuestionMaker::add_touches(const Path& path, const QueryFilter& filter) {
  using Touches = std::vector<Touch>;
  const Touches truth = world_.touches(path, filter);
  const Queries queries = queries_;
  add<Touches>("find_touches", truth,
               [=](Touches& found) { return queries.find_touches(path, found, filter); });
  add<Touches>("visit_touches", truth, [=](Touches& found) {
    const auto visit = [&](const Touch& touch, double end) {
      found.push_back(touch);
      return end;
    };
    Status status = queries.visit_touches(path, visit, filter);
    std::ranges::sort(found, sooner);
    return status;
  });
  using First = std::optional<Touch>;
  add<First>("first_touch", first_of(truth),
             [=](First& first) { return tell(queries.first_touch(path, filter), first); });
  add<bool>("any_touch", !truth.empty(),
            [=](bool& any) { return tell(queries.any_touch(path, filter), any); });
}

void QuestionMaker::add_nearest(const Aabb& box, const QueryFilter& filter) {
  using Neighbors = std::vector<Neighbor>;
  const std::size_t count = 1 + random_.count();
  const double most = random_.distance();
  const Queries queries = queries_;
  add<Neighbors>("find_nearest", world_.nearest(box, count, most, filter),
                 [=](Neighbors& found) { return queries.find_nearest(box, count, found, most, filter); });
}

void QuestionMaker::add_pairs_of() {
  std::vector<BodyId> bodies;
  for (const auto& [body, box] : world_.boxes) {
    if (bodies.size() < 5) bodies.push_back(body);
  }
  using Pairs = std::vector<Pair>;
  const Queries queries = queries_;
  add<Pairs>("find_pairs_of", world_.pairs_of(bodies),
             [=](Pairs& found) { return queries.find_pairs_of(bodies, found); });
}

void QuestionMaker::add_single() {
  const QueryFilter filter = random_.filter();
  // A sphere and a box, a ray and a box that moves.
  for (const bool is_point : {false, true}) {
    const Region region = random_.region();
    add_overlaps(is_point ? Region(region.box.min, region.distance) : region, filter);
    Path path = random_.path();
    if (is_point) path.box = box_at(path.box.min);
    add_touches(path, filter);
  }
  add_nearest(random_.box(), filter);
  add_pairs_of();
}

void QuestionMaker::add_batches_of_regions(const QueryFilter& filter) {
  std::vector<Region> regions;
  std::vector<std::vector<BodyId>> overlaps;
  std::vector<std::vector<Neighbor>> within;
  std::array<bool, kBatch> any{};
  for (std::size_t i = 0; i < kBatch; ++i) {
    regions.push_back(random_.region());
    overlaps.push_back(world_.overlaps(regions[i], filter));
    within.push_back(world_.within(regions[i], filter));
    any[i] = !overlaps[i].empty();
  }
  const Queries queries = queries_;
  using Bodies = BatchAnswers<BodyId>;
  add<Bodies>("a batch of find_overlaps", overlaps,
              [=](Bodies& found) { return queries.find_overlaps(regions, found, filter); });
  using Neighbors = BatchAnswers<Neighbor>;
  add<Neighbors>("a batch of find_within", within,
                 [=](Neighbors& found) { return queries.find_within(regions, found, filter); });
  using Any = std::array<bool, kBatch>;
  add<Any>("any_overlaps", any, [=](Any& found) { return queries.any_overlaps(regions, found, filter); });
}

void QuestionMaker::add_batches_of_paths(const QueryFilter& filter) {
  std::vector<Path> paths;
  std::vector<std::vector<Touch>> touches;
  std::array<std::optional<Touch>, kBatch> first;
  std::array<bool, kBatch> any{};
  for (std::size_t i = 0; i < kBatch; ++i) {
    paths.push_back(random_.path());
    touches.push_back(world_.touches(paths[i], filter));
    first[i] = first_of(touches[i]);
    any[i] = first[i].has_value();
  }
  const Queries queries = queries_;
  using Touches = BatchAnswers<Touch>;
  add<Touches>("a batch of find_touches", touches,
               [=](Touches& found) { return queries.find_touches(paths, found, filter); });
  using First = std::array<std::optional<Touch>, kBatch>;
  add<First>("first_touches", first,
             [=](First& found) { return queries.first_touches(paths, found, filter); });
  using Any = std::array<bool, kBatch>;
  add<Any>("any_touches", any, [=](Any& found) { return queries.any_touches(paths, found, filter); });
}

void QuestionMaker::add_batch_of_boxes(const QueryFilter& filter) {
  constexpr std::size_t kNearest = 3;
  const double most = random_.distance();
  std::vector<Aabb> boxes;
  std::vector<std::vector<Neighbor>> nearest;
  for (std::size_t i = 0; i < kBatch; ++i) {
    boxes.push_back(random_.box());
    nearest.push_back(world_.nearest(boxes[i], kNearest, most, filter));
  }
  const Queries queries = queries_;
  using Neighbors = BatchAnswers<Neighbor>;
  add<Neighbors>("a batch of find_nearest", nearest, [=](Neighbors& found) {
    return queries.find_nearest(boxes, kNearest, found, most, filter);
  });
}

void QuestionMaker::add_batches() {
  const QueryFilter filter = random_.filter();
  add_batches_of_regions(filter);
  add_batches_of_paths(filter);
  add_batch_of_boxes(filter);
}

}  // namespace

std::vector<Question> make_questions(const Queries& queries, const queries::Reference& world,
                                     std::uint64_t seed) {
  QuestionMaker maker(queries, world, seed);
  maker.add_single();
  maker.add_batches();
  return maker.take();
}

}  // namespace cellsweep::contract
