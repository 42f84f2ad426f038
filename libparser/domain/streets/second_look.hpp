// All texts of a city read at once, and then once more: a route that other texts describe too is likelier to be the one meant.
//
// Routes are many and pictures few, and each picture was shown to several people; which texts are about the same picture is
// not told here (with that, read_together.hpp). After a first reading every route has support from the other texts: the sum of
// their probabilities for it, and the number of texts that hold it likelier than all others together. A second
// log-linear choice weighs, for each candidate r of text t,
//
//   log p_t(r);  log of its rank's probability;  support, in steps and as log(1 + support / expected);  number of texts, in steps
//
// with weights learned in other cities, where the first reading was done by readers that had not seen the city either. The
// setting is another one than reading text by text: the texts of the city are all there, unread.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "libparser/domain/streets/street_model.hpp"

namespace waymark::streets {

using TextReadings = std::vector<StreetReading>;  // all candidates of one text, best first

struct TransductiveReranking {
  std::vector<double> weights;  // by feature; empty: readings stay as they are
};

struct ReadCity {
  std::vector<TextReadings> texts;
  std::vector<StreetRoute> right;  // of each text
};

// The weights that make the right routes likeliest after the second look, each city counting alike; texts without their right
// route among the candidates teach nothing. Gradient ascent with AdaGrad's steps [DHS11] over all texts, deterministic.
TransductiveReranking learn_second_look(std::span<const ReadCity> cities);

// The readings of each text anew, best first, probabilities that sum to 1. O(candidates · log candidates) in all texts.
std::vector<TextReadings> look_again(const TransductiveReranking& look, std::span<const TextReadings> texts);

}  // namespace waymark::streets
