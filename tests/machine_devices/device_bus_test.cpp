// Registers at their addresses, what reaching them costs, and all devices as one actor.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <common/error.hpp>
#include <isa_sim/machine/device_bus.hpp>

namespace finback::machine {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr Address kSicaMask1 = 0xFFC00110, kSicbSyscr = 0xFFC01104;
constexpr Address kMdma1 = 0xFFC01F00, kMdma2 = 0xFFC00F00, kHost = 0xFFC0F000;
constexpr Cycles kSclk = 5;

class DeviceBusTest : public testing::Test {
 protected:
  std::uint32_t read(Address address, int bytes = 4, Cycles now = 0) {
    return bus_.read(0, address, bytes, now).value;
  }
  // A copy of 16 words on stream 0.
  void start_copy(Address controller, Address from, Address to, Cycles now) {
    for (const auto& [channel, start, config] :
         {std::tuple{0x40U, from, 0x09U}, std::tuple{0x00U, to, 0x8BU}}) {
      bus_.write(0, controller + channel + 0x04, 4, start, now);
      bus_.write(0, controller + channel + 0x10, 2, 16, now);
      bus_.write(0, controller + channel + 0x14, 2, 4, now);
      bus_.write(0, controller + channel + 0x08, 2, config, now);
    }
  }

