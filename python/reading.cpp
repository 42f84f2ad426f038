// Reading: English instructions → formulas on a map, by a trained model.
#include "libparser/grounding/understand.hpp"
#include "libparser/model_file.hpp"
#include "python/handles.hpp"

namespace waymark::python {
namespace {

struct ReadingHandle {
  FormulaHandle formula;
  double probability = 0;
};

struct Understood {
  std::vector<ReadingHandle> readings;  // best first; none: not understood
  double probability = 1;
  bool ongoing = false;
  std::vector<std::string> unknown_words;
};

Understood read(const parser::Grounder& model, const std::string& text, const plan::Map& map, const std::string& start,
                std::size_t top, bool force) {
  const auto starts = plan::parse_start(start, map);
  const auto arena = std::make_shared<ltl::Arena>(map.vocabulary());
  const parser::UnderstandOptions options{.least = force ? 0 : parser::least_understood};
  parser::Understanding found = interruptible([&](const std::stop_token&) {
    const parser::Executor executor(map);
    return parser::understand(model, text, executor, starts, *arena, options);
  });
  Understood out{{}, found.probability, found.ongoing, std::move(found.words_not_understood)};
  for (const parser::Reading& reading : found.readings)
    if (out.readings.size() < top) out.readings.push_back({{arena, reading.formula}, reading.probability});
  return out;
}

}  // namespace

void bind_reading(py::module_& m) {
  py::class_<ReadingHandle>(m, "Reading", "A formula that a text may mean, with its probability.")
      .def_readonly("formula", &ReadingHandle::formula, "The formula.")
      .def_readonly("probability", &ReadingHandle::probability, "Of all readings together 1.")
      .def("__repr__", [](const ReadingHandle& r) {
        return "Reading(" + py::repr(py::cast(r.formula)).cast<std::string>() + ", " + std::to_string(r.probability) +
               ")";
      });
  py::class_<Understood>(m, "Understanding", "What a text means on a map; false in conditions when not understood.")
      .def_readonly("readings", &Understood::readings, "The likeliest first; none when the text was not understood.")
      .def_readonly("probability", &Understood::probability, "That the text was understood at all.")
      .def_readonly("ongoing", &Understood::ongoing, "Does the first reading speak of what goes on for ever?")
      .def_readonly("unknown_words", &Understood::unknown_words, "Words that name nothing here.")
      .def("__bool__", [](const Understood& u) { return !u.readings.empty(); });
  py::class_<parser::Grounder>(m, "Model", "A trained model that reads instructions.")
      .def(py::init([](const std::string& file) { return parser::load_grounder(file); }), py::arg("file"),
           "Maps a model file into memory.")
      .def("read", &read, py::arg("text"), py::arg("map"), py::arg("start"), py::arg("top") = 5,
           py::arg("force") = false, "What the text means on the map, said at the start pose.");
}

}  // namespace waymark::python
