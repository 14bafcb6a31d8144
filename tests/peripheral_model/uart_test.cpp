// The UART: characters in their time, and who is told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <common/error.hpp>
#include <peripheral_model/uart.hpp>

namespace finback::peripheral {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr Cycles kSclk = 5;
constexpr std::uint32_t kData = 0x00, kEnable = 0x04, kIdentification = 0x08, kLineControl = 0x0C,
                        kModemControl = 0x10, kLineStatus = 0x14, kScratch = 0x1C, kGlobal = 0x24;
constexpr std::uint32_t kEmpty = 0x60, kReady = 1, kOverrun = 2;
constexpr std::uint32_t kDivisor = 65;
constexpr Cycles kCharacter = 10 * 16 * kDivisor * kSclk;  // 8N1

class UartTest : public testing::Test {
 protected:
  UartTest() {
    uart_.set_output([this](std::uint8_t character) { sent_ += static_cast<char>(character); });
  }
  void write(std::uint32_t offset, std::uint32_t value, Cycles now = 0) {
    uart_.write(offset, 2, value, now);
  }
  std::uint32_t read(std::uint32_t offset, Cycles now = 0) { return uart_.read(offset, 2, now); }
  void set_up(std::uint32_t line_control = 3) {
    write(kLineControl, 0x80 | line_control);
    write(kData, kDivisor);
    write(kEnable, 0);
    write(kLineControl, line_control);
    write(kGlobal, 1);
  }
  void receive(const std::string& text) { uart_.set_input({text.begin(), text.end()}); }

  PeripheralParameters parameters_;
  std::vector<std::tuple<Uart::Line, bool, Cycles>> lines_;
  Uart uart_{parameters_, kSclk, [this](Uart::Line line, bool level, Cycles at) {
               lines_.emplace_back(line, level, at);
             }};
  std::string sent_;
};

TEST_F(UartTest, RegistersKeepWhatIsWritten) {
  write(kScratch, 0x5A);
  EXPECT_EQ(read(kScratch), 0x5AU);
  write(kLineControl, 0x83);
  write(kData, 0x34);
  write(kEnable, 0x12);
  EXPECT_EQ(read(kData), 0x34U);
  EXPECT_EQ(read(kEnable), 0x12U);
  write(kLineControl, 0x03);
  EXPECT_EQ(read(kEnable), 0U) << "the latch is apart";
  EXPECT_EQ(read(kLineStatus), kEmpty);
}

TEST_F(UartTest, ACharacterTakesItsBitsTime) {
  for (const auto& [control, half_bits] : std::vector<std::pair<std::uint32_t, Cycles>>{
           {3, 20}, {0, 14}, {4, 15}, {7, 22}, {0x1F, 24}}) {
    set_up(control);
    write(kData, 'x', 0);
    const Cycles end = half_bits * 8 * kDivisor * kSclk;
    EXPECT_EQ(uart_.next_event_time(), end) << control;
    uart_.advance(end);
    write(kGlobal, 0);
  }
  EXPECT_EQ(sent_, "x\x18\x18xx") << "of five bits the lower ones";
}

TEST_F(UartTest, TwoCharactersFitAndAThirdIsRefused) {
  set_up();
  write(kData, 'a', 0);
  EXPECT_EQ(read(kLineStatus), 0x20U) << "THR has passed it on";
  write(kData, 'b', 10);
  EXPECT_EQ(read(kLineStatus), 0U);
  EXPECT_THAT([&] { write(kData, 'c', 20); },
              ThrowsMessage<GuestFault>(HasSubstr("wait for THRE, bit 5 of UART_LSR")));
  uart_.advance(kCharacter);
  EXPECT_EQ(sent_, "a");
  EXPECT_EQ(uart_.next_event_time(), 2 * kCharacter);
  uart_.advance(2 * kCharacter);
  EXPECT_EQ(sent_, "ab");
  EXPECT_EQ(read(kLineStatus), kEmpty);
}

TEST_F(UartTest, InputComesCharacterByCharacterAndOverrunsWhoDoesNotRead) {
  receive("hey");
  set_up();
  EXPECT_EQ(uart_.next_event_time(), kCharacter);
  uart_.advance(kCharacter);
  EXPECT_EQ(read(kLineStatus), kEmpty | kReady);
  EXPECT_EQ(read(kData), 'h');
  EXPECT_EQ(read(kLineStatus), kEmpty);
  uart_.advance(3 * kCharacter);
  EXPECT_EQ(read(kLineStatus), kEmpty | kReady | kOverrun);
  EXPECT_EQ(read(kLineStatus), kEmpty | kReady) << "reading it clears the error";
  EXPECT_EQ(read(kData), 'y') << "the e is lost";
  EXPECT_EQ(uart_.next_event_time(), kNever);
}

TEST_F(UartTest, InterruptsComeAndGoWithTheirCause) {
  receive("ab");
  set_up();
  write(kEnable, 7, 0);
  using Line = std::tuple<Uart::Line, bool, Cycles>;
  EXPECT_THAT(lines_, ElementsAre(Line(Uart::Line::transmitted, true, 0)));
  EXPECT_EQ(read(kIdentification, 1), 2U);
  EXPECT_EQ(lines_.back(), Line(Uart::Line::transmitted, false, 1)) << "told";
  EXPECT_EQ(read(kIdentification, 1), 1U);

  uart_.advance(kCharacter);
  EXPECT_EQ(lines_.back(), Line(Uart::Line::received, true, kCharacter));
  EXPECT_EQ(read(kIdentification), 4U);
  uart_.advance(2 * kCharacter);
  EXPECT_EQ(lines_.back(), Line(Uart::Line::error, true, 2 * kCharacter));
  EXPECT_EQ(read(kIdentification), 6U);
  read(kLineStatus, 2 * kCharacter + 1);
  EXPECT_EQ(lines_.back(), Line(Uart::Line::error, false, 2 * kCharacter + 1));
  read(kData, 2 * kCharacter + 2);
  EXPECT_EQ(lines_.back(), Line(Uart::Line::received, false, 2 * kCharacter + 2));
}

TEST_F(UartTest, LoopBackReceivesWhatItSends) {
  set_up();
  write(kModemControl, 0x10);
  write(kData, 'q', 0);
  uart_.advance(kCharacter);
  EXPECT_EQ(read(kData), 'q');
  EXPECT_EQ(sent_, "");
}

TEST_F(UartTest, WhatCannotWorkIsAFault) {
  EXPECT_THAT([&] { write(kData, 'a'); },
              ThrowsMessage<GuestFault>(HasSubstr("set UCEN, UART_GCTL = 1, first")));
  EXPECT_THAT([&] { write(kGlobal, 3); }, ThrowsMessage<GuestFault>(HasSubstr("IREN")));
  EXPECT_THAT([&] { write(kLineStatus, 0); },
              ThrowsMessage<GuestFault>("UART_LSR = 0x0: it is read-only"));
}

}  // namespace
}  // namespace finback::peripheral
