// Checks a JSON document against a JSON schema, as far as report/result.schema.json goes.
//
// Models type, const, enum, minimum, maximum, pattern, required, properties, additionalProperties,
// items and $ref into the same document. Any other keyword that would restrict a document is a
// complaint of its own, so that the schema cannot outgrow the check unseen.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace finback::report {

// One line for each place where `document` breaks `schema`, e.g. "/cores/core_a/cycles: ...".
[[nodiscard]] std::vector<std::string> schema_complaints(const nlohmann::json& schema,
                                                         const nlohmann::json& document);

}  // namespace finback::report
