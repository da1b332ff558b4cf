/// @file
/// Queries of engine `stream`.
#include <span>
#include <utility>

#include "bench/queries/query_peer.h"
#include "cellsweep/broadphase.h"
#include "cellsweep/options.h"

namespace cellsweep::bench {
namespace {

enum class Way {
  lists,   ///< a call for each question, answers in order
  visits,  ///< the same in no order, by a visitor
  batch    ///< all questions in one call
};

template <class Answer>
Answers answers_of(const BatchAnswers<Answer>& batch) {
  Answers answers;
  answers.first = batch.first;
  for (const Answer& answer : batch.answers) {
    if constexpr (std::is_same_v<Answer, BodyId>) {
      answers.answers.push_back({answer, 0});
    } else if constexpr (std::is_same_v<Answer, Touch>) {
      answers.answers.push_back({answer.body, answer.time});
    } else {
      answers.answers.push_back(answer);
    }
  }
  return answers;
}

class OwnQueries final : public QueryPeer {
 public:
  OwnQueries(Way way, unsigned threads) : way_(way) {
    StreamOptions options;
    options.threads = threads;
    world_ = std::move(*make_broadphase(options));
  }

  void build(std::span<const Aabb> boxes) override {
    boxes_ = boxes;
    ids_.resize(boxes.size());
    for (std::size_t i = 0; i < ids_.size(); ++i) ids_[i] = static_cast<BodyId>(i);
    check(world_.insert(ids_, boxes));
    check(world_.update().status());
    world_.queries().prepare();
  }

  void move(std::span<const BodyId> bodies) override {
    moved_.clear();
    for (const BodyId body : bodies) moved_.push_back(boxes_[body]);
    check(world_.move(bodies, moved_));
    check(world_.update().status());
  }

  void find_overlaps(const Aabb& box, std::vector<BodyId>& found) override { overlaps(box, found); }

  void find_within(const Point& center, float radius, std::vector<BodyId>& found) override {
    overlaps({center, radius}, found);
  }

  std::optional<Touch> first_touch(const Ray& ray) override { return *world_.queries().first_touch(ray); }
  bool any_touch(const Ray& ray) override { return *world_.queries().any_touch(ray); }

  void find_touches(const Ray& ray, std::vector<Touch>& found) override {
    check(world_.queries().find_touches(ray, found));
  }

  void find_nearest(const Point& point, std::size_t count, std::vector<Neighbor>& found) override {
    check(world_.queries().find_nearest(point, count, found));
  }

  void answer_batch(const Questions& questions) override {
    const Queries queries = world_.queries();
    kind_ = questions.kind;
    prepare(questions);
    switch (kind_) {
      case QuestionKind::rays:
      case QuestionKind::down:
      case QuestionKind::segments:
        return check(queries.first_touches(paths_, first_));
      case QuestionKind::any:
        return check(queries.any_touches(paths_, std::span(any_.get(), paths_.size())));
      case QuestionKind::all:
        return check(queries.find_touches(paths_, touches_));
      case QuestionKind::nearest1:
      case QuestionKind::nearest8:
        return check(queries.find_nearest(questions.boxes, nearest_of(kind_), neighbors_));
      default:
        return check(queries.find_overlaps(regions_, bodies_));
    }
  }

  Answers batch() const override {
    if (kind_ == QuestionKind::all) return answers_of(touches_);
    if (kind_ == QuestionKind::nearest1 || kind_ == QuestionKind::nearest8) return neighbors_;
    if (!is_ray(kind_)) return answers_of(bodies_);
    Answers answers;
    answers.first = {0};
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      if (kind_ == QuestionKind::any ? any_[i] : first_[i].has_value()) {
        answers.answers.push_back(kind_ == QuestionKind::any ? Neighbor{}
                                                             : Neighbor{first_[i]->body, first_[i]->time});
      }
      answers.first.push_back(answers.answers.size());
    }
    return answers;
  }

 private:
  // A failure leaves no answers, which the oracle denies.
  static void check(const Status& status) { static_cast<void>(status.ok()); }

  void overlaps(const Region& region, std::vector<BodyId>& found) {
    if (way_ == Way::lists) return check(world_.queries().find_overlaps(region, found));
    found.clear();
    check(world_.queries().visit_overlaps(region, [&](BodyId body) {
      found.push_back(body);
      return true;
    }));
  }

  // A caller who has many questions has them as they are asked.
  void prepare(const Questions& questions) {
    if (prepared_ == &questions) return;
    prepared_ = &questions;
    paths_.assign(questions.rays.begin(), questions.rays.end());
    first_.resize(paths_.size());
    any_ = std::make_unique<bool[]>(paths_.size());
    regions_.clear();
    const double around = kind_ == QuestionKind::radius ? double{questions.radius} : 0;
    for (const Aabb& box : questions.boxes) regions_.emplace_back(box, around);
  }

  Way way_;
  Broadphase world_;
  std::span<const Aabb> boxes_;
  std::vector<BodyId> ids_;
  std::vector<Aabb> moved_;
  const Questions* prepared_ = nullptr;
  QuestionKind kind_ = QuestionKind::boxes;
  std::vector<Path> paths_;
  std::vector<Region> regions_;
  BatchAnswers<BodyId> bodies_;
  BatchAnswers<Touch> touches_;
  BatchAnswers<Neighbor> neighbors_;
  std::vector<std::optional<Touch>> first_;
  std::unique_ptr<bool[]> any_;
};

QueryPeerInfo own_queries(std::string_view name, std::string_view settings, Way way, unsigned threads) {
  QueryPeerInfo info;
  info.name = name;
  info.settings = settings;
  info.is_own = true;
  info.in_batches = way == Way::batch;
  info.many_threads = threads != 1;
  info.moves_for_pairs = true;
  for (const QuestionKindInfo& kind : kQuestionKinds) {
    if (way != Way::visits || !is_ray(kind.kind)) info.answers.push_back(kind.kind);
  }
  if (way == Way::visits) {
    std::erase(info.answers, QuestionKind::nearest1);
    std::erase(info.answers, QuestionKind::nearest8);
  }
  info.make = [=] { return std::make_unique<OwnQueries>(way, threads); };
  return info;
}

}  // namespace

void add_own_query_peers(std::vector<QueryPeerInfo>& peers) {
  peers.push_back(own_queries("stream", "a call for each question, answers in order", Way::lists, 1));
  peers.push_back(own_queries("stream_visit", "the same in no order, by a visitor", Way::visits, 1));
  peers.push_back(own_queries("stream_batch_1", "all questions in one call, one thread", Way::batch, 1));
  peers.push_back(own_queries("stream_batch", "all questions in one call, all threads", Way::batch, 0));
}

}  // namespace cellsweep::bench
