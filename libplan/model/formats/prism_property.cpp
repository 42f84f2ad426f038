#include <algorithm>

#include "libplan/model/formats/prism_properties.hpp"

namespace waymark::plan {

bool PrismProperty::is_truth() const {
  if (!comparison.empty() || ask == PrismProperty::Ask::States) return true;
  if (ask == PrismProperty::Ask::Multi)
    return std::none_of(nested.begin(), nested.end(), [](const PrismProperty& p) { return p.comparison.empty(); });
  if (ask != PrismProperty::Ask::Filter) return false;
  return summary == "forall" || summary == "exists" ||
         ((summary == "state" || summary == "first") && nested[0].is_truth());
}

}  // namespace waymark::plan
