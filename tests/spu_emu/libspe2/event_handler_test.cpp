// Event handlers and the queue of stop information.
#include <thread>

#include "../host/test_context.h"

namespace spu_emu {
namespace {

struct Handler {
  Handler() : pointer(spe_event_handler_create()) {}
  ~Handler() { spe_event_handler_destroy(pointer); }
  Handler(const Handler&) = delete;
  Handler& operator=(const Handler&) = delete;
  spe_event_handler_ptr_t pointer;
};

spe_event_unit_t unit(spe_context_ptr_t spe, unsigned int events, unsigned int data) {
  spe_event_unit_t result{};
  result.events = events;
  result.spe = spe;
  result.data.u32 = data;
  return result;
}

TEST(EventHandler, tells_of_a_stop_with_the_users_data) {
  TestContext context;
  Handler handler;
  auto stopped = unit(context.spe, SPE_EVENT_SPE_STOPPED, 42);
  EXPECT_EQ(spe_event_handler_register(handler.pointer, &stopped), 0);
  spe_event_unit_t event{};
  EXPECT_EQ(spe_event_wait(handler.pointer, &event, 1, 0), 0);
  EXPECT_EQ(spe_event_wait(handler.pointer, &event, 1, 3), 0);
  std::thread thread([&] { context.run(Probe::return_parameter, 9); });
  EXPECT_EQ(spe_event_wait(handler.pointer, &event, 1, -1), 1);
  thread.join();
  EXPECT_EQ(event.events, unsigned{SPE_EVENT_SPE_STOPPED});
  EXPECT_EQ(event.spe, context.spe);
  EXPECT_EQ(event.data.u32, 42U);
  spe_stop_info_t info{};
  EXPECT_EQ(spe_stop_info_read(context.spe, &info), 0);
  EXPECT_EQ(info.result.spe_exit_code, 9);
  EXPECT_EQ(spe_stop_info_read(context.spe, &info), -1);
  EXPECT_EQ(errno, EAGAIN);
  EXPECT_EQ(spe_event_wait(handler.pointer, &event, 1, 0), 0);
}

TEST(EventHandler, tells_of_mailboxes_and_tag_groups) {
  for (const DmaMode mode : {DmaMode::eager, DmaMode::late}) {
    TestContext context(settings_of(mode));
    Handler handler;
    auto all = unit(context.spe, SPE_EVENT_OUT_INTR_MBOX | SPE_EVENT_IN_MBOX | SPE_EVENT_TAG_GROUP, 1);
    EXPECT_EQ(spe_event_handler_register(handler.pointer, &all), 0);
    std::array<spe_event_unit_t, 4> events{};
    EXPECT_EQ(spe_event_wait(handler.pointer, events.data(), 4, 0), 1);
    EXPECT_EQ(events[0].events, unsigned{SPE_EVENT_IN_MBOX});
    Words words;
    EXPECT_EQ(spe_mfcio_get(context.spe, 0x20000, &words, sizeof words, 1, 0, 0), 0);
    EXPECT_EQ(spe_event_wait(handler.pointer, events.data(), 4, -1), 2);
    EXPECT_EQ(events[1].events, unsigned{SPE_EVENT_TAG_GROUP});
    std::thread thread([&] { context.run(Probe::echo_mailbox); });
    std::array<unsigned int, 2> messages{2, 0};
    auto in_box = unit(context.spe, SPE_EVENT_IN_MBOX | SPE_EVENT_TAG_GROUP, 1);
    EXPECT_EQ(spe_event_handler_deregister(handler.pointer, &in_box), 0);
    spe_in_mbox_write(context.spe, messages.data(), 2, SPE_MBOX_ALL_BLOCKING);
    EXPECT_EQ(spe_event_wait(handler.pointer, events.data(), 4, -1), 1);
    EXPECT_EQ(events[0].events, unsigned{SPE_EVENT_OUT_INTR_MBOX});
    thread.join();
  }
}

TEST(EventHandler, wrong_registrations_are_refused) {
  TestContext context;
  TestContext without({}, 0);
  Handler handler;
  auto event = unit(context.spe, SPE_EVENT_IN_MBOX, 0);
  const auto fails_with = [](int error, int result) {
    return result == -1 && std::exchange(errno, 0) == error;
  };
  EXPECT_TRUE(fails_with(ESRCH, spe_event_handler_register(nullptr, &event)));
  EXPECT_TRUE(fails_with(EINVAL, spe_event_handler_register(handler.pointer, nullptr)));
  EXPECT_TRUE(fails_with(ENOENT, spe_event_handler_deregister(handler.pointer, &event)));
  EXPECT_EQ(spe_event_handler_register(handler.pointer, &event), 0);
  EXPECT_TRUE(fails_with(EEXIST, spe_event_handler_register(handler.pointer, &event)));
  auto disabled = unit(without.spe, SPE_EVENT_IN_MBOX, 0);
  EXPECT_TRUE(fails_with(ENOTSUP, spe_event_handler_register(handler.pointer, &disabled)));
  auto unknown = unit(context.spe, 0x100, 0);
  EXPECT_TRUE(fails_with(ENOTSUP, spe_event_handler_register(handler.pointer, &unknown)));
  auto nobody = unit(nullptr, SPE_EVENT_IN_MBOX, 0);
  EXPECT_TRUE(fails_with(EINVAL, spe_event_handler_register(handler.pointer, &nobody)));
  EXPECT_TRUE(fails_with(ESRCH, spe_event_wait(nullptr, &event, 1, 0)));
  EXPECT_TRUE(fails_with(EINVAL, spe_event_wait(handler.pointer, nullptr, 1, 0)));
  EXPECT_TRUE(fails_with(EINVAL, spe_event_wait(handler.pointer, &event, 0, 0)));
  EXPECT_TRUE(fails_with(ESRCH, spe_event_handler_destroy(nullptr)));
  spe_stop_info_t info{};
  EXPECT_TRUE(fails_with(ENOTSUP, spe_stop_info_read(without.spe, &info)));
}

TEST(EventHandler, forgets_a_destroyed_context) {
  Handler handler;
  {
    TestContext context;
    auto event = unit(context.spe, SPE_EVENT_IN_MBOX, 0);
    EXPECT_EQ(spe_event_handler_register(handler.pointer, &event), 0);
  }
  spe_event_unit_t event{};
  EXPECT_EQ(spe_event_wait(handler.pointer, &event, 1, 0), 0);
}

}  // namespace
}  // namespace spu_emu
