// Which instructions may stand in one packet (hardware.md 1.3): a 32-bit DSP operation and two
// short accesses, of which one at most goes through a P register and one at most stores. Says
// nothing of dependences.
#pragma once

#include "../target/BfinInstrInfo.hpp"

namespace llvm {

/// The DSP form of a two-byte operation, 0 where there is none.
unsigned dsp_form(unsigned opcode);
/// The slot that an instruction can fill, kAlone where it never shares a packet. Virtual registers
/// will do.
unsigned slot_of(const MachineInstr& inst, const BfinInstrInfo& tii);

class PacketSlots {
 public:
  /// Adds an instruction that fills `slot`; false, and nothing is added, where the packet has no
  /// room.
  bool add(const MachineInstr& inst, unsigned slot);

 private:
  unsigned members_ = 0;
  bool alone_ = false;
  bool dsp_ = false;
  bool shift_ = false;
  bool store_ = false;
  bool pointer_store_ = false;
  unsigned accesses_ = 0;
  unsigned pointer_accesses_ = 0;
};

}  // namespace llvm
