#include "libplan/solve/landmark_tour.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <queue>
#include <stdexcept>

#include "libplan/solve/product_search.hpp"

namespace waymark::plan {
namespace {

constexpr double unreached = INFINITY;

// A place is visited with what its letters carry: the landmarks are collected on arrival.
template <class Model>
class Tours {
 public:
  Tours(const Model& model, const std::vector<std::string>& landmarks, const std::stop_token& stop)
      : model_(model), names_(landmarks), stop_(stop), mask_(model.letters().size(), 0) {
    if (!model.is_deterministic()) throw std::invalid_argument("a tour needs a deterministic model");
    if (landmarks.size() > most_landmarks) throw std::invalid_argument("too many landmarks for a tour");
    for (std::size_t i = 0; i < landmarks.size(); ++i)
      if (const auto p = model.letters().vocabulary().find(landmarks[i]))
        for (std::uint32_t l = 0; l < mask_.size(); ++l)
          if (model.letters()[LetterId{l}].contains(*p)) mask_[l] |= 1U << i;
  }

  std::optional<std::variant<LandmarkTour, NoLandmarkTour>> run(bool closed) {
    find_stops();
    const std::uint32_t all = (1U << names_.size()) - 1;
    std::uint32_t seen = mask_[model_.initial_letter().index];
    for (const Stop& stop : stops_) seen |= stop.mask;
    if (seen != all) return NoLandmarkTour{missing(all & ~seen)};
    if (!find_distances()) return std::nullopt;
    std::optional<LandmarkTour> best;
    if (!closed) {
      best = cheapest(0, mask_[model_.initial_letter().index], false);
    } else {
      const std::uint32_t anchor = rarest();
      for (std::size_t i = 1; i < stops_.size(); ++i) {
        if ((stops_[i].mask & anchor) == 0) continue;
        if (stop_.stop_requested()) return std::nullopt;
        const auto tour = cheapest(i, stops_[i].mask, true);
        if (tour && (!best || tour->cost < best->cost)) best = tour;
      }
    }
    if (!best) return NoLandmarkTour{"no walk passes all of them: there is no way on from one, or none back"};
    return *best;
  }

 private:
  struct Stop {
    std::uint32_t place, mask;
  };

  std::string missing(std::uint32_t mask) const {
    std::string out = "never seen from the start:";
    for (std::size_t i = 0; i < names_.size(); ++i)
      if (((mask >> i) & 1U) != 0) out += ' ' + names_[i];
    return out;
  }

  // The landmark with the fewest places: every closed tour passes one of them.
  std::uint32_t rarest() const {
    std::uint32_t best = 1;
    std::size_t fewest = stops_.size();
    for (std::size_t i = 0; i < names_.size(); ++i) {
      const auto places = static_cast<std::size_t>(std::count_if(
          stops_.begin() + 1, stops_.end(), [&](const Stop& stop) { return ((stop.mask >> i) & 1U) != 0; }));
      if (places < fewest) {
        fewest = places;
        best = 1U << i;
      }
    }
    return best;
  }

  // The start, then the places that a letter with a landmark leads into, as far as they can be reached.
  void find_stops() {
    stops_.push_back({model_.initial(), 0});
    std::vector<bool> reached(model_.states(), false), met(model_.states(), false);  // met: arrived at
    std::vector<std::uint32_t> open{model_.initial()}, found;
    std::vector<std::uint32_t> mask(model_.states(), 0);
    reached[model_.initial()] = true;
    while (!open.empty()) {
      const std::uint32_t s = open.back();
      open.pop_back();
      for (std::uint32_t k = 0; k < model_.choices(s); ++k)
        model_.for_each_outcome(s, k, [&](std::uint32_t t, LetterId letter, double) {
          if (met[t] && mask[t] != mask_[letter.index])
            throw std::invalid_argument("a landmark that is seen or not by the way in which one arrives");
          if (!met[t] && mask_[letter.index] != 0) found.push_back(t);
          met[t] = true;
          mask[t] = mask_[letter.index];
          if (reached[t]) return;
          reached[t] = true;
          open.push_back(t);
        });
    }
    std::sort(found.begin(), found.end());
    for (std::uint32_t place : found) stops_.push_back({place, mask[place]});
  }

  bool find_distances() {
    constexpr std::uint32_t none = UINT32_MAX;
    std::vector<std::uint32_t> stop_of(model_.states(), none);
    for (std::uint32_t i = 1; i < stops_.size(); ++i) stop_of[stops_[i].place] = i;
    distance_.assign(stops_.size(), std::vector<double>(stops_.size(), unreached));
    const std::optional<double> uniform = uniform_cost(model_);
    for (std::size_t i = 0; i < stops_.size(); ++i) {
      if (stop_.stop_requested()) return false;
      const auto arrive = [&](std::uint32_t t, double cost) {
        if (stop_of[t] != none) distance_[i][stop_of[t]] = std::min(distance_[i][stop_of[t]], cost);
      };
      if (uniform)
        breadth_first(stops_[i].place, *uniform, arrive);
      else
        dijkstra(stops_[i].place, arrive);
    }
    return true;
  }

  // Both call arrive(place, cost) for every step, also one back to where they began; least costs come first.
  template <class Arrive>
  void breadth_first(std::uint32_t from, double step, const Arrive& arrive) const {
    std::vector<bool> met(model_.states(), false);
    std::vector<std::uint32_t> layer{from}, next;
    met[from] = true;
    for (double cost = step; !layer.empty(); cost += step) {
      next.clear();
      for (std::uint32_t s : layer)
        for (std::uint32_t k = 0; k < model_.choices(s); ++k)
          model_.for_each_outcome(s, k, [&](std::uint32_t t, LetterId, double) {
            arrive(t, cost);
            if (met[t]) return;
            met[t] = true;
            next.push_back(t);
          });
      layer.swap(next);
    }
  }

