// docs/fidelity.md: the device registers that hardware.md, sections 3 and 4, gives addresses of.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <map>
#include <tests/fidelity/figures_on_page.hpp>

#include <isa_sim/machine/device_bus.hpp>

namespace finback::machine {
namespace {

using Addresses = std::map<Address, std::string>;

void add_channel(Addresses& all, Address base, const std::string& name, bool mapped) {
  constexpr std::pair<Address, const char*> kRegisters[] = {
      {0x00, "NEXT_DESC_PTR"}, {0x04, "START_ADDR"},    {0x08, "CONFIG"},
      {0x10, "X_COUNT"},       {0x14, "X_MODIFY"},      {0x18, "Y_COUNT"},
      {0x1C, "Y_MODIFY"},      {0x20, "CURR_DESC_PTR"}, {0x24, "CURR_ADDR"},
      {0x28, "IRQ_STATUS"},    {0x30, "CURR_X_COUNT"},  {0x38, "CURR_Y_COUNT"}};
  for (const auto& [offset, register_name] : kRegisters) {
    all[base + offset] = name + "_" + register_name;
  }
  if (mapped) {
    all[base + 0x2C] = name + "_PERIPHERAL_MAP";
  }
}

Addresses published_registers() {
  Addresses all = {
      {0xFFC01B0C, "DMA1_TC_PER"}, {0xFFC01B10, "DMA1_TC_CNT"}, {0xFFC00B0C, "DMA2_TC_PER"}};
  for (const auto& [base, controller] : {std::pair{0xFFC01C00, 1}, std::pair{0xFFC00C00, 2}}) {
    for (Address channel = 0; channel < 12; ++channel) {
      add_channel(all, base + 0x40 * channel, fmt::format("DMA{}_{}", controller, channel), true);
    }
  }
  constexpr std::array kEnds = {"D0", "S0", "D1", "S1"};
  for (const auto& [base, controller] :
       {std::pair{0xFFC01F00, "MDMA1_"}, std::pair{0xFFC00F00, "MDMA2_"},
        std::pair{0xFFC01800, "IMDMA_"}}) {
    for (Address end = 0; end < kEnds.size(); ++end) {
      add_channel(all, base + 0x40 * end, controller + std::string(kEnds[end]), base != 0xFFC01800);
    }
  }
  constexpr std::array kPpi = {"CONTROL", "STATUS", "COUNT", "DELAY", "FRAME"};
  for (const auto& [base, name] :
       {std::pair{0xFFC01000, "PPI0_"}, std::pair{0xFFC01300, "PPI1_"}}) {
    for (Address i = 0; i < kPpi.size(); ++i) {
      all[base + 4 * i] = name + std::string(kPpi[i]);
    }
  }
  constexpr std::array kInterrupts = {"SWRST", "SYSCR", "RVECT", "IMASK0", "IMASK1", "ISR0",
                                      "ISR1",  "IWR0",  "IWR1",  "IAR0",   "IAR1",   "IAR2",
                                      "IAR3",  "IAR4",  "IAR5",  "IAR6",   "IAR7"};
  for (const auto& [base, name] :
       {std::pair{0xFFC00100, "SICA_"}, std::pair{0xFFC01100, "SICB_"}}) {
    for (Address i = 0; i < kInterrupts.size(); ++i) {
      all[base + 4 * i] = name + std::string(kInterrupts[i]);
    }
  }
  return all;
}

// Those whose address holds a register of this name.
double found(const Addresses& all) {
  const MachineDescription description;
  memory::MemorySystem memory(description.map, description.memory, description.clock, {});
  const DeviceBus bus(
      description, memory,
      {.lines_changed = [](int, std::uint32_t, bool, Cycles) {}, .core_b_released = [](Cycles) {}});
  return static_cast<double>(std::ranges::count_if(
      all, [&](const auto& one) { return bus.register_name(one.first) == one.second; }));
}

std::vector<PublishedFigure> register_figures() {
  const Addresses all = published_registers();
  return {{"device registers at their addresses", static_cast<double>(all.size()), "registers",
           "V 3, 4", [=] { return found(all); }}};
}

TEST(PublishedRegisters, StandOnThePageAsTheyAreFound) { expect_on_page(register_figures()); }

TEST(PublishedRegisters, AreMetThroughout) {
  EXPECT_THAT(not_met(register_figures()), testing::IsEmpty());
}

}  // namespace
}  // namespace finback::machine
