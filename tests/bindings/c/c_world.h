/// @file
/// A world through the face for C, as the tests hold it.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/c.h"
#include "cellsweep/pair.h"

namespace cellsweep::c {

template <auto kDestroy>
struct Destroy {
  void operator()(auto* object) const { kDestroy(object); }
};

using World = std::unique_ptr<cellsweep_broadphase, Destroy<cellsweep_destroy>>;
using PairList = std::unique_ptr<cellsweep_pair_list, Destroy<cellsweep_pair_list_destroy>>;
using Answers = std::unique_ptr<cellsweep_answers, Destroy<cellsweep_answers_destroy>>;
using History = std::unique_ptr<cellsweep_history, Destroy<cellsweep_history_destroy>>;

inline World make_world(const cellsweep_stream_options* options = nullptr) {
  cellsweep_broadphase* made = nullptr;
  cellsweep_failure why;
  EXPECT_EQ(cellsweep_create(options, &made, &why), CELLSWEEP_OK) << why.message;
  return World(made);
}

inline PairList make_list() {
  cellsweep_pair_list* made = nullptr;
  EXPECT_EQ(cellsweep_pair_list_create(&made, nullptr), CELLSWEEP_OK);
  return PairList(made);
}

inline Answers make_answers() {
  cellsweep_answers* made = nullptr;
  EXPECT_EQ(cellsweep_answers_create(&made, nullptr), CELLSWEEP_OK);
  return Answers(made);
}

inline std::vector<Pair> copied(const cellsweep_pair* pairs, std::size_t count) {
  std::vector<Pair> copy;
  for (std::size_t i = 0; i < count; ++i) copy.push_back({pairs[i].a, pairs[i].b});
  return copy;
}

inline std::vector<Pair> pairs_in(const PairList& list) {
  std::size_t count = 0;
  const cellsweep_pair* pairs = cellsweep_listed_pairs(list.get(), &count);
  return copied(pairs, count);
}

inline std::vector<Pair> pairs_of(const World& world) {
  const cellsweep_pair* pairs = nullptr;
  std::size_t count = 0;
  EXPECT_EQ(cellsweep_pairs(world.get(), &pairs, &count, nullptr), CELLSWEEP_OK);
  return copied(pairs, count);
}

inline cellsweep_boxes boxes_in(const std::vector<Aabb>& boxes) {
  return cellsweep_boxes_of(reinterpret_cast<const cellsweep_aabb*>(boxes.data()), boxes.size());
}

inline cellsweep_ids ids_in(const std::vector<BodyId>& ids) {
  return cellsweep_ids_of(ids.data(), ids.size());
}

inline constexpr cellsweep_aabb kCube = {{0, 0, 0}, {1, 1, 1}};

/// Bodies 0 to `count` - 1 with the same box, up to date.
inline World make_cubes(std::size_t count) {
  World world = make_world();
  const std::vector<cellsweep_aabb> boxes(count, kCube);
  std::vector<BodyId> ids(count);
  EXPECT_EQ(cellsweep_add(world.get(), cellsweep_boxes_of(boxes.data(), count), ids.data(), nullptr),
            CELLSWEEP_OK);
  EXPECT_EQ(cellsweep_update(world.get(), nullptr, nullptr), CELLSWEEP_OK);
  return world;
}

}  // namespace cellsweep::c
