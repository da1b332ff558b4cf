/// @file
/// Questions about the bodies of all ranks: asked of those whose regions are concerned, put together here.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "cellsweep/broadphase.h"
#include "cellsweep/function_ref.h"
#include "cellsweep/ranks.h"
#include "ranks/cuts.h"
#include "ranks/held_bodies.h"
#include "ranks/job.h"
#include "ranks/question_round.h"

namespace cellsweep::ranks {

/// All collective; what they promise stands at DistributedQueries.
class RankQueries {
 public:
  using Filter = std::optional<BodyFilter>;

  RankQueries(const Job& job, const Cuts& cuts, const HeldBodies& held, const Broadphase& engine)
      : job_(job), cuts_(cuts), held_(held), engine_(engine) {}

  Status find_overlaps(std::span<const cellsweep::Region> regions, BatchAnswers<GlobalId>& found,
                       const Filter& as) const;
  Status find_touches(std::span<const Path> paths, BatchAnswers<GlobalTouch>& found, const Filter& as) const;
  Status first_touches(std::span<const Path> paths, std::span<std::optional<GlobalTouch>> first,
                       const Filter& as) const;
  Status find_nearest(std::span<const Aabb> boxes, std::size_t count, BatchAnswers<GlobalNeighbor>& found,
                      double most, const Filter& as) const;
  Status find_within(std::span<const cellsweep::Region> regions, BatchAnswers<GlobalNeighbor>& found,
                     const Filter& as) const;

 private:
  using QuestionsByRank = std::vector<std::vector<QuestionRow>>;

  template <class Reached>
  void send(const QuestionRow& question, const Reached& reached, QuestionsByRank& to) const;
  QuestionsByRank regions_by_rank(std::span<const cellsweep::Region> regions, const Filter& as) const;
  QuestionsByRank paths_by_rank(std::span<const Path> paths, const Filter& as) const;
  QuestionsByRank to_homes(std::span<const Aabb> boxes, std::size_t count, double most,
                           const Filter& as) const;

  /// The questions of this rank, how ranks answer them, and what becomes of the answers, which are sorted.
  struct Asking {
    FunctionRef<QuestionsByRank()> questions;
    Answerer answerer;
    FunctionRef<void(const std::vector<AnswerRow>&)> take;
  };
  Status ask(const Status& allowed, const Asking& asking) const;
  Status find_nearest_within(const Status& allowed, std::span<const cellsweep::Region> regions,
                             std::size_t count, BatchAnswers<GlobalNeighbor>& found, const Filter& as) const;

  using Method = Status (RankQueries::*)(Questions, std::vector<AnswerRow>&) const;
  auto answers_of(Method method) const {
    return [this, method](Questions questions, std::vector<AnswerRow>& rows) {
      return (this->*method)(questions, rows);
    };
  }
  template <class Answer>
  void append(std::uint64_t number, std::span<const Answer> found, std::vector<AnswerRow>& answers) const;
  Status answer_overlaps(Questions questions, std::vector<AnswerRow>& answers) const;
  Status answer_touches(Questions questions, std::vector<AnswerRow>& answers) const;
  Status answer_first_touches(Questions questions, std::vector<AnswerRow>& answers) const;
  Status answer_within(Questions questions, std::vector<AnswerRow>& answers) const;
  Status answer_nearest(Questions questions, std::vector<AnswerRow>& answers) const;

  const Job& job_;
  const Cuts& cuts_;
  const HeldBodies& held_;
  const Broadphase& engine_;
};

}  // namespace cellsweep::ranks
