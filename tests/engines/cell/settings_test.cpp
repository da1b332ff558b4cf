/// @file
/// The engines on SPEs in the table: every setting by its name.
#include <gmock/gmock.h>

#include <map>
#include <set>

#include "engines/cell/cell_world.h"
#include "engines/cell/settings.h"

namespace cellsweep::cell {
namespace {

using testing::HasSubstr;

template <class Options>
Result<Options> read_as(const SettingValues& values) {
  return read_settings<Options>("tested", values, setting_rows<Options>());
}

/// What every engine on SPEs reads, each away from its default.
const SettingValues kOfSpes = {{"local_store", "131072"},        {"spe_engine", "isa"}, {"cycles", "true"},
                               {"cycle_parameter", "latency=1"}, {"dma", "late"},       {"dma_seed", "7"},
                               {"cycle_parameter", "hertz=2"}};

void expect_read(const SpeOptions& spes) {
  EXPECT_EQ(spes.local_store, 131072U);
  EXPECT_EQ(spes.spe_engine, SpeEngine::isa);
  EXPECT_TRUE(spes.cycles);
  EXPECT_THAT(spes.cycle_parameter, testing::ElementsAre("latency=1", "hertz=2"));
  EXPECT_EQ(spes.dma, DmaMode::late);
  EXPECT_EQ(spes.dma_seed, 7U);
}

template <class Options>
Options read_with_spes(SettingValues values) {
  values.insert(values.end(), kOfSpes.begin(), kOfSpes.end());
  const auto options = read_as<Options>(values);
  EXPECT_TRUE(options.ok()) << options.status().message;
  expect_read(options->spes);
  return *options;
}

TEST(CellSettings, OfEveryEngineAreReadByName) {
  const auto paper = read_with_spes<CellPaperOptions>({{"method", "2"},
                                                       {"literal", "true"},
                                                       {"list_dma", "true"},
                                                       {"pair_map_bytes", "640"},
                                                       {"trace", "a file"}});
  EXPECT_EQ(paper.method, 2U);
  EXPECT_TRUE(paper.literal);
  EXPECT_TRUE(paper.list_dma);
  EXPECT_EQ(paper.pair_map_bytes, 640U);
  EXPECT_EQ(paper.trace, "a file");
  const auto brute = read_with_spes<CellBruteOptions>({{"spus", "5"}, {"trace", "a file"}});
  EXPECT_EQ(brute.spus, 5U);
  EXPECT_EQ(brute.trace, "a file");
  const auto resident =
      read_with_spes<CellResidentOptions>({{"spus", "5"}, {"spu_boxes", "true"}, {"trace", "a file"}});
  EXPECT_EQ(resident.spus, 5U);
  EXPECT_TRUE(resident.spu_boxes);
  EXPECT_EQ(resident.trace, "a file");
  const auto stream = read_with_spes<CellStreamOptions>(
      {{"spus", "5"}, {"threads", "3"}, {"isa", "portable"}, {"max_pairs", "9"}, {"trace", "a file"}});
  EXPECT_EQ(stream.spus, 5U);
  EXPECT_EQ(stream.stream.threads, 3U);
  EXPECT_EQ(stream.stream.isa, VectorIsa::portable);
  EXPECT_EQ(stream.stream.max_pairs, 9U);
  EXPECT_EQ(stream.stream.trace, "a file");
}

TEST(CellSettings, StandInTheTableWithValuesThatTheyBeginWith) {
  add_cell_engines();
  for (const char* name : {"cell-paper", "cell-brute", "cell-resident", "cell-stream"}) {
    const EngineInfo* info = find_engine(name);
    ASSERT_NE(info, nullptr) << name;
    EXPECT_FALSE(info->summary.empty());
    std::set<std::string_view> names;
    SettingValues initial;
    for (const SettingInfo& setting : info->settings) {
      EXPECT_TRUE(names.insert(setting.name).second) << setting.name << " twice";
      EXPECT_FALSE(setting.help.empty()) << setting.name;
      EXPECT_EQ(setting.choices.empty(), setting.kind != SettingKind::choice) << setting.name;
      if (setting.kind != SettingKind::texts) initial.emplace_back(setting.name, setting.initial);
    }
    EXPECT_EQ(names.contains("method"), std::string_view(name) == "cell-paper");
    const auto plain = make_broadphase(name);
    const auto same = make_broadphase(name, initial);
    ASSERT_TRUE(plain.ok() && same.ok()) << same.status().message;
    EXPECT_EQ(plain->name(), name);
    EXPECT_EQ(plain->capacity().bodies, same->capacity().bodies);
    EXPECT_FALSE(make_broadphase(name, {{"dma", "sometimes"}}).ok());
    EXPECT_EQ(make_broadphase(name, {{"spu", "3"}}).status().setting, "spu");
    EXPECT_EQ(make_broadphase(name, {{"local_store", "100"}}).status().setting, "local_store");
  }
}

TEST(CellSettings, AddedTwiceStandThereOnce) {
  add_cell_engines();
  const std::size_t rows = engine_table().size();
  add_cell_engines();
  EXPECT_EQ(engine_table().size(), rows);
}

TEST(LocalStoreMapByName, IsThatOfTheOptionsStruct) {
  add_cell_engines();
  const auto by_name = local_store_map("cell-paper", {{"method", "2"}, {"list_dma", "true"}}, 100);
  const auto by_struct = local_store_map(CellPaperOptions{.method = 2, .list_dma = true}, 100);
  ASSERT_TRUE(by_name.ok() && by_struct.ok());
  EXPECT_EQ(by_name->engine, "cell-paper");
  EXPECT_EQ(by_name->used(), by_struct->used());
  EXPECT_EQ(local_store_map("cell-brute", {{"spus", "7"}}, 1)->spus, 7U);
  EXPECT_EQ(local_store_map("cell-stream", {}, 1)->spus, 3U);
  EXPECT_GT(local_store_map("cell-resident", {{"spu_boxes", "true"}}, 10)->used(),
            local_store_map("cell-resident", {}, 10)->used());
}

TEST(LocalStoreMapByName, NeverWrapsForAnyNumberOfBodies) {
  add_cell_engines();
  constexpr std::uint64_t kMost = std::uint64_t{1} << 32U;
  for (const char* engine : {"cell-paper", "cell-brute", "cell-resident"}) {
    std::uint64_t before = 0;
    for (std::uint64_t bodies = 256; bodies <= kMost; bodies *= 16) {
      const auto map = local_store_map(engine, {}, bodies);
      ASSERT_TRUE(map.ok()) << map.status().message;
      EXPECT_GT(map->used(), before) << engine << " " << bodies;
      before = map->used();
    }
    for (const std::uint64_t bodies :
         {kMost + 1, std::uint64_t{1} << 61U, std::uint64_t{1} << 63U, UINT64_MAX}) {
      const Status status = local_store_map(engine, {}, bodies).status();
      EXPECT_EQ(status.code, StatusCode::capacity) << engine << " " << bodies;
      EXPECT_EQ(status.number, bodies);
      EXPECT_EQ(status.limit, kMost);
    }
  }
}

TEST(LocalStoreMapByName, IsRefusedAsTheEngineWouldBe) {
  add_cell_engines();
  EXPECT_EQ(local_store_map("cell-paper", {{"method", "3"}}, 1).status().setting, "method");
  EXPECT_EQ(local_store_map("cell-brute", {{"spus", "17"}}, 1).status().setting, "spus");
  EXPECT_EQ(local_store_map("cell-resident", {{"spus", "2"}}, 1).status().setting, "spus");
  EXPECT_EQ(local_store_map("cell-stream", {{"nothing", "2"}}, 1).status().setting, "nothing");
}

TEST(LocalStoreMapByName, IsNotThereForAnEngineWithoutALocalStore) {
  const Status none = local_store_map("control", {}, 10).status();
  EXPECT_EQ(none.code, StatusCode::bad_option);
  EXPECT_THAT(none.message, HasSubstr("no local store"));
  const Status unknown = local_store_map("nobody", {}, 10).status();
  EXPECT_EQ(unknown.code, StatusCode::bad_option);
  EXPECT_THAT(unknown.message, HasSubstr("There is no engine \"nobody\""));
}

}  // namespace
}  // namespace cellsweep::cell
