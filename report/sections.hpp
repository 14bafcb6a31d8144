// Sections that several text writers print.
#pragma once

#include <string>

#include <report/page.hpp>

namespace finback::report {

inline constexpr std::size_t kAll = ~std::size_t{0};

// Order of the functions' table.
enum class FunctionOrder : std::uint8_t { exclusive, inclusive, stalls };

// Cycles of each core by cause.
void write_cores(Page& page, const RunResult& result);
// Bytes a frame by level and initiator.
void write_traffic(Page& page, const RunResult& result);
// The `most` functions that cost most, time asleep not counted where cycles of their own decide;
// `core`: of one core only, "": of both.
void write_functions(Page& page, const RunResult& result, std::size_t most,
                     FunctionOrder order = FunctionOrder::exclusive, const std::string& core = "",
                     const Style& style = {});
// The `most` objects that cause the most stalls, and of these without, that move the most bytes.
void write_objects(Page& page, const RunResult& result, std::size_t most);
// The operating points of a program that changed its clocks, and when it did; else nothing.
void write_clocks(Page& page, const RunResult& r);

}  // namespace finback::report
