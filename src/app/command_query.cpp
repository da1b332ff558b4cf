#include <algorithm>
#include <charconv>
#include <iostream>
#include <iterator>
#include <memory>
#include <utility>

#include "app/answer.h"
#include "app/checks.h"
#include "app/commands.h"
#include "app/engine_flags.h"
#include "app/frame_range.h"
#include "app/output.h"
#include "app/question_lines.h"
#include "app/scene_flags.h"
#include "base/text.h"
#include "cellsweep/world/frame_file.h"
#include "report/table.h"
#include "report/text_file.h"

namespace cellsweep::app {
namespace {

constexpr const char* kQuestionGroup = "Questions";
constexpr const char* kDetailGroup = "What more is said of questions";
constexpr const char* kAnswerGroup = "Which bodies are answers";
constexpr const char* kStandardInput = "-";

/// What --as-category and its like say, as typed.
struct FilterFlags {
  std::string category;
  std::string mask;
  bool is_static = false;

  Result<std::optional<BodyFilter>> filter() const {
    std::optional<BodyFilter> filter;
    if (category.empty() && mask.empty() && !is_static) return filter;
    filter.emplace().is_static = is_static;
    if (Status status = read_bits("--as-category", category, filter->category); !status.ok()) return status;
    if (Status status = read_bits("--as-mask", mask, filter->mask); !status.ok()) return status;
    return filter;
  }

 private:
  // 6 or 0x6; nothing typed leaves them as they are.
  static Status read_bits(const char* flag, const std::string& typed, std::uint32_t& bits) {
    if (typed.empty()) return {};
    const bool is_hex = typed.starts_with("0x");
    const char* const end = typed.data() + typed.size();
    const auto [last, error] = std::from_chars(typed.data() + (is_hex ? 2 : 0), end, bits, is_hex ? 16 : 10);
    if (error == std::errc() && last == end) return {};
    return Status::bad_input(
        text(flag, ": bits are wanted, 0 to 4,294,967,295 or 0x0 to 0xffffffff, not \"", typed, "\"."));
  }
};

struct Query {
  std::string file;
  SceneFlags scene;
  EngineFlags engines;
  std::size_t frame = 0;
  std::vector<std::pair<const QuestionKind*, std::string>> typed;  // in the order of the command line
  std::string questions_file;
  QuestionDetails details;
  FilterFlags as;
  bool json = false;

  // Questions are looked at before a world is made, which may take long.
  ExitCode run() const {
    if (engines.names().size() != 1) {
      return complain(Status::bad_option("engine", "Questions are asked of one engine at a time.",
                                         engines.names().size(), 1));
    }
    if (const Status status = engines.check(); !status.ok()) return complain(status);
    const auto questions = all_questions();
    if (!questions) return complain(questions.status());
    const auto source = make_source();
    if (!source) return complain(source.status());
    const auto world = make_world(**source);
    if (!world) return complain(world.status());
    std::vector<Answer> answers;
    for (const Question& question : *questions) {
      auto answer = ask(*world, question);
      if (!answer) return complain(answer.status());
      answers.push_back(std::move(*answer));
    }
    print((*source)->name(), *world, *questions, answers);
    return kGood;
  }

 private:
  Result<std::vector<Question>> all_questions() const {
    std::vector<Question> questions;
    for (const auto& [kind, numbers] : typed) {
      auto question = question_of_flag(*kind, numbers, details);
      if (!question) return question.status();
      questions.push_back(std::move(*question));
    }
    if (Status status = check_details(); !status.ok()) return status;
    if (Status status = add_written(questions); !status.ok()) return status;
    if (questions.empty()) return nothing_asked();
    const auto filter = as.filter();
    if (!filter) return filter.status();
    for (Question& question : questions) {
      if (!question.as) question.as = *filter;
    }
    return questions;
  }

  Status check_details() const {
    std::vector<const QuestionKind*> kinds;
    for (const auto& [kind, numbers] : typed) kinds.push_back(kind);
    const std::string flag = useless_detail(details, kinds);
    if (flag.empty()) return {};
    return Status::bad_input(text(flag,
                                  " is of no question on this command line; query --help says of which "
                                  "it is."));
  }

  Status add_written(std::vector<Question>& questions) const {
    if (questions_file.empty()) return {};
    const bool is_standard_input = questions_file == kStandardInput;
    const auto lines = is_standard_input ? read_standard_input() : report::read_text_file(questions_file);
    if (!lines) return lines.status();
    auto written = questions_of_lines(*lines, is_standard_input ? "standard input" : questions_file);
    if (!written) return written.status();
    std::move(written->begin(), written->end(), std::back_inserter(questions));
    return {};
  }

  static Result<std::string> read_standard_input() {
    std::string lines(std::istreambuf_iterator<char>(std::cin), {});
    if (std::cin.bad()) return Status::bad_input("Standard input cannot be read.");
    return lines;
  }

  static Status nothing_asked() {
    std::string flags;
    for (const QuestionKind& kind : question_kinds()) flags += flag_of(kind.name) + ", ";
    return Status::bad_input(text("Nothing is asked; questions are ", flags, "or lines of --questions."));
  }

  Result<std::unique_ptr<FrameSource>> make_source() const {
    if (file.empty()) return make_scene_frames(scene.settings);
    const auto recording = read_frame_file(file);
    if (!recording) return recording.status();
    return recording->make_source();
  }

