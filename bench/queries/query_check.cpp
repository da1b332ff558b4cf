#include "bench/queries/query_check.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>

#include "base/text.h"

namespace cellsweep::bench {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// When a ray enters a box that is larger on each side by `more`, or smaller; never where it does not.
double enters(const Ray& ray, const Aabb& box, double more) {
  double enter = 0;
  double leave = ray.end;
  for (std::size_t k = 0; k < 3; ++k) {
    const double low = box.min[k] - more;
    const double high = box.max[k] + more;
    if (low > high) return kNever;
    const double d = ray.direction[k];
    if (d == 0) {
      if (ray.origin[k] < low || ray.origin[k] > high) return kNever;
      continue;
    }
    const double a = (low - ray.origin[k]) / d;
    const double b = (high - ray.origin[k]) / d;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave ? enter : kNever;
}

double first_entry(const Ray& ray, std::span<const Aabb> boxes, double more) {
  double first = kNever;
  for (const Aabb& box : boxes) first = std::min(first, enters(ray, box, more));
  return first;
}

double distance_between(const Aabb& one, const Aabb& other) {
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double gap = std::max({double{one.min[k]} - other.max[k], double{other.min[k]} - one.max[k], 0.0});
    square += gap * gap;
  }
  return std::sqrt(square);
}

std::vector<Neighbor> all_on_ray(const Ray& ray, std::span<const Aabb> boxes) {
  std::vector<Neighbor> found;
  for (BodyId body = 0; body < boxes.size(); ++body) {
    const double time = enters(ray, boxes[body], 0);
    if (time < kNever) found.push_back({body, time});
  }
  return found;
}

std::vector<Neighbor> nearest_of_all(const Aabb& from, std::span<const Aabb> boxes, std::size_t count) {
  std::vector<Neighbor> found;
  for (BodyId body = 0; body < boxes.size(); ++body)
    found.push_back({body, distance_between(boxes[body], from)});
  const std::size_t some = std::min(count, found.size());
  std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(some), found.end(),
                    [](const Neighbor& a, const Neighbor& b) { return a.distance < b.distance; });
  found.resize(some);
  return found;
}

std::vector<Neighbor> look_at_all(const Questions& questions, std::size_t i, std::span<const Aabb> boxes) {
  const QuestionKind kind = questions.kind;
  if (kind == QuestionKind::nearest1 || kind == QuestionKind::nearest8)
    return nearest_of_all(questions.boxes[i], boxes, nearest_of(kind));
  std::vector<Neighbor> found;
  if (!is_ray(kind)) {
    const double reach = kind == QuestionKind::radius ? questions.radius : 0;
    for (BodyId body = 0; body < boxes.size(); ++body) {
      if (distance_between(boxes[body], questions.boxes[i]) <= reach) found.push_back({body, 0});
    }
    return found;
  }
  found = all_on_ray(questions.rays[i], boxes);
  if (kind == QuestionKind::all || found.empty()) return found;
  if (kind == QuestionKind::any) return {{}};
  return {*std::min_element(found.begin(), found.end(),
                            [](const Neighbor& a, const Neighbor& b) { return a.distance < b.distance; })};
}

/// Compares the answers to one question.
class Judge {
 public:
  Judge(const Questions& questions, std::size_t question, std::span<const Aabb> boxes, double slack)
      : questions_(questions), question_(question), boxes_(boxes), slack_(slack) {}

  bool agree(std::span<const Neighbor> given, std::span<const Neighbor> expected) const {
    if (std::any_of(given.begin(), given.end(),
                    [&](const Neighbor& answer) { return answer.body >= boxes_.size(); }))
      return false;
    switch (questions_.kind) {
      case QuestionKind::nearest1:
      case QuestionKind::nearest8:
        return agree_on_nearest(given, expected);
      case QuestionKind::rays:
      case QuestionKind::down:
      case QuestionKind::segments:
        return agree_on_first(given, expected);
      case QuestionKind::any:
        return given.size() == expected.size() || may_be_any(!given.empty());
      default:
        return agree_on_bodies(given, expected);
    }
  }

 private:
  const Ray& ray() const { return questions_.rays[question_]; }
  bool are_close(double one, double other) const { return one == other || std::fabs(one - other) <= slack_; }

  bool agree_on_nearest(std::span<const Neighbor> given, std::span<const Neighbor> expected) const {
    if (given.size() != expected.size()) return false;
    std::set<BodyId> bodies;
    for (std::size_t i = 0; i < given.size(); ++i) {
      const double distance = distance_between(boxes_[given[i].body], questions_.boxes[question_]);
      if (!are_close(given[i].distance, expected[i].distance) || !are_close(given[i].distance, distance))
        return false;
      bodies.insert(given[i].body);
    }
    return bodies.size() == given.size();
  }

  bool agree_on_first(std::span<const Neighbor> given, std::span<const Neighbor> expected) const {
    const double here = given.empty() ? kNever : given.front().distance;
    const double there = expected.empty() ? kNever : expected.front().distance;
    if (!given.empty() && !(enters(ray(), boxes_[given.front().body], slack_) <= here + slack_)) return false;
    if (are_close(here, there)) return true;
    return here >= first_entry(ray(), boxes_, slack_) - slack_ &&
           here <= first_entry(ray(), boxes_, -slack_) + slack_;
  }

  bool may_be_any(bool given) const {
    return given ? first_entry(ray(), boxes_, slack_) < kNever
                 : first_entry(ray(), boxes_, -slack_) == kNever;
  }