  MachineDescription description_;
  memory::MemorySystem memory_{description_.map, description_.memory, description_.clock, {}};
  std::vector<std::tuple<int, std::uint32_t, Cycles>> changes_;
  DeviceBus bus_{description_,
                 memory_,
                 {.lines_changed = [this](int core, std::uint32_t pending, bool,
                                          Cycles at) { changes_.emplace_back(core, pending, at); },
                  .core_b_released = [](Cycles) {}}};
};

TEST_F(DeviceBusTest, RegistersHaveTheBf561sNames) {
  EXPECT_EQ(bus_.register_name(0xFFC00104), "SICA_SYSCR");
  EXPECT_EQ(bus_.register_name(kSicbSyscr), "SICB_SYSCR");
  EXPECT_EQ(bus_.register_name(0xFFC0110C), "SICB_IMASK0");
  EXPECT_EQ(bus_.register_name(0xFFC00140), "SICA_IAR7");
  EXPECT_EQ(bus_.register_name(0xFFC01F08), "MDMA1_D0_CONFIG");
  EXPECT_EQ(bus_.register_name(0xFFC01FE8), "MDMA1_S1_IRQ_STATUS");
  EXPECT_EQ(bus_.register_name(0xFFC00F44), "MDMA2_S0_START_ADDR");
  EXPECT_EQ(bus_.register_name(0xFFC018B8), "IMDMA_D1_CURR_Y_COUNT");
  EXPECT_EQ(bus_.register_name(0xFFC0F00C), "HOST_FRAME_GRAB");
  EXPECT_EQ(bus_.register_name(0xFFC01310), "PPI1_FRAME");
  EXPECT_EQ(bus_.register_name(0xFFC00A10), "EBIU_SDGCTL");
  EXPECT_EQ(bus_.register_name(0xFFC00500), "");
}

TEST_F(DeviceBusTest, EveryNamedRegisterCanBeReadUnlessItsFaultSaysWhyNot) {
  int registers = 0;
  for (Address address = 0xFFC00000; address < 0xFFC10000; address += 4) {
    if (bus_.register_name(address).empty()) {
      EXPECT_THROW(bus_.read(0, address, 4, 0), GuestFault) << std::hex << address;
      continue;
    }
    ++registers;
    try {
      bus_.read(0, address, 4, 0);
    } catch (const GuestFault& fault) {
      EXPECT_THAT(fault.what(), HasSubstr(bus_.register_name(address)));
    }
  }
  const int dma = 2 * (16 * 13 + 2) + 4 * 12;
  EXPECT_EQ(registers, 2 * 15 + 1 + dma + 10 + 7 + 2 * 5 + 2 * 3 + 9 + 12 * 4 + 2 * 3 + 3 * 17 + 5);
}

TEST_F(DeviceBusTest, AReadHoldsTheCoreAndAWriteOnlyBehindAnother) {
  EXPECT_EQ(bus_.read(0, kSicaMask1, 4, 100).stall, 4 * kSclk);
  EXPECT_EQ(bus_.write(0, kSicaMask1, 4, 1, 200), 0U);
  EXPECT_EQ(bus_.writes_drained_at(0), 200 + 2 * kSclk);
  EXPECT_EQ(bus_.write(0, kSicaMask1, 4, 1, 201), 2 * kSclk - 1);
  EXPECT_EQ(bus_.writes_drained_at(0), 200 + 4 * kSclk);
  EXPECT_EQ(bus_.read(0, kSicaMask1, 4, 210).stall, 2 * kSclk + 4 * kSclk);
  EXPECT_EQ(bus_.read(1, kSicaMask1, 4, 210).stall, 4 * kSclk);
  EXPECT_EQ(bus_.write(0, kSicaMask1, 4, 1, 240), 0U);
}

TEST_F(DeviceBusTest, WhatIsNoRegisterNamesTheNearest) {
  EXPECT_THAT([&] { read(0xFFC01F0C); },
              ThrowsMessage<GuestFault>(
                  HasSubstr("0xffc01f0c: no device register is modelled there (the nearest is "
                            "MDMA1_D0_CONFIG at 0xffc01f08)")));
  EXPECT_THAT([&] { read(0xFFC00800); },  // SPORT0
              ThrowsMessage<GuestFault>(testing::EndsWith("no device register is modelled there")));
}

TEST_F(DeviceBusTest, AccessesOfTheWrongSizeAreFaults) {
  EXPECT_THAT([&] { read(kSicaMask1, 2); },
              ThrowsMessage<GuestFault>(HasSubstr("SICA_IMASK1 at 0xffc00110 takes 4 bytes")));
  EXPECT_THAT([&] { bus_.write(0, kHost + kConsole, 1, 65, 0); },
              ThrowsMessage<GuestFault>(HasSubstr("store of 1 byte at 0xffc0f01c: HOST_CONSOLE")));
  EXPECT_THAT([&] { read(kMdma1 + 2, 4); }, ThrowsMessage<GuestFault>(HasSubstr("2 or 4 bytes")));
  EXPECT_EQ(read(0xFFC00104, 2), 0x20U);  // SYSCR is a 16-bit register
}

TEST_F(DeviceBusTest, ATransferInterruptsTheCoreThatAskedForIt) {
  const std::array<std::uint8_t, 4> word = {1, 2, 3, 4};
  memory_.store_bytes(0x1000, word);
  for (const Address wakeup1 : {0xFFC00120U, 0xFFC01120U}) {
    bus_.write(0, wakeup1, 4, 0, 0);  // no wake-up, to see the request alone
  }
  bus_.write(0, kSicaMask1, 4, 1U << (53 - 32), 0);
  start_copy(kMdma1, 0x1000, 0xFF800000, 100);
  EXPECT_EQ(bus_.next_event_time(), 100 + 8 * kSclk);
  // Start-up 8, read 1 + 3 + 3 + 16, write 2 + 16, interrupt 3.
  const Cycles done = 100 + (8 + 23 + 18) * kSclk;
  bus_.advance(done + 3 * kSclk - 1);
  EXPECT_EQ(read(kMdma1 + 0x28, 2), 1U);
  EXPECT_EQ(memory_.view_bytes(0xFF800002, 1)[0], 3);
  EXPECT_TRUE(changes_.empty());
  bus_.advance(done + 3 * kSclk);
  EXPECT_THAT(changes_, testing::ElementsAre(std::tuple{0, 1U << 8, done + 3 * kSclk}));
  bus_.write(0, kMdma1 + 0x28, 2, 1, done + 100);
  EXPECT_EQ(changes_.back(), (std::tuple{0, 0U, done + 100}));
  EXPECT_EQ(bus_.next_event_time(), kNever);
}

TEST_F(DeviceBusTest, BothControllersRunBesideEachOther) {
  bus_.write(0, kSicaMask1, 4, 0xFFFFFFFF, 0);
  start_copy(kMdma2, 0x1000, 0xFF800000, 100);
  start_copy(kMdma1, 0x2000, 0xFF400000, 100);
  bus_.advance(100000);
  EXPECT_EQ(read(kMdma1 + 0x28, 2), 1U);
  EXPECT_EQ(read(kMdma2 + 0x28, 2), 1U);
  EXPECT_EQ(std::get<1>(changes_.back()), 1U << 8 | 1U << 9);
}

TEST_F(DeviceBusTest, ImdmaIsThereAndRefusesToRunAt600Megahertz) {
  bus_.write(0, 0xFFC01810, 2, 12, 0);
  EXPECT_EQ(read(0xFFC01810, 2), 12U);
  EXPECT_THAT([&] { bus_.write(0, 0xFFC01808, 2, 1, 0); },
              ThrowsMessage<GuestFault>(HasSubstr("05000182")));
}

}  // namespace
}  // namespace finback::machine
