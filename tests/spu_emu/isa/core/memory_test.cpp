// Loads and stores: addresses, and the byte order between registers and the local store.
#include "test_machine.h"

namespace spu_emu::isa {
namespace {

constexpr Words kValue = {0x00112233, 0x44556677, 0x8899aabb, 0xccddeeff};

class Memory : public testing::Test {
 protected:
  void expect_loaded(std::uint32_t instruction, std::uint32_t address) {
    for (std::uint32_t k = 0; k < 4; ++k) spu_.put(address + 4 * k, kValue[k]);
    spu_.set(5, {});
    spu_.program({instruction, kStop}, 0x400);
    spu_.run_to_stop();
    EXPECT_EQ(spu_.reg(5), kValue);
    for (std::uint32_t k = 0; k < 4; ++k) spu_.put(address + 4 * k, 0);
  }
  void expect_stored(std::uint32_t instruction, std::uint32_t address) {
    spu_.set(5, kValue);
    spu_.program({instruction, kStop}, 0x400);
    spu_.run_to_stop();
    for (std::uint32_t k = 0; k < 4; ++k) EXPECT_EQ(spu_.get(address + 4 * k), kValue[k]);
    for (std::uint32_t k = 0; k < 4; ++k) spu_.put(address + 4 * k, 0);
  }
  TestMachine spu_;
};

TEST_F(Memory, IsReadAndWrittenAtAllKindsOfAddresses) {
  spu_.set(6, {0x1000, 1, 1, 1});
  spu_.set(7, {0x230, 2, 2, 2});
  for (const bool load : {true, false}) {
    const auto expect = [&](const char* name, std::initializer_list<std::int32_t> operands,
                            std::uint32_t address) {
      const std::string mnemonic = (load ? "lq" : "stq") + std::string(name);
      load ? expect_loaded(encode(mnemonic, operands), address)
           : expect_stored(encode(mnemonic, operands), address);
    };
    expect("d", {5, 0x1ff0, 6}, 0x2ff0);
    expect("d", {5, -0x1000, 6}, 0);
    expect("x", {5, 6, 7}, 0x1230);
    expect("a", {5, 0x2340}, 0x2340);
    expect("r", {5, 0x2000}, 0x2400);
    expect("r", {5, -0x400}, 0);
  }
}

TEST_F(Memory, AddressesWrapAndLoseTheirLowFourBits) {
  spu_.set(6, {0xfffffff7, 0, 0, 0});
  expect_loaded(encode("lqd", {5, 0, 6}), 0x3fff0);
  expect_stored(encode("stqd", {5, 16, 6}), 0);
  spu_.set(7, {0x4001f, 0, 0, 0});
  expect_loaded(encode("lqx", {5, 6, 7}), 0x10);
  expect_stored(encode("stqa", {5, -4}), 0x3fff0);
  expect_loaded(encode("lqr", {5, 0x24}), 0x420);
}

TEST_F(Memory, KeepsTheBytesInTheOrderOfTheSpu) {
  spu_.set(5, kValue);
  spu_.program({encode("stqa", {5, 0x1000}), kStop}, 0x400);
  spu_.run_to_stop();
  for (std::size_t k = 0; k < 16; ++k)
    EXPECT_EQ(spu_.local->bytes[0x1000 + k], static_cast<std::byte>(k * 0x11)) << k;
}

}  // namespace
}  // namespace spu_emu::isa
