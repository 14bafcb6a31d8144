// Spans, access rules, and counts whose sums are exact.
#include "memory_fixture.hpp"

namespace finback::memory {
namespace {

using MemorySystemTest = MemoryTest;
using testing::HasSubstr;

TEST_F(MemorySystemTest, EveryAddressLiesInOneSpan) {
  places_ = {{"left", "shared", 0x1000, 0x100},
             {"right", "shared", 0x1100, 10},
             {"tail", "shared", 0x110C, 4}};
  EXPECT_EQ(span(0, 0x0FFF)->size, 0x1000U);
  EXPECT_EQ(span(0, 0x1000), span(0, 0x10FF));
  EXPECT_NE(span(0, 0x10FF), span(0, 0x1100));
  // Padding up to a multiple of four belongs to the object before it.
  EXPECT_EQ(span(0, 0x110B), span(0, 0x1100));
  EXPECT_EQ(span(0, 0x110C)->size, 4U);
  EXPECT_EQ(span(0, 0x1110)->object, span(0, 0)->object);  // free bytes are one thing
}

TEST_F(MemorySystemTest, MemoryIsZeroAndKeepsWhatIsStored) {
  EXPECT_EQ(*span(0, 0x03FFFFFF)->at(0x03FFFFFF), 0);
  const std::array<std::uint8_t, 3> bytes = {1, 2, 3};
  memory().store_bytes(kL2 + 5, bytes);
  EXPECT_EQ(*span(1, kL2 + 6)->at(kL2 + 6), 2);
  EXPECT_EQ(memory().view_bytes(kL2 + 5, 3)[2], 3);
  EXPECT_THROW(memory().store_bytes(kL2 + 0x1FFFE, bytes), InputError);
}

TEST_F(MemorySystemTest, CoresReachTheirOwnL1Only) {
  EXPECT_NE(memory().find_span(0, kL1A), nullptr);
  EXPECT_EQ(memory().find_span(1, kL1A), nullptr);
  EXPECT_EQ(memory().find_span(0, 0xFFA00000), nullptr);  // own instruction memory
  EXPECT_EQ(memory().find_span(0, 0x04000000), nullptr);
  EXPECT_EQ(MemorySystem::window(0, span(0, kL2)), nullptr);
  EXPECT_EQ(MemorySystem::window(0, span(0, kL1A))->bytes, span(0, kL1A)->bytes);
}

TEST_F(MemorySystemTest, FaultsSayWhatIsWrong) {
  EXPECT_EQ(memory().core_fault(0, kL2, 4, true), "");
  EXPECT_EQ(memory().core_fault(0, kL2 + 2, 4, true),
            "store of 4 bytes at 0xfeb00002: misaligned, the address must be a multiple of 4");
  EXPECT_EQ(memory().core_fault(0, 0x04000000, 1, false),
            "load of 1 byte at 0x04000000: no memory is mapped there");
  EXPECT_EQ(memory().core_fault(1, kL1A, 2, false),
            "load of 2 bytes at 0xff800000: l1.data.a of core_a is out of reach of core_b (only "
            "DMA goes there)");
  EXPECT_THAT(memory().core_fault(0, 0xFFA00000, 4, false), HasSubstr("instruction memory"));
}

TEST_F(MemorySystemTest, DmaFaultsSayWhatIsWrong) {
  const auto fault = [this](Address address, std::int32_t stride, std::uint32_t count) {
    return memory().dma_fault({address, stride, count}, 4, Direction::write);
  };
  EXPECT_EQ(fault(kL1A, 4, 8192), "");
  EXPECT_EQ(fault(kL1A + 0x7FFC, -4, 8192), "");
  EXPECT_THAT(fault(kL1A, 4, 8193), HasSubstr("0xff808003: the transfer leaves l1.data.a"));
  EXPECT_THAT(fault(kL1A, -4, 2), HasSubstr("0xff7ffffc: the transfer leaves l1.data.a"));
  EXPECT_THAT(fault(0xFFB00000, 4, 1), HasSubstr("DMA does not reach l1.scratch"));
  EXPECT_THAT(fault(0x80000000, 4, 1), HasSubstr("no memory is mapped"));
}

TEST_F(MemorySystemTest, PlacesMustFitAndNotOverlap) {
  places_ = {{"one", "core_a", kL1A, 100}, {"two", "core_a", kL1A + 96, 100}};
  EXPECT_THAT([&] { build(); }, testing::ThrowsMessage<InputError>(HasSubstr("overlaps one")));
  places_ = {{"long", "core_a", kL1A, 0x8001}};
  EXPECT_THAT([&] { build(); }, testing::ThrowsMessage<InputError>(HasSubstr("long of core_a")));
}

TEST_F(MemorySystemTest, TrafficIsCountedByObject) {
  places_ = {
      {"a", "shared", 0x1000, 0x40}, {"b", "shared", 0x1040, 0x40}, {"table", "core_a", kL1A, 64}};
  build();
  dma(Direction::read, 0x1000, 20, 0);  // 16 words of a, 4 of b
  const Cycles stall = read(1, 0x1044, 1000);
  MemoryWindow* window = MemorySystem::window(0, span(0, kL1A));
  window->reads = {3, 5, 7};
  window->writes = {1, 0, 0};

  std::map<std::string, ObjectTraffic> by_name;
  for (const ObjectTraffic& object : memory().objects()) {
    by_name.emplace(object.name + "@" + object.region, object);
  }
  const auto traffic = [&](const char* name, Initiator initiator, Direction direction) {
    return by_name.at(name)
        .traffic[static_cast<std::size_t>(initiator)][static_cast<std::size_t>(direction)];
  };
  EXPECT_EQ(traffic("a@l3", Initiator::mdma1_0, Direction::read), (Traffic{16, 64, 0}));
  EXPECT_EQ(traffic("b@l3", Initiator::mdma1_0, Direction::read), (Traffic{4, 16, 0}));
  EXPECT_EQ(traffic("b@l3", Initiator::core_b, Direction::read), (Traffic{1, 4, stall}));
  EXPECT_EQ(traffic("table@l1.data.a", Initiator::core_a, Direction::read), (Traffic{15, 41, 0}));
  EXPECT_EQ(traffic("table@l1.data.a", Initiator::core_a, Direction::write), (Traffic{1, 1, 0}));
  EXPECT_EQ(traffic("(free)@l3", Initiator::core_b, Direction::read), Traffic{});
  EXPECT_EQ(by_name.at("(free)@l3").size, (64U << 20) - 0x80);
}

TEST_F(MemorySystemTest, SumsOverObjectsLevelsAndCountersAgree) {
  for (Address i = 0; i < 50; ++i) {
    places_.push_back({"l3_" + std::to_string(i), "shared", 0x100 * i, 0x90 + i});
    places_.push_back({"l2_" + std::to_string(i), "shared", kL2 + 0x200 * i, 0x101});
  }
  build();
  std::uint32_t random = 1;
  Cycles now = 0;
  Bytes moved = 0;
  for (int i = 0; i < 5000; ++i) {
    random = random * 1664525 + 1013904223;
    const Address address = (random >> 16 & 0x3FFC) + (random >> 30 & 1 ? kL2 : kL3);
    const int core = static_cast<int>(random >> 29 & 1);
    moved += 4;
    if ((random >> 28 & 1) != 0) {
      read(core, address, now);
    } else {
      write(core, address, now);
    }
    now += random >> 24 & 0x1F;
    if (i % 10 == 0) {
      dma(Direction::write, address & ~0xFFFU, 50, now, Initiator::mdma2_1);
      moved += 200;
    }
  }
  CounterRegistry registry;
  memory().register_counters(registry);
  Bytes counted = 0;
  Traffic by_level;
  for (const auto& [name, reading] : registry.snapshot()) {
    counted += name.starts_with("traffic.") && name.ends_with(".bytes") ? reading.value : 0;
  }
  Traffic by_object;
  for (const ObjectTraffic& object : memory().objects()) {
    for (const auto& directions : object.traffic) {
      by_object += directions[0];
      by_object += directions[1];
    }
  }
  for (int level = 0; level < kLevelCount; ++level) {
    for (int initiator = 0; initiator < kInitiatorCount; ++initiator) {
      for (const Direction direction : {Direction::read, Direction::write}) {
        by_level += memory().level_traffic(static_cast<Level>(level),
                                           static_cast<Initiator>(initiator), direction);
      }
    }
  }
  EXPECT_EQ(by_object, by_level);
  EXPECT_EQ(by_object.bytes, moved);
  EXPECT_EQ(counted, moved);
}

TEST_F(MemorySystemTest, HostAccessCountsAndTakesNoTime) {
  std::uint8_t* bytes = memory().host_access(0x2000, 1000, Direction::write);
  bytes[999] = 7;
  EXPECT_EQ(memory().view_bytes(0x2000 + 999, 1)[0], 7);
  EXPECT_EQ(memory().level_traffic(Level::l3, Initiator::host, Direction::write).bytes, 1000U);
  EXPECT_THROW(memory().host_access(kL2 + 0x1FFFF, 2, Direction::read), InputError);
}

TEST_F(MemorySystemTest, GatherAndScatterFollowTheirRuns) {
  const std::array<std::uint8_t, 16> bytes = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  memory().store_bytes(kL2, bytes);
  const std::array<DmaRun, 2> runs = {{{kL2, 4, 3}, {kL2 + 15, -2, 2}}};
  std::array<std::uint8_t, 5> taken{};
  memory().gather(runs, 1, taken.data(), Initiator::mdma1_0, 0);
  EXPECT_THAT(taken, testing::ElementsAre(0, 4, 8, 15, 13));
  const DmaRun row{kL3, 1, 5};
  memory().scatter({&row, 1}, 1, taken.data(), Initiator::mdma1_0);
  EXPECT_EQ(memory().view_bytes(kL3, 5)[3], 15);
}

}  // namespace
}  // namespace finback::memory
