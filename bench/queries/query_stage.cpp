#include "bench/queries/query_stage.h"

#include <algorithm>

namespace cellsweep::bench {
namespace {

std::size_t worlds_with(std::size_t bodies) {
  constexpr std::size_t kMostWorlds = 8;
  constexpr std::size_t kBodiesInAll = 200'000;
  return std::clamp<std::size_t>(kBodiesInAll / bodies, 1, kMostWorlds);
}

/// As many questions as looking at all boxes takes a quarter of a second for.
std::size_t questions_to_check(std::size_t bodies) {
  return std::clamp<std::size_t>(30'000'000 / bodies, 8, 256);
}

}  // namespace

QueryStage::QueryStage(const StageSetting& setting) : setting_(setting) {
  for (std::size_t i = 0; i < worlds_with(setting.bodies); ++i) {
    worlds_.push_back(std::make_unique<QueryWorld>(setting.world, setting.bodies, i + 1));
    sizes_.push_back(find_sizes(worlds_[i]->boxes(), worlds_[i]->bounds()));
  }
}

const Questions& QueryStage::questions(std::size_t world, QuestionKind kind) {
  const auto [entry, is_new] = questions_.try_emplace({world, kind});
  if (is_new) {
    const QueryWorld& about = *worlds_[world];
    entry->second = make_questions(kind, setting_.questions / worlds_.size(), about.boxes(), about.bounds(),
                                   sizes_[world], world + 1);
  }
  return entry->second;
}

QueryPeer& QueryStage::peer(std::size_t world, const QueryPeerInfo& info) {
  std::unique_ptr<QueryPeer>& peer = peers_[{world, info.name}];
  if (!peer) {
    peer = info.make();
    peer->build(worlds_[world]->boxes());
  }
  return *peer;
}

const Answers& QueryStage::expected(std::size_t world, QuestionKind kind, std::string& fault) {
  const auto [entry, is_new] = expected_.try_emplace({world, kind});
  if (is_new) {
    const QueryPeerInfo& judge = query_peer_table().front();
    const Questions& asked = questions(world, kind);
    const auto boxes = worlds_[world]->boxes();
    entry->second = ask_all(peer(world, judge), judge, asked);
    const Answers truth = answer_by_looking_at_all(asked, boxes, questions_to_check(boxes.size()));
    fault = find_fault(entry->second, truth, asked, boxes, slack_of(worlds_[world]->bounds()));
  }
  return entry->second;
}

const QueryStage::Verdict& QueryStage::verdict(const QueryPeerInfo& info, QuestionKind kind) {
  const auto [entry, is_new] = verdicts_.try_emplace({info.name, kind});
  Verdict& verdict = entry->second;
  for (std::size_t i = 0; is_new && i < worlds_.size(); ++i) {
    std::string fault;
    const Answers& truth = expected(i, kind, fault);
    const Questions& asked = questions(i, kind);
    const Answers answers = ask_all(peer(i, info), info, asked);
    if (fault.empty())
      fault = find_fault(answers, truth, asked, worlds_[i]->boxes(), slack_of(worlds_[i]->bounds()));
    if (verdict.fault.empty()) verdict.fault = fault;
    verdict.answers += answers.answers.size();
    verdict.hash = mix64(verdict.hash + hash_of(answers));
  }
  return verdict;
}

const std::string& QueryStage::fault(const QueryPeerInfo& info, QuestionKind kind) {
  return verdict(info, kind).fault;
}
std::size_t QueryStage::answers(const QueryPeerInfo& info, QuestionKind kind) {
  return verdict(info, kind).answers;
}
std::uint64_t QueryStage::hash(const QueryPeerInfo& info, QuestionKind kind) {
  return verdict(info, kind).hash;
}

QueryStage& stage_of(const StageSetting& setting) {
  static std::unique_ptr<QueryStage> stage;
  if (stage && stage->setting() == setting) return *stage;
  stage.reset();
  stage = std::make_unique<QueryStage>(setting);
  return *stage;
}

}  // namespace cellsweep::bench
