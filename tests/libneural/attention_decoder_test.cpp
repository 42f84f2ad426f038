#include "libneural/attention_decoder.hpp"

#include <array>

#include "tests/libneural/reference.hpp"

namespace waymark::neural {
namespace {

using reference::Reader;
using reference::Real;

constexpr AttentionDecoder::Sizes sizes{.encoded = 4, .inputs = 3, .width = 5, .symbol = 2, .symbols = 6};
constexpr std::array<Index, 4> elements{0, 3, 4, 8}, choices{0, 2, 2, 5};  // the second sequence has no choice

constexpr std::array<Index, 5> said{2, 0, 0, 1, 2};  // columns of x

Real scores_of(const Eigen::VectorXd& theta, const Real& h, const Real& e, const Real& m, const Real& x) {
  Reader read(theta);
  const Real phi = read.take(sizes.symbol, sizes.symbols);
  return reference::attention(read, phi, sizes.width, h, e, m, x);
}

void check_against_definition(bool marked) {
  ltl::Random random(7);
  Parameters parameters;
  const auto uniform = [&] { return random.unit(); };
  const Block phi = parameters.add_for_relu(sizes.symbol, sizes.symbols, sizes.symbol, uniform);
  const AttentionDecoder decoder(parameters, sizes, phi, uniform);
  parameters.values() += 0.3F * reference::random_matrix(random, parameters.size(), 1);  // no bias stays zero
  const Matrix h = reference::random_matrix(random, 4, 8), e = reference::random_matrix(random, 4, 3),
               x = reference::random_matrix(random, 3, 3), c = reference::random_matrix(random, 6, 5),
               marks = reference::random_matrix(random, 6, 3).cwiseMax(0.0F);
  const AttentionDecoder::Sequences in{&h, elements, &e, marked ? &marks : nullptr, choices, said};
  AttentionDecoder::Signals signals;
  decoder.forward(parameters, in, x, signals);

  Eigen::VectorXd theta = parameters.values().cast<double>(), hs = h.reshaped().cast<double>(),
                  es = e.reshaped().cast<double>(), xs = x.reshaped().cast<double>();
  const auto expected = [&] {
    const Eigen::Map<const Real> hh(hs.data(), 4, 8), ee(es.data(), 4, 3), xx(xs.data(), 3, 3);
    Real scores(6, 5);
    for (std::size_t s = 0; s < 3; ++s)
      for (Index j = choices[s]; j < choices[s + 1]; ++j) {
        const auto i = static_cast<Index>(s);
        const Real m = marked ? Real(marks.col(i).cast<double>()) : Real(Real::Zero(6, 1));
        scores.col(j) = scores_of(theta, hh.middleCols(elements[s], elements[s + 1] - elements[s]), ee.col(i), m,
                                  xx.col(said[static_cast<std::size_t>(j)]));
      }
    return scores;
  };
  EXPECT_LT((signals.scores.cast<double>() - expected()).cwiseAbs().maxCoeff(), 1e-4);
  Matrix dx(3, 3);
  signals.dscores = c;
  decoder.backward(parameters, in, x, signals, dx);
  const auto loss = [&] { return reference::dot(c, expected()); };
  reference::check(theta, parameters.gradients().data(), loss, "parameters");
  reference::check(hs, signals.dh.data(), loss, "h");
  reference::check(es, signals.de.data(), loss, "e");
  reference::check(xs, dx.data(), loss, "x");
}

TEST(AttentionDecoder, IsTheDefinitionAndItsGradient) { check_against_definition(false); }
TEST(AttentionDecoder, CountsWhatIsNamedByItsGate) { check_against_definition(true); }

}  // namespace
}  // namespace waymark::neural
