#include "libparser/model/linear_model.hpp"

#include "libparser/model/ranking_model.hpp"
#include "libparser/model/weights_bytes.hpp"

namespace waymark::parser {

std::shared_ptr<const LinearModel> LinearModel::read(WeightsReader& in, const RankingModel& ranking) {
  auto model = std::make_shared<LinearModel>(ranking.language);
  model->words = ranking.words;
  model->weights = in.table(model->weights.columns());
  return model;
}

void LinearModel::write(WeightsWriter& out, double threshold) const { out.table(weights, threshold); }

}  // namespace waymark::parser
