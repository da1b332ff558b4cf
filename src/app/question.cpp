#include "app/question.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "app/setting_flags.h"
#include "base/text.h"
#include "report/units.h"

namespace cellsweep::app {
namespace {

using Form = QuestionForm;

constexpr std::size_t kAnyNumber = 0;
constexpr double kLargestId = std::numeric_limits<std::uint32_t>::max();

constexpr std::array kKinds = {
    QuestionKind{Form::box, "box", "MINX,MINY,MINZ,MAXX,MAXY,MAXZ", "Which bodies overlap a box", 6, 6, 6},
    QuestionKind{Form::point, "point", "X,Y,Z", "Which bodies have this point", 3, 3, 3},
    QuestionKind{Form::sphere, "sphere", "X,Y,Z,RADIUS", "Which bodies overlap a sphere", 4, 4, 3},
    QuestionKind{Form::ray, "ray", "X,Y,Z,DX,DY,DZ", "Which bodies a ray touches, and when", 6, 6, 3},
    QuestionKind{Form::segment, "segment", "X,Y,Z,X,Y,Z",
                 "Which bodies the way between two points touches, from 0 to 1", 6, 6, 6},
    QuestionKind{Form::sweep, "sweep", "MINX,MINY,MINZ,MAXX,MAXY,MAXZ,DX,DY,DZ",
                 "Which bodies a box touches that goes so far", 9, 9, 6},
    QuestionKind{Form::nearest, "nearest", "X,Y,Z", "The nearest bodies to a point, or to a box of 6 numbers",
                 3, 6, 6},
    QuestionKind{Form::within, "within", "X,Y,Z",
                 "Which bodies are within a --distance of a point, or of a box of 6 numbers", 3, 6, 6},
    QuestionKind{Form::pairs_of, "pairs_of", "ID[,ID...]", "The pairs in which one of these bodies is",
                 kAnyNumber, kAnyNumber, 0},
};

bool is_region(Form form) {
  return form == Form::box || form == Form::point || form == Form::sphere;
}

bool is_path(Form form) {
  return form == Form::ray || form == Form::segment || form == Form::sweep;
}

/// A detail, by the name that it has in a file; its flag is that of a setting.
struct Detail {
  std::string_view name;
  bool (*is_given)(const QuestionDetails&);
  bool (*is_of)(Form);
};

constexpr std::array kDetails = {
    Detail{"end", [](const QuestionDetails& d) { return d.end.has_value(); },
           [](Form form) { return form == Form::ray || form == Form::sweep; }},
    Detail{"first", [](const QuestionDetails& d) { return d.first; }, is_path},
    Detail{"any", [](const QuestionDetails& d) { return d.any; },
           [](Form form) { return is_path(form) || is_region(form); }},
    Detail{"count", [](const QuestionDetails& d) { return d.count.has_value(); },
           [](Form form) { return form == Form::nearest; }},
    Detail{"most", [](const QuestionDetails& d) { return d.most.has_value(); },
           [](Form form) { return form == Form::nearest; }},
    Detail{"distance", [](const QuestionDetails& d) { return d.distance.has_value(); },
           [](Form form) { return form == Form::within; }},
};

// As short as tells it from all others.
std::string exact_text(double number) {
  std::array<char, 32> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr};
}

Status bad_question(const std::string& where, const std::string& fault) {
  return Status::bad_input(where + ": " + fault);
}

std::string wanted_numbers(const QuestionKind& kind) {
  if (kind.numbers == kind.more_numbers) return text(kind.numbers, " numbers, ", kind.shape, ",");
  return text(kind.numbers, " or ", kind.more_numbers, " numbers");
}

Status check_coordinate(double coordinate, const std::string& where) {
  if (std::fabs(coordinate) <= FLT_MAX) return {};
  return bad_question(where, text("a coordinate is ", exact_text(coordinate),
                                  "; it must be finite, and is at most ", exact_text(FLT_MAX), "."));
}

Status check_id(double id, const std::string& where) {
  if (id >= 0 && id <= kLargestId && id == std::floor(id)) return {};
  return bad_question(where, text("a body's id is ", exact_text(id), "; it must be a whole number, 0 to ",
                                  report::count_text(static_cast<std::size_t>(kLargestId)), "."));
}

Status check_numbers(const Question& question, const std::string& where) {
  const QuestionKind& kind = *question.kind;
  const std::size_t count = question.numbers.size();
  if (kind.numbers != kAnyNumber && count != kind.numbers && count != kind.more_numbers) {
    return bad_question(where, text(wanted_numbers(kind), " are wanted, and there ",
                                    count == 1 ? "is 1" : text("are ", count), "."));
  }
  if (count == 0) return bad_question(where, "at least one id is wanted.");
  for (std::size_t i = 0; i < count; ++i) {
    Status status;
    if (i < kind.coordinates) status = check_coordinate(question.numbers[i], where);
    if (kind.form == Form::pairs_of) status = check_id(question.numbers[i], where);
    if (!status.ok()) return status;
  }
  return {};
}

Status check_details(const Question& question, const std::string& where, std::string_view sign) {
  for (const Detail& detail : kDetails) {
    if (detail.is_given(question.details) && !detail.is_of(question.kind->form))
      return bad_question(where, text("it has no ", sign, detail.name, "."));
  }
  if (question.kind->form == Form::within && !question.details.distance)
    return bad_question(where, text("it needs ", sign, "distance."));
  if (question.details.first && question.details.any)
    return bad_question(where, text(sign, "first and ", sign, "any are not for one question."));
  return {};
}

/// Numbers from a text such as "0,0.5,-1e3".
Result<std::vector<double>> numbers_of(std::string_view typed, const std::string& where) {
  std::vector<double> numbers;
  while (true) {
    const std::string_view word = typed.substr(0, typed.find(','));
    double number = 0;
    const auto [last, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || last != word.data() + word.size()) {
      const char* const fault =
          error == std::errc::result_out_of_range ? "\" is out of range." : "\" is no number.";
      return bad_question(where, text("\"", word, fault));
    }
    numbers.push_back(number);
    if (word.size() == typed.size()) return numbers;
    typed.remove_prefix(word.size() + 1);
  }
}

/// The details that a question of this form has.
QuestionDetails details_of(const QuestionDetails& all, Form form) {
  QuestionDetails some;
  const auto has = [&](std::string_view name) {
    return std::find_if(kDetails.begin(), kDetails.end(), [&](const Detail& d) { return d.name == name; })
        ->is_of(form);
  };
  if (has("end")) some.end = all.end;
  if (has("first")) some.first = all.first;
  if (has("any")) some.any = all.any;
  if (has("count")) some.count = all.count;
  if (has("most")) some.most = all.most;
  if (has("distance")) some.distance = all.distance;
  return some;
}

}  // namespace

