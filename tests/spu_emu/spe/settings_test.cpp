// Emulation settings: process-wide, by scope, and what is refused.
#include "spe/settings.h"

#include <gtest/gtest.h>
#include <libspe2.h>

#include <stdexcept>
#include <thread>

namespace spu_emu {
namespace {

TEST(Settings, scopes_nest_and_concern_their_own_thread) {
  EmulationSettings outer;
  outer.seed = 11;
  const SettingsScope scope(outer);
  EXPECT_EQ(current_settings().seed, 11U);
  {
    EmulationSettings inner;
    inner.seed = 22;
    const SettingsScope nested(inner);
    EXPECT_EQ(current_settings().seed, 22U);
    std::thread([] { EXPECT_EQ(current_settings().seed, default_settings().seed); }).join();
  }
  EXPECT_EQ(current_settings().seed, 11U);
}

TEST(Settings, the_default_holds_for_contexts_created_later) {
  const EmulationSettings before = default_settings();
  EmulationSettings settings;
  settings.local_store_limit = 128 * 1024;
  set_default_settings(settings);
  spe_context_ptr_t spe = spe_context_create(0, nullptr);
  set_default_settings(before);
  EXPECT_EQ(spe_ls_size_get(spe), 128 * 1024);
  spe_context_destroy(spe);
}

TEST(Settings, impossible_ones_are_refused_and_change_nothing) {
  const auto refused = [](auto&& change) {
    EmulationSettings settings;
    change(settings);
    EXPECT_THROW(set_default_settings(settings), std::invalid_argument);
    EXPECT_THROW(SettingsScope{settings}, std::invalid_argument);
  };
  refused([](EmulationSettings& s) { s.local_store_limit = 100; });
  refused([](EmulationSettings& s) { s.stack_reserve = 100; });
  refused([](EmulationSettings& s) { s.code_reserve = 300 * 1024; });
  refused([](EmulationSettings& s) { s.timebase_hertz = 0; });
  EXPECT_EQ(default_settings().local_store_limit, 256U * 1024);
  EXPECT_EQ(current_settings().stack_reserve, 16U * 1024);
}

}  // namespace
}  // namespace spu_emu
