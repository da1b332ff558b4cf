/// @file
/// The engine table: every row makes an engine with settings that are good, and refuses the others in words.
#include <gmock/gmock.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include "contract/contract_engines.h"
#include "every_engine.h"

namespace cellsweep::contract {
namespace {

using testing::HasSubstr;

TEST(EngineTable, EveryNameIsThereOnceAndHasASummary) {
  std::set<std::string_view> names;
  for (const EngineInfo& info : every_engine()) {
    EXPECT_FALSE(info.name.empty());
    EXPECT_FALSE(info.summary.empty()) << info.name;
    EXPECT_TRUE(names.insert(info.name).second) << info.name << " is listed twice";
  }
  for (const char* name : {"control", "stream", "oracle"}) EXPECT_TRUE(names.contains(name)) << name;
}

TEST(EngineTable, EveryRowMakesAnEngineOfItsNameAndIsFoundByIt) {
  for (const EngineInfo& info : every_engine()) {
    const auto made = make_broadphase(info.name);
    ASSERT_TRUE(made.ok()) << info.name << ": " << made.status().message;
    EXPECT_EQ(made->name(), info.name);
    EXPECT_EQ(find_engine(info.name), &info);
    EXPECT_TRUE(info.make({}).ok()) << info.name;
  }
}

TEST(EngineTable, AddingTheEnginesOfAnotherLibraryAgainAddsNoRow) {
  const std::size_t rows = every_engine().size();
  add_every_engine();
  EXPECT_EQ(engine_table().size(), rows);
}

TEST(EngineTable, AnUnknownNameIsRefusedWithTheNamesThatAreKnown) {
  for (const std::string_view name : {"no such engine", "", "CONTROL", "control ", "contro"}) {
    EXPECT_EQ(find_engine(name), nullptr);
    const auto made = make_broadphase(name);
    ASSERT_FALSE(made.ok()) << '"' << name << '"';
    EXPECT_EQ(made.status().code, StatusCode::bad_option);
    for (const EngineInfo& info : every_engine()) {
      EXPECT_THAT(made.status().message, HasSubstr(std::string(info.name)));
    }
  }
}

/// Expects that an engine refuses one setting, and returns what it says.
std::string refusal_of(const EngineInfo& info, const std::string& setting, const std::string& value) {
  const Status status = make_broadphase(info.name, {{setting, value}}).status();
  EXPECT_EQ(status.code, StatusCode::bad_option) << info.name << ", " << setting << " = " << value;
  EXPECT_EQ(status.setting, setting) << info.name;
  EXPECT_THAT(status.message, HasSubstr(setting));
  return status.message;
}

TEST(EngineSettings, EachIsThereOnceAndSaysWhatItIsFor) {
  for (const EngineInfo& info : every_engine()) {
    std::set<std::string_view> names;
    for (const SettingInfo& setting : info.settings) {
      EXPECT_FALSE(setting.name.empty()) << info.name;
      EXPECT_FALSE(setting.help.empty()) << info.name << ", " << setting.name;
      EXPECT_TRUE(names.insert(setting.name).second) << info.name << " has two of " << setting.name;
      EXPECT_EQ(setting.kind == SettingKind::choice, !setting.choices.empty()) << setting.name;
    }
    EXPECT_TRUE(names.contains("trace")) << info.name;
  }
}

TEST(EngineSettings, TheInitialValueOfEachIsGood) {
  for (const EngineInfo& info : every_engine()) {
    SettingValues all;
    for (const SettingInfo& setting : info.settings) {
      // Of a setting that may be given several times there is nothing to give.
      if (setting.kind == SettingKind::texts && setting.initial.empty()) continue;
      const SettingValues one = {{std::string(setting.name), std::string(setting.initial)}};
      const auto made = make_broadphase(info.name, one);
      EXPECT_TRUE(made.ok()) << info.name << ", " << setting.name << ": " << made.status().message;
      all.push_back(one.front());
    }
    EXPECT_TRUE(make_broadphase(info.name, all).ok()) << info.name;
  }
}

TEST(EngineSettings, TheInitialValueOfAChoiceIsOneOfThem) {
  for (const EngineInfo& info : every_engine()) {
    for (const SettingInfo& setting : info.settings) {
      if (setting.kind != SettingKind::choice) continue;
      EXPECT_THAT(setting.choices, testing::Contains(setting.initial)) << info.name << ", " << setting.name;
    }
  }
}

TEST(EngineSettings, EveryChoiceIsKnownThoughThisMachineMayNotHaveIt) {
  for (const EngineInfo& info : every_engine()) {
    for (const SettingInfo& setting : info.settings) {
      for (const std::string_view choice : setting.choices) {
        const auto made = make_broadphase(info.name, {{std::string(setting.name), std::string(choice)}});
        if (made) continue;
        EXPECT_TRUE(setting.name == "isa" || setting.name == "spe_engine") << setting.name << " " << choice;
        EXPECT_EQ(made.status().setting, setting.name) << made.status().message;
      }
    }
  }
}

TEST(EngineSettings, OnesThatAnEngineDoesNotHaveAreRefusedWithThoseThatItHas) {
  for (const EngineInfo& info : every_engine()) {
    for (const char* name : {"no_such_setting", "", "trace ", "TRACE"}) {
      const std::string words = refusal_of(info, name, "1");
      EXPECT_THAT(words, HasSubstr(std::string(info.name)));
      for (const SettingInfo& setting : info.settings) {
        EXPECT_THAT(words, HasSubstr(std::string(setting.name)));
      }
    }
  }
}

TEST(EngineSettings, TextsThatAreNoValueAreRefusedWithWhatIsOne) {
  const std::vector<std::string> no_numbers = {
      "", "many", "-1", "1.5", "1 ", "0x10", "99999999999999999999999"};
  for (const EngineInfo& info : every_engine()) {
    for (const SettingInfo& setting : info.settings) {
      const std::string name(setting.name);
      if (setting.kind == SettingKind::number || setting.kind == SettingKind::bytes) {
        for (const std::string& value : no_numbers) refusal_of(info, name, value);
      } else if (setting.kind == SettingKind::flag) {
        for (const char* value : {"", "1", "True", "no"}) {
          EXPECT_THAT(refusal_of(info, name, value), HasSubstr("true"));
        }
      } else if (setting.kind == SettingKind::choice) {
        const std::string words = refusal_of(info, name, "none of these");
        for (const auto choice : setting.choices) EXPECT_THAT(words, HasSubstr(std::string(choice)));
      }
    }
  }
}

TEST(EngineSettings, NumbersOutOfRangeAreRefused) {
  const auto refuse = [](const char* engine, const char* setting, const char* value) {
    const EngineInfo* info = find_engine(engine);
    if (info != nullptr) refusal_of(*info, setting, value);
  };
  every_engine();
  refuse("stream", "threads", "4294967296");
  refuse("control", "pair_map_bytes", "63");
  refuse("cell-paper", "method", "0");
  refuse("cell-paper", "method", "3");
  refuse("cell-paper", "local_store", "1000");
  refuse("cell-brute", "spus", "17");
  refuse("cell-resident", "spus", "2");
  refuse("cell-resident", "spus", "17");
  refuse("cell-stream", "spus", "17");
}

TEST(EngineSettings, OfTwoValuesForOneTheLastCounts) {
  const auto made = make_broadphase("control", {{"pair_map_bytes", "64"}, {"pair_map_bytes", "192"}});
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(made->capacity().bodies, 3U);
}

TEST(ContractSuite, RunsOnEveryEngineWithItsDefaultsWhichAreExact) {
  for (const EngineInfo& info : every_engine()) {
    if (!takes_part(info.name)) continue;
    EXPECT_TRUE(std::ranges::any_of(contract_engines(), [&](const ContractEngine& engine) {
      return engine.name == info.name && engine.label == label_of(info.name);
    })) << info.name;
    for (const SettingInfo& setting : info.settings) {
      if (setting.name == "literal") {
        EXPECT_EQ(setting.initial, "false") << info.name;
      }
    }
  }
}

}  // namespace
}  // namespace cellsweep::contract