  // As it is after any number of updates: an engine that saw the frames before has no other pairs and boxes.
  Result<Broadphase> make_world(FrameSource& source) const {
    std::size_t at = 0;
    if (Status status = go_to_frame(source, at, frame, "query"); !status.ok()) return status;
    auto made = engines.make(source.bodies().size());
    if (!made) return made.status();
    report::FedEngine& fed = made->front();
    if (Status status = report::insert_all(fed.engine, source, fed.shape); !status.ok()) return status;
    if (const auto changes = fed.engine.update(); !changes) return changes.status();
    return std::move(fed.engine);
  }

  void print(const std::string& source, const Broadphase& world, const std::vector<Question>& questions,
             const std::vector<Answer>& answers) const {
    if (json) return print_json(as_json(source, world, questions, answers));
    report::Table table({"source", "engine", "frame", "bodies"}, 2);
    table.add({source, std::string(world.name()), text(frame), text(world.size())});
    print_text(table.text());
    for (std::size_t i = 0; i < answers.size(); ++i) print_text("\n" + answer_text(questions[i], answers[i]));
  }

  nlohmann::ordered_json as_json(const std::string& source, const Broadphase& world,
                                 const std::vector<Question>& questions,
                                 const std::vector<Answer>& answers) const {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < answers.size(); ++i) list.push_back(answer_json(questions[i], answers[i]));
    return {{"source", source},
            {"engine", world.name()},
            {"frame", frame},
            {"bodies", world.size()},
            {"answers", std::move(list)}};
  }
};

void add_question_flags(CLI::App& command, Query& query) {
  for (const QuestionKind& kind : question_kinds()) {
    const auto take = [&query, &kind](const std::string& numbers) {
      query.typed.emplace_back(&kind, numbers);
    };
    // Each at its place on the command line, so that answers come in the order of the questions.
    command.add_option_function<std::string>(flag_of(kind.name), take, std::string(kind.help))
        ->type_name(std::string(kind.shape))
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
        ->trigger_on_parse()
        ->group(kQuestionGroup);
  }
  command
      .add_option("--questions", query.questions_file,
                  "A file with a question a line as JSON; - for standard input")
      ->type_name("FILE")
      ->group(kQuestionGroup);
}

void add_detail_flags(CLI::App& command, QuestionDetails& details) {
  command
      .add_option("--end", details.end, "Time at which a --ray or --sweep ends, in lengths of its direction")
      ->check(number(0))
      ->type_name("T")
      ->group(kDetailGroup)
      ->default_str("of a ray none, of a sweep 1");
  auto* first =
      command.add_flag("--first", details.first, "Only what a --ray, --segment or --sweep touches first")
          ->group(kDetailGroup);
  command.add_flag("--any", details.any, "Only whether there is one; not of --nearest, --within, --pairs-of")
      ->excludes(first)
      ->group(kDetailGroup);
  command.add_option("--count", details.count, "How many of the --nearest")
      ->check(count(1))
      ->type_name("K")
      ->group(kDetailGroup)
      ->default_str("1");
  command.add_option("--most", details.most, "How far the --nearest may be")
      ->check(number(0))
      ->type_name("D")
      ->group(kDetailGroup)
      ->default_str("any distance");
  command.add_option("--distance", details.distance, "How far bodies --within it may be")
      ->check(number(0))
      ->type_name("D")
      ->group(kDetailGroup);
}

void add_filter_flags(CLI::App& command, FilterFlags& as) {
  command.add_option("--as-category", as.category, "Those that a body of these categories may meet")
      ->type_name("BITS")
      ->group(kAnswerGroup)
      ->default_str("all bodies; with --as-mask or --as-static 1");
  command.add_option("--as-mask", as.mask, "Those of these categories")
      ->type_name("BITS")
      ->group(kAnswerGroup)
      ->default_str("all categories");
  command.add_flag("--as-static", as.is_static, "Those that are not static")->group(kAnswerGroup);
}

}  // namespace

void add_query(CLI::App& program, ExitCode& exit_code) {
  CLI::App* command = program.add_subcommand(
      "query", "Ask what is in a region, on a path, or near, in a frame of a scene or recording");
  auto query = std::make_shared<Query>();
  auto* file = command->add_option("FILE", query->file, "A recording; without one, a scene is asked");
  add_question_flags(*command, *query);
  add_detail_flags(*command, query->details);
  add_filter_flags(*command, query->as);
  query->scene.add_to(*command);
  query->scene.add_filters_to(*command);
  SceneFlags::exclude_beside(*command, *file);
  command->add_option("--frame", query->frame, "Frame to ask about")
      ->check(count())
      ->type_name("N")
      ->capture_default_str();
  query->engines.add_to(*command, EngineFlags::Purpose::a_look, "stream");
  command->add_flag("--json", query->json, "One JSON object on standard output");
  command->footer(
      "Questions are answered in their order; those of a file come last.\n"
      "Examples:\n"
      "  cellsweep query --scene paper --frame 100 --box 0,0,0,2,2,2\n"
      "  cellsweep query bench/scenes/bullet-pile-1024.aabbs --frame 30 --json \\\n"
      "    --ray 0,50,0,0,-1,0 --first --nearest 0,0,0 --count 5\n"
      "  cellsweep query --within 0,0,0 --distance 1.5 --pairs-of 7,12\n"
      "  echo '{\"point\": [1, 2, 3]}' | cellsweep query --questions -");
  command->callback([query, &exit_code] { exit_code = query->run(); });
}

}  // namespace cellsweep::app
