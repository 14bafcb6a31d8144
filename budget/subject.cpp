#include <string_view>

#include <budget/subject.hpp>

namespace finback::budget {

namespace {

// "OWNER.NAME.QUANTITY", where the name may hold dots.
struct Parts {
  std::string owner;
  std::string name;
  std::string quantity;
};

Parts parts_of(const std::string& text) {
  const std::size_t first = text.find('.');
  const std::size_t last = text.rfind('.');
  if (first == std::string::npos) {
    return {text, "", ""};
  }
  return {text.substr(0, first), first < last ? text.substr(first + 1, last - first - 1) : "",
          text.substr(last + 1)};
}

Subject function_subject(const Parts& parts) {
  if (parts.quantity == "code_bytes") {
    return {SubjectKind::code, parts.owner, parts.name};
  }
  const bool inclusive = parts.quantity.starts_with("inclusive_cycles");
  return {inclusive ? SubjectKind::callees : SubjectKind::function, parts.owner, parts.name};
}

// Of "core_b.stall.l3_read.cycles" and its like, without the core.
Subject core_subject(const std::string& core, const std::string& rest) {
  constexpr std::string_view kStall = "stall.";
  if (rest.starts_with(kStall)) {
    return {SubjectKind::cause, core, rest.substr(kStall.size(), rest.rfind('.') - kStall.size())};
  }
  if (rest.starts_with("issue.") || rest == "packets" || rest == "instructions") {
    return {SubjectKind::cause, core, "issue"};
  }
  if (rest.starts_with("code.")) {
    return {SubjectKind::code, core, ""};
  }
  if (rest.starts_with("stack.")) {
    return {SubjectKind::stack, core, ""};
  }
  return {SubjectKind::core, core, ""};
}

// Of "l3.core_b.read.stall.cycles" and its like.
Subject traffic_subject(const Parts& parts) {
  constexpr std::string_view kStall = ".stall";
  if (parts.name.starts_with("core_") && parts.name.ends_with(kStall)) {
    const std::size_t dot = parts.name.find('.');
    const std::string direction =
        parts.name.substr(dot + 1, parts.name.size() - kStall.size() - dot - 1);
    return {SubjectKind::cause, parts.name.substr(0, dot), parts.owner + "_" + direction};
  }
  return {SubjectKind::level, "", parts.owner};
}

}  // namespace

Subject subject_of(const std::string& metric) {
  const std::size_t dot = metric.find('.');
  const std::string family = metric.substr(0, dot);
  const std::string rest = dot == std::string::npos ? "" : metric.substr(dot + 1);
  const Parts parts = parts_of(rest);
  if (family == "function") {
    return function_subject(parts);
  }
  if (family == "stage") {
    return {SubjectKind::stage, parts.owner, parts.name};
  }
  if (family == "object") {
    return {SubjectKind::object, parts.owner, parts.name};
  }
  if (family == "memory" && parts.owner != "sdram") {
    return {SubjectKind::region, parts.owner, parts.name};
  }
  if (family == "memory" || family == "bus_utilisation") {
    return {SubjectKind::level, "", "l3"};
  }
  if (family == "traffic") {
    return traffic_subject(parts);
  }
  if (family == "level") {
    return {SubjectKind::level, "", parts.owner};
  }
  if (family.starts_with("core_") && !rest.empty()) {
    return core_subject(family, rest);
  }
  if (family.starts_with("power") || family.starts_with("energy")) {
    return {SubjectKind::power, "", ""};
  }
  if (family == "accuracy") {
    return {SubjectKind::accuracy, "", ""};
  }
  return {SubjectKind::camera, "", ""};
}

}  // namespace finback::budget
