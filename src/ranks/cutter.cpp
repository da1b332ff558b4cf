#include "ranks/cutter.h"

#include <zoltan.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace cellsweep::ranks {
namespace {

// Directions that stay what they are: else a cut that has hardly moved may turn the world over, and all
// bodies go to other ranks. Nothing is printed.
constexpr std::pair<const char*, const char*> kSettings[] = {
    {"DEBUG_LEVEL", "0"},         {"CHECK_GEOM", "0"},        {"LB_METHOD", "RCB"},
    {"KEEP_CUTS", "1"},           {"RCB_REUSE", "1"},         {"RCB_RECTILINEAR_BLOCKS", "1"},
    {"RCB_LOCK_DIRECTIONS", "1"}, {"REDUCE_DIMENSIONS", "0"}, {"IMBALANCE_TOL", "1.02"},
    {"RETURN_LISTS", "NONE"},     {"NUM_GID_ENTRIES", "1"},   {"NUM_LID_ENTRIES", "1"}};

using Points = std::span<const Point>;

// What Zoltan asks; its objects are places in the list of points.
int count_points(void* points, int* error) {
  *error = ZOLTAN_OK;
  return static_cast<int>(static_cast<const Points*>(points)->size());
}

void list_points(void* points, int, int, ZOLTAN_ID_PTR global, ZOLTAN_ID_PTR local, int, float*, int* error) {
  *error = ZOLTAN_OK;
  for (std::size_t i = 0; i < static_cast<const Points*>(points)->size(); ++i)
    global[i] = local[i] = static_cast<ZOLTAN_ID_TYPE>(i);
}

int count_axes(void*, int* error) {
  *error = ZOLTAN_OK;
  return 3;
}

void list_coordinates(void* points, int, int, int count, ZOLTAN_ID_PTR, ZOLTAN_ID_PTR local, int, double* out,
                      int* error) {
  *error = ZOLTAN_OK;
  for (int i = 0; i < count; ++i) {
    for (const float x : (*static_cast<const Points*>(points))[local[i]]) *out++ = x;
  }
}

// A float is above a cut, or not, as it is above the largest float that is not above the cut.
float as_float(double cut) {
  if (std::fabs(cut) > 3.4e38) return cut < 0 ? -kInfinity : kInfinity;
  const auto nearest = static_cast<float>(cut);
  return double{nearest} > cut ? std::nextafter(nearest, -kInfinity) : nearest;
}

Region as_region(const std::array<double, 3>& low, const std::array<double, 3>& high) {
  Region region;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    region.above[axis] = as_float(low[axis]);
    region.up_to[axis] = as_float(high[axis]);
    if (region.above[axis] >= region.up_to[axis]) return kNowhere;
  }
  return region;
}

Status refuse(const char* what) {
  return Status::over_capacity(std::string("Zoltan has no memory to ") + what + ".", 0, 0);
}

}  // namespace

void Cutter::Destroy::operator()(Zoltan_Struct* zoltan) const {
  Zoltan_Destroy(&zoltan);
}

Status Cutter::begin(MPI_Comm communicator) {
  MPI_Comm_size(communicator, &ranks_);
  if (ranks_ == 1) return {};
  float version = 0;
  Zoltan_Initialize(0, nullptr, &version);
  zoltan_.reset(Zoltan_Create(communicator));
  if (!zoltan_) return refuse("begin");
  for (const auto& [name, value] : kSettings) Zoltan_Set_Param(zoltan_.get(), name, value);
  return {};
}

Result<std::vector<Region>> Cutter::cut(std::span<const Point> points) {
  if (!zoltan_) return std::vector<Region>{kEverywhere};
  Zoltan_Set_Num_Obj_Fn(zoltan_.get(), count_points, &points);
  Zoltan_Set_Obj_List_Fn(zoltan_.get(), list_points, &points);
  Zoltan_Set_Num_Geom_Fn(zoltan_.get(), count_axes, nullptr);
  Zoltan_Set_Geom_Multi_Fn(zoltan_.get(), list_coordinates, &points);
  int changes = 0;
  std::array<int, 4> counts{};
  std::array<ZOLTAN_ID_PTR, 4> ids{};
  std::array<int*, 4> places{};
  const int result =
      Zoltan_LB_Partition(zoltan_.get(), &changes, &counts[0], &counts[1], &counts[2], &ids[0], &ids[1],
                          &places[0], &places[1], &counts[3], &ids[2], &ids[3], &places[2], &places[3]);
  Zoltan_LB_Free_Part(&ids[0], &ids[1], &places[0], &places[1]);
  Zoltan_LB_Free_Part(&ids[2], &ids[3], &places[2], &places[3]);
  if (result != ZOLTAN_OK && result != ZOLTAN_WARN) return refuse("cut the world");
  return regions();
}

Result<std::vector<Region>> Cutter::regions() const {
  std::vector<Region> regions;
  for (int rank = 0; rank < ranks_; ++rank) {
    int axes = 0;
    std::array<double, 3> low{};
    std::array<double, 3> high{};
    if (Zoltan_RCB_Box(zoltan_.get(), rank, &axes, &low[0], &low[1], &low[2], &high[0], &high[1], &high[2]) !=
        ZOLTAN_OK)
      return refuse("tell its cuts");
    regions.push_back(as_region(low, high));
  }
  return regions;
}

}  // namespace cellsweep::ranks
