// The host engine's local store: its limit, its parts, and addresses of program memory.
#include "host/host_local_store.h"

#include <vector>

#include "test_context.h"

namespace spu_emu {
namespace {

TEST(LocalStore, has_any_size_or_none_by_its_setting) {
  EmulationSettings small;
  small.local_store_limit = 128 * 1024;
  TestContext limited(small);
  EXPECT_EQ(spe_ls_size_get(limited.spe), 128 * 1024);
  EXPECT_EQ(limited.run(Probe::allocate_until_full, 10000), -1);
  EmulationSettings off;
  off.local_store_limit = 0;
  TestContext unlimited(off);
  EXPECT_EQ(spe_ls_size_get(unlimited.spe), 1 << 30);
  const Words words;
  EXPECT_EQ(unlimited.exit_code(Probe::sum_into_heap, &words), words.sum());
  EXPECT_EQ(unlimited.exit_code(Probe::sum_into_stack, &words), words.sum());
}

TEST(LocalStore, a_program_whose_data_does_not_fit_is_refused_with_the_map) {
  EmulationSettings tiny;
  tiny.local_store_limit = 16 * 1024 + 256;
  tiny.code_reserve = 0;
  TestContext context(tiny);
  EXPECT_EQ(context.load_result, -1);
  EXPECT_NE(last_fault(context.spe).find("does not fit"), std::string::npos) << last_fault(context.spe);
  EXPECT_NE(last_fault(context.spe).find("stack"), std::string::npos);
}

TEST(LocalStore, the_map_tells_every_part) {
  TestContext context;
  const std::string map = local_store_map(context.spe);
  for (const char* part :
       {"262144", "code", "49152", "data", "heap", "stack", "16384", "free", "in use at most"}) {
    EXPECT_NE(map.find(part), std::string::npos) << part << " is not in:\n" << map;
  }
}

TEST(LocalStore, segments_and_stack_have_addresses_and_both_ways_agree) {
  Arena arena(256 * 1024);
  HostLocalStore store(arena, 16 * 1024, 8 * 1024);
  alignas(128) static std::array<std::byte, 1000> data;
  alignas(128) static const std::array<std::byte, 300> constants{};
  auto* constant = const_cast<std::byte*>(constants.data());
  ASSERT_TRUE(store.place({{constant, 300, false}, {data.data() + 5, 900, true}}));
  for (std::byte* pointer : {data.data() + 5, data.data() + 904, constant, constant + 299,
                             store.arena().stack_top() - 1, store.arena().stack_top() - 8192}) {
    const auto ls = store.address_of(pointer);
    ASSERT_TRUE(ls.has_value());
    EXPECT_EQ(store.at(*ls, 1), pointer);
    EXPECT_EQ(*ls % 16, reinterpret_cast<std::uintptr_t>(pointer) % 16);
    const auto number = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(pointer));
    EXPECT_EQ(store.address_of_number(number), number < 256 * 1024 ? number : *ls);
  }
  EXPECT_EQ(*store.address_of(data.data() + 5), 16U * 1024 + 5);
  EXPECT_FALSE(store.address_of(data.data()).has_value());
  EXPECT_FALSE(store.address_of(data.data() + 905).has_value());
  EXPECT_FALSE(store.address_of(store.arena().stack_top() - 8193).has_value());
  EXPECT_TRUE(store.below_stack_reserve(store.arena().stack_top() - 8193));
  EXPECT_FALSE(store.address_of(store.arena().stack_top()).has_value());
}

TEST(LocalStore, a_transfer_across_two_parts_is_refused_with_the_map) {
  Arena arena(256 * 1024);
  HostLocalStore store(arena, 16 * 1024, 8 * 1024);
  ASSERT_TRUE(store.place({}));
  const std::uint32_t stack_begin = 248 * 1024;
  EXPECT_NE(store.at(stack_begin - 128, 128), nullptr);
  EXPECT_NE(store.at(stack_begin, 128), nullptr);
  EXPECT_EQ(store.at(stack_begin - 128, 256), nullptr);
  EXPECT_NE(store.why_not(stack_begin - 128, 256).find("cross"), std::string::npos);
  EXPECT_EQ(store.at(256 * 1024 - 16, 32), nullptr);
}

}  // namespace
}  // namespace spu_emu
