// Transfers: their bytes, their time by formula, their interrupts.
#include "dma_fixture.hpp"

namespace finback::dma {
namespace {

using MemoryDmaTest = DmaTest;

// Unloaded L3 to L1, n full bursts of 16 words within one row and before the first refresh:
// start-up 8, what starts the reads (1 + CL 3 + tRCD 3) and the writes (2), then a word a SCLK; the
// last burst is written while none is read.
constexpr Cycles l3_to_l1_sclk(Cycles bursts) { return 8 + 7 + 2 + 16 * (bursts + 1); }

TEST_F(MemoryDmaTest, UnloadedLatencyByFormula) {
  for (const std::uint32_t bursts : {1U, 2U, 16U, 32U}) {
    build();
    EXPECT_EQ(copy(*dma1_, 0, kL3, kL1A, 16 * bursts, kBits32, 100),
              100 + l3_to_l1_sclk(bursts) * kSclk);
  }
}

TEST_F(MemoryDmaTest, DoneAndItsInterruptComeWithTheLastWordNotACycleBefore) {
  const auto bytes = pattern(64);
  memory_->store_bytes(kL3, bytes);
  program(*dma1_, kS0, kL3, 16, 4);
  program(*dma1_, kD0, kL1A, 16, 4);
  enable(*dma1_, 0, kBits32 | kInterruptEnable, 0);
  EXPECT_EQ(status(*dma1_, kD0), kRun);
  const Cycles done = l3_to_l1_sclk(1) * kSclk;
  dma1_->advance(done - 1);
  EXPECT_EQ(status(*dma1_, kD0), kRun);
  EXPECT_EQ(bytes_at(kL1A, 64), std::vector<std::uint8_t>(64));
  EXPECT_TRUE(lines_.empty());
  dma1_->advance(done);
  EXPECT_EQ(status(*dma1_, kD0), kDone);
  EXPECT_EQ(bytes_at(kL1A, 64), bytes);
  EXPECT_EQ(lines_, (std::vector<LineChange>{{53, true, done}}));

  dma1_->write(kD0 + kIrqStatus, 2, kRun, done + 10);  // writing 0 to DONE leaves it
  EXPECT_EQ(status(*dma1_, kD0), kDone);
  dma1_->write(kD0 + kIrqStatus, 2, kDone, done + 20);
  EXPECT_EQ(status(*dma1_, kD0), 0U);
  EXPECT_EQ(lines_.back(), (LineChange{53, false, done + 20}));
}

TEST_F(MemoryDmaTest, WithoutDiEnDoneIsSetAndTheLineStaysLow) {
  copy(*dma1_, 1, kL3, kL2, 100, kBits16, 0);
  EXPECT_EQ(status(*dma1_, kD1), kDone);
  EXPECT_TRUE(lines_.empty());
}

TEST_F(MemoryDmaTest, StartUpIsFeltToTheCycle) {
  for (const int sclk : {0, 1, 8, 9, 100}) {
    parameters_.startup_sclk.set(sclk);
    build();
    EXPECT_EQ(copy(*dma1_, 0, kL3, kL1A, 16, kBits32, 100),
              100 + (l3_to_l1_sclk(1) - 8 + static_cast<Cycles>(sclk)) * kSclk);
  }
}

enum class Ends { both_at_once, in_turn, in_turn_with_starts };

// What starts each end, and how the two come together.
struct Path {
  const char* name;
  Address from, to;
  Cycles read_start, write_start;  // SCLK before the first element
  Ends ends;
};

class DmaPath : public DmaTest,
                public testing::WithParamInterface<std::tuple<Path, std::uint32_t, int>> {};

// hardware.md 3.2: a word of any width a SCLK, behind what starts the transfer at its two ends.
// Both ends at once where the memories differ, in turn where they do not; SDRAM then starts every
// burst.
TEST_P(DmaPath, TakesWhatTheFormulaSays) {
  const auto& [path, width, burst] = GetParam();
  memory_parameters_.sdram_refresh_sclk.set(0);
  memory_parameters_.sdram_trcd_sclk.set(0);
  memory_parameters_.sdram_turnaround_sclk.set(0);
  memory_parameters_.sdram_page_bytes.set(65536);
  parameters_.burst_elements.set(burst);
  build();
  constexpr Cycles kBursts = 12;
  const auto n = static_cast<Cycles>(burst);
  const Cycles starts = path.read_start + path.write_start;
  const Cycles sclk = path.ends == Ends::both_at_once ? starts + (kBursts + 1) * n
                      : path.ends == Ends::in_turn    ? starts + 2 * kBursts * n
                                                      : kBursts * (starts + 2 * n);
  const auto bytes = pattern(kBursts * n << (width >> 2U));
  memory_->store_bytes(path.from, bytes);
  EXPECT_EQ(copy(*dma1_, 0, path.from, path.to, static_cast<std::uint32_t>(kBursts * n), width, 0),
            (8 + sclk) * kSclk);
  EXPECT_EQ(bytes_at(path.to, static_cast<std::uint32_t>(bytes.size())), bytes);
}

INSTANTIATE_TEST_SUITE_P(
    All, DmaPath,
    testing::Combine(testing::Values(Path{"l3_l1", kL3, kL1A, 4, 2, Ends::both_at_once},
                                     Path{"l1_l3", kL1A, kL3, 2, 3, Ends::both_at_once},
                                     Path{"l3_l2", kL3, kL2, 4, 2, Ends::both_at_once},
                                     Path{"l2_l3", kL2, kL3, 2, 3, Ends::both_at_once},
                                     Path{"l2_l1", kL2, kL1B, 2, 2, Ends::both_at_once},
                                     Path{"l1_l2", kL1B, kL2, 2, 2, Ends::both_at_once},
                                     Path{"l1_other_l1", kL1A, kL1B, 2, 2, Ends::both_at_once},
                                     Path{"l1_same_l1", kL1A, kL1A2, 2, 2, Ends::in_turn},
                                     Path{"l2_l2", kL2, kL2 + 0x10000, 2, 2, Ends::in_turn},
                                     Path{"l3_l3", kL3, kL3 + (16U << 20), 4, 3,
                                          Ends::in_turn_with_starts}),
                     testing::Values(kBits8, kBits16, kBits32), testing::Values(4, 16, 64)),
    [](const testing::TestParamInfo<std::tuple<Path, std::uint32_t, int>>& path) {
      return std::string(std::get<0>(path.param).name) + "_" +
             std::to_string(8U << (std::get<1>(path.param) >> 2U)) + "_bits_by_" +
             std::to_string(std::get<2>(path.param));
    });

struct Bandwidth {
  const char* name;
  Address from, to;
  std::uint32_t width;
  double low, high;  // MB/s
};

class DmaBandwidth : public DmaTest, public testing::WithParamInterface<Bandwidth> {};

// hardware.md 3.2: 4 B a SCLK at most (480 MB/s), all but rows and refreshes of it reached by a
// stream that has the memories for itself; half when both ends are in the same memory; 1 B a SCLK
// (120 MB/s) for 8-bit elements.
TEST_P(DmaBandwidth, LiesWithinItsBounds) {
  const Bandwidth& b = GetParam();
  const std::uint32_t bytes = 16384;
  const std::uint32_t elements = bytes >> (b.width >> 2U);
  const Cycles cycles = copy(*dma1_, 0, b.from, b.to, elements, b.width, 0);
  const double megabytes_per_second = bytes * 600.0 / static_cast<double>(cycles);
  EXPECT_GE(megabytes_per_second, b.low);
  EXPECT_LE(megabytes_per_second, b.high);
  RecordProperty("megabytes_per_second", std::to_string(megabytes_per_second));
}

INSTANTIATE_TEST_SUITE_P(
    All, DmaBandwidth,
    testing::Values(Bandwidth{"l3_to_l1", kL3, kL1A, kBits32, 0.95 * 480, 480},
                    Bandwidth{"l1_to_l3", kL1A, kL3, kBits32, 0.95 * 480, 480},
                    Bandwidth{"l3_to_l2", kL3, kL2, kBits32, 0.95 * 480, 480},
                    Bandwidth{"l2_to_l1", kL2, kL1B, kBits32, 0.98 * 480, 480},
                    Bandwidth{"l1_to_same_l1", kL1A, kL1A2, kBits32, 0.49 * 480, 0.50 * 480},
                    Bandwidth{"l1_to_other_l1", kL1A, kL1B, kBits32, 0.98 * 480, 480},
                    Bandwidth{"l3_to_l3", kL3, kL3 + (16U << 20), kBits32, 0.30 * 480, 0.50 * 480},
                    Bandwidth{"16_bits", kL3, kL1A, kBits16, 0.95 * 240, 240},
                    Bandwidth{"8_bits", kL3, kL1A, kBits8, 0.95 * 120, 120}),
    [](const testing::TestParamInfo<Bandwidth>& b) { return b.param.name; });

TEST_F(MemoryDmaTest, EveryWidthMovesItsBytes) {
  const auto bytes = pattern(4000);
  for (const std::uint32_t width : {kBits8, kBits16, kBits32}) {
    build();
    memory_->store_bytes(kL3 + 12, bytes);
    copy(*dma2_, 1, kL3 + 12, kL2 + 64, 4000U >> (width >> 2U), width, 0);
    EXPECT_EQ(bytes_at(kL2 + 64, 4000), bytes);
    EXPECT_EQ(bytes_at(kL2, 64), std::vector<std::uint8_t>(64));
    EXPECT_EQ(bytes_at(kL2 + 64 + 4000, 64), std::vector<std::uint8_t>(64));
  }
}

TEST_F(MemoryDmaTest, SubSamplingTakesEveryFourthPixelOfEveryFourthRow) {
  constexpr std::uint32_t kWidth = 640;
  const auto image = pattern(std::size_t{kWidth} * 480);
  memory_->store_bytes(kL3, image);
  program(*dma1_, kS0, kL3, 160, 4);
  program_rows(*dma1_, kS0, 120, 4 + 3 * kWidth);
  program(*dma1_, kD0, kL1A, 160, 1);
  program_rows(*dma1_, kD0, 120, 1);
  enable(*dma1_, 0, kBits8 | kTwoDimensional, 0);
  finish(*dma1_);
  const auto small = bytes_at(kL1A, 160 * 120);
  for (std::uint32_t y = 0; y < 120; ++y) {
    for (std::uint32_t x = 0; x < 160; ++x) {
      ASSERT_EQ(small[y * 160 + x], image[4 * y * kWidth + 4 * x]) << x << ' ' << y;
    }
  }
}

TEST_F(MemoryDmaTest, ACountOfZeroIs65536) {
  const auto bytes = pattern(65536);
  memory_->store_bytes(kL3, bytes);
  copy(*dma1_, 0, kL3, kL2, 0, kBits8, 0);
  EXPECT_EQ(bytes_at(kL2, 65536), bytes);
  EXPECT_EQ(bytes_at(kL2 + 65536, 4), std::vector<std::uint8_t>(4));
}

TEST_F(MemoryDmaTest, DiSelInterruptsWithEveryRow) {
  program(*dma1_, kS0, kL3, 16, 4);
  program_rows(*dma1_, kS0, 3, 4);
  program(*dma1_, kD0, kL1A, 16, 4);
  program_rows(*dma1_, kD0, 3, 64);
  enable(*dma1_, 0, kBits32 | kTwoDimensional | kInterruptEnable | kInterruptPerRow, 0);
  std::vector<Cycles> rows;
  while (dma1_->next_event_time() != kNever) {
    dma1_->advance(dma1_->next_event_time());
    if (!lines_.empty() && lines_.back().level) {
      rows.push_back(lines_.back().at);
      dma1_->write(kD0 + kIrqStatus, 2, kDone, lines_.back().at);
    }
  }
  EXPECT_THAT(rows, testing::ElementsAre(l3_to_l1_sclk(1) * kSclk, l3_to_l1_sclk(2) * kSclk,
                                         l3_to_l1_sclk(3) * kSclk));
}

TEST_F(MemoryDmaTest, AutobufferGoesRoundUntilDisabled) {
  program(*dma1_, kS0, kL3, 32, 4);
  program(*dma1_, kD0, kL1A, 32, 4);
  enable(*dma1_, 0, kBits32 | kAutobuffer | kInterruptEnable, 0);
  std::vector<Cycles> ends;
  while (ends.size() < 5) {
    dma1_->advance(dma1_->next_event_time());
    if (!lines_.empty() && lines_.back().level) {
      ends.push_back(lines_.back().at);
      EXPECT_EQ(status(*dma1_, kD0), kDone | kRun);
      memory_->store_bytes(kL3, pattern(128, static_cast<std::uint32_t>(ends.size())));
      dma1_->write(kD0 + kIrqStatus, 2, kDone, lines_.back().at);
    }
  }
  // The source reads ahead into the next round: 32 words and the starts at both ends, 4 + 2 SCLK.
  // Its first burst of a round is under way when the round before ends.
  EXPECT_EQ(ends[4] - ends[3], 38 * kSclk);
  EXPECT_EQ(bytes_at(kL1A, 128), pattern(128, 4));
  dma1_->write(kD0 + kConfig, 2, 0, ends[4] + 1);
  finish(*dma1_);
  EXPECT_EQ(status(*dma1_, kD0), 0U);
  EXPECT_EQ(status(*dma1_, kS0) & kRun, kRun);
}

TEST_F(MemoryDmaTest, AFinishedStreamStartsAgainByConfig) {
  copy(*dma1_, 0, kL3, kL1A, 64, kBits32, 0);
  memory_->store_bytes(kL3, pattern(256));
  const Cycles done = copy(*dma1_, 0, kL3, kL1A, 64, kBits32, 2000);
  EXPECT_EQ(done, 2000 + (l3_to_l1_sclk(4) - 3) * kSclk);  // the row is open
  EXPECT_EQ(bytes_at(kL1A, 256), pattern(256));
}

TEST_F(MemoryDmaTest, ConfigOfARunningChannelIsAFault) {
  program(*dma1_, kS0, kL3, 64, 4);
  program(*dma1_, kD0, kL1A, 64, 4);
  enable(*dma1_, 0, kBits32, 0);
  EXPECT_THAT([&] { enable(*dma1_, 0, kBits32, 10); },
              testing::ThrowsMessage<GuestFault>(testing::HasSubstr(
                  "MDMA1_S0_CONFIG = 0x9: it was written while the channel runs")));
}

TEST_F(MemoryDmaTest, CurrentRegistersFollowTheTransfer) {
  program(*dma1_, kS0, kL3, 100, 4);
  program(*dma1_, kD0, kL1A, 100, 4);
  enable(*dma1_, 0, kBits32, 0);
  EXPECT_EQ(dma1_->read(kS0 + kCurrentAddress, 4, 0), kL3);
  EXPECT_EQ(dma1_->read(kS0 + kCurrentXCount, 2, 0), 100U);
  dma1_->advance(60 * kSclk);  // two bursts were asked for
  EXPECT_EQ(dma1_->read(kS0 + kCurrentAddress, 4, 0), kL3 + 3 * 64);
  EXPECT_EQ(dma1_->read(kD0 + kCurrentAddress, 4, 0), kL1A + 2 * 64);
  EXPECT_EQ(dma1_->read(kD0 + kCurrentXCount, 2, 0), 100U - 32);
}

}  // namespace
}  // namespace finback::dma
