#include <algorithm>
#include <tuple>

#include <budget/changes.hpp>
#include <budget/line_changes.hpp>

namespace finback::budget {

namespace {

std::int64_t change(std::uint64_t before, std::uint64_t after) {
  return static_cast<std::int64_t>(after) - static_cast<std::int64_t>(before);
}

Cycles idle_of(const report::Function& function) {
  Cycles idle = 0;
  for (const auto& [cause, cycles] : function.causes) {
    idle += cause == kIdle ? cycles : 0;
  }
  return idle;
}

FunctionChange compare_function(const report::Function& before, const report::Function& after) {
  FunctionChange row;
  row.core = after.core;
  row.name = after.name;
  row.before = before.exclusive - idle_of(before);
  row.after = after.exclusive - idle_of(after);
  row.idle = change(idle_of(before), idle_of(after));
  row.causes = compare_causes(before.causes, after.causes);
  row.calls_before = before.calls;
  row.calls_after = after.calls;
  row.code_before = before.code_bytes;
  row.code_after = after.code_bytes;
  return row;
}

ObjectChange compare_object(const report::Object& before, const report::Object& after) {
  ObjectChange row;
  row.region_before = before.region;
  row.region_after = after.region;
  row.level_before = before.level;
  row.level_after = after.level;
  row.size_before = before.size;
  row.size_after = after.size;
  for (const report::ObjectAccess& access : before.accesses) {
    row.bytes_before += access.read_bytes + access.written_bytes;
    row.stalls[access.initiator] -= static_cast<std::int64_t>(access.stall_cycles);
  }
  for (const report::ObjectAccess& access : after.accesses) {
    row.bytes_after += access.read_bytes + access.written_bytes;
    row.stalls[access.initiator] += static_cast<std::int64_t>(access.stall_cycles);
  }
  std::erase_if(row.stalls, [](const auto& entry) { return entry.second == 0; });
  return row;
}

template <class Row>
using Named = std::map<std::pair<std::string, std::string>, const Row*>;

Named<report::Function> by_name(const std::vector<report::Function>& rows) {
  Named<report::Function> named;
  for (const report::Function& row : rows) {
    named.emplace(std::pair(row.core, row.name), &row);
  }
  return named;
}

// What nothing was placed on is no object that could move.
Named<report::Object> by_name(const std::vector<report::Object>& rows) {
  Named<report::Object> named;
  for (const report::Object& row : rows) {
    if (row.name != "(free)") {
      named.emplace(std::pair(row.owner, row.name), &row);
    }
  }
  return named;
}

std::vector<const report::Line*> lines_of(const report::RunResult& result,
                                          const report::Function& function) {
  std::vector<const report::Line*> lines;
  for (const report::Line& line : result.lines) {
    if (line.core == function.core && line.function == function.name) {
      lines.push_back(&line);
    }
  }
  return lines;
}

void compare_functions(const report::RunResult& before, const report::RunResult& after,
                       Changes& changes) {
  const Named<report::Function> old_rows = by_name(before.functions);
  const Named<report::Function> new_rows = by_name(after.functions);
  for (const report::Function& function : after.functions) {
    const auto found = old_rows.find({function.core, function.name});
    const report::Function absent;
    FunctionChange row =
        compare_function(found == old_rows.end() ? absent : *found->second, function);
    row.is_new = found == old_rows.end();
    row.lines = compare_lines(lines_of(before, function), lines_of(after, function));
    changes.functions.push_back(std::move(row));
  }
  for (const report::Function& function : before.functions) {
    if (!new_rows.contains({function.core, function.name})) {
      report::Function absent;
      absent.core = function.core;
      absent.name = function.name;
      FunctionChange row = compare_function(function, absent);
      row.is_gone = true;
      changes.functions.push_back(std::move(row));
    }
  }
}

void compare_objects(const report::RunResult& before, const report::RunResult& after,
                     Changes& changes) {
  const Named<report::Object> old_rows = by_name(before.objects);
  const Named<report::Object> new_rows = by_name(after.objects);
  const report::Object absent;
  const auto add = [&](const auto& key, const report::Object& from, const report::Object& to) {
    ObjectChange row = compare_object(from, to);
    std::tie(row.owner, row.name) = key;
    changes.objects.push_back(std::move(row));
  };
  for (const auto& [key, object] : new_rows) {
    const auto found = old_rows.find(key);
    add(key, found == old_rows.end() ? absent : *found->second, *object);
  }
  for (const auto& [key, object] : old_rows) {
    if (!new_rows.contains(key)) {
      add(key, *object, absent);
    }
  }
}

}  // namespace

Changes compare(const report::RunResult& before, const report::RunResult& after) {
  Changes changes;
  compare_functions(before, after, changes);
  compare_objects(before, after, changes);
  return changes;
}

}  // namespace finback::budget
