// The declared numbers of the memories: L1's DMA port, L2, SDRAM and the write
// buffers. L1 sub-banks are the core's (core_parameters.hpp).
//
// Each carries its certainty and source as in hardware.md; those in SCLK become core cycles by the
// clock ratio when the memory system is built.
#pragma once

#include <common/parameter.hpp>

namespace finback::memory {

struct MemoryParameters final : ParameterGroup {
  // --- L1, as DMA sees it ---
  IntegerParameter l1_dma_overhead_sclk{
      this,
      {"memory.l1.dma_overhead_sclk", "SCLK", 2, 0, 64, 'E', "hardware.md 3.2",
       "start of DMA on a core's L1 port, before a work unit's first word"}};
  IntegerParameter l1_dma_word_sclk{this,
                                    {"memory.l1.dma_word_sclk", "SCLK", 1, 1, 64, 'D',
                                     "hardware.md 3.2", "one DMA word on a core's L1 port"}};

  // --- the store buffer between a core and L2, L3 ---
  IntegerParameter write_buffer_entries{
      this,
      {"memory.write_buffer_entries", "", 5, 1, 16, 'M', "hardware.md 2.3, 2.4",
       "posted writes to L2 and L3 that a core has under way before it stalls"}};

  // --- L2 ---
  IntegerParameter l2_read_cycles{
      this,
      {"memory.l2.read_cycles", "CCLK", 9, 1, 64, 'M', "hardware.md 2.3",
       "one uncached read of up to 64 bits, its issue cycle included; instruction fetch too"}};
  IntegerParameter l2_write_cycles{this,
                                   {"memory.l2.write_cycles", "CCLK", 3, 0, 64, 'E',
                                    "hardware.md 2.3", "time of one posted write on the L2 port"}};
  IntegerParameter l2_contention_cycles{
      this,
      {"memory.l2.contention_cycles", "CCLK", 2, 0, 64, 'E', "hardware.md 2.3",
       "added to the rest of the access in progress for a core that finds the other one there"}};
  IntegerParameter l2_sub_bank_bytes{this,
                                     {"memory.l2.sub_bank_bytes", "bytes", 16384, 1024, 1048576,
                                      'M', "hardware.md 2.3", "size of one L2 sub-bank"}};
  IntegerParameter l2_dma_collision_cycles{
      this,
      {"memory.l2.dma_collision_cycles", "CCLK", 2, 0, 64, 'E', "hardware.md 2.3",
       "delay of a core access to a sub-bank that a DMA burst is using (the DMA port wins)"}};
  IntegerParameter l2_dma_overhead_sclk{
      this,
      {"memory.l2.dma_overhead_sclk", "SCLK", 2, 0, 64, 'E', "hardware.md 3.2",
       "start of DMA on L2's DMA port, before a work unit's first word"}};
  IntegerParameter l2_dma_word_sclk{this,
                                    {"memory.l2.dma_word_sclk", "SCLK", 1, 1, 64, 'V',
                                     "hardware.md 2.3", "one DMA word on L2's 32-bit DMA port"}};

  // --- IMDMA, in L1 and on the port of L2 that the cores use ---
  IntegerParameter imdma_overhead_cycles{
      this,
      {"memory.imdma.overhead_cycles", "CCLK", 6, 0, 64, 'E', "hardware.md 3.2",
       "start of an IMDMA burst at either end, before its first element"}};
  IntegerParameter imdma_word_cycles{
      this,
      {"memory.imdma.word_cycles", "CCLK", 3, 1, 64, 'M', "hardware.md 3.2",
       "one element of IMDMA at either end, of any width (2 to 4 cycles)"}};
  IntegerParameter l2_burst_beat_cycles{
      this,
      {"memory.l2.burst_beat_cycles", "CCLK", 2, 1, 64, 'M', "hardware.md 2.3",
       "each further 64 bits of a cache line, to or from L2"}};

  // --- caches: what holds without code that sets them up ---
  IntegerParameter cache_data_banks{
      this,
      {"memory.cache.data_banks", "", 0, 0, 2, 'V', "hardware.md 2.2",
       "banks of each core's L1 data memory whose upper half is cache from reset on (DMC of "
       "DMEM_CONTROL): none, A, or A and B"}};
  IntegerParameter cache_code{
      this,
      {"memory.cache.code", "", 0, 0, 1, 'V', "hardware.md 2.2",
       "1: the upper half of each core's L1 instruction memory is cache from reset on (IMC of "
       "IMEM_CONTROL), and code of L2 and L3 is cached while CPLBs are off"}};
  IntegerParameter cache_l2_policy{
      this,
      {"memory.cache.l2_policy", "", 0, 0, 3, 'V', "hardware.md 2.2",
       "data of L2 while CPLBs are off: 0 uncached, as on the chip; 1 write-through; 2 the same, "
       "stores bring lines in; 3 write-back"}};
  IntegerParameter cache_l3_policy{
      this,
      {"memory.cache.l3_policy", "", 0, 0, 3, 'V', "hardware.md 2.2",
       "data of L3 while CPLBs are off: 0 to 3 as memory.cache.l2_policy"}};

