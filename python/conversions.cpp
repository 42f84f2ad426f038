#include <chrono>
#include <functional>
#include <future>

#include "python/handles.hpp"

namespace waymark::python {
namespace {

ltl::Letter renamed(const ltl::Letter& letter, const ltl::Vocabulary& from, const ltl::Vocabulary& to) {
  ltl::Letter out;
  for (const ltl::Proposition p : letter.members())
    if (const auto known = to.find(from.name(p))) out.insert(*known);
  return out;
}

std::vector<ltl::Letter> letters_in(const py::handle& letters, const ltl::Vocabulary& vocabulary) {
  std::vector<ltl::Letter> out;
  for (const py::handle letter : py::iter(letters)) out.push_back(letter_of(letter, vocabulary));
  return out;
}

ltl::AnyWord read(const std::string& text, const ltl::Vocabulary& vocabulary) {
  ltl::Vocabulary names;
  const ltl::AnyWord read = ltl::read_word(text, names);
  if (const auto* trace = std::get_if<ltl::Trace>(&read)) {
    std::vector<ltl::Letter> letters;
    for (const ltl::Letter& letter : *trace) letters.push_back(renamed(letter, names, vocabulary));
    return ltl::Trace(std::move(letters));
  }
  const auto& lasso = std::get<ltl::Lasso>(read);
  std::vector<ltl::Letter> prefix, cycle;
  for (std::size_t i = 0; i < lasso.size(); ++i)
    (i < lasso.loop_start() ? prefix : cycle).push_back(renamed(lasso[i], names, vocabulary));
  return ltl::Lasso(std::move(prefix), std::move(cycle));
}

}  // namespace

ltl::Semantics semantics_of(const std::string& name) {
  if (name == "finite") return ltl::Semantics::Finite;
  if (name == "infinite") return ltl::Semantics::Infinite;
  throw py::value_error("semantics is 'finite' or 'infinite', not '" + name + "'");
}

ltl::Letter letter_of(const py::handle& letter, const ltl::Vocabulary& vocabulary) {
  if (py::isinstance<py::str>(letter)) {
    ltl::Vocabulary names;
    const ltl::Letter read = ltl::read_letter(letter.cast<std::string>(), names);
    return renamed(read, names, vocabulary);
  }
  ltl::Letter out;
  for (const py::handle name : py::iter(letter))
    if (const auto p = vocabulary.find(name.cast<std::string>())) out.insert(*p);
  return out;
}

ltl::AnyWord word_of(const py::handle& word, const py::handle& cycle, const ltl::Vocabulary& vocabulary) {
  if (cycle.is_none() && py::isinstance<py::str>(word)) return read(word.cast<std::string>(), vocabulary);
  if (!cycle.is_none()) return ltl::Lasso(letters_in(word, vocabulary), letters_in(cycle, vocabulary));
  return ltl::Trace(letters_in(word, vocabulary));
}

py::frozenset names_of(const ltl::Letter& letter, const ltl::Vocabulary& vocabulary) {
  py::set names;
  for (const ltl::Proposition p : letter.members()) names.add(vocabulary.name(p));
  return py::frozenset(names);
}

py::list letters_of(const ltl::Trace& word, const ltl::Vocabulary& vocabulary) {
  py::list out;
  for (const ltl::Letter& letter : word) out.append(names_of(letter, vocabulary));
  return out;
}

py::tuple letters_of(const ltl::Lasso& word, const ltl::Vocabulary& vocabulary) {
  py::list prefix, cycle;
  for (std::size_t i = 0; i < word.size(); ++i)
    (i < word.loop_start() ? prefix : cycle).append(names_of(word[i], vocabulary));
  return py::make_tuple(prefix, cycle);
}

void wait_for(const std::function<void(std::stop_token)>& job) {
  std::stop_source stop;
  const py::gil_scoped_release released;
  auto done = std::async(std::launch::async, [&] { job(stop.get_token()); });
  while (done.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready) {
    const py::gil_scoped_acquire held;
    if (PyErr_CheckSignals() == 0) continue;
    stop.request_stop();
    {
      const py::gil_scoped_release again;
      done.wait();
    }
    throw py::error_already_set();
  }
  done.get();
}

}  // namespace waymark::python
