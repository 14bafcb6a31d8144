// The caches as the core meets them: which accesses and fetches go through them, and the
// instructions that move their lines.
#include <fmt/format.h>

#include <isa_sim/core/core.hpp>

namespace finback::core {

using isa::Operation;
using isa::SystemAction;

memory::CachePolicy Core::cache_policy(memory::Level level, Address address) {
  return protection_.guards_data() ? protection_.cache_policy(address)
                                   : memory_.default_policy(level);
}

bool Core::give_way(const Operation& operation, memory::Span* span, Address address, Cause cause) {
  const bool line = cause == Cause::data_cache || cause == Cause::code_cache;
  for (;;) {
    const Cycles from = memory_.core_turn(number_, span, line, now(operation));
    if (from == now(operation)) {
      return false;
    }
    add_stall(operation, cause, from - now(operation), address);
    if (from >= turn_.shared_until) {  // else nobody else acts until then
      state_.retry = &operation;
      return true;
    }
  }
}

std::uint8_t* Core::cached_access(const Operation& operation, memory::Span* span, Address address,
                                  int bytes, bool write, bool continued,
                                  memory::CachePolicy policy) {
  const bool far = span->level == memory::Level::l3;
  if (!continued && !memory_.stays_in_cache(number_, address, write, policy) &&
      (wait_for_turn(operation) ||
       (far && !write && give_way(operation, nullptr, address, Cause::data_cache)))) {
    return nullptr;
  }
  tell_access(operation, address, bytes, write);
  const memory::CachedAccess access = memory_.cached_access(number_, span, address, bytes, write,
                                                            policy, operation.site, now(operation));
  if (access.through) {
    add_far_bytes(operation, static_cast<std::size_t>(span->level), bytes);
  }
  charge(operation, access,
         !access.through ? Cause::data_cache
         : far           ? Cause::l3_write
                         : Cause::l2_write,
         address);
  state_.store_also = access.also;
  return access.bytes;
}

void Core::charge(const Operation& operation, const memory::CachedAccess& access, Cause cause,
                  Address address) {
  if (access.stall > 0) {
    add_stall(operation, cause, access.stall, address);
  }
  for (std::size_t level = 0; level < access.moved.size(); ++level) {
    if (access.moved[level] != 0) {
      line_bytes_[operation.site][level] += access.moved[level];
    }
  }
}

void Core::move_line(const Operation& operation, SystemAction action, Address address) {
  if (!memory_.data_cache_on(number_)) {
    return;
  }
  memory::Span* span = memory_.find_span(number_, address);
  if (span == nullptr || span->level == memory::Level::l1 || wait_for_turn(operation)) {
    return;
  }
  if (action != SystemAction::prefetch_line) {
    charge(operation,
           memory_.flush_line(number_, address, action == SystemAction::flush_invalidate_line,
                              operation.site, now(operation)),
           Cause::data_cache, address);
  } else if (cache_policy(span->level, address) != memory::CachePolicy::uncached) {
    charge(operation, memory_.prefetch_line(number_, span, address, operation.site, now(operation)),
           Cause::data_cache, address);
  }
}

void Core::configure_code_cache() {
  const bool on = protection_.code_cache();
  const memory::Region* half = memory_.map().find(number_, "l1.code.cache");
  if (on && (half == nullptr || half->cache_bytes != memory::CodeCache::kBytes)) {
    throw GuestFault(
        fmt::format("IMEM_CONTROL: {} has no {} bytes of instruction memory that can "
                    "be cache on this machine",
                    name_of(id_), memory::CodeCache::kBytes));
  }
  for (const ir::PlacedFunction& function : image_.functions) {
    if (on && half->contains(function.address)) {
      throw GuestFault(
          fmt::format("{} of {} shall be instruction cache, but {} lies there at "
                      "{:#010x}: place it elsewhere",
                      half->name, name_of(id_), function.name, function.address));
    }
  }
  memory_.configure_code_cache(number_, on, protection_.locked_ways());
}

bool Core::fetch_code(const Operation& operation) {
  const auto bytes = static_cast<Address>(std::int64_t{parameters_.fetch_bytes});
  const auto first = static_cast<Address>(operation[0]);
  const Address end = first + static_cast<Address>(operation[1]) * bytes;
  const auto level = static_cast<memory::Level>(operation[2]);
  Protection::CodePage page{.cached = memory_.default_code_cache()};
  if (protection_.guards_fetch()) {
    page = protection_.code_page(first);
  }
  const bool far = level == memory::Level::l3;
  if (!page.cached || !memory_.code_cache_on(number_)) {
    if (wait_for_turn(operation) || (far && give_way(operation, nullptr, first, Cause::fetch))) {
      return false;
    }
    for (Address at = first; at != end; at += bytes) {
      add_stall(operation, Cause::fetch,
                memory_.fetch_code(number_, level, at, bytes, now(operation)), at);
    }
    return true;
  }
  const Address step = std::min(bytes, memory::kLineBytes);
  for (Address at = first; at != end; at += step) {
    if (!memory_.code_cache_holds(number_, at) &&
        (wait_for_turn(operation) ||
         (far && give_way(operation, nullptr, at, Cause::code_cache)))) {
      return false;
    }
  }
  for (Address at = first; at != end; at += step) {
    add_stall(operation, Cause::code_cache,
              memory_.cached_fetch(number_, level, at, step, page.important, now(operation)), at);
  }
  return true;
}

}  // namespace finback::core
