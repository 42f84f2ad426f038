#include "libparser/corpus/corpus_output.hpp"

#include <cassert>
#include <nlohmann/json.hpp>

namespace waymark::parser {

namespace {

nlohmann::ordered_json list_of(const std::vector<plan::Pose>& path) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const plan::Pose& pose : path) out.push_back({pose.x, pose.y, pose.heading});
  return out;
}

void add_paths(nlohmann::ordered_json& sentence, const char* key, const std::vector<std::vector<plan::Pose>>& paths) {
  for (const std::vector<plan::Pose>& path : paths) sentence[key].push_back(list_of(path));
}

}  // namespace

std::string json_lines(const Corpus& corpus) {
  std::string lines;
  for (const Paragraph& paragraph : corpus.paragraphs) {
    nlohmann::ordered_json sentences = nlohmann::ordered_json::array();
    for (const Sentence& sentence : paragraph.sentences) {
      assert(!sentence.heading_unknown);
      nlohmann::ordered_json one{{"id", sentence.id}, {"text", sentence.text}, {"path", list_of(sentence.absolute)}};
      add_paths(one, "also_good", sentence.also_good);
      add_paths(one, "refused", sentence.refused);
      if (!sentence.formula.empty()) one["formula"] = sentence.formula;
      sentences.push_back(std::move(one));
    }
    const nlohmann::ordered_json line{
        {"id", paragraph.id}, {"map", paragraph.map}, {"text", paragraph.text}, {"sentences", std::move(sentences)}};
    lines += line.dump() + '\n';
  }
  return lines;
}

std::string pairs_text(const Corpus& corpus) {
  std::string lines;
  for (const Paragraph& paragraph : corpus.paragraphs)
    for (const Sentence& sentence : paragraph.sentences)
      if (!sentence.formula.empty()) lines += sentence.text + '\t' + sentence.formula + '\n';
  return lines;
}

}  // namespace waymark::parser
