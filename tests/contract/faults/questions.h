/// @file
/// Every question that a world can be asked, with the true answer beside it.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cellsweep/query.h"
#include "queries/random_questions.h"
#include "queries/reference.h"

namespace cellsweep::contract {

/// Asked into memory of its own, a new one each time.
struct Question {
  std::string name;
  std::function<Status()> ask;
  std::function<bool()> is_right;  ///< of the last answer
};

/// Of a batch: enough for several threads, and for being sorted.
inline constexpr std::size_t kBatch = 260;

/// Random questions, one of each kind, alone and in a batch.
std::vector<Question> make_questions(const Queries& queries, const queries::Reference& world,
                                     std::uint64_t seed);

}  // namespace cellsweep::contract
