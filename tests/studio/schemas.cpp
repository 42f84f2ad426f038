#include "tests/studio/schemas.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

namespace waymark::studio {
namespace {

using nlohmann::json;
using Adapter = valijson::adapters::NlohmannJsonAdapter;

json read(const std::string& path) {
  std::ifstream in(path);
  EXPECT_TRUE(in) << path;
  return json::parse(in);
}

const valijson::Schema& schema_of(const std::string& name) {
  static std::map<std::string, valijson::Schema> known;
  const auto [at, fresh] = known.try_emplace(name);
  if (fresh) {
    const json text = read(WAYMARK_DATA_FOLDER "/schemas/" + name + ".schema.json");
    valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(Adapter(text), at->second);
  }
  return at->second;
}

}  // namespace

std::string fault(const std::string& name, const json& document) {
  valijson::ValidationResults results;
  if (valijson::Validator().validate(schema_of(name), Adapter(document), &results)) return "";
  std::string all;
  for (valijson::ValidationResults::Error error; results.popError(error);) {
    for (const std::string& part : error.context) all += part;
    all += ": " + error.description + '\n';
  }
  return all.empty() ? "invalid" : all;
}

}  // namespace waymark::studio