  // --- SDRAM and the external bus ---
  IntegerParameter sdram_cl_sclk{this,
                                 {"memory.sdram.cl_sclk", "SCLK", 3, 0, 8, 'V', "hardware.md 2.4",
                                  "CAS latency: column command to first data"}};
  IntegerParameter sdram_trcd_sclk{this,
                                   {"memory.sdram.trcd_sclk", "SCLK", 3, 0, 16, 'V',
                                    "hardware.md 2.4", "row activation to column command"}};
  IntegerParameter sdram_trp_sclk{this,
                                  {"memory.sdram.trp_sclk", "SCLK", 3, 0, 16, 'V',
                                   "hardware.md 2.4", "precharge (closing a row)"}};
  IntegerParameter sdram_tras_sclk{this,
                                   {"memory.sdram.tras_sclk", "SCLK", 6, 0, 32, 'V',
                                    "hardware.md 2.4", "least time between opening and closing"}};
  IntegerParameter sdram_twr_sclk{this,
                                  {"memory.sdram.twr_sclk", "SCLK", 2, 0, 16, 'V',
                                   "hardware.md 2.4", "write recovery: last data to precharge"}};
  IntegerParameter sdram_core_read_overhead_sclk{
      this,
      {"memory.sdram.core_read_overhead_sclk", "SCLK", 5, 0, 64, 'D', "hardware.md 2.4",
       "added to CL for a core's read (clock crossing): 5 + 3 = the measured 8 SCLK"}};
  IntegerParameter sdram_core_read_hold_sclk{
      this,
      {"memory.sdram.core_read_hold_sclk", "SCLK", 4, 0, 64, 'E', "hardware.md 2.4",
       "part of a core's read during which nobody else can use the bus (CL + one data beat)"}};
  IntegerParameter sdram_write_sclk{
      this,
      {"memory.sdram.write_sclk", "SCLK", 1, 0, 64, 'V', "hardware.md 2.4",
       "one posted write of up to 32 bits to an open row on the bus"}};
  IntegerParameter sdram_beat_sclk{
      this,
      {"memory.sdram.beat_sclk", "SCLK", 1, 1, 16, 'D', "hardware.md 2.4",
       "one 32-bit word in a stream: DMA elements, second half of an instruction fetch"}};
  IntegerParameter sdram_dma_overhead_sclk{
      this,
      {"memory.sdram.dma_overhead_sclk", "SCLK", 1, 0, 64, 'E', "hardware.md 3.2",
       "lost, besides CL (read) or tWR (write), where a DMA burst does not go on from the one "
       "before"}};
  IntegerParameter sdram_turnaround_sclk{
      this,
      {"memory.sdram.turnaround_sclk", "SCLK", 1, 0, 16, 'E', "hardware.md 2.5",
       "a DMA burst in the other direction than the one before"}};
  IntegerParameter sdram_refresh_period_ns{
      this,
      {"memory.sdram.refresh_period_ns", "ns", 7812, 100, 1000000, 'V', "hardware.md 2.4",
       "time between refreshes of one row in every bank (64 ms / 8192)"}};
  IntegerParameter sdram_refresh_sclk{
      this,
      {"memory.sdram.refresh_sclk", "SCLK", 12, 0, 64, 'D', "hardware.md 2.4",
       "time that a refresh takes the bus (tRP + tRFC); 0: rows are never refreshed"}};
  IntegerParameter sdram_bus_bytes{
      this,
      {"memory.sdram.bus_bytes", "bytes", 4, 2, 4, 'V', "hardware.md 2.4",
       "width of the external data bus: 4, or 2 in 16-bit mode (with half the page_bytes)"}};
  IntegerParameter sdram_banks{
      this,
      {"memory.sdram.banks", "", 4, 1, 16, 'V', "hardware.md 2.4",
       "internal banks, each with one open row; equal parts of the region"}};
  IntegerParameter sdram_page_bytes{
      this,
      {"memory.sdram.page_bytes", "bytes", 2048, 256, 65536, 'V', "hardware.md 2.4",
       "bytes of one row over the bus: 9 column bits on 32 bits"}};
  IntegerParameter external_patience_sclk{
      this,
      {"memory.external.patience_sclk", "SCLK", 64, 0, 100000, 'E', "hardware.md 2.5",
       "the longest that others go before a core or a DMA controller on the external port by "
       "precedence; then it is next (0: the order of asking)"}};
  IntegerParameter async_core_read_overhead_sclk{
      this,
      {"memory.async.core_read_overhead_sclk", "SCLK", 5, 0, 64, 'E', "hardware.md 2.4",
       "added to a core's read of asynchronous memory: the same clock crossing as SDRAM's"}};
};

}  // namespace finback::memory
