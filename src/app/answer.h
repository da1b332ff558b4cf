/// @file
/// Asks a world and writes down what it answers.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

#include "app/question.h"
#include "cellsweep/query.h"

namespace cellsweep::app {

/// Whether there is one, or all there are, in the order of query.h.
using Answer =
    std::variant<bool, std::vector<BodyId>, std::vector<Touch>, std::vector<Neighbor>, std::vector<Pair>>;

/// The region or the path that a question is about.
Region region_of(const Question& question);
Path path_of(const Question& question);

/// Errors: those of the query, behind the question's words.
Result<Answer> ask(const Broadphase& world, const Question& question);

/// {"question": ..., "count": ..., "bodies": [...]}.
nlohmann::ordered_json answer_json(const Question& question, const Answer& answer);

/// Some lines for a person, the first of which is the question.
std::string answer_text(const Question& question, const Answer& answer);

}  // namespace cellsweep::app
