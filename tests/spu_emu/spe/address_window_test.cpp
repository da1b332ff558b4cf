// Addresses reserved for an SPE, all of its 4 GB or the parts that are used.
#include "spe/address_window.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <memory>
#include <set>
#include <vector>

#include "mfc/command.h"
#include "mfc/spe_directory.h"

namespace spu_emu {
namespace {

/// Asks the system to read the byte, which survives if there is none.
bool is_readable(const std::byte* address) {
  int ends[2];
  if (pipe(ends) != 0) return false;
  const bool readable = write(ends[1], address, 1) == 1;
  close(ends[0]);
  close(ends[1]);
  return readable;
}

class Window : public testing::TestWithParam<AddressWindow::Extent> {};

TEST_P(Window, begins_at_a_multiple_of_its_size) {
  const AddressWindow window(GetParam());
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(window.base()) & 0xffffffffU, 0U);
}

TEST_P(Window, has_room_for_a_local_store_and_nothing_beside_it) {
  const AddressWindow window(GetParam());
  ASSERT_EQ(mprotect(window.base(), kLocalStoreSize, PROT_READ | PROT_WRITE), 0);
  std::memset(window.base(), 1, kLocalStoreSize);
  EXPECT_TRUE(is_readable(window.base() + kLocalStoreSize - 1));
  EXPECT_FALSE(is_readable(window.base() - 1));
  EXPECT_FALSE(is_readable(window.base() + kLocalStoreSize));
}

TEST_P(Window, keeps_the_problem_state_from_everybody) {
  const AddressWindow window(GetParam());
  std::byte* const registers = window.base() + kProblemStateOffset;
  void* given =
      mmap(registers, kProblemStateSize, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  ASSERT_NE(given, MAP_FAILED);
  EXPECT_NE(given, registers);
  munmap(given, kProblemStateSize);
}

TEST_P(Window, is_never_that_of_another_spe) {
  std::vector<std::unique_ptr<AddressWindow>> windows;
  std::set<std::byte*> bases;
  for (int i = 0; i < 6; ++i) {
    windows.push_back(std::make_unique<AddressWindow>(GetParam()));
    bases.insert(windows.back()->base());
  }
  EXPECT_EQ(bases.size(), windows.size());
}

INSTANTIATE_TEST_SUITE_P(extents, Window,
                         testing::Values(AddressWindow::Extent::whole, AddressWindow::Extent::parts),
                         [](const auto& test) {
                           return test.param == AddressWindow::Extent::whole ? "whole" : "parts";
                         });

TEST(WindowInParts, comes_back_to_the_system_as_often_as_it_is_taken) {
  std::set<std::byte*> bases;
  for (int i = 0; i < 500; ++i) bases.insert(AddressWindow(AddressWindow::Extent::parts).base());
  EXPECT_LT(bases.size(), 50U);
}

TEST(WindowInParts, leaves_what_lies_between_to_others) {
  const AddressWindow window(AddressWindow::Extent::parts);
  std::byte* const middle = window.base() + 0x80000000U;
  constexpr std::size_t kSize = 1 << 16;
  void* given = mmap(middle, kSize, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  EXPECT_EQ(given, middle);
  munmap(given, kSize);
}

}  // namespace
}  // namespace spu_emu
