#include "libparser/model_file.hpp"

#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <variant>

#include "libparser/model/weights_bytes.hpp"
#include "libparser/model/whole_file.hpp"

namespace waymark::parser {
namespace {

template <class... Models>
WordModel read_word_model(std::type_identity<OneOf<Models...>>, WeightsReader& in, const RankingModel& ranking) {
  WordModel model;
  const auto read_as = [&]<class M>(std::type_identity<M>) {
    if (in.header().kind != M::file_kind) return false;
    model = M::read(in, ranking);
    return true;
  };
  if (!(read_as(std::type_identity<Models>()) || ...)) in.fail("is a model file of an unknown kind");
  return model;
}

// A proposition of no known form is an error of the file.
std::shared_ptr<RankingModel> read_language(WeightsReader& in) {
  const ltl::Vocabulary vocabulary = in.vocabulary();
  try {
    return std::make_shared<RankingModel>(vocabulary, in.header().dialect);
  } catch (const std::invalid_argument& error) {
    in.fail(error.what());
  }
}

Grounder read_grounder(WeightsReader& in, const std::shared_ptr<const MappedFile>& file) {
  auto ranking = read_language(in);
  ranking->words = in.words();
  WordModel word_model = read_word_model(std::type_identity<WordModel>(), in, *ranking);
  ranking->reranker = in.table(1);
  ranking->start_pose_model = in.table(1);
  std::shared_ptr<const LiftedReader> commands;
  if (in.number() != 0) commands = LiftedReader::read_from(in, file);
  in.end();
  return {std::move(word_model), std::move(ranking), std::move(commands)};
}

}  // namespace

std::string serialize(const Grounder& grounder, double threshold) {
  const RankingModel& ranking = *grounder.ranking;
  return std::visit(
      [&](const auto& word_model) {
        WeightsWriter out({word_model->file_kind, ranking.language.dialect()});
        out.strings(ranking.language.vocabulary().names());
        out.strings(ranking.words.words());
        word_model->write(out, threshold);
        out.table(ranking.reranker, least_of_rerankers * threshold);
        out.table(ranking.start_pose_model, least_of_rerankers * threshold);
        out.number(grounder.commands ? 1 : 0);
        if (grounder.commands) grounder.commands->write(out);
        return out.finish();
      },
      grounder.word_model);
}

std::string serialize_within(const Grounder& grounder, std::size_t bytes) {
  double threshold = least_weight;
  std::string out = serialize(grounder, threshold);
  while (out.size() > bytes && threshold < 65'504) out = serialize(grounder, threshold *= 1.25);
  return out;
}

Grounder parse_grounder(std::string_view bytes, std::string_view source) {
  const auto file = std::make_shared<const MappedFile>(bytes);
  WeightsReader in(file, source);
  return read_grounder(in, file);
}

Grounder load_grounder(const std::filesystem::path& file) {
  const std::string source = file.string();
  const auto mapped = std::make_shared<const MappedFile>(file);
  WeightsReader in(mapped, source);
  return read_grounder(in, mapped);
}

void save(const Grounder& grounder, const std::filesystem::path& file) {
  write_file(file, serialize_within(grounder, most_bytes));
}

}  // namespace waymark::parser
