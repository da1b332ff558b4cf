// Contexts, gangs, areas and machine information.
#include "../host/test_context.h"

namespace spu_emu {
namespace {

TEST(Context, null_contexts_and_gangs_are_esrch) {
  const auto is_esrch = [](int result) { return result == -1 && std::exchange(errno, 0) == ESRCH; };
  unsigned int word = 0;
  spe_stop_info_t stop;
  EXPECT_TRUE(is_esrch(spe_context_destroy(nullptr)));
  EXPECT_TRUE(is_esrch(spe_gang_context_destroy(nullptr)));
  EXPECT_TRUE(is_esrch(spe_program_load(nullptr, &spu_emu_probe)));
  EXPECT_TRUE(is_esrch(spe_stop_info_read(nullptr, &stop)));
  EXPECT_TRUE(is_esrch(spe_out_mbox_read(nullptr, &word, 1)));
  EXPECT_TRUE(is_esrch(spe_out_mbox_status(nullptr)));
  EXPECT_TRUE(is_esrch(spe_in_mbox_write(nullptr, &word, 1, SPE_MBOX_ANY_NONBLOCKING)));
  EXPECT_TRUE(is_esrch(spe_in_mbox_status(nullptr)));
  EXPECT_TRUE(is_esrch(spe_out_intr_mbox_read(nullptr, &word, 1, SPE_MBOX_ANY_NONBLOCKING)));
  EXPECT_TRUE(is_esrch(spe_out_intr_mbox_status(nullptr)));
  EXPECT_TRUE(is_esrch(spe_signal_write(nullptr, SPE_SIG_NOTIFY_REG_1, 0)));
  EXPECT_TRUE(is_esrch(spe_mfcio_put(nullptr, 0, &word, 4, 0, 0, 0)));
  EXPECT_TRUE(is_esrch(spe_mfcio_tag_status_read(nullptr, 1, SPE_TAG_ALL, &word)));
  EXPECT_TRUE(is_esrch(spe_mssync_start(nullptr)));
  EXPECT_TRUE(is_esrch(spe_mssync_status(nullptr)));
  EXPECT_TRUE(is_esrch(spe_ls_size_get(nullptr)));
  EXPECT_EQ(spe_ls_area_get(nullptr), nullptr);
  EXPECT_EQ(spe_ps_area_get(nullptr, SPE_CONTROL_AREA), nullptr);
  EXPECT_EQ(spe_context_create_affinity(0, nullptr, nullptr), nullptr);
  EXPECT_EQ(errno, ESRCH);
}

TEST(Context, isolation_is_refused) {
  EXPECT_EQ(spe_context_create(SPE_ISOLATE, nullptr), nullptr);
  EXPECT_EQ(errno, ENODEV);
  EXPECT_EQ(spe_context_create(SPE_ISOLATE_EMULATE, nullptr), nullptr);
  EXPECT_EQ(errno, EINVAL);
}

TEST(Context, a_gang_lives_as_long_as_its_contexts) {
  spe_gang_context_ptr_t gang = spe_gang_context_create(0);
  ASSERT_NE(gang, nullptr);
  spe_context_ptr_t one = spe_context_create(0, gang);
  spe_context_ptr_t two = spe_context_create_affinity(0, one, gang);
  ASSERT_NE(two, nullptr);
  EXPECT_EQ(spe_gang_context_destroy(gang), -1);
  EXPECT_EQ(errno, EBUSY);
  EXPECT_EQ(spe_context_destroy(one), 0);
  EXPECT_EQ(spe_context_destroy(two), 0);
  EXPECT_EQ(spe_gang_context_destroy(gang), 0);
}

TEST(Context, the_local_store_is_256_kb_aligned_and_plain_memory) {
  TestContext context;
  auto* area = static_cast<unsigned char*>(spe_ls_area_get(context.spe));
  EXPECT_EQ(spe_ls_size_get(context.spe), 0x40000);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(area) & 0xffffffffU, 0U);
  area[0x30000] = 7;
  area[0x3ffff] = 8;
  EXPECT_EQ(area[0x30000], 7);
}

TEST(Context, the_local_store_has_guard_pages_on_both_sides) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  TestContext context;
  auto* area = static_cast<volatile unsigned char*>(spe_ls_area_get(context.spe));
  EXPECT_DEATH(area[-1] = 1, "");
  EXPECT_DEATH(area[0x40000] = 1, "");
}

TEST(Context, problem_state_areas_need_map_ps) {
  TestContext plain;
  EXPECT_EQ(spe_ps_area_get(plain.spe, SPE_CONTROL_AREA), nullptr);
  EXPECT_EQ(errno, EACCES);
  TestContext mapped({}, SPE_MAP_PS);
  EXPECT_NE(spe_ps_area_get(mapped.spe, SPE_CONTROL_AREA), nullptr);
  EXPECT_NE(spe_ps_area_get(mapped.spe, SPE_SIG_NOTIFY_1_AREA),
            spe_ps_area_get(mapped.spe, SPE_SIG_NOTIFY_2_AREA));
  EXPECT_EQ(spe_ps_area_get(mapped.spe, static_cast<ps_area>(7)), nullptr);
  EXPECT_EQ(errno, EINVAL);
}

TEST(Context, the_machine_has_nodes_of_eight_spes) {
  const int nodes = spe_cpu_info_get(SPE_COUNT_PHYSICAL_CPU_NODES, -1);
  EXPECT_GE(nodes, 1);
  EXPECT_EQ(spe_cpu_info_get(SPE_COUNT_PHYSICAL_SPES, -1), nodes * 8);
  EXPECT_EQ(spe_cpu_info_get(SPE_COUNT_USABLE_SPES, 0), 8);
  EXPECT_EQ(spe_cpu_info_get(SPE_COUNT_USABLE_SPES, nodes), -1);
  EXPECT_EQ(errno, EINVAL);
  EXPECT_EQ(spe_cpu_info_get(99, -1), -1);
  EXPECT_EQ(errno, EINVAL);
}

TEST(Context, multisource_synchronisation_is_always_done) {
  TestContext context;
  EXPECT_EQ(spe_mssync_start(context.spe), 0);
  EXPECT_EQ(spe_mssync_status(context.spe), 0);
}

}  // namespace
}  // namespace spu_emu
