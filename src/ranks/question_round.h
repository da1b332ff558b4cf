/// @file
/// Questions to the ranks that may know answers, and the answers back.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cellsweep/function_ref.h"
#include "cellsweep/ranks.h"
#include "ranks/job.h"
#include "ranks/messages.h"

namespace cellsweep::ranks {

/// One question, of whichever kind all ranks ask now.
struct QuestionRow {
  std::uint64_t number;  ///< among those of its rank
  Aabb box;
  std::array<double, 3> direction;
  double reach;  ///< a distance, or the end of a path
  std::uint64_t count;
  FilterRow as;
  std::uint32_t has_as;
};
static_assert(sizeof(QuestionRow) == 88);

/// A body that answers question `number`; what `value` is depends on the kind.
struct AnswerRow {
  std::uint64_t number;
  GlobalId body;
  double value;
};

using Questions = std::span<const QuestionRow>;

/// Answers questions of one rank from what this rank has; may throw std::bad_alloc.
using Answerer = FunctionRef<Status(Questions questions, std::vector<AnswerRow>& answers)>;

/// Collective. `to` has the questions for each rank, this one among them. All answers are put into `answers`,
/// in no order. Errors, the same on all ranks: what an answerer says, capacity.
Status ask_ranks(const Job& job, std::span<const std::vector<QuestionRow>> to, Answerer answerer,
                 std::vector<AnswerRow>& answers);

}  // namespace cellsweep::ranks