  // Bodies on one side only must be such that rounding may bring in or leave out.
  bool agree_on_bodies(std::span<const Neighbor> given, std::span<const Neighbor> expected) const {
    const std::vector<Neighbor> one = sorted(given);
    const std::vector<Neighbor> other = sorted(expected);
    auto a = one.begin();
    auto b = other.begin();
    while (a != one.end() || b != other.end()) {
      if (b == other.end() || (a != one.end() && a->body < b->body)) {
        if (!may_be_there((a++)->body)) return false;
      } else if (a == one.end() || b->body < a->body) {
        if (!may_be_missing((b++)->body)) return false;
      } else {
        if (!are_close((a++)->distance, (b++)->distance)) return false;
      }
    }
    return std::adjacent_find(one.begin(), one.end(), [](const Neighbor& x, const Neighbor& y) {
             return x.body == y.body;
           }) == one.end();
  }

  static std::vector<Neighbor> sorted(std::span<const Neighbor> answers) {
    std::vector<Neighbor> list(answers.begin(), answers.end());
    std::sort(list.begin(), list.end(), [](const Neighbor& a, const Neighbor& b) { return a.body < b.body; });
    return list;
  }

  bool may_be_there(BodyId body) const {
    if (questions_.kind == QuestionKind::radius) return is_at_radius(body);
    return questions_.kind == QuestionKind::all && enters(ray(), boxes_[body], slack_) < kNever;
  }
  bool may_be_missing(BodyId body) const {
    if (questions_.kind == QuestionKind::radius) return is_at_radius(body);
    return questions_.kind == QuestionKind::all && enters(ray(), boxes_[body], -slack_) == kNever;
  }
  bool is_at_radius(BodyId body) const {
    return are_close(distance_between(boxes_[body], questions_.boxes[question_]), questions_.radius);
  }

  const Questions& questions_;
  std::size_t question_;
  std::span<const Aabb> boxes_;
  double slack_;
};

// What ask() left there, of a question of this kind.
void append(const AnswerRoom& room, QuestionKind kind, std::vector<Neighbor>& answers) {
  switch (kind) {
    case QuestionKind::rays:
    case QuestionKind::down:
    case QuestionKind::segments:
      if (room.first) answers.push_back({room.first->body, room.first->time});
      return;
    case QuestionKind::any:
      if (room.any) answers.push_back({});
      return;
    case QuestionKind::all:
      for (const Touch& touch : room.touches) answers.push_back({touch.body, touch.time});
      return;
    case QuestionKind::nearest1:
    case QuestionKind::nearest8:
      answers.insert(answers.end(), room.neighbors.begin(), room.neighbors.end());
      return;
    default:
      for (const BodyId body : room.bodies) answers.push_back({body, 0});
  }
}

}  // namespace

std::size_t ask(QueryPeer& peer, const Questions& questions, std::size_t i, AnswerRoom& room) {
  switch (questions.kind) {
    case QuestionKind::rays:
    case QuestionKind::down:
    case QuestionKind::segments:
      room.first = peer.first_touch(questions.rays[i]);
      return room.first ? 1 : 0;
    case QuestionKind::any:
      room.any = peer.any_touch(questions.rays[i]);
      return room.any ? 1 : 0;
    case QuestionKind::all:
      peer.find_touches(questions.rays[i], room.touches);
      return room.touches.size();
    case QuestionKind::nearest1:
    case QuestionKind::nearest8:
      peer.find_nearest(questions.boxes[i].min, nearest_of(questions.kind), room.neighbors);
      return room.neighbors.size();
    case QuestionKind::radius:
      peer.find_within(questions.boxes[i].min, questions.radius, room.bodies);
      return room.bodies.size();
    default:
      peer.find_overlaps(questions.boxes[i], room.bodies);
      return room.bodies.size();
  }
}

Answers ask_all(QueryPeer& peer, const QueryPeerInfo& info, const Questions& questions) {
  if (info.in_batches) {
    peer.answer_batch(questions);
    return peer.batch();
  }
  AnswerRoom room;
  Answers answers;
  answers.first = {0};
  for (std::size_t i = 0; i < questions.size(); ++i) {
    ask(peer, questions, i, room);
    append(room, questions.kind, answers.answers);
    answers.first.push_back(answers.answers.size());
  }
  return answers;
}

Answers answer_by_looking_at_all(const Questions& questions, std::span<const Aabb> boxes, std::size_t some) {
  Answers answers;
  answers.first = {0};
  for (std::size_t i = 0; i < std::min(some, questions.size()); ++i) {
    const std::vector<Neighbor> found = look_at_all(questions, i, boxes);
    answers.answers.insert(answers.answers.end(), found.begin(), found.end());
    answers.first.push_back(answers.answers.size());
  }
  return answers;
}

std::string find_fault(const Answers& answers, const Answers& expected, const Questions& questions,
                       std::span<const Aabb> boxes, double slack) {
  if (answers.size() < expected.size())
    return text(answers.size(), " questions answered of ", expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (Judge(questions, i, boxes, slack).agree(answers[i], expected[i])) continue;
    return text("question ", i, " has ", answers[i].size(), " answers, and should have ", expected[i].size(),
                ", or others");
  }
  return "";
}

double slack_of(const Aabb& bounds) {
  double largest = 0;
  for (std::size_t k = 0; k < 3; ++k)
    largest = std::max({largest, std::fabs(double{bounds.min[k]}), std::fabs(double{bounds.max[k]})});
  return 2e-6 * largest;
}

std::uint64_t hash_of(const Answers& answers) {
  std::uint64_t hash = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    for (const Neighbor& answer : answers[i]) hash ^= mix64(std::uint64_t{i} << 32 | answer.body);
  }
  return hash;
}

}  // namespace cellsweep::bench
