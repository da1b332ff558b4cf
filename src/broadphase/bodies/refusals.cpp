#include "broadphase/bodies/refusals.h"

#include <algorithm>
#include <string>
#include <vector>

#include "base/body_names.h"
#include "base/sorting/key_sort.h"
#include "base/text.h"
#include "geometry/box_fault.h"
#include "geometry/canonical.h"

namespace cellsweep {
namespace {

template <class IsAtFault>
std::vector<BodyId> all_where(std::span<const BodyId> ids, IsAtFault&& is_at_fault) {
  std::vector<BodyId> bad;
  std::copy_if(ids.begin(), ids.end(), std::back_inserter(bad), is_at_fault);
  return bad;
}

[[gnu::cold, gnu::noinline]] Status bad_bodies(StatusCode code, const std::vector<BodyId>& bad,
                                               const char* why) {
  return Status::bad_bodies(code, text(subject(std::span(bad)), " ", why, "."), bad);
}

Status refuse(StatusCode code, const std::vector<BodyId>& bad, const char* why) {
  return bad.empty() ? Status() : bad_bodies(code, bad, why);
}

[[gnu::cold, gnu::noinline]] Status over_capacity(std::string_view engine, const Capacity& capacity,
                                                  std::uint64_t wanted) {
  const std::string mend =
      capacity.setting.empty() ? "no setting raises this limit" : "raise " + capacity.setting;
  return Status::over_capacity(text("Engine ", engine, " takes ", capacity.bodies, " bodies, ", wanted,
                                    " were asked for: ", capacity.reason, "; ", mend, "."),
                               wanted, capacity.bodies, capacity.setting);
}

}  // namespace

Status length_status(std::size_t ids, std::size_t others, std::string_view what) {
  return Status::bad_input(
      text("There are ", ids, " ids but ", others, " ", what, "; one for each id is needed."));
}

Status find_invalid_boxes(std::span<const BodyId> ids, std::span<const Aabb> boxes) {
  std::vector<BodyId> bad;
  std::string faults;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Aabb box = canonical(boxes[i]);
    if (is_valid(box)) continue;
    const BodyId body = ids.empty() ? static_cast<BodyId>(i) : ids[i];
    bad.push_back(body);
    if (bad.size() <= Status::kMostBodies) {
      faults += text(bad.size() == 1 ? "" : "; body ", bad.size() == 1 ? "" : text(body, ": "),
                     describe_fault(boxes[i]));
    }
  }
  if (bad.empty()) return {};
  if (bad.size() > Status::kMostBodies) faults += text("; and ", bad.size() - Status::kMostBodies, " more");
  return Status::bad_bodies(StatusCode::invalid_box,
                            text("The box of body ", bad.front(), " is refused: ", faults, "."), bad);
}

Status find_unknown(const IdTable& table, std::span<const BodyId> ids) {
  return refuse(StatusCode::unknown_body,
                all_where(ids, [&](BodyId id) { return table.find(id) == kNoSlot; }), "not in the engine");
}

Status find_unseen(std::span<const BodyId> ids, const std::function<bool(BodyId)>& is_unseen) {
  return refuse(StatusCode::unknown_body, all_where(ids, is_unseen), "unknown to the last update");
}

Status find_held(const IdTable& table, std::span<const BodyId> ids) {
  return refuse(StatusCode::duplicate_body,
                all_where(ids, [&](BodyId id) { return table.find(id) != kNoSlot; }),
                "in the engine already");
}

// Each once, in the order of the call.
Status find_listed_twice(std::span<const BodyId> ids) {
  std::vector<BodyId> sorted(ids.begin(), ids.end());
  sort_numbers(sorted);
  std::vector<BodyId> twice;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i] == sorted[i - 1] && (twice.empty() || twice.back() != sorted[i]))
      twice.push_back(sorted[i]);
  }
  std::vector<bool> named(twice.size(), false);
  return refuse(StatusCode::duplicate_body,
                all_where(ids,
                          [&](BodyId id) {
                            const auto found = std::lower_bound(twice.begin(), twice.end(), id);
                            if (found == twice.end() || *found != id) return false;
                            const auto place = static_cast<std::size_t>(found - twice.begin());
                            const bool is_first = !named[place];
                            named[place] = true;
                            return is_first;
                          }),
                "listed twice in one call");
}

Status check_capacity(std::string_view engine, const Capacity& capacity, std::uint64_t wanted) {
  return wanted <= capacity.bodies ? Status() : over_capacity(engine, capacity, wanted);
}

bool ascends(std::span<const BodyId> ids) {
  bool good = true;
  for (std::size_t i = 1; i < ids.size(); ++i) good &= ids[i - 1] < ids[i];
  return good;
}

}  // namespace cellsweep
