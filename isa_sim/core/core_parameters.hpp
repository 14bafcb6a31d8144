// The numbers of one core's pipeline, each declared once. Source: hardware.md sections 1.3 to 1.6
// and 4.
#pragma once

#include <common/parameter.hpp>

namespace finback::core {

struct CoreParameters : ParameterGroup {
  IntegerParameter branch_taken{
      this,
      {"core.branch.taken_cycles", "CCLK", 5, 1, 100, 'V', "hardware.md 1.4 (SIM)",
       "total cycles of a jump, call, return or correctly predicted taken branch"}};
  IntegerParameter branch_mispredicted{
      this,
      {"core.branch.mispredicted_cycles", "CCLK", 9, 1, 100, 'V', "hardware.md 1.4 (SIM, OC)",
       "total cycles of a conditional branch that went against its BP bit"}};
  IntegerParameter fetch_bytes{this,
                               {"core.fetch.bytes", "bytes", 8, 8, 64, 'V', "hardware.md 1.1 (CA)",
                                "what one fetch brings, from a multiple of it; at least the "
                                "longest packet, so that straight "
                                "code in L1 never waits"}};
  IntegerParameter split_target{
      this,
      {"core.fetch.split_target_cycles", "CCLK", 1, 0, 20, 'D', "hardware.md 1.1 (CA)",
       "stall before a packet in L1 that a change of flow leads to and that lies across two "
       "fetches: the alignment buffer is empty and waits for the second"}};
  IntegerParameter load_to_address{
      this,
      {"core.hazard.load_to_address_cycles", "CCLK", 3, 0, 20, 'V',
       "hardware.md 1.5 (OC slide 12, GCC)",
       "stall between a load of a P, I, M, B or L register and its use in stage AC"}};
  IntegerParameter move_to_address{this,
                                   {"core.hazard.move_to_address_cycles", "CCLK", 4, 0, 20, 'V',
                                    "hardware.md 1.5 (GCC; ADI's slide says 3)",
                                    "stall between a move from a data register into a P, I, M, B "
                                    "or L register and its use in stage AC"}};
  IntegerParameter alu_to_ex1{
      this,
      {"core.hazard.alu_to_ex1_cycles", "CCLK", 1, 0, 20, 'M', "hardware.md 1.5 (VLIB)",
       "stall between a result of EX2 and its use as an operand of a multiply, video or bit-field "
       "instruction"}};
  IntegerParameter multiply32{
      this,
      {"core.issue.multiply32_cycles", "CCLK", 3, 1, 100, 'V', "hardware.md 1.6 (OC, SIM, GCC)",
       "total cycles of a 32-bit multiply"}};
  IntegerParameter link{this,
                        {"core.issue.link_cycles", "CCLK", 3, 1, 100, 'V', "hardware.md 1.6 (SIM)",
                         "total cycles of LINK"}};
  IntegerParameter unlink{this,
                          {"core.issue.unlink_cycles", "CCLK", 2, 1, 100, 'V',
                           "hardware.md 1.6 (SIM)", "total cycles of UNLINK"}};
  IntegerParameter core_sync{this,
                             {"core.issue.csync_cycles", "CCLK", 10, 1, 1000, 'V',
                              "hardware.md 1.6 (SIM)", "total cycles of CSYNC"}};
  IntegerParameter system_sync{
      this,
      {"core.issue.ssync_cycles", "CCLK", 10, 1, 1000, 'V', "hardware.md 1.6 (SIM)",
       "total cycles of SSYNC with no system write pending"}};
  IntegerParameter event{this,
                         {"core.issue.event_cycles", "CCLK", 3, 1, 100, 'V',
                          "hardware.md 1.6 (SIM)", "total cycles of STI, RAISE and EXCPT"}};
  IntegerParameter test_and_set{
      this,
      {"core.issue.testset_cycles", "CCLK", 2, 1, 100, 'V', "hardware.md 1.6 (SIM)",
       "cycles of TESTSET beside its two memory accesses"}};
  IntegerParameter loop_register{
      this,
      {"core.issue.loop_register_cycles", "CCLK", 10, 1, 100, 'M', "hardware.md 1.4",
       "total cycles of writing LC, LT or LB by a move instead of LSETUP"}};
  IntegerParameter sub_bank_conflict{
      this,
      {"core.sub_bank.conflict_cycles", "CCLK", 1, 0, 20, 'M',
       "hardware.md 1.5 (rule: PT slide 36)",
       "stall when both accesses of a packet hit one L1 sub-bank with equal address bit 2"}};
  IntegerParameter sub_bank_dma{
      this,
      {"core.sub_bank.dma_conflict_cycles", "CCLK", 1, 0, 20, 'E', "hardware.md 1.5",
       "stall when a DMA word passes in the L1 sub-bank and half that the core accesses; 0: DMA is "
       "never in the way"}};
  IntegerParameter sub_bank_bytes{this,
                                  {"core.sub_bank.bytes", "bytes", 4096, 8, 65536, 'V',
                                   "hardware.md 2.2 (PT slides 35-36)", "size of an L1 sub-bank"}};
  IntegerParameter store_buffer_stall{
      this,
      {"core.store_buffer.stall_cycles", "CCLK", 0, 0, 20, 'M', "hardware.md 1.5",
       "stall of a load from L1 of bytes that are still in the store buffer; 0: they are "
       "forwarded"}};
  IntegerParameter store_buffer_stay{
      this,
      {"core.store_buffer.stay_cycles", "CCLK", 5, 1, 20, 'M', "hardware.md 1.5",
       "how long a store to L1 stays in the store buffer; matters where its stall is not 0"}};
  IntegerParameter interrupt_entry{
      this,
      {"core.interrupt.entry_cycles", "CCLK", 10, 1, 1000, 'E', "hardware.md 4",
       "pipeline flush and vectoring, from recognition to the handler's first instruction"}};
  IntegerParameter idle_wake{
      this,
      {"core.idle.wake_cycles", "CCLK", 10, 0, 100000, 'V', "hardware.md 1.6 (OP slide 29)",
       "from a wake-up event to the instruction after IDLE"}};
};

}  // namespace finback::core
