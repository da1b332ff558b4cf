/// @file
/// The worlds of some rows, the questions to them, and those who have built their trees of them.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "bench/queries/query_check.h"
#include "bench/queries/query_peer.h"
#include "bench/queries/query_world.h"

namespace cellsweep::bench {

/// What rows have in common that are about the same worlds.
struct StageSetting {
  std::string world;
  std::size_t bodies = 0;
  std::size_t questions = 8'192;  ///< of each kind, to all worlds together

  friend bool operator==(const StageSetting&, const StageSetting&) = default;
};

/// Some worlds of a kind: small ones are several, one after the other, so that the processor's caches and
/// branch predictors know none of them by heart.
class QueryStage {
 public:
  explicit QueryStage(const StageSetting& setting);

  const StageSetting& setting() const { return setting_; }
  std::size_t worlds() const { return worlds_.size(); }

  /// Of one world.
  const Questions& questions(std::size_t world, QuestionKind kind);
  /// One who has entered a world's bodies, and stays until the stage goes.
  QueryPeer& peer(std::size_t world, const QueryPeerInfo& info);

  /// What is wrong with the peer's answers: they are compared with those of the first row of the table, and
  /// these with what looking at all boxes finds to the first few questions. Empty if nothing is.
  const std::string& fault(const QueryPeerInfo& info, QuestionKind kind);

  /// The peer's to all worlds together, found with fault().
  std::size_t answers(const QueryPeerInfo& info, QuestionKind kind);
  std::uint64_t hash(const QueryPeerInfo& info, QuestionKind kind);

 private:
  struct Verdict {
    std::string fault;
    std::size_t answers = 0;
    std::uint64_t hash = 0;
  };
  const Verdict& verdict(const QueryPeerInfo& info, QuestionKind kind);
  const Answers& expected(std::size_t world, QuestionKind kind, std::string& fault);

  StageSetting setting_;
  std::vector<std::unique_ptr<QueryWorld>> worlds_;
  std::vector<QuestionSizes> sizes_;
  std::map<std::pair<std::size_t, QuestionKind>, Questions> questions_;
  std::map<std::pair<std::size_t, QuestionKind>, Answers> expected_;
  std::map<std::pair<std::size_t, std::string_view>, std::unique_ptr<QueryPeer>> peers_;
  std::map<std::pair<std::string_view, QuestionKind>, Verdict> verdicts_;
};

/// The stage of a setting; the one before goes.
QueryStage& stage_of(const StageSetting& setting);

}  // namespace cellsweep::bench
