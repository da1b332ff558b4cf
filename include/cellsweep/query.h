/// @file
/// Questions to a Broadphase between two updates: which bodies are here, on this way, or nearest.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/broadphase.h"
#include "cellsweep/export.h"
#include "cellsweep/filter.h"
#include "cellsweep/function_ref.h"
#include "cellsweep/pair.h"
#include "cellsweep/status.h"

namespace cellsweep {

/// x, y, z in the world's length unit.
using Point = std::array<float, 3>;

/// The box that holds this point and no other.
constexpr Aabb box_at(const Point& point) {
  return {point, point};
}

struct Sphere {
  Point center{};
  double radius = 0;  ///< 0 or more, infinity allowed
};

/// All points that are no further than `distance` from a box: a box, a point or a sphere become one by
/// themselves.
struct Region {
  Aabb box{};
  double distance = 0;  ///< 0 or more, infinity allowed

  Region() = default;
  Region(const Aabb& of, double around = 0) : box(of), distance(around) {}
  Region(const Point& point, double around = 0) : box(box_at(point)), distance(around) {}
  Region(const Sphere& sphere) : box(box_at(sphere.center)), distance(sphere.radius) {}
};

/// The points origin + time * direction for all times from 0 to `end`.
struct Ray {
  Point origin{};
  /// Of any length but none; a component may be zero. Each within the range of a float.
  std::array<double, 3> direction{};
  double end = std::numeric_limits<double>::infinity();  ///< in lengths of `direction`

  /// All points from one to another: times go from 0 to 1.
  static Ray between(const Point& from, const Point& to) {
    return {from, {double{to[0]} - from[0], double{to[1]} - from[1], double{to[2]} - from[2]}, 1};
  }
};

/// A box that moves by `direction` in each unit of time, from 0 to `end`.
struct MovingBox {
  Aabb box{};
  std::array<double, 3> direction{};  ///< as that of a Ray
  double end = 1;
};

/// Where a moving box, or the point of a ray, comes along: rays and moving boxes become one by themselves.
struct Path {
  Aabb box{};
  std::array<double, 3> direction{};
  double end = 1;

  Path() = default;
  Path(const Ray& ray) : box(box_at(ray.origin)), direction(ray.direction), end(ray.end) {}
  Path(const MovingBox& moving) : box(moving.box), direction(moving.direction), end(moving.end) {}
};

/// A body on a path.
struct Touch {
  BodyId body = 0;
  double time = 0;  ///< of the first touch, in lengths of the path's direction; 0 where it begins in one

  friend bool operator==(const Touch&, const Touch&) = default;
};

/// A body and how far it is: 0 where the boxes share a point.
struct Neighbor {
  BodyId body = 0;
  double distance = 0;

  friend bool operator==(const Neighbor&, const Neighbor&) = default;
};

/// Which bodies are answers at all.
struct QueryFilter {
  /// Only those that a body with this filter may form a pair with: may_pair(). None: all bodies.
  std::optional<BodyFilter> as{};
  /// Only those for which it returns true; it is asked after everything else. In a batch it is called by
  /// several threads at a time. What it throws leaves the query.
  std::function<bool(BodyId)> predicate{};
};

/// The answers to a batch of questions: those to question i, in the order of a single question, are
/// answers[first[i]] to before answers[first[i + 1]].
template <class Answer>
struct BatchAnswers {
  std::vector<std::size_t> first{};
  std::vector<Answer> answers{};

  /// Questions answered.
  std::size_t size() const { return first.empty() ? 0 : first.size() - 1; }
  std::span<const Answer> operator[](std::size_t question) const {
    return std::span(answers).subspan(first[question], first[question + 1] - first[question]);
  }
};

/// Asks a Broadphase, as of its last update(): bodies inserted, moved or removed since are as they were then;
/// before the first update there are none. It holds nothing but the Broadphase's address, which must be there
/// and not be moved while it is used.
///
/// Exactness: the answers are those of looking at each box, whatever the engine, its threads and the machine.
/// Boxes are closed. A body overlaps a region when its distance is at most the region's, where a distance is
/// computed thus: on each axis the gap between the two intervals, 0 where they meet; then the root of the sum
/// of the three squares; all in double, to nearest. A path touches a body when on each axis the times at
/// which the two intervals meet, and 0 to `end`, have a time in common. The times at which they begin and
/// cease to meet are a difference divided by a component of the direction, in double, to nearest; to decide
/// they are taken earlier and later by 2^-51 of themselves, so that no rounding makes a touch be missed. What
/// is told is max(0, the latest of the beginnings) itself. Coordinates asked for become canonical as those of
/// bodies do: -0 and denormals are 0.
///
/// Order: bodies ascend; touches ascend by (time, body), neighbours by (distance, body). What a callback
/// gets comes in no order, each body once.
///
/// Errors, by which nothing is answered and the caller's memory stays as it is: invalid_box (NaN, infinity or
/// min > max, in a box or a point), bad_input (a direction that is zero, NaN or out of range, an end, radius
/// or distance that is negative or NaN; spans of different length). In a batch the first question at fault is
/// named. std::bad_alloc may leave a call; the caller's vectors hold anything then.
///
/// Threads: any number may ask at a time, while none calls a function of the Broadphase that is not const; in
/// a debug build an assertion fails when one does. Batches use the engine's threads, if no other batch does.
class CELLSWEEP_API Queries {
 public:
  explicit Queries(const Broadphase& broadphase) : broadphase_(&broadphase) {}

