#include "schema_check.hpp"

#include <algorithm>
#include <regex.h>
#include <set>
#include <stdexcept>

namespace finback::report {

namespace {

using Json = nlohmann::json;

const std::set<std::string> kKnownKeywords = {
    "$schema", "$defs",    "$ref",  "title",      "description",
    "type",    "const",    "enum",  "minimum",    "maximum",
    "pattern", "required", "items", "properties", "additionalProperties"};

bool has_type(const Json& value, const std::string& type) {
  return (type == "object" && value.is_object()) || (type == "array" && value.is_array()) ||
         (type == "string" && value.is_string()) || (type == "boolean" && value.is_boolean()) ||
         (type == "null" && value.is_null()) || (type == "number" && value.is_number()) ||
         (type == "integer" && value.is_number_integer());
}

// POSIX, since std::regex raises false alarms in g++ 12 under the sanitizers.
bool matches(const std::string& text, const std::string& pattern) {
  regex_t compiled;
  if (::regcomp(&compiled, pattern.c_str(), REG_EXTENDED | REG_NOSUB) != 0) {
    throw std::invalid_argument("schema pattern: " + pattern);
  }
  const bool found = ::regexec(&compiled, text.c_str(), 0, nullptr, 0) == 0;
  ::regfree(&compiled);
  return found;
}

class Checker {
 public:
  explicit Checker(const Json& root) : root_(root) {}

  void check(const Json& schema, const Json& value, const std::string& place) {
    if (schema.is_boolean()) {
      expect(schema.get<bool>(), place, "is not allowed here");
      return;
    }
    if (schema.contains("$ref")) {
      const std::string target = schema["$ref"].get<std::string>().substr(1);
      check(root_.at(Json::json_pointer(target)), value, place);
      return;
    }
    for (const auto& [keyword, unused] : schema.items()) {
      expect(kKnownKeywords.count(keyword) > 0, place, "keyword not checked: " + keyword);
    }
    check_scalar(schema, value, place);
    if (value.is_object()) {
      check_object(schema, value, place);
    }
    if (value.is_array() && schema.contains("items")) {
      for (std::size_t i = 0; i < value.size(); ++i) {
        check(schema["items"], value[i], place + "/" + std::to_string(i));
      }
    }
  }

  std::vector<std::string> take() { return std::move(complaints_); }

 private:
  void expect(bool holds, const std::string& place, const std::string& complaint) {
    if (!holds) {
      complaints_.push_back((place.empty() ? "/" : place) + ": " + complaint);
    }
  }

  void check_scalar(const Json& schema, const Json& value, const std::string& place) {
    if (schema.contains("type")) {
      const Json types = schema["type"].is_array() ? schema["type"] : Json::array({schema["type"]});
      const bool fits = std::any_of(types.begin(), types.end(), [&](const Json& type) {
        return has_type(value, type.get<std::string>());
      });
      expect(fits, place, "is not of type " + schema["type"].dump());
    }
    if (schema.contains("const")) {
      expect(value == schema["const"], place, "is not " + schema["const"].dump());
    }
    if (schema.contains("enum")) {
      const Json& allowed = schema["enum"];
      expect(std::find(allowed.begin(), allowed.end(), value) != allowed.end(), place,
             "is none of " + allowed.dump());
    }
    if (value.is_number()) {
      expect(!schema.contains("minimum") || value >= schema["minimum"], place, "is too small");
      expect(!schema.contains("maximum") || value <= schema["maximum"], place, "is too large");
    }
    if (value.is_string() && schema.contains("pattern")) {
      expect(matches(value.get<std::string>(), schema["pattern"].get<std::string>()), place,
             "breaks its pattern");
    }
  }

  void check_object(const Json& schema, const Json& value, const std::string& place) {
    for (const Json& key : schema.value("required", Json::array())) {
      expect(value.contains(key.get<std::string>()), place, "lacks " + key.get<std::string>());
    }
    const Json properties = schema.value("properties", Json::object());
    for (const auto& [key, member] : value.items()) {
      std::string inner = place;
      inner.append("/").append(key);
      if (properties.contains(key)) {
        check(properties[key], member, inner);
      } else if (schema.contains("additionalProperties")) {
        check(schema["additionalProperties"], member, inner);
      }
    }
  }

  const Json& root_;
  std::vector<std::string> complaints_;
};

}  // namespace

std::vector<std::string> schema_complaints(const Json& schema, const Json& document) {
  Checker checker(schema);
  checker.check(schema, document, "");
  return checker.take();
}

}  // namespace finback::report