  template <class Arrive>
  void dijkstra(std::uint32_t from, const Arrive& arrive) const {
    using Entry = std::pair<double, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap;
    std::vector<double> cost(model_.states(), unreached);
    cost[from] = 0;
    heap.push({0, from});
    while (!heap.empty()) {
      const double c = heap.top().first;
      const std::uint32_t s = heap.top().second;
      heap.pop();
      if (c > cost[s]) continue;
      for (std::uint32_t k = 0; k < model_.choices(s); ++k)
        model_.for_each_outcome(s, k, [&](std::uint32_t t, LetterId, double) {
          const double there = c + model_.cost(s, k);
          arrive(t, there);
          if (there >= cost[t]) return;
          cost[t] = there;
          heap.push({there, t});
        });
    }
  }

  // From one stop, where `visited` are visited already, over all landmarks, and back when closed. [HK62]
  std::optional<LandmarkTour> cheapest(std::size_t from, std::uint32_t visited, bool closed) const {
    const std::size_t n = stops_.size(), masks = std::size_t{1} << names_.size();
    if (n == 0) return std::nullopt;  // never: the start is a stop
    const auto all = static_cast<std::uint32_t>(masks - 1);
    std::vector<double> cost(masks * n, unreached);
    std::vector<std::uint64_t> before(masks * n, 0);
    cost[visited * n + from] = 0;
    for (std::size_t at = std::size_t{visited} * n; at < cost.size(); ++at) {  // a step never visits less
      if (cost[at] == unreached) continue;
      const std::size_t mask = at / n, i = at % n;
      for (std::size_t j = 1; j < n; ++j) {
        const std::size_t next = (mask | stops_[j].mask) * n + j;
        if (next / n == mask || !(cost[at] + distance_[i][j] < cost[next])) continue;
        cost[next] = cost[at] + distance_[i][j];
        before[next] = at;
      }
    }
    std::size_t last = cost.size();
    double best = unreached;
    for (std::size_t i = 0; i < n; ++i) {
      const double whole = cost[all * n + i] + (closed ? distance_[i][from] : 0);
      if (whole < best) {
        best = whole;
        last = all * n + i;
      }
    }
    if (best == unreached) return std::nullopt;
    LandmarkTour tour{best, {}};
    if (closed) tour.stops.push_back(stops_[from].place);
    const std::size_t first = std::size_t{visited} * n + from;
    for (std::size_t at = last; at != first; at = before[at]) tour.stops.push_back(stops_[at % n].place);
    tour.stops.push_back(stops_[from].place);
    std::reverse(tour.stops.begin(), tour.stops.end());
    return tour;
  }

  const Model& model_;
  const std::vector<std::string>& names_;
  const std::stop_token& stop_;
  std::vector<std::uint32_t> mask_;  // by letter: the landmarks it carries
  std::vector<Stop> stops_;
  std::vector<std::vector<double>> distance_;
};

// At least one step, so that a stop can be the one before it.
template <class Model>
void append_leg(const Model& model, std::uint32_t from, std::uint32_t to, ChoiceRoute& route) {
  struct Step {
    double cost = unreached;
    std::uint32_t place = 0, choice = 0;  // from which, and how
  };
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap;
  std::vector<Step> best(model.states());
  const auto expand = [&](double cost, std::uint32_t s) {
    for (std::uint32_t k = 0; k < model.choices(s); ++k)
      model.for_each_outcome(s, k, [&](std::uint32_t t, LetterId, double) {
        const double there = cost + model.cost(s, k);
        if (there >= best[t].cost) return;
        best[t] = {there, s, k};
        heap.push({there, t});
      });
  };
  for (expand(0, from); !heap.empty() && heap.top().second != to;) {
    const auto [cost, s] = heap.top();
    heap.pop();
    if (cost <= best[s].cost) expand(cost, s);
  }
  if (heap.empty()) throw std::logic_error("a tour between whose stops there is no way");
  std::vector<Step> steps{best[to]};
  while (steps.back().place != from) steps.push_back(best[steps.back().place]);
  route.cost += best[to].cost;
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
    route.choices.push_back(step->choice);
    const bool last = std::next(step) == steps.rend();
    route.places.push_back(last ? to : std::next(step)->place);
  }
}

}  // namespace

template <class Model>
std::optional<std::variant<LandmarkTour, NoLandmarkTour>> shortest_tour(const Model& model,
                                                                        const std::vector<std::string>& landmarks,
                                                                        bool closed, const std::stop_token& stop) {
  return Tours<Model>(model, landmarks, stop).run(closed);
}

template <class Model>
ChoiceRoute walk(const Model& model, const LandmarkTour& tour) {
  ChoiceRoute out;
  out.places.push_back(tour.stops.front());
  for (std::size_t i = 0; i + 1 < tour.stops.size(); ++i) append_leg(model, tour.stops[i], tour.stops[i + 1], out);
  return out;
}

template std::optional<std::variant<LandmarkTour, NoLandmarkTour>> shortest_tour(const Mdp&,
                                                                                 const std::vector<std::string>&, bool,
                                                                                 const std::stop_token&);
template std::optional<std::variant<LandmarkTour, NoLandmarkTour>> shortest_tour(const GridWorld&,
                                                                                 const std::vector<std::string>&, bool,
                                                                                 const std::stop_token&);
template ChoiceRoute walk(const Mdp&, const LandmarkTour&);
template ChoiceRoute walk(const GridWorld&, const LandmarkTour&);

}  // namespace waymark::plan
