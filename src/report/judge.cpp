#include "report/judge.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/text.h"

namespace cellsweep::report {
namespace {

using Pairs = std::vector<Pair>;

Pairs without(const Pairs& all, const Pairs& some) {
  Pairs rest;
  std::set_difference(all.begin(), all.end(), some.begin(), some.end(), std::back_inserter(rest));
  return rest;
}

std::string box_text(const Aabb& box) {
  return text("[", box.min[0], " ", box.min[1], " ", box.min[2], "] to [", box.max[0], " ", box.max[1], " ",
              box.max[2], "]");
}

}  // namespace

void Judge::compare(std::span<const Pair> said, const PairChanges& changes, const std::vector<Pair>& truth,
                    std::span<const Aabb> boxes) {
  Pairs found(said.begin(), said.end());
  std::sort(found.begin(), found.end());
  const Pairs missed = without(truth, found);
  const Pairs invented = without(found, truth);
  if (!missed.empty()) note(missed.front(), true, boxes);
  if (!invented.empty()) note(invented.front(), false, boxes);
  report_.pairs += truth.size();
  report_.missed += missed.size();
  report_.invented += invented.size();
  report_.wrong_changes += wrong_changes(changes, found);
  ++report_.frames;
  before_ = std::move(found);
}

void Judge::note(Pair pair, bool missed, std::span<const Aabb> boxes) {
  if (report_.first) return;
  // An engine that invents pairs may invent bodies, too.
  const auto box = [&](BodyId id) { return id < boxes.size() ? boxes[id] : Aabb{}; };
  report_.first = Difference{report_.frames, pair, missed, box(pair.a), box(pair.b)};
}

std::size_t Judge::wrong_changes(const PairChanges& changes, const Pairs& found) const {
  const auto differ = [](std::span<const Pair> said, const Pairs& should) {
    return std::equal(said.begin(), said.end(), should.begin(), should.end()) ? 0U : 1U;
  };
  return differ(changes.began, without(found, before_)) + differ(changes.ended, without(before_, found));
}

std::string describe(const Difference& difference) {
  return text("frame ", difference.frame, ": pair ", difference.pair.a, " ", difference.pair.b,
              difference.missed ? " overlaps but was not reported" : " was reported but does not overlap",
              "; body ", difference.pair.a, " ", box_text(difference.box_a), ", body ", difference.pair.b,
              " ", box_text(difference.box_b));
}

}  // namespace cellsweep::report
