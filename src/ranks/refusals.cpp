#include "ranks/refusals.h"

#include <algorithm>
#include <string>

#include "base/body_names.h"
#include "base/text.h"
#include "geometry/box_fault.h"
#include "geometry/canonical.h"

namespace cellsweep::ranks {

Status length_status(std::size_t ids, std::size_t others, const char* what) {
  return Status::bad_input(
      text("There are ", ids, " ids but ", others, " ", what, "; one for each id is needed."));
}

Status find_invalid_boxes(std::span<const GlobalId> ids, std::span<const Aabb> boxes) {
  Status status;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (is_valid(canonical(boxes[i]))) continue;
    if (++status.number > 1) continue;
    status.code = StatusCode::invalid_box;
    status.message = text("The box of body ", ids[i], " is refused: ", describe_fault(boxes[i]));
  }
  if (status.number > 1) status.message += text("; and of ", status.number - 1, " more");
  if (!status.ok()) status.message += ".";
  return status;
}

Status refuse_bodies(StatusCode code, std::vector<GlobalId> bodies, const char* why) {
  Status status;
  if (bodies.empty()) return status;
  std::ranges::sort(bodies);
  bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  status.code = code;
  status.number = bodies.size();
  status.message = text(subject(std::span<const GlobalId>(bodies)), " ", why, ".");
  return status;
}

Status find_listed_twice(std::span<const GlobalId> ids) {
  if (std::ranges::adjacent_find(ids, std::ranges::greater_equal()) == ids.end()) return {};
  std::vector<GlobalId> sorted(ids.begin(), ids.end());
  std::ranges::sort(sorted);
  std::vector<GlobalId> twice;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i] == sorted[i - 1]) twice.push_back(sorted[i]);
  }
  return refuse_bodies(StatusCode::duplicate_body, std::move(twice), "listed twice in one call");
}

}  // namespace cellsweep::ranks
