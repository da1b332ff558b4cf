#include "report/verify.h"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "base/text.h"
#include "engines/oracle/brute_force.h"
#include "report/progress.h"
#include "report/run_engine.h"

namespace cellsweep::report {
namespace {

using Pairs = std::vector<Pair>;

Pairs without(const Pairs& all, const Pairs& some) {
  Pairs rest;
  std::set_difference(all.begin(), all.end(), some.begin(), some.end(), std::back_inserter(rest));
  return rest;
}

// One engine's side of the comparison; keeps what the engine said the frame before.
class Judge {
 public:
  explicit Judge(const Broadphase& engine) { report_.engine = engine.name(); }

  void compare(const Broadphase& engine, const PairChanges& changes, const Pairs& truth,
               std::span<const Aabb> boxes) {
    Pairs found(engine.pairs().begin(), engine.pairs().end());
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

  const VerifyReport& report() const { return report_; }

 private:
  void note(Pair pair, bool missed, std::span<const Aabb> boxes) {
    if (report_.first) return;
    // An engine that invents pairs may invent bodies, too.
    const auto box = [&](BodyId id) { return id < boxes.size() ? boxes[id] : Aabb{}; };
    report_.first = Difference{report_.frames, pair, missed, box(pair.a), box(pair.b)};
  }

  std::size_t wrong_changes(const PairChanges& changes, const Pairs& found) const {
    const auto differ = [](std::span<const Pair> said, const Pairs& should) {
      return std::equal(said.begin(), said.end(), should.begin(), should.end()) ? 0U : 1U;
    };
    return differ(changes.began, without(found, before_)) + differ(changes.ended, without(before_, found));
  }

  VerifyReport report_;
  Pairs before_;
};

// The boxes that an engine made of all bodies.
Result<std::vector<Aabb>> handed_out_boxes(const Broadphase& engine, std::size_t bodies) {
  std::vector<BodyId> ids(bodies);
  std::iota(ids.begin(), ids.end(), BodyId{0});
  std::vector<Aabb> boxes(bodies);
  if (Status status = engine.boxes(ids, boxes); !status.ok()) return status;
  return boxes;
}

}  // namespace

Result<std::vector<VerifyReport>> verify_engines(std::span<const std::unique_ptr<Broadphase>> engines,
                                                 FrameSource& source, std::size_t updates, Shape shape) {
  std::vector<Judge> judges;
  for (const auto& engine : engines) {
    if (Status status = insert_all(*engine, source, shape); !status.ok()) return status;
    judges.emplace_back(*engine);
  }
  Progress progress("verify", updates);
  for (std::size_t frame = 0;; ++frame) {
    Pairs truth;
    if (shape == Shape::boxes) truth = brute_force_pairs(source.boxes());
    for (std::size_t i = 0; i < engines.size(); ++i) {
      const auto changes = engines[i]->update();
      if (!changes) return changes.status();
      if (shape == Shape::boxes) {
        judges[i].compare(*engines[i], *changes, truth, source.boxes());
        continue;
      }
      const auto boxes = handed_out_boxes(*engines[i], source.boxes().size());
      if (!boxes) return boxes.status();
      judges[i].compare(*engines[i], *changes, brute_force_pairs(*boxes), *boxes);
    }
    progress.show(frame);
    if (frame == updates || !source.advance()) break;
    for (const auto& engine : engines) {
      if (Status status = move_changed(*engine, source, shape); !status.ok()) return status;
    }
  }
  std::vector<VerifyReport> reports;
  for (const Judge& judge : judges) reports.push_back(judge.report());
  return reports;
}

std::string describe(const Difference& difference) {
  const auto box = [](const Aabb& b) {
    return text("[", b.min[0], " ", b.min[1], " ", b.min[2], "] to [", b.max[0], " ", b.max[1], " ", b.max[2],
                "]");
  };
  return text("frame ", difference.frame, ": pair ", difference.pair.a, " ", difference.pair.b,
              difference.missed ? " overlaps but was not reported" : " was reported but does not overlap",
              "; body ", difference.pair.a, " ", box(difference.box_a), ", body ", difference.pair.b, " ",
              box(difference.box_b));
}

}  // namespace cellsweep::report
