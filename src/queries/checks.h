/// @file
/// Whether a question can be answered, and the sentences that refuse one.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "cellsweep/query.h"

namespace cellsweep::queries {

/// `place` is that of the question in a batch.
Status check(const Aabb& box, std::optional<std::size_t> place = {});
Status check(const Region& region, std::optional<std::size_t> place = {});
Status check(const Path& path, std::optional<std::size_t> place = {});

/// The first one that is refused, or an ok status.
template <class Question>
Status check_all(std::span<const Question> questions) {
  for (std::size_t i = 0; i < questions.size(); ++i) {
    if (Status status = check(questions[i], i); !status.ok()) return status;
  }
  return {};
}

/// That of find_nearest().
Status check_most(double most);

/// There must be room for an answer to each question.
Status check_room(std::size_t questions, std::size_t room);

}  // namespace cellsweep::queries
