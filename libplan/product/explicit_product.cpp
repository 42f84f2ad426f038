#include "libplan/product/explicit_product.hpp"

#include <string>
#include <utility>
#include <vector>

namespace waymark::plan {
namespace {

void name_place(std::vector<std::string>& out, const Mdp&) { out.emplace_back("place"); }
void name_place(std::vector<std::string>& out, const GridWorld&) { out.insert(out.end(), {"x", "y"}); }

void add_place(std::vector<std::int32_t>& out, const Mdp&, std::uint32_t place) {
  out.push_back(static_cast<std::int32_t>(place));
}
void add_place(std::vector<std::int32_t>& out, const GridWorld& grid, std::uint32_t place) {
  out.push_back(static_cast<std::int32_t>(place % grid.width()));
  out.push_back(static_cast<std::int32_t>(place / grid.width()));
}

template <class Model>
class Unfolding {
 public:
  explicit Unfolding(const ProductMdp<Model>& product)
      : product_(product), goal_(vocabulary_.add("goal")), marked_(vocabulary_.add("marked")) {}

  StateLabelled run() {
    MdpBuilder builder(vocabulary_);
    name_place(values_.variables, product_.model());
    values_.variables.emplace_back("task");
    product_.for_each_state([&](const State& s) { goals_.push_back(product_.is_goal(s)); });
    product_.for_each_state([&](const State& s) { add(builder, s); });
    const std::vector<std::uint32_t>& starts = product_.starts();
    if (needs_trap_ || starts.empty()) {
      add_apart(builder, "lost", -1);
      stay(builder, trap(), {});
    }
    std::uint32_t initial = starts.empty() ? trap() : starts[0];
    if (starts.size() > 1) {
      initial = add_apart(builder, "start", -2);
      for (std::size_t i = 0; i < starts.size(); ++i) {
        builder.add_choice("guess_" + std::to_string(i), 0);
        builder.add_outcome(starts[i], builder.letter(letter(starts[i], false)));
      }
    }
    const LetterId first = builder.letter(initial < goals_.size() ? letter(initial, false) : ltl::Letter{});
    return with_labels_on_states(std::move(builder).build(initial, first), values_);
  }

 private:
  using State = typename ProductMdp<Model>::State;

  std::uint32_t trap() const { return product_.states(); }
  ltl::Letter letter(std::uint32_t target, bool marked) const {
    ltl::Letter out;
    if (goals_[target]) out.insert(goal_);
    if (marked) out.insert(marked_);
    return out;
  }

  std::uint32_t add_apart(MdpBuilder& builder, const char* name, std::int32_t value) {
    for (std::size_t v = 0; v < values_.variables.size(); ++v) values_.values.push_back(value);
    return builder.add_state(name);
  }

  static void stay(MdpBuilder& builder, std::uint32_t state, const ltl::Letter& letter) {
    builder.add_choice("stay", 0);
    builder.add_outcome(state, builder.letter(letter));
  }

  void add(MdpBuilder& builder, const State& s) {
    const Model& model = product_.model();
    builder.add_state(model.name(s.place) + " · " + std::to_string(s.task));
    add_place(values_.values, model, s.place);
    values_.values.push_back(static_cast<std::int32_t>(s.task));
    if (product_.choices(s) == 0) return stay(builder, s.index, letter(s.index, false));
    for (std::uint32_t k = 0; k < product_.choices(s); ++k) {
      builder.add_choice(product_.is_jump(s, k) ? "jump" : model.action(s.place, k), product_.cost(s, k));
      product_.for_each_outcome(s, k, [&](std::uint32_t target, double probability, bool marked) {
        if (target == ProductMdp<Model>::trap) {
          needs_trap_ = true;
          builder.add_outcome(trap(), builder.letter({}), probability);
        } else {
          builder.add_outcome(target, builder.letter(letter(target, marked)), probability);
        }
      });
    }
  }

  const ProductMdp<Model>& product_;
  ltl::Vocabulary vocabulary_;
  ltl::Proposition goal_, marked_;
  StateValues values_;
  std::vector<bool> goals_;
  bool needs_trap_ = false;
};

}  // namespace

StateLabelled explicit_product(const ProductMdp<Mdp>& product) { return Unfolding(product).run(); }
StateLabelled explicit_product(const ProductMdp<GridWorld>& product) { return Unfolding(product).run(); }

}  // namespace waymark::plan
