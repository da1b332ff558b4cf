/// @file
/// Many questions at a time: by the workers of the engine, and close ones one after the other.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "base/tuning.h"
#include "broadphase/last_update.h"
#include "cellsweep/query.h"
#include "engines/stream/cells/cell_tree.h"

namespace cellsweep::queries {

inline const Aabb& where(const Aabb& box) {
  return box;
}
inline const Aabb& where(const Region& region) {
  return region.box;
}
inline const Aabb& where(const Path& path) {
  return path.box;
}

/// Runs a batch. The workers are one batch's at a time; another one is run by its caller alone.
class Batch {
 public:
  explicit Batch(const LastUpdate& last)
      : crew_(last.crew),
        crew_is_taken_(last.crew_is_taken),
        is_mine_(!last.crew_is_taken.test_and_set(std::memory_order_acquire)),
        root_(last.cells.root) {}
  Batch(const Batch&) = delete;
  Batch& operator=(const Batch&) = delete;
  ~Batch() {
    if (is_mine_) crew_is_taken_.clear(std::memory_order_release);
  }

  /// Calls `answer(i)` for each question, from several threads.
  template <class Question, class Answer>
  void for_each(std::span<const Question> questions, const Answer& answer) {
    const std::vector<std::uint32_t> order = order_of(questions);
    run(parts_of(questions.size()), [&](std::size_t part) {
      const Share share = share_of(questions.size(), part);
      for (std::size_t i = share.first; i < share.last; ++i) answer(order.empty() ? i : order[i]);
    });
  }

  /// Calls `list(i, answers)`, which appends the answers to a question, for each of them.
  template <class Question, class Answer, class List>
  void list(std::span<const Question> questions, BatchAnswers<Answer>& found, const List& list) {
    const std::vector<std::uint32_t> order = order_of(questions);
    const auto place = [&](std::size_t i) { return order.empty() ? i : order[i]; };
    std::vector<std::vector<Answer>> lists(parts_of(questions.size()));
    found.first.assign(questions.size() + 1, 0);
    run(lists.size(), [&](std::size_t part) {
      const Share share = share_of(questions.size(), part);
      for (std::size_t i = share.first; i < share.last; ++i) {
        const std::size_t before = lists[part].size();
        list(place(i), lists[part]);
        found.first[place(i) + 1] = lists[part].size() - before;
      }
    });
    std::partial_sum(found.first.begin(), found.first.end(), found.first.begin());
    found.answers.resize(found.first.back());
    run(lists.size(), [&](std::size_t part) {
      const Share share = share_of(questions.size(), part);
      auto from = lists[part].begin();
      for (std::size_t i = share.first; i < share.last; ++i) {
        const std::size_t first = found.first[place(i)];
        const auto count = static_cast<std::ptrdiff_t>(found.first[place(i) + 1] - first);
        std::copy(from, from + count, found.answers.begin() + static_cast<std::ptrdiff_t>(first));
        from += count;
      }
    });
  }

 private:
  static std::size_t parts_of(std::size_t questions) {
    return (questions + tuning::kQuestionsOfPart - 1) / tuning::kQuestionsOfPart;
  }
  static Share share_of(std::size_t questions, std::size_t part) {
    const std::size_t first = part * tuning::kQuestionsOfPart;
    return {first, std::min(first + tuning::kQuestionsOfPart, questions)};
  }

  template <class Job>
  void run(std::size_t parts, const Job& job) {
    if (!is_mine_) {
      for (std::size_t part = 0; part < parts; ++part) job(part);
      return;
    }
    crew_.plan(parts * tuning::kQuestionsOfPart, tuning::kQuestionGuess);
    crew_.for_each(parts, 1, [&](unsigned, std::size_t part) { job(part); });
  }

  /// By the cells in which questions begin: what one has read is in the cache for the next. Empty: as they
  /// are.
  template <class Question>
  std::vector<std::uint32_t> order_of(std::span<const Question> questions) const {
    if (root_ == nullptr || questions.size() < tuning::kQuestionsSorted) return {};
    std::vector<std::uint32_t> next(root_->grid.cells() + 1, 0);
    std::vector<std::uint32_t> cells(questions.size());
    for (std::size_t i = 0; i < questions.size(); ++i) {
      cells[i] = root_->grid.block_of(where(questions[i])).first;
      ++next[cells[i] + 1];
    }
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<std::uint32_t> order(questions.size());
    for (std::size_t i = 0; i < questions.size(); ++i)
      order[next[cells[i]]++] = static_cast<std::uint32_t>(i);
    return order;
  }

  Crew& crew_;
  std::atomic_flag& crew_is_taken_;
  bool is_mine_;
  const stream::Node* root_;
};

}  // namespace cellsweep::queries
