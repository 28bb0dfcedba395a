// The part of JSON Schema (draft 2020-12) that docs/schema/ uses: type, const, enum, required,
// properties, additionalProperties, items, anyOf, pattern, minimum, $ref to #/$defs/.
//
// Beware   A keyword that it does not know is an error of the schema, so that none is ignored.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace plumb {

/// What in `value` is not as `schema` says, one message each: "/tables/0/key: must be string".
/// Throws std::logic_error on a schema that it cannot read.
std::vector<std::string> SchemaErrors(const nlohmann::json& schema,
                                      const nlohmann::json& value);

/// The schema of that file within docs/schema/.
nlohmann::json PublishedSchema(const std::string& file);

}  // namespace plumb