  // --- many questions between two updates

  /// Makes the tree of boxes now that questions about paths and what is near are answered with, or brings the
  /// one that there is up to date: worth it before many of them. Otherwise that is done by the question that
  /// has paid for it, once all of them together have taken about as long as it takes: to make it, 0.25 us for
  /// each body; after an update that changed something, 5 ns for each, or 20 to 50 ns for each of few that
  /// changed (four times that among a million, which no cache holds). It has 45 bytes for each body.
  /// std::bad_alloc may leave the call.
  void prepare() const;

  // --- what is in a region

  /// Bodies that overlap the region; `found` is overwritten.
  Status find_overlaps(const Region& region, std::vector<BodyId>& found,
                       const QueryFilter& filter = {}) const;
  /// The same one at a time, until `visit` returns false.
  Status visit_overlaps(const Region& region, FunctionRef<bool(BodyId)> visit,
                        const QueryFilter& filter = {}) const;
  /// Whether there is one.
  Result<bool> any_overlap(const Region& region, const QueryFilter& filter = {}) const;
  /// A list for each of many regions.
  Status find_overlaps(std::span<const Region> regions, BatchAnswers<BodyId>& found,
                       const QueryFilter& filter = {}) const;
  /// `any` has one for each region.
  Status any_overlaps(std::span<const Region> regions, std::span<bool> any,
                      const QueryFilter& filter = {}) const;

  // --- what is on a path

  /// Bodies that the path touches; `found` is overwritten.
  Status find_touches(const Path& path, std::vector<Touch>& found, const QueryFilter& filter = {}) const;
  /// The same one at a time, nearer ones mostly before others. `visit` gets a touch and the time at which the
  /// path ends now, and returns where it ends from now on: that time to go on, less to shorten the path, less
  /// than 0 to stop.
  Status visit_touches(const Path& path, FunctionRef<double(const Touch&, double)> visit,
                       const QueryFilter& filter = {}) const;
  /// The first of find_touches().
  Result<std::optional<Touch>> first_touch(const Path& path, const QueryFilter& filter = {}) const;
  /// Whether there is one.
  Result<bool> any_touch(const Path& path, const QueryFilter& filter = {}) const;
  /// A list for each of many paths.
  Status find_touches(std::span<const Path> paths, BatchAnswers<Touch>& found,
                      const QueryFilter& filter = {}) const;
  /// `first` and `any` have one for each path.
  Status first_touches(std::span<const Path> paths, std::span<std::optional<Touch>> first,
                       const QueryFilter& filter = {}) const;
  Status any_touches(std::span<const Path> paths, std::span<bool> any, const QueryFilter& filter = {}) const;

  // --- what is near

  /// No limit to a distance.
  static constexpr double kAnyDistance = std::numeric_limits<double>::infinity();

  /// The first `count` of find_within(box, most); `found` is overwritten.
  Status find_nearest(const Aabb& box, std::size_t count, std::vector<Neighbor>& found,
                      double most = kAnyDistance, const QueryFilter& filter = {}) const;
  Status find_nearest(const Point& point, std::size_t count, std::vector<Neighbor>& found,
                      double most = kAnyDistance, const QueryFilter& filter = {}) const {
    return find_nearest(box_at(point), count, found, most, filter);
  }
  /// A list for each of many boxes.
  Status find_nearest(std::span<const Aabb> boxes, std::size_t count, BatchAnswers<Neighbor>& found,
                      double most = kAnyDistance, const QueryFilter& filter = {}) const;

  /// Bodies within a distance of the region's box, that of the region; `found` is overwritten.
  Status find_within(const Region& region, std::vector<Neighbor>& found,
                     const QueryFilter& filter = {}) const;
  Status find_within(std::span<const Region> regions, BatchAnswers<Neighbor>& found,
                     const QueryFilter& filter = {}) const;

  // --- pairs

  /// The pairs as of the last update in which one of these bodies is, or both, each once, ascending: for
  /// those who look after a few bodies, at a cost that follows these. `found` is overwritten. Errors:
  /// unknown_body for one that the last update did not see.
  Status find_pairs_of(std::span<const BodyId> bodies, std::vector<Pair>& found) const;
  Status find_pairs_of(BodyId body, std::vector<Pair>& found) const {
    return find_pairs_of({&body, 1}, found);
  }

 private:
  const Broadphase* broadphase_;
};

}  // namespace cellsweep
