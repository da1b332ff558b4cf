/// @file
/// Questions as lines of JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/question.h"

namespace cellsweep::app {

/// A question for each line of a file of JSON objects, {"box": [0, 0, 0, 1, 1, 1]}; empty lines are none.
/// `file` is its name for messages. Errors: bad_input, which names the line.
Result<std::vector<Question>> questions_of_lines(const std::string& lines, const std::string& file);

/// The question as a line of such a file.
nlohmann::ordered_json question_json(const Question& question);

}  // namespace cellsweep::app
