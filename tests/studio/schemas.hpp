// JSON documents against the schemas that are installed with waymark.
#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace waymark::studio {

// What is wrong with a document, "" when nothing is. name: of the schema, "plan" or "cli/plan".
std::string fault(const std::string& name, const nlohmann::json& document);

}  // namespace waymark::studio
