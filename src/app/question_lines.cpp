#include "app/question_lines.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "app/suggestion.h"
#include "base/text.h"
#include "report/units.h"

namespace cellsweep::app {
namespace {

using Json = nlohmann::ordered_json;

/// What a line of a file asks, taken from it key by key.
class QuestionLine {
 public:
  QuestionLine(const std::string& line, std::string where) : where_(std::move(where)) {
    object_ = Json::parse(line, nullptr, false);
  }

  Result<Question> read() {
    if (!object_.is_object()) return fault("a JSON object is wanted, such as {\"point\": [0, 0, 0]}.");
    for (const auto& [key, value] : object_.items()) {
      if (Status status = take(key, value); !status.ok()) return status;
    }
    if (question_.kind == nullptr) return fault(text("it asks nothing; there are: ", kind_names(), "."));
    const std::string where = text(where_, ", ", question_.kind->name);
    if (Status status = check_question(question_, where, ""); !status.ok()) return status;
    return std::move(question_);
  }

 private:
  Status fault(const std::string& what) const { return Status::bad_input(text(where_, ": ", what)); }

  static std::string kind_names() {
    std::string names;
    for (const QuestionKind& kind : question_kinds())
      names.append(names.empty() ? "" : ", ").append(kind.name);
    return names;
  }

  Status take(const std::string& key, const Json& value) {
    for (const QuestionKind& kind : question_kinds()) {
      if (key == kind.name) return take_numbers(kind, value);
    }
    QuestionDetails& details = question_.details;
    if (key == "end") return take_number(key, value, details.end);
    if (key == "most") return take_number(key, value, details.most);
    if (key == "distance") return take_number(key, value, details.distance);
    if (key == "first") return take_truth(key, value, details.first);
    if (key == "any") return take_truth(key, value, details.any);
    if (key == "count") return take_whole(key, value, details.count);
    if (key == "as") return take_filter(value);
    return unknown(key);
  }

  Status unknown(const std::string& key) const {
    std::vector<std::string> keys = {"as"};
    for (const QuestionKind& kind : question_kinds()) keys.emplace_back(kind.name);
    for (const std::string_view detail : detail_names()) keys.emplace_back(detail);
    const auto meant = nearest(key, keys);
    return fault(text("there is no \"", key, "\"", meant ? "; did you mean " + *meant + "?" : "."));
  }

  Status take_numbers(const QuestionKind& kind, const Json& value) {
    if (question_.kind != nullptr)
      return fault(
          text("it asks for ", question_.kind->name, " and for ", kind.name, "; a line has one question."));
    question_.kind = &kind;
    const bool are_numbers = value.is_array() && std::all_of(value.begin(), value.end(),
                                                             [](const Json& one) { return one.is_number(); });
    if (!are_numbers) return fault(text(kind.name, " is a list of numbers, not ", value.dump(), "."));
    question_.numbers = value.get<std::vector<double>>();
    return {};
  }

  Status take_number(const std::string& key, const Json& value, std::optional<double>& number) const {
    if (!value.is_number() || value.get<double>() < 0)
      return fault(text(key, " is a number, 0 or more, not ", value.dump(), "."));
    number = value.get<double>();
    return {};
  }

  Status take_whole(const std::string& key, const Json& value, std::optional<std::uint64_t>& number) const {
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() < 1)
      return fault(text(key, " is a whole number, 1 or more, not ", value.dump(), "."));
    number = value.get<std::uint64_t>();
    return {};
  }

  Status take_truth(const std::string& key, const Json& value, bool& truth) const {
    if (!value.is_boolean()) return fault(text(key, " is true or false, not ", value.dump(), "."));
    truth = value.get<bool>();
    return {};
  }

  Status take_bits(const std::string& key, const Json& value, std::uint32_t& bits) const {
    const auto most = std::numeric_limits<std::uint32_t>::max();
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() > most)
      return fault(
          text(key, " is a whole number, 0 to ", report::count_text(most), ", not ", value.dump(), "."));
    bits = value.get<std::uint32_t>();
    return {};
  }

  Status take_filter(const Json& value) {
    if (!value.is_object())
      return fault(text("as is an object, such as {\"mask\": 2}, not ", value.dump(), "."));
    BodyFilter& filter = question_.as.emplace();
    for (const auto& [key, part] : value.items()) {
      Status status = fault(text("as has category, mask and static, not \"", key, "\"."));
      if (key == "category") status = take_bits(key, part, filter.category);
      if (key == "mask") status = take_bits(key, part, filter.mask);
      if (key == "static") status = take_truth(key, part, filter.is_static);
      if (!status.ok()) return status;
    }
    return {};
  }

  std::string where_;
  Json object_;
  Question question_;
};

}  // namespace

Result<std::vector<Question>> questions_of_lines(const std::string& lines, const std::string& file) {
  std::vector<Question> questions;
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < lines.size();) {
    const std::size_t end = std::min(lines.find('\n', begin), lines.size());
    const std::string line = lines.substr(begin, end - begin);
    begin = end + 1;
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    auto question = QuestionLine(line, text(file, ", line ", number)).read();
    if (!question) return question.status();
    questions.push_back(std::move(*question));
  }
  return questions;
}

nlohmann::ordered_json question_json(const Question& question) {
  const QuestionDetails& details = question.details;
  Json json;
  Json& numbers = json[std::string(question.kind->name)] = Json::array();
  for (const double number : question.numbers) {
    if (question.kind->form == QuestionForm::pairs_of) {
      numbers.push_back(static_cast<std::uint32_t>(number));
    } else {
      numbers.push_back(number);
    }
  }
  if (details.end) json["end"] = *details.end;
  if (details.first) json["first"] = true;
  if (details.any) json["any"] = true;
  if (details.count) json["count"] = *details.count;
  if (details.most) json["most"] = *details.most;
  if (details.distance) json["distance"] = *details.distance;
  if (question.as) {
    json["as"] = {
        {"category", question.as->category}, {"mask", question.as->mask}, {"static", question.as->is_static}};
  }
  return json;
}

}  // namespace cellsweep::app
