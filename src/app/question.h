/// @file
/// Questions to a world, as somebody types them or writes them down.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cellsweep/filter.h"
#include "cellsweep/status.h"

namespace cellsweep::app {

/// What is asked about: a region, a path, what is near, or pairs.
enum class QuestionForm { box, point, sphere, ray, segment, sweep, nearest, within, pairs_of };

/// What more may be said of a question, each of some forms.
struct QuestionDetails {
  std::optional<double> end;  ///< the time at which the path ends
  bool first = false;         ///< the first touch is enough
  bool any = false;           ///< whether there is an answer is enough
  std::optional<std::uint64_t> count;
  std::optional<double> most;  ///< the largest distance of a neighbour
  std::optional<double> distance;

  friend bool operator==(const QuestionDetails&, const QuestionDetails&) = default;
};

/// A form of question: --box of the command, "box" of a file.
struct QuestionKind {
  QuestionForm form;
  std::string_view name;   ///< "pairs_of"
  std::string_view shape;  ///< its numbers as help shows them
  std::string_view help;
  std::size_t numbers = 0;       ///< how many
  std::size_t more_numbers = 0;  ///< or so many
  std::size_t coordinates = 0;   ///< of them, the first ones, are coordinates
};

std::span<const QuestionKind> question_kinds();

/// One that holds together as far as can be known without a world.
struct Question {
  const QuestionKind* kind = nullptr;
  std::vector<double> numbers{};  ///< as typed; coordinates are within the range of a float
  QuestionDetails details{};
  std::optional<BodyFilter> as{};
};

/// The details by the names that they have in a file; a flag is that of a setting.
std::vector<std::string_view> detail_names();

/// Errors: bad_input, behind `where`, for numbers that are too many, too few or too large, and for details
/// that are not of this kind; `sign` is what stands before a detail's name where it was given: "--" of a
/// flag.
Status check_question(const Question& question, const std::string& where, std::string_view sign);

/// A question from "0,0,0,1,1,1" and those of the details that it has. Errors: bad_input, which names the
/// flag.
Result<Question> question_of_flag(const QuestionKind& kind, const std::string& typed,
                                  const QuestionDetails& details);

/// The first of the details that no question of these kinds has, as a flag; empty when each is of use.
std::string useless_detail(const QuestionDetails& details, std::span<const QuestionKind* const> kinds);

/// The question as flags of the command.
std::string question_text(const Question& question);

}  // namespace cellsweep::app