std::span<const QuestionKind> question_kinds() {
  return kKinds;
}

std::vector<std::string_view> detail_names() {
  std::vector<std::string_view> names;
  names.reserve(std::size(kDetails));
  for (const Detail& detail : kDetails) names.push_back(detail.name);
  return names;
}

Status check_question(const Question& question, const std::string& where, std::string_view sign) {
  if (Status status = check_numbers(question, where); !status.ok()) return status;
  return check_details(question, where, sign);
}

Result<Question> question_of_flag(const QuestionKind& kind, const std::string& typed,
                                  const QuestionDetails& details) {
  const std::string where = flag_of(kind.name);
  auto numbers = numbers_of(typed, where);
  if (!numbers) return numbers.status();
  Question question{&kind, std::move(*numbers), details_of(details, kind.form), {}};
  if (Status status = check_question(question, where, "--"); !status.ok()) return status;
  return question;
}

std::string useless_detail(const QuestionDetails& details, std::span<const QuestionKind* const> kinds) {
  for (const Detail& detail : kDetails) {
    const bool is_useful = std::any_of(kinds.begin(), kinds.end(),
                                       [&](const QuestionKind* kind) { return detail.is_of(kind->form); });
    if (detail.is_given(details) && !is_useful) return flag_of(detail.name);
  }
  return {};
}

std::string question_text(const Question& question) {
  const QuestionDetails& details = question.details;
  std::string words = flag_of(question.kind->name);
  char between = ' ';
  for (const double number : question.numbers) {
    words += std::exchange(between, ',');
    words += exact_text(number);
  }
  if (details.end) words += " --end " + exact_text(*details.end);
  if (details.first) words += " --first";
  if (details.any) words += " --any";
  if (details.count) words += text(" --count ", *details.count);
  if (details.most) words += " --most " + exact_text(*details.most);
  if (details.distance) words += " --distance " + exact_text(*details.distance);
  return words;
}

}  // namespace cellsweep::app
