// What ends a block before its end. Thrown out of an operation: it costs nothing where it does not
// happen.
#pragma once

#include <string>

#include <common/error.hpp>
#include <isa_sim/core/core.hpp>

namespace finback::core {

struct Core::Trap {
  enum class Kind : std::uint8_t {
    exception,  // `operation` cannot be completed; its packet is undone
    fetch,      // the block is done, but at `address` is no instruction
    boundary,   // the packet of `operation` shall begin a block
    halted,     // `operation` ended the program; without one, a reset did
  };
  Kind kind = Kind::exception;
  const isa::Operation* operation = nullptr;
  int cause = 0;  // of an exception: EXCAUSE
  Address address = 0;
};

// The program did what the machine cannot; `operation` was not completed.
struct FaultAt : GuestFault {
  FaultAt(const std::string& what, const isa::Operation& at) : GuestFault(what), operation(&at) {}
  const isa::Operation* operation;
};

}  // namespace finback::core
