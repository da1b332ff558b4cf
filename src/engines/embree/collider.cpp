#include "engines/embree/collider.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <mutex>
#include <new>
#include <string>
#include <thread>

#include "base/inside_embree.h"
#include "cellsweep/engine/engine.h"

namespace cellsweep::embree {
namespace {

// More than the threads of most machines: two seldom share a bin.
constexpr std::size_t kBins = 64;

// Embree leaves boxes out whose coordinates are near the largest float, and multiplies edges. Clamping keeps
// the order of coordinates, so that no overlap is lost; what it invents, the boxes themselves deny.
constexpr float kFarthest = 1e15F;

// A few float steps outwards, whatever Embree does to the last bit: touching counts.
constexpr float kWiden = 0x1p-21F;

float below(float value) {
  const float inside = std::clamp(value, -kFarthest, kFarthest);
  return inside - (std::fabs(inside) * kWiden + std::numeric_limits<float>::min());
}

float above(float value) {
  return -below(-value);
}

std::size_t bin_of_this_thread() {
  static thread_local const std::size_t bin =
      std::hash<std::thread::id>{}(std::this_thread::get_id()) % kBins;
  return bin;
}

// Embree wants to know how a ray meets a body; none is ever sent.
void meet_no_ray(const RTCIntersectFunctionNArguments*) {}
void be_hidden_from_no_ray(const RTCOccludedFunctionNArguments*) {}

}  // namespace

/// What the threads that share it have found.
struct alignas(64) Collider::Bin {
  std::mutex mutex;
  std::vector<std::uint64_t> pairs;
  std::uint64_t candidates = 0;
};

Collider::Collider(unsigned threads) : bins_(kBins), found_(kBins) {
  const InsideEmbree inside(this);
  device_.reset(rtcNewDevice(("threads=" + std::to_string(threads)).c_str()));
  if (!device_) throw std::bad_alloc();
  scene_.reset(rtcNewScene(device_.get()));
  rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_DYNAMIC);
  rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_LOW);
  geometry_.reset(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_USER));
  rtcSetGeometryBuildQuality(geometry_.get(), RTC_BUILD_QUALITY_LOW);
  rtcSetGeometryUserData(geometry_.get(), this);
  rtcSetGeometryBoundsFunction(geometry_.get(), tell_bounds, nullptr);
  rtcSetGeometryIntersectFunction(geometry_.get(), meet_no_ray);
  rtcSetGeometryOccludedFunction(geometry_.get(), be_hidden_from_no_ray);
  rtcAttachGeometry(scene_.get(), geometry_.get());
  throw_if_out_of_memory();
}

// What Embree began when a thread or memory was not to be had it cannot end: it would end the program. So a
// device that failed stays, with its threads. In a child of fork() it would wait for threads that are not
// there.
Collider::~Collider() {
  const InsideEmbree inside(this);
  if (has_failed_ || !process_.is_this_process()) {
    static_cast<void>(geometry_.release());
    static_cast<void>(scene_.release());
    static_cast<void>(device_.release());
  }
  geometry_.reset();
  scene_.reset();
  device_.reset();
}

// The one thing that can go wrong with calls whose arguments are right.
void Collider::throw_if_out_of_memory() {
  if (rtcGetDeviceError(device_.get()) != RTC_ERROR_NONE) has_failed_ = true;
  if (has_failed_ || has_lost_pairs_) throw std::bad_alloc();
}

void Collider::tell_bounds(const RTCBoundsFunctionArguments* arguments) {
  const auto* collider = static_cast<const Collider*>(arguments->geometryUserPtr);
  const CalledByEmbree called(collider);
  const Aabb& box = collider->boxes_[arguments->primID];
  RTCBounds& bounds = *arguments->bounds_o;
  if (!(box.min[0] <= box.max[0])) {
    bounds = {1, 1, 1, 0, -1, -1, -1, 0};
    return;
  }
  bounds = {below(box.min[0]), below(box.min[1]), below(box.min[2]), 0,
            above(box.max[0]), above(box.max[1]), above(box.max[2]), 0};
}

void Collider::build(std::span<const Aabb> boxes) {
  boxes_ = boxes;
  const InsideEmbree inside(this);
  rtcSetGeometryUserPrimitiveCount(geometry_.get(), static_cast<unsigned>(boxes.size()));
  rtcCommitGeometry(geometry_.get());
  rtcCommitScene(scene_.get());
  throw_if_out_of_memory();
}

// Both orders of a pair come, from whichever threads.
void Collider::keep_overlapping(std::span<const RTCCollision> candidates, Bin& bin) const {
  const std::scoped_lock lock(bin.mutex);
  bin.candidates += candidates.size();
  for (const RTCCollision& candidate : candidates) {
    const SlotPair pair{candidate.primID0, candidate.primID1};
    if (pair.a < pair.b && overlap(boxes_[pair.a], boxes_[pair.b])) bin.pairs.push_back(pair_key(pair));
  }
}

// Nothing may be thrown through Embree.
void Collider::take_candidates(void* collider, RTCCollision* candidates, unsigned count) {
  auto* self = static_cast<Collider*>(collider);
  const CalledByEmbree called(self);
  try {
    self->keep_overlapping({candidates, count}, self->bins_[bin_of_this_thread()]);
  } catch (const std::bad_alloc&) {
    self->has_lost_pairs_ = true;
  }
}

std::span<const std::span<const std::uint64_t>> Collider::find_pairs() {
  for (Bin& bin : bins_) {
    bin.pairs.clear();
    bin.candidates = 0;
  }
  has_lost_pairs_ = false;
  {
    const InsideEmbree inside(this);
    rtcCollide(scene_.get(), scene_.get(), take_candidates, this);
    throw_if_out_of_memory();
  }
  for (std::size_t i = 0; i < kBins; ++i) {
    found_[i] = bins_[i].pairs;
    candidates_ += bins_[i].candidates;
  }
  return found_;
}

std::size_t Collider::bytes() const {
  std::size_t sum = kBins * sizeof(Bin);
  for (const Bin& bin : bins_) sum += bin.pairs.capacity() * sizeof(std::uint64_t);
  return sum;
}

}  // namespace cellsweep::embree

#ifdef CELLSWEEP_THREAD_SANITIZER

// The C library's functions are watched whoever calls them; what these two do with them between their own
// threads is theirs. So is the memory that their threads get by posix_memalign() and that the main thread
// gives back at the end of the program; of ours only SPU programs call it, for memory of one thread.
// Shown, because the sanitizer's shared library looks for it.
extern "C" [[gnu::visibility("default")]] const char* __tsan_default_suppressions() {  // NOLINT: its name
  return "called_from_lib:libembree3.so.3\n"
         "called_from_lib:libtbb.so.12\n"
         "race_top:^posix_memalign$\n";
}

#endif
