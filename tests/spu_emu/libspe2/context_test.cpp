// Contexts, gangs, areas and machine information.
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <thread>
#include <vector>

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

TEST(Context, affinity_that_a_cell_refuses_is_refused) {
  const auto refused = [](spe_context_ptr_t context, int error) {
    return context == nullptr && std::exchange(errno, 0) == error;
  };
  spe_gang_context_ptr_t gang = spe_gang_context_create(0);
  spe_gang_context_ptr_t other = spe_gang_context_create(0);
  std::vector<spe_context_ptr_t> made{spe_context_create(SPE_AFFINITY_MEMORY, gang)};
  ASSERT_NE(made[0], nullptr);
  EXPECT_TRUE(refused(spe_context_create(SPE_AFFINITY_MEMORY, gang), EEXIST));
  EXPECT_TRUE(refused(spe_context_create(SPE_AFFINITY_MEMORY, nullptr), EINVAL));
  EXPECT_TRUE(refused(spe_context_create_affinity(0, made[0], other), EINVAL));
  for (int i = 0; i < 2; ++i) made.push_back(spe_context_create_affinity(0, made[0], gang));
  EXPECT_TRUE(refused(spe_context_create_affinity(0, made[0], gang), EEXIST));
  while (made.size() < 8) made.push_back(spe_context_create_affinity(0, made.back(), gang));
  EXPECT_TRUE(refused(spe_context_create_affinity(0, made.back(), gang), EEXIST));
  EXPECT_EQ(spe_context_destroy(made.back()), 0);
  made.back() = spe_context_create_affinity(0, made[6], gang);
  ASSERT_NE(made.back(), nullptr);
  EXPECT_EQ(spe_program_load(made[7], &spu_emu_probe), 0);
  unsigned int entry = SPE_DEFAULT_ENTRY;
  EXPECT_EQ(spe_context_run(made[7], &entry, 0, nullptr, nullptr, nullptr), 0);
  EXPECT_EQ(spe_context_destroy(made[7]), 0);
  EXPECT_TRUE(refused(spe_context_create_affinity(0, made[6], gang), EBUSY));
  made[7] = spe_context_create(0, gang);
  ASSERT_NE(made[7], nullptr);
  for (spe_context_ptr_t context : made) EXPECT_EQ(spe_context_destroy(context), 0);
  EXPECT_EQ(spe_gang_context_destroy(gang), 0);
  EXPECT_EQ(spe_gang_context_destroy(other), 0);
}

TEST(Context, an_image_that_is_no_spu_program_is_refused_when_it_is_opened) {
  for (const char* name : {"/bin/sh", "/bin/cat"}) {
    EXPECT_EQ(spe_image_open(name), nullptr) << name;
    EXPECT_EQ(errno, EINVAL);
  }
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

TEST(Context, loads_and_stores_reach_a_mapped_problem_state) {
  TestContext context({}, SPE_MAP_PS | SPE_EVENTS_ENABLE);
  auto* control =
      static_cast<volatile spe_spu_control_area_t*>(spe_ps_area_get(context.spe, SPE_CONTROL_AREA));
  ASSERT_NE(control, nullptr);
  std::thread program([&] { EXPECT_EQ(context.run(Probe::echo_mailbox), 0); });
  control->SPU_In_Mbox = 0x1235;
  while ((control->SPU_Mbox_Stat & 0xffU) == 0) std::this_thread::yield();
  EXPECT_EQ(control->SPU_Out_Mbox, 0x1236U);
  control->SPU_In_Mbox = 0;
  program.join();
}

TEST(Context, proxy_dma_may_be_written_into_a_mapped_problem_state) {
  TestContext context({}, SPE_MAP_PS);
  auto* area =
      static_cast<volatile spe_mfc_command_area_t*>(spe_ps_area_get(context.spe, SPE_MFC_COMMAND_AREA));
  ASSERT_NE(area, nullptr);
  const Words words;
  const auto ea = reinterpret_cast<std::uintptr_t>(&words);
  area->MFC_LSA = 0x20000;
  area->MFC_EAH = static_cast<unsigned int>(ea >> 32U);
  area->MFC_EAL = static_cast<unsigned int>(ea);
  area->MFC_Size_Tag = sizeof words << 16U | 3U;
  area->MFC_Command.MFC_ClassID_CMD = 0x40;
  EXPECT_EQ(area->MFC_Command.MFC_CMDStatus, 0U);
  area->Prxy_QueryMask = 1U << 3U;
  while (area->Prxy_TagStatus != 1U << 3U) {
  }
  EXPECT_EQ(area->MFC_QStatus, 0x80000008U);
  EXPECT_EQ(static_cast<const unsigned int*>(spe_ls_area_get(context.spe))[0x8000 + 7], words.words[7]);
}

TEST(Context, what_a_mapped_problem_state_does_not_take_names_the_function_to_call) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  TestContext context({}, SPE_MAP_PS);
  auto* control =
      static_cast<volatile spe_spu_control_area_t*>(spe_ps_area_get(context.spe, SPE_CONTROL_AREA));
  // By SIGSEGV, which a sanitizer turns into an end of its own.
  EXPECT_DEATH(control->SPU_RunCntl = 1, "0x0401c .*call spe_context_run instead");
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

/// What a child finds with a context and a handler of its parent's: 0 if all is as it should be.
int look_from_a_child(const TestContext& context, spe_event_handler_ptr_t handler) {
  const auto is_esrch = [](int result) { return result == -1 && std::exchange(errno, 0) == ESRCH; };
  unsigned int word = 0;
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_event_unit_t event{SPE_EVENT_SPE_STOPPED, context.spe, {}};
  if (!is_esrch(spe_context_run(context.spe, &entry, 0, nullptr, nullptr, nullptr))) return 1;
  if (!is_esrch(spe_out_mbox_read(context.spe, &word, 1))) return 2;
  if (!is_esrch(spe_event_wait(handler, &event, 1, -1))) return 3;
  if (last_fault(context.spe).find("do not come along with fork()") == std::string::npos) return 4;
  if (spe_event_handler_destroy(handler) != 0 || spe_context_destroy(context.spe) != 0) return 5;
  TestContext own;
  return own.exit_code(Probe::return_parameter, 6) == 6 ? 0 : 6;
}

TEST(Context, a_child_process_is_told_that_the_contexts_are_its_parent_s_and_can_make_its_own) {
  TestContext context;
  spe_event_handler_ptr_t handler = spe_event_handler_create();
  const pid_t child = fork();
  if (child == 0) {
    alarm(60);
    _exit(look_from_a_child(context, handler));
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status)) << "signal " << WTERMSIG(status);
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_EQ(context.exit_code(Probe::return_parameter, 5), 5) << "the parent's go on";
  EXPECT_EQ(spe_event_handler_destroy(handler), 0);
}

}  // namespace
}  // namespace spu_emu
