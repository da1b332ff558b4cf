#include "app/answer.h"

#include <algorithm>
#include <array>
#include <utility>

#include "app/question_lines.h"
#include "app/wrap.h"
#include "base/text.h"
#include "report/table.h"
#include "report/units.h"

namespace cellsweep::app {
namespace {

using Json = nlohmann::ordered_json;
using Form = QuestionForm;

/// The numbers of a question as what they stand for.
class Parts {
 public:
  explicit Parts(const Question& question) : numbers_(question.numbers) {}

  Point point(std::size_t first) const {
    return {coordinate(first), coordinate(first + 1), coordinate(first + 2)};
  }
  Aabb box() const { return {point(0), point(3)}; }
  Aabb point_or_box() const { return numbers_.size() == 3 ? box_at(point(0)) : box(); }
  std::array<double, 3> direction(std::size_t first) const {
    return {numbers_[first], numbers_[first + 1], numbers_[first + 2]};
  }
  double number(std::size_t place) const { return numbers_[place]; }
  std::vector<BodyId> ids() const {
    std::vector<BodyId> ids;
    for (const double number : numbers_) ids.push_back(static_cast<BodyId>(number));
    return ids;
  }

 private:
  float coordinate(std::size_t place) const { return static_cast<float>(numbers_[place]); }

  const std::vector<double>& numbers_;
};

}  // namespace

Region region_of(const Question& question) {
  const Parts parts(question);
  if (question.kind->form == Form::sphere) return Sphere{parts.point(0), parts.number(3)};
  return {parts.point_or_box(), question.details.distance.value_or(0)};
}

Path path_of(const Question& question) {
  const Parts parts(question);
  if (question.kind->form == Form::segment) return Ray::between(parts.point(0), parts.point(3));
  if (question.kind->form == Form::sweep)
    return MovingBox{parts.box(), parts.direction(6), question.details.end.value_or(MovingBox().end)};
  return Ray{parts.point(0), parts.direction(3), question.details.end.value_or(Ray().end)};
}

namespace {

/// One question and its answer, which is of the kind that the last call asked for.
class Asking {
 public:
  Asking(const Broadphase& world, const Question& question)
      : queries_(world.queries()), question_(question), filter_{question.as, {}} {}

  Status ask(Answer& answer) const {
    switch (question_.kind->form) {
      case Form::box:
      case Form::point:
      case Form::sphere:
        return ask_region(answer);
      case Form::ray:
      case Form::segment:
      case Form::sweep:
        return ask_path(answer);
      case Form::nearest:
        return queries_.find_nearest(Parts(question_).point_or_box(), question_.details.count.value_or(1),
                                     answer.emplace<std::vector<Neighbor>>(),
                                     question_.details.most.value_or(Queries::kAnyDistance), filter_);
      case Form::within:
        return queries_.find_within(region_of(question_), answer.emplace<std::vector<Neighbor>>(), filter_);
      case Form::pairs_of:
        return queries_.find_pairs_of(Parts(question_).ids(), answer.emplace<std::vector<Pair>>());
    }
    return {};
  }

 private:
  Status ask_region(Answer& answer) const {
    const Region region = region_of(question_);
    if (question_.details.any) return keep(queries_.any_overlap(region, filter_), answer);
    return queries_.find_overlaps(region, answer.emplace<std::vector<BodyId>>(), filter_);
  }

  Status ask_path(Answer& answer) const {
    const Path path = path_of(question_);
    if (question_.details.any) return keep(queries_.any_touch(path, filter_), answer);
    std::vector<Touch>& touches = answer.emplace<std::vector<Touch>>();
    if (!question_.details.first) return queries_.find_touches(path, touches, filter_);
    const auto first = queries_.first_touch(path, filter_);
    if (first && *first) touches.push_back(**first);
    return first.status();
  }

  static Status keep(const Result<bool>& any, Answer& answer) {
    if (any) answer = *any;
    return any.status();
  }

  Queries queries_;
  const Question& question_;
  QueryFilter filter_;
};

Json list_json(const std::vector<BodyId>& bodies) {
  return {{"bodies", bodies}};
}

Json list_json(const std::vector<Touch>& touches) {
  Json list = Json::array();
  for (const Touch& touch : touches) list.push_back({{"body", touch.body}, {"time", touch.time}});
  return {{"touches", list}};
}

Json list_json(const std::vector<Neighbor>& neighbors) {
  Json list = Json::array();
  for (const Neighbor& one : neighbors) list.push_back({{"body", one.body}, {"distance", one.distance}});
  return {{"neighbors", list}};
}

Json list_json(const std::vector<Pair>& pairs) {
  Json list = Json::array();
  for (const Pair& pair : pairs) list.push_back({pair.a, pair.b});
  return {{"pairs", list}};
}

std::string list_text(const std::vector<BodyId>& bodies) {
  std::string ids;
  for (const BodyId body : bodies) append_text(ids.append(ids.empty() ? "" : " "), body);
  return wrapped(ids) + "\n";
}

std::string list_text(const std::vector<Touch>& touches) {
  report::Table table({"body", "time"}, 0);
  for (const Touch& touch : touches) table.add({text(touch.body), text(touch.time)});
  return table.text();
}

std::string list_text(const std::vector<Neighbor>& neighbors) {
  report::Table table({"body", "distance"}, 0);
  for (const Neighbor& one : neighbors) table.add({text(one.body), text(one.distance)});
  return table.text();
}

std::string list_text(const std::vector<Pair>& pairs) {
  report::Table table({"body", "with"}, 0);
  for (const Pair& pair : pairs) table.add({text(pair.a), text(pair.b)});
  return table.text();
}

/// `with(list)` unless the answer is yes or no.
template <class With>
auto of_list(const Answer& answer, const With& with) {
  using Written = decltype(with(std::vector<BodyId>()));
  return std::visit(
      [&](const auto& list) -> Written {
        if constexpr (std::is_same_v<decltype(list), const bool&>) {
          return {};
        } else {
          return with(list);
        }
      },
      answer);
}

std::string count_phrase(const Question& question, std::size_t count) {
  const bool is_of_pairs = question.kind->form == Form::pairs_of;
  if (count == 0) return is_of_pairs ? "no pair" : "no body";
  if (count == 1) return is_of_pairs ? "1 pair" : "1 body";
  return report::count_text(count) + (is_of_pairs ? " pairs" : " bodies");
}

}  // namespace

Result<Answer> ask(const Broadphase& world, const Question& question) {
  Answer answer;
  Status status = Asking(world, question).ask(answer);
  if (status.ok()) return answer;
  status.message = question_text(question) + ": " + status.message;
  return status;
}

Json answer_json(const Question& question, const Answer& answer) {
  Json json = {{"question", question_json(question)}};
  if (const bool* any = std::get_if<bool>(&answer)) {
    json["any"] = *any;
    return json;
  }
  json["count"] = of_list(answer, [](const auto& list) { return list.size(); });
  json.update(of_list(answer, [](const auto& list) { return list_json(list); }));
  return json;
}

std::string answer_text(const Question& question, const Answer& answer) {
  const std::string asked = question_text(question) + ": ";
  if (const bool* any = std::get_if<bool>(&answer)) return asked + (*any ? "yes\n" : "no\n");
  const std::size_t count = of_list(answer, [](const auto& list) { return list.size(); });
  std::string found = asked + count_phrase(question, count) + "\n";
  if (count > 0) found += of_list(answer, [](const auto& list) { return list_text(list); });
  return found;
}

}  // namespace cellsweep::app
